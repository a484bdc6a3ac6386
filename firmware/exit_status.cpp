#include "exit_status.h"

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

}  // namespace

int report_failures(const std::function<int()>& program) {
  try {
    const int status = program();
    if (!std::cout.flush())
      return fail(kFailed, "standard output cannot be written; free some room or redirect it");
    return status;
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
