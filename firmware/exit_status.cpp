#include "exit_status.h"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <new>

#include "scene/input_error.h"
#include "script_buttons.h"

namespace vitrine {
namespace {

int fail(ExitStatus status, const char* message) {
  std::cerr << "vitrine: " << message << '\n';
  return status;
}

/// What was printed has to arrive for a program to have done its work.
int finished(int status) {
  if (std::cout.flush()) return status;
  return fail(kFailed, "standard output cannot be written; free some room or redirect it");
}

}  // namespace

void leave_now(int status) {
  status = finished(status);
  std::fflush(nullptr);
  std::_Exit(status);
}

int report_failures(const std::function<int()>& program) {
  try {
    return finished(program());
  } catch (const UsageError& error) {
    return fail(kUsage, error.what());
  } catch (const InputError& error) {
    return fail(kBadInput, error.what());
  } catch (const ScriptError& error) {
    return fail(kBadInput, error.what());
  } catch (const std::bad_alloc&) {
    return fail(kFailed, "out of memory; use a smaller scene or picture");
  } catch (const std::exception& error) {
    return fail(kFailed, error.what());
  }
}

}  // namespace vitrine
