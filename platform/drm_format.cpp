#include "drm_format.h"

#include <algorithm>
#include <array>

#include <drm_fourcc.h>

namespace vitrine {
namespace {

constexpr std::uint32_t kOpaque = 0xff000000;

constexpr auto kFormats = std::to_array<DrmFormat>({
    {DRM_FORMAT_XRGB8888, "XRGB8888", PixelFormat::kXrgb8888, {32, {16, 8}, {8, 8}, {0, 8}, 0}},
    {DRM_FORMAT_ARGB8888, "ARGB8888", PixelFormat::kXrgb8888, {32, {16, 8}, {8, 8}, {0, 8}, kOpaque}},
    {DRM_FORMAT_XBGR8888, "XBGR8888", PixelFormat::kXrgb8888, {32, {0, 8}, {8, 8}, {16, 8}, 0}},
    {DRM_FORMAT_ABGR8888, "ABGR8888", PixelFormat::kXrgb8888, {32, {0, 8}, {8, 8}, {16, 8}, kOpaque}},
    {DRM_FORMAT_RGBX8888, "RGBX8888", PixelFormat::kXrgb8888, {32, {24, 8}, {16, 8}, {8, 8}, 0}},
    {DRM_FORMAT_BGRX8888, "BGRX8888", PixelFormat::kXrgb8888, {32, {8, 8}, {16, 8}, {24, 8}, 0}},
    {DRM_FORMAT_RGB888, "RGB888", PixelFormat::kRgb888, {24, {16, 8}, {8, 8}, {0, 8}, 0}},
    {DRM_FORMAT_BGR888, "BGR888", PixelFormat::kRgb888, {24, {0, 8}, {8, 8}, {16, 8}, 0}},
    {DRM_FORMAT_RGB565, "RGB565", PixelFormat::kRgb565, {16, {11, 5}, {5, 6}, {0, 5}, 0}},
    {DRM_FORMAT_BGR565, "BGR565", PixelFormat::kRgb565, {16, {0, 5}, {5, 6}, {11, 5}, 0}},
});

}  // namespace

std::span<const DrmFormat> drm_formats() { return kFormats; }

const DrmFormat* choose_format(std::span<const std::uint32_t> offered, int preferred_bits,
                               std::optional<PixelFormat> kind) {
  const auto first = [&](std::optional<PixelFormat> wanted) -> const DrmFormat* {
    for (const DrmFormat& format : kFormats) {
      if (wanted && format.kind != *wanted) continue;
      if (std::ranges::find(offered, format.code) != offered.end()) return &format;
    }
    return nullptr;
  };
  if (kind) {
    if (const DrmFormat* const format = first(kind)) return format;
  } else if (preferred_bits == 16) {
    if (const DrmFormat* const format = first(PixelFormat::kRgb565)) return format;
  }
  return first(std::nullopt);
}

}  // namespace vitrine
