// What signals ask for: SIGINT and SIGTERM an end, a second one at once; SIGHUP that the config be read anew.
#pragma once

#include <atomic>

namespace vitrine {

/// From this call on the signals set the flag, which is returned, instead of killing the program.
const std::atomic<bool>& watch_stop_signals();

/// The same for SIGHUP; who acts on it clears the flag.
std::atomic<bool>& watch_reload_signal();

}  // namespace vitrine
