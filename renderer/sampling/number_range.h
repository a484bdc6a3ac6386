// A choice made in steps by one 32-bit random number: the numbers that lead to where the steps have come are
// a range, and a step divides it between two alternatives. So the probability of an outcome is known exactly,
// in either number system: its share of all 2^32 numbers. And close numbers choose alike, which keeps a
// stratified sequence stratified.
#pragma once

#include <algorithm>
#include <cstdint>

namespace vitrine {

template <class N>
class NumberRange {
  using Unit = typename N::Unit;
  using Density = typename N::Density;

 public:
  [[nodiscard]] std::uint64_t size() const { return size_; }
  [[nodiscard]] typename N::Density prob() const {
    if (size_ > 0xffffffffU) return Density(1);
    return N::density_from_count(static_cast<std::uint32_t>(size_)) * Density(0x1p-32);
  }

  /// How many of the numbers go to the first of two alternatives, by their weights, of which one at least is
  /// above 0. An alternative without weight gets none, another one its `least` or more.
  [[nodiscard]] std::uint64_t share_of_first(Density first, Density second, std::uint64_t least_first,
                                             std::uint64_t least_second) const {
    if (!(second > 0)) return size_;
    if (!(first > 0)) return 0;
    constexpr int kDigits = 24;
    const auto fraction =
        static_cast<std::uint64_t>(N::quantize(Unit(first / (first + second)), 1 << kDigits));
    return std::clamp((size_ * fraction) >> kDigits, least_first, size_ - least_second);
  }
  /// Whether `bits`, one of its numbers, is of the first `share`.
  [[nodiscard]] bool is_first(std::uint32_t bits, std::uint64_t share) const { return bits - begin_ < share; }
  /// Leaves the first `share` of the numbers, or the others.
  void keep(bool first, std::uint64_t share) {
    if (!first) begin_ += share;
    size_ = first ? share : size_ - share;
  }

 private:
  std::uint64_t begin_ = 0;
  std::uint64_t size_ = std::uint64_t{1} << 32;
};

}  // namespace vitrine
