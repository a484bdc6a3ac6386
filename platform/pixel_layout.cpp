#include "pixel_layout.h"

namespace vitrine {
namespace {

std::string field_text(const char* name, const BitField& field) {
  return std::string(name) + " " + std::to_string(field.offset) + "+" + std::to_string(field.length);
}

}  // namespace

std::string layout_problem(const PixelLayout& layout) {
  const int bits = layout.bits_per_pixel;
  if (bits != 16 && bits != 24 && bits != 32) return "it has " + std::to_string(bits) + " bits a pixel";
  std::uint64_t taken = 0;
  for (const BitField& field : {layout.red, layout.green, layout.blue}) {
    if (field.length < 1 || field.length > 16 || field.offset < 0 || field.offset > bits - field.length) {
      return "it has no red, green and blue within a pixel's " + std::to_string(bits) + " bits";
    }
    const std::uint64_t mask = ((std::uint64_t{1} << field.length) - 1) << field.offset;
    if ((taken & mask) != 0) return "it has colours that share bits";
    taken |= mask;
  }
  return "";
}

std::string layout_text(const PixelLayout& layout) {
  return std::to_string(layout.bits_per_pixel) + " bits: " + field_text("red", layout.red) + ", " +
         field_text("green", layout.green) + ", " + field_text("blue", layout.blue);
}

}  // namespace vitrine
