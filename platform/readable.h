// Waiting for one of several file descriptors.
#pragma once

#include <span>

#include "buttons.h"

namespace vitrine {

[[nodiscard]] bool readable_now(int descriptor);

/// Returns when one of them is readable, has an error, or at `until`.
void wait_readable(std::span<const int> descriptors, Clock::time_point until);

}  // namespace vitrine
