#include "stop_signals.h"

#include <csignal>

namespace vitrine {
namespace {

std::atomic<bool> stop_asked{false};
std::atomic<bool> reload_asked{false};
// ARMv5 has no instruction for all that an atomic can do, but storing a byte, which is all that happens here,
// needs none.
static_assert(ATOMIC_BOOL_LOCK_FREE != 0, "a signal handler may touch nothing that takes a lock");

extern "C" void ask_to_stop(int) { stop_asked = true; }
extern "C" void ask_to_reload(int) { reload_asked = true; }

}  // namespace

const std::atomic<bool>& watch_stop_signals() {
  struct sigaction action {};
  action.sa_handler = ask_to_stop;
  action.sa_flags = static_cast<int>(SA_RESETHAND);  // the second one kills
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  return stop_asked;
}

std::atomic<bool>& watch_reload_signal() {
  struct sigaction action {};
  action.sa_handler = ask_to_reload;
  action.sa_flags = SA_RESTART;
  sigaction(SIGHUP, &action, nullptr);
  return reload_asked;
}

}  // namespace vitrine
