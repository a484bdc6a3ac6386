#include "picture_size.h"

#include <charconv>

namespace vitrine {
namespace {

std::optional<int> parse_side(std::string_view digits) {
  int side = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), side);
  if (error != std::errc{} || end != digits.data() + digits.size() || side < 1 || side > kMaxPictureSide) {
    return std::nullopt;
  }
  return side;
}

}  // namespace

std::optional<PictureSize> parse_size(std::string_view text) {
  const std::size_t cross = text.find('x');
  if (cross == std::string_view::npos) return std::nullopt;
  const std::optional<int> width = parse_side(text.substr(0, cross));
  const std::optional<int> height = parse_side(text.substr(cross + 1));
  if (!width || !height) return std::nullopt;
  return PictureSize{*width, *height};
}

}  // namespace vitrine
