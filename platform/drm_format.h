// The pixel formats of KMS that we can write, and which of those a screen offers to use.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "display.h"
#include "pixel_layout.h"

namespace vitrine {

struct DrmFormat {
  std::uint32_t code = 0;                     ///< of drm_fourcc.h
  std::string_view name;                      ///< "XRGB8888"
  PixelFormat kind = PixelFormat::kXrgb8888;  ///< which of ours it stands for in a configuration
  PixelLayout layout{};
};

/// The best first.
[[nodiscard]] std::span<const DrmFormat> drm_formats();

/// The format to use of those offered: of the kind asked for where there is one, else the best, but one of 16
/// bits when `preferred_bits` says that the driver prefers that. Null: none of the offered can be written.
[[nodiscard]] const DrmFormat* choose_format(std::span<const std::uint32_t> offered, int preferred_bits,
                                             std::optional<PixelFormat> kind);

}  // namespace vitrine
