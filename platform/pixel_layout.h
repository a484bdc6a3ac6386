// How a screen's memory holds a colour: which bits of a pixel's word are red, green and blue, as a
// framebuffer device tells it and as a format code of KMS means it. Words lie least significant byte first,
// as they do on every board we build for; a pixel of 24 bits is three bytes without a gap.
#pragma once

#include <cstdint>
#include <string>

namespace vitrine {

struct BitField {
  int offset = 0;  ///< of the lowest bit
  int length = 0;

  bool operator==(const BitField&) const = default;
};

struct PixelLayout {
  int bits_per_pixel = 32;  ///< 16, 24 or 32
  BitField red{16, 8};
  BitField green{8, 8};
  BitField blue{0, 8};
  std::uint32_t always_set = 0;  ///< bits that are 1 in every pixel: opacity, where the screen has it

  bool operator==(const PixelLayout&) const = default;
};

/// Why pixels cannot be written in a layout, as "it has ...", or empty.
[[nodiscard]] std::string layout_problem(const PixelLayout& layout);

/// As a person reads it: "16 bits: red 11+5, green 5+6, blue 0+5" (offset + length).
[[nodiscard]] std::string layout_text(const PixelLayout& layout);

}  // namespace vitrine
