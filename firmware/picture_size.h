// A picture's size as people write it: WIDTHxHEIGHT.
#pragma once

#include <optional>
#include <string_view>

namespace vitrine {

/// In pixels.
struct PictureSize {
  int width = 0;
  int height = 0;

  bool operator==(const PictureSize&) const = default;
};

inline constexpr int kMaxPictureSide = 8192;

/// "640x480"; nothing for other forms and for sides outside 1..kMaxPictureSide.
std::optional<PictureSize> parse_size(std::string_view text);

}  // namespace vitrine
