// How the program ends: one table of exit codes, and the one place that turns a failure into a line on
// stderr.
#pragma once

#include <functional>
#include <stdexcept>

namespace vitrine {

enum ExitStatus : int {
  kDone = 0,
  kFailed = 1,    ///< at run time: a file cannot be written, no display
  kUsage = 2,     ///< the command line is wrong
  kBadInput = 3,  ///< a scene, playlist, config or script is wrong
};

/// What the user typed cannot be done. `what()` is one line with the remedy.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Ends the process as returning `status` from `program` below would, but at once: what other threads do is
/// neither waited for nor taken apart.
[[noreturn]] void leave_now(int status);

/// Runs `program` and returns its status; what it throws becomes one line on stderr and the status that
/// belongs to it.
int report_failures(const std::function<int()>& program);

}  // namespace vitrine
