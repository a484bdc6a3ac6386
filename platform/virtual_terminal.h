// The text console beneath the picture: put into graphics mode so that neither cursor nor messages shine
// through, left when somebody switches to another (Ctrl+Alt+F2), and given back at the end.
//
// Given back by whom? A program that is killed cannot tidy up, and the kernel leaves the console of a dead
// owner in graphics mode: black, or with a stale text that answers no key. So a child process, forked at the
// start, holds the console's file and the reading end of a pipe that only the program can write to. When the
// program ends, however it ends (return, exception, signal, kill -9, out of memory), the kernel closes the
// pipe; the child wakes, sets text mode and automatic switching, and ends. It is the only place that
// restores. What it cannot survive is being killed together with the program (a service manager that kills a
// whole control group): there the manager has to reset the terminal, as systemd does with TTYPath= and
// TTYReset=.
#pragma once

#include <optional>
#include <string>

#include <sys/types.h>

#include "file_descriptor.h"

namespace vitrine {

/// There may be one at a time, as switching speaks by signals (SIGRTMIN+4, SIGRTMIN+5). Must outlive the open
/// card, so that the kernel can draw the text when it is asked to.
class VirtualTerminal {
 public:
  /// Takes the program's own console, or else the one that is shown unless a desktop has it. Goes on without
  /// one where there is none, or no right to it (that takes to be started on it, or root).
  VirtualTerminal();
  ~VirtualTerminal();
  VirtualTerminal(const VirtualTerminal&) = delete;
  VirtualTerminal& operator=(const VirtualTerminal&) = delete;

  enum class Wish { kNone, kRelease, kAcquire };
  /// What the kernel wants of us now: to release the screen, or to take it again. Answer by released() or
  /// acquired() when that is done.
  [[nodiscard]] Wish wish();
  void released();
  void acquired();

  /// Whether ours is the console that is shown; always so without one.
  [[nodiscard]] bool shown() const { return shown_; }

 private:
  FileDescriptor tty_;
  FileDescriptor alive_;  // the writing end of the child's pipe
  pid_t keeper_ = -1;
  bool shown_ = true;
};

}  // namespace vitrine
