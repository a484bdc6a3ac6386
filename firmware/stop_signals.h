// SIGINT and SIGTERM ask the program to end; a second one ends it at once.
#pragma once

#include <atomic>

namespace vitrine {

/// From this call on the signals set the flag, which is returned, instead of killing the program.
const std::atomic<bool>& watch_stop_signals();

}  // namespace vitrine
