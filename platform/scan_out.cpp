#include "scan_out.h"

#include <algorithm>
#include <cstring>

namespace vitrine {
namespace {

/// Rows gathered at once: their pixels lie in one cache line of each of the picture's rows when it is turned
/// on its side.
constexpr int kBandRows = 16;
constexpr int kPattern = 8;

/// The index in `source` pixels of the pixel in the middle of each of `target`, backwards if asked.
std::vector<int> nearest_indices(int source, int target, bool backwards) {
  std::vector<int> indices(static_cast<std::size_t>(target));
  for (int i = 0; i < target; ++i) {
    const auto at = static_cast<int>((2 * std::int64_t{i} + 1) * source / (2 * std::int64_t{target}));
    indices[static_cast<std::size_t>(i)] = backwards ? source - 1 - at : at;
  }
  return indices;
}

bool counts_up(const std::vector<int>& indices) {
  for (std::size_t i = 0; i < indices.size(); ++i) {
    if (indices[i] != static_cast<int>(i)) return false;
  }
  return true;
}

const std::uint32_t* row_of(const Surface& picture, int y) {
  return reinterpret_cast<const std::uint32_t*>(picture.pixels +
                                                static_cast<std::size_t>(y) * picture.stride_bytes);
}

/// A colour's value in `length` <= 8 bits, dithered by 0 <= d < 255: floor((value * (2^length - 1) + d) /
/// 255).
std::uint32_t dithered(std::uint32_t value, unsigned length, std::uint32_t d) {
  const std::uint32_t x =
      (value << length) - value + d;  // < 65535, for which the next line is exactly x / 255
  return (x + 1 + (x >> 8)) >> 8;
}

}  // namespace

Extent turned(Extent size, int rotation) {
  return rotation % 180 == 0 ? size : Extent{size.height, size.width};
}

PixelRect place_picture(Extent picture, Extent screen, Scaling scaling) {
  Extent shown;
  const int factor = std::min(screen.width / picture.width, screen.height / picture.height);
  if (scaling == Scaling::kInteger && factor >= 1) {
    shown = {picture.width * factor, picture.height * factor};
  } else {
    const std::int64_t by_width = std::int64_t{screen.width} * picture.height;
    const std::int64_t by_height = std::int64_t{screen.height} * picture.width;
    const auto rounded = [](std::int64_t product, int divisor) {
      return std::max(static_cast<int>((2 * product + divisor) / (2 * std::int64_t{divisor})), 1);
    };
    shown = by_width <= by_height ? Extent{screen.width, rounded(by_width, picture.width)}
                                  : Extent{rounded(by_height, picture.height), screen.height};
  }
  return {(screen.width - shown.width) / 2, (screen.height - shown.height) / 2, shown.width, shown.height};
}

int dither_pattern(int x, int y) {
  // Bayer's: the bits of x ^ y and of y, interleaved from the coarsest to the finest.
  int value = 0;
  for (int bit = 0; bit < 3; ++bit) {
    value = value << 2 | ((x ^ y) >> bit & 1) << 1 | (y >> bit & 1);
  }
  return value;
}

ScanOut::ScanOut(Extent picture, const ScreenMemory& screen, int rotation, Scaling scaling)
    : screen_(screen),
      rect_(place_picture(turned(picture, rotation), {screen.width, screen.height}, scaling)),
      transposed_(rotation % 180 != 0) {
  // Turned clockwise by 90 degrees, the picture's lowest row is the leftmost column.
  const Extent seen = turned(picture, rotation);
  of_column_ = nearest_indices(seen.width, rect_.width, rotation == 90 || rotation == 180);
  of_row_ = nearest_indices(seen.height, rect_.height, rotation == 180 || rotation == 270);
  direct_ = !transposed_ && counts_up(of_column_);

  // An odd number of cache lines: rows whose addresses differ by a power of two would fight for the same
  // ones.
  constexpr std::size_t kLine = 16;
  const std::size_t lines = (static_cast<std::size_t>(rect_.width) + kLine - 1) / kLine;
  band_stride_ = (lines | 1) * kLine;
  if (!direct_) band_.resize(band_stride_ * (transposed_ ? kBandRows : 1));

  const PixelLayout& layout = screen.layout;
  const auto lengths = std::minmax({layout.red.length, layout.green.length, layout.blue.length});
  if (lengths.second > 8) {
    encoding_ = Encoding::kWidened;
  } else if (lengths.first < 8) {
    encoding_ = Encoding::kDithered;
  } else {
    encoding_ = layout == PixelLayout{} ? Encoding::kSame : Encoding::kBytes;
  }
  if (encoding_ == Encoding::kWidened) {
    const BitField fields[] = {layout.red, layout.green, layout.blue};
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint64_t most = (std::uint64_t{1} << fields[c].length) - 1;
      for (std::size_t value = 0; value < 256; ++value) {
        widened_[c][value] = static_cast<std::uint32_t>((value * most + 127) / 255 << fields[c].offset);
      }
    }
  }
  if (encoding_ == Encoding::kDithered) {
    dither_.reserve(static_cast<std::size_t>(rect_.width) * kPattern);
    for (int y = 0; y < kPattern; ++y) {
      for (int x = 0; x < rect_.width; ++x) {
        dither_.push_back((static_cast<unsigned>(dither_pattern(rect_.x + x, y)) * 255 + 127) / 64);
      }
    }
  }
}

void ScanOut::copy(const Surface& picture, std::byte* pixels) {
  if (direct_) {
    for (int y = 0; y < rect_.height; ++y) {
      store_row(row_of(picture, of_row_[static_cast<std::size_t>(y)]), y, pixels);
    }
    return;
  }
  const int step = transposed_ ? kBandRows : 1;
  for (int first = 0; first < rect_.height; first += step) {
    const int count = std::min(step, rect_.height - first);
    gather(picture, first, count);
    for (int i = 0; i < count; ++i) {
      store_row(band_.data() + static_cast<std::size_t>(i) * band_stride_, first + i, pixels);
    }
  }
}

void ScanOut::gather(const Surface& picture, int first, int count) {
  const int* const of_row = of_row_.data() + first;
  const std::size_t width = of_column_.size();
  if (!transposed_) {
    if (first > 0 && of_row[0] == of_row[-1]) return;  // the band holds it already
    const std::uint32_t* const from = row_of(picture, of_row[0]);
    for (std::size_t x = 0; x < width; ++x) band_[x] = from[of_column_[x]];
    return;
  }
  for (std::size_t x = 0; x < width; ++x) {
    const std::uint32_t* const from = row_of(picture, of_column_[x]);
    std::uint32_t* to = band_.data() + x;
    for (int i = 0; i < count; ++i, to += band_stride_) *to = from[of_row[i]];
  }
}

void ScanOut::store_row(const std::uint32_t* from, int y, std::byte* pixels) const {
  const auto bytes = static_cast<std::size_t>(screen_.layout.bits_per_pixel / 8);
  std::byte* to = pixels + static_cast<std::size_t>(rect_.y + y) * screen_.stride_bytes +
                  static_cast<std::size_t>(rect_.x) * bytes;
  switch (bytes) {
    case 2:
      encode_row(from, y, [to](std::size_t i, std::uint32_t word) {
        const auto half = static_cast<std::uint16_t>(word);
        std::memcpy(to + 2 * i, &half, sizeof half);
      });
      break;
    case 3:
      encode_row(from, y, [to](std::size_t i, std::uint32_t word) {
        to[3 * i] = static_cast<std::byte>(word);
        to[3 * i + 1] = static_cast<std::byte>(word >> 8);
        to[3 * i + 2] = static_cast<std::byte>(word >> 16);
      });
      break;
    default:
      if (encoding_ == Encoding::kSame) {
        std::memcpy(to, from, static_cast<std::size_t>(rect_.width) * 4);
      } else {
        encode_row(from, y,
                   [to](std::size_t i, std::uint32_t word) { std::memcpy(to + 4 * i, &word, sizeof word); });
      }
      break;
  }
}

template <class Write>
void ScanOut::encode_row(const std::uint32_t* from, int y, Write write) const {
  const auto width = static_cast<std::size_t>(rect_.width);
  const PixelLayout layout = screen_.layout;  // a copy: the compiler knows that no store changes it
  const auto red = static_cast<unsigned>(layout.red.offset);
  const auto green = static_cast<unsigned>(layout.green.offset);
  const auto blue = static_cast<unsigned>(layout.blue.offset);
  const std::uint32_t always_set = layout.always_set;
  if (encoding_ == Encoding::kWidened) {
    for (std::size_t i = 0; i < width; ++i) {
      const std::uint32_t word = from[i];
      write(i, widened_[0][word >> 16 & 255] | widened_[1][word >> 8 & 255] | widened_[2][word & 255] |
                   always_set);
    }
  } else if (encoding_ == Encoding::kDithered) {
    const auto red_bits = static_cast<unsigned>(layout.red.length);
    const auto green_bits = static_cast<unsigned>(layout.green.length);
    const auto blue_bits = static_cast<unsigned>(layout.blue.length);
    const std::uint32_t* const dither =
        dither_.data() + static_cast<std::size_t>((rect_.y + y) % kPattern) * width;
    for (std::size_t i = 0; i < width; ++i) {
      const std::uint32_t word = from[i];
      const std::uint32_t d = dither[i];
      write(i, dithered(word >> 16 & 255, red_bits, d) << red |
                   dithered(word >> 8 & 255, green_bits, d) << green |
                   dithered(word & 255, blue_bits, d) << blue | always_set);
    }
  } else {
    for (std::size_t i = 0; i < width; ++i) {
      const std::uint32_t word = from[i];
      write(i, (word >> 16 & 255) << red | (word >> 8 & 255) << green | (word & 255) << blue | always_set);
    }
  }
}

void ScanOut::blacken(std::byte* pixels) const {
  const auto bytes = static_cast<std::size_t>(screen_.layout.bits_per_pixel / 8);
  std::vector<std::byte> row(static_cast<std::size_t>(screen_.width) * bytes);
  for (std::size_t i = 0; i < row.size(); ++i) {
    row[i] = static_cast<std::byte>(screen_.layout.always_set >> (8 * (i % bytes)));
  }
  for (int y = 0; y < screen_.height; ++y) {
    std::memcpy(pixels + static_cast<std::size_t>(y) * screen_.stride_bytes, row.data(), row.size());
  }
}

}  // namespace vitrine
