// Reciprocal and reciprocal square root of normalised 32-bit integers: a table gives 9 bits, two Newton steps
// the rest. Everything that divides or takes a root in fixed point comes down to these two; they hold no
// floating point and no division at run time.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

namespace vitrine {
namespace detail {

inline constexpr auto kReciprocalTable = [] {
  std::array<std::uint32_t, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    // The middle of the interval of mantissas with these top bits.
    const std::uint64_t middle = (512 + 2 * std::uint64_t{i} + 1) << 22;
    table[i] = static_cast<std::uint32_t>((std::uint64_t{1} << 62) / middle);
  }
  return table;
}();

constexpr std::uint64_t integer_sqrt(std::uint64_t x) {
  std::uint64_t root = 0;
  for (std::uint64_t bit = std::uint64_t{1} << 31; bit != 0; bit >>= 1) {
    if ((root + bit) * (root + bit) <= x) root += bit;
  }
  return root;
}

inline constexpr auto kRsqrtTable = [] {
  std::array<std::uint32_t, 384> table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    const std::uint64_t middle = (256 + 2 * std::uint64_t{i} + 1) << 22;
    const std::uint64_t value = (std::uint64_t{1} << 61) / integer_sqrt(middle << 30);
    table[i] = static_cast<std::uint32_t>(value < 0x7fffffffU ? value : 0x7fffffffU);
  }
  return table;
}();

}  // namespace detail

/// 2^62 / m for m in [2^31, 2^32), in [2^30, 2^31); relative error 1.001 * 2^-30.
constexpr std::uint32_t reciprocal_mantissa(std::uint32_t m) {
  std::uint32_t r = detail::kReciprocalTable[(m >> 23) & 255U];
  for (int step = 0; step < 2; ++step) {  // r += r (1 - m r)
    const auto error = static_cast<std::int32_t>((std::uint32_t{1} << 31) -
                                                 static_cast<std::uint32_t>((std::uint64_t{m} * r) >> 31));
    r += static_cast<std::uint32_t>((static_cast<std::int64_t>(r >> 1) * error) >> 30);
  }
  return r;
}

/// 2^46 / sqrt(m) for m in [2^30, 2^32): with m / 2^30 in [1, 4), 2^31 / sqrt(m / 2^30), in [2^30, 2^31);
/// relative error 2^-29.
constexpr std::uint32_t rsqrt_mantissa(std::uint32_t m) {
  std::uint32_t y = detail::kRsqrtTable[(m >> 23) - 128U];
  for (int step = 0; step < 2; ++step) {  // y += y (1 - m y^2) / 2
    const auto y_squared = static_cast<std::uint32_t>((std::uint64_t{y} * y) >> 31);
    const auto error = static_cast<std::int32_t>(
        (std::uint32_t{1} << 30) - static_cast<std::uint32_t>((std::uint64_t{m} * y_squared) >> 31));
    y += static_cast<std::uint32_t>((static_cast<std::int64_t>(y) * error) >> 31);
  }
  return y < 0x7fffffffU ? y : 0x7fffffffU;
}

/// x * 2^-shift, rounded to nearest; a negative shift multiplies. `shift` in [-31, 62].
constexpr std::int64_t shift_right_rounded(std::int64_t x, int shift) {
  if (shift <= 0) return x << -shift;
  return (x + (std::int64_t{1} << (shift - 1))) >> shift;
}

/// The nearest value a 32-bit integer can hold.
constexpr std::int32_t saturate_i32(std::int64_t x) {
  if (x > INT32_MAX) return INT32_MAX;
  if (x < -INT32_MAX) return -INT32_MAX;
  return static_cast<std::int32_t>(x);
}

}  // namespace vitrine
