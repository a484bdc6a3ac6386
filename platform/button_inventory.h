// What a machine offers as buttons: what the backends of this build can find.
#pragma once

#include <optional>

#include "gpio_places.h"
#include "input_devices.h"

namespace vitrine {

/// What a build without the backend cannot look for is not there.
struct ButtonInventory {
  std::optional<GpioInventory> gpio;
  std::optional<InputInventory> input;
};

}  // namespace vitrine
