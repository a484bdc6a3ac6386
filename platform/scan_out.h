// The way of a finished picture to the screen: turned, scaled, put between black borders, and stored as the
// screen's memory wants its bits. The picture is upright and in cached memory; the screen's memory is often
// uncached, so it is only ever written, row by row from left to right, and never read.
//
// A colour that has less than 8 bits on the screen is dithered by an ordered 8 x 8 pattern fixed to the
// screen,
//   level = floor((value * (2^bits - 1) + (pattern(x, y) * 255 + 127) / 64) / 255),
// so that smooth shades show no bands; with 8 bits that is the value itself.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "display.h"
#include "display_options.h"
#include "pixel_layout.h"
#include "surface.h"

namespace vitrine {

/// Memory that a screen shows: `height` rows, `stride_bytes` apart. Without the pixels themselves.
struct ScreenMemory {
  int width = 0;
  int height = 0;
  std::size_t stride_bytes = 0;
  PixelLayout layout{};
};

struct Extent {
  int width = 0;
  int height = 0;

  bool operator==(const Extent&) const = default;
};

/// A size as it is after a turn by `rotation` degrees.
[[nodiscard]] Extent turned(Extent size, int rotation);

/// Where a picture of that size, turned already, lies on the screen: whole, in the middle, undistorted.
[[nodiscard]] PixelRect place_picture(Extent picture, Extent screen, Scaling scaling);

/// The value 0..63 of the dither pattern at a pixel of the screen.
[[nodiscard]] int dither_pattern(int x, int y);

/// Copies pictures of one size to screens of one kind.
class ScanOut {
 public:
  /// `picture` is the size of the upright picture; the layout is one that layout_problem() finds none in.
  ScanOut(Extent picture, const ScreenMemory& screen, int rotation, Scaling scaling);

  /// Writes the picture, which is kXrgb8888 and of the size given, to its rectangle of the screen whose first
  /// byte is at `pixels`. Leaves the borders alone.
  void copy(const Surface& picture, std::byte* pixels);
  /// Makes the whole screen black, borders too.
  void blacken(std::byte* pixels) const;

  /// The part of the screen that copy() writes.
  [[nodiscard]] const PixelRect& rect() const { return rect_; }

 private:
  /// How a row of 0x00RRGGBB words becomes the screen's.
  enum class Encoding : std::uint8_t {
    kSame,      ///< as it is
    kBytes,     ///< 8 bits a colour, elsewhere
    kDithered,  ///< up to 8 bits a colour
    kWidened,   ///< more than 8 bits for some colour
  };

  /// The rows first..first+count of the rectangle, each `rect_.width` words, `band_stride_` words apart.
  void gather(const Surface& picture, int first, int count);
  void store_row(const std::uint32_t* from, int y, std::byte* pixels) const;
  /// Gives the words of a row, encoded, to `write` one by one.
  template <class Write>
  void encode_row(const std::uint32_t* from, int y, Write write) const;

  ScreenMemory screen_;
  PixelRect rect_;
  Encoding encoding_ = Encoding::kSame;
  bool transposed_ = false;
  bool direct_ = false;         // rows go out as they are in the picture, without a band
  std::vector<int> of_column_;  // for each column of the rectangle: the picture's column, transposed its row
  std::vector<int> of_row_;     // for each row: the picture's row, transposed its column
  std::vector<std::uint32_t> band_;
  std::size_t band_stride_ = 0;
  std::vector<std::uint32_t> dither_;  // 8 rows of the pattern, as wide as the rectangle
  std::array<std::array<std::uint32_t, 256>, 3> widened_{};  // per colour: a value's bits in place
};

}  // namespace vitrine
