// What each sequence promises of the numbers that Sampler takes from it. Independent random numbers have more
// tests in sampler_test.cpp; nets without the sampler are in sobol_test.cpp.
#include "sampling/sequence.h"

#include <array>
#include <bit>
#include <cmath>
#include <complex>
#include <cstdint>
#include <functional>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sampling/sampler.h"
#include "statistics/chi_square.h"
#include "statistics/z_test.h"

namespace vitrine {
namespace {

using Bits = std::pair<std::uint32_t, std::uint32_t>;

struct Named {
  Sequence sequence;
  const char* name;
};
constexpr Named kRandom{Sequence::kRandom, "random"};
constexpr Named kGrid{Sequence::kGrid, "grid"};
constexpr Named kStratified{Sequence::kStratified, "stratified"};
constexpr Named kSobol{Sequence::kSobol, "sobol"};
constexpr Named kBlueNoise{Sequence::kBlueNoise, "blue-noise"};
constexpr std::array kAll{kRandom, kGrid, kStratified, kSobol, kBlueNoise};
constexpr std::array kUnbiased{kRandom, kStratified, kSobol, kBlueNoise};

Bits pair_at(Sampler sampler, std::uint32_t dimension) {
  sampler.seek(dimension);
  const std::uint32_t first = sampler.next_bits();
  const std::uint32_t second = sampler.next_bits();
  return {first, second};
}
std::uint32_t bits_at(const Sampler& sampler, std::uint32_t dimension) {
  return pair_at(sampler, dimension).first;
}

// Whether pairs fill a grid of 16 x 16 cells evenly, by their leading and by their last digits.
constexpr std::uint32_t kDraws = 30000;
template <class Pair>
void expect_uniform(const Pair& pair, int comparisons, const std::string& what) {
  std::vector<std::uint64_t> leading(256, 0);
  std::vector<std::uint64_t> last(256, 0);
  for (std::uint32_t i = 0; i < kDraws; ++i) {
    const auto [a, b] = pair(i);
    ++leading[(a >> 28) * 16 + (b >> 28)];
    ++last[(a & 15U) * 16 + (b & 15U)];
  }
  EXPECT_GT(chi_square_uniform(leading).p_value, sidak(2 * comparisons)) << what << ", leading digits";
  EXPECT_GT(chi_square_uniform(last).p_value, sidak(2 * comparisons)) << what << ", last digits";
}

// Of the same pixel and sample, over the seeds: this is what makes any number of samples unbiased.
TEST(SequenceTest, EverySampleIsUniform) {
  constexpr std::array<std::uint32_t, 6> kSamples{0, 1, 2, 3, 63, 1000000};
  constexpr std::array<std::uint32_t, 3> kDimensions{0, 6, 28};
  constexpr int kComparisons = 4 * 6 * 3;
  for (const Named& s : kUnbiased) {
    for (const std::uint32_t sample : kSamples) {
      for (const std::uint32_t dimension : kDimensions) {
        expect_uniform(
            [&](std::uint32_t i) { return pair_at(Sampler(s.sequence, i, 5, 3, sample), dimension); },
            kComparisons, s.name + std::string(", sample ") + std::to_string(sample));
      }
    }
  }
}

TEST(SequenceTest, SamplesOfAPixelAreUniform) {
  for (const Named& s : kUnbiased) {
    for (const std::uint32_t dimension : {0U, 1U, 2U, 7U, 40U}) {
      expect_uniform([&](std::uint32_t i) { return pair_at(Sampler(s.sequence, 1, 5, 3, i), dimension); },
                     4 * 5, s.name);
    }
  }
}

// Numbers of one sample in different dimensions; of neighbours, where the sequence does not plan them
// together; and of what was split here and there.
TEST(SequenceTest, WhatIsNotPlannedTogetherIsIndependent) {
  constexpr int kComparisons = 4 * 10;
  const auto both = [](const Sampler& a, std::uint32_t dim_a, const Sampler& b, std::uint32_t dim_b) {
    return Bits(bits_at(a, dim_a), bits_at(b, dim_b));
  };
  for (const Named& s : kUnbiased) {
    const auto at = [&](std::uint32_t seed, std::uint32_t x, std::uint32_t y, std::uint32_t sample) {
      return Sampler(s.sequence, seed, x, y, sample);
    };
    const auto split_at = [](Sampler sampler, std::uint32_t dimension, std::uint32_t i, std::uint32_t count) {
      sampler.seek(dimension);
      return sampler.split(i, count);
    };
    const auto expect = [&](const char* what, const auto& pair) {
      expect_uniform(pair, kComparisons, s.name + std::string(": ") + what);
    };
    for (const std::uint32_t other : {1U, 2U, 4U, 9U}) {
      expect("two dimensions",
             [&](std::uint32_t i) { return both(at(i, 3, 4, 2), 0, at(i, 3, 4, 2), other); });
    }
    expect("two groups in one pixel",
           [&](std::uint32_t i) { return both(at(1, 3, 4, i), 4, at(1, 3, 4, i), 8); });
    expect("a sample and its child",
           [&](std::uint32_t i) { return both(at(2, 3, 4, i), 8, split_at(at(2, 3, 4, i), 8, 0, 4), 8); });
    expect("children of different places", [&](std::uint32_t i) {
      const Sampler parent = at(3, 3, 4, i / 4);
      return both(split_at(parent, 4, i % 4, 4), 12, split_at(parent, 12, i % 4, 4), 12);
    });
    expect("children and grandchildren", [&](std::uint32_t i) {
      const Sampler child = split_at(at(4, 3, 4, i / 8), 4, i / 4 % 2, 2);
      return both(child, 12, split_at(child, 12, i % 4, 4), 12);
    });
    if (s.sequence == Sequence::kBlueNoise) continue;  // plans pixels together
    expect("pixels side by side",
           [&](std::uint32_t i) { return both(at(5, i, 7, 0), 0, at(5, i + 1, 7, 0), 0); });
    expect("pixels one upon another",
           [&](std::uint32_t i) { return both(at(5, 7, i, 1), 0, at(5, 7, i + 1, 1), 0); });
  }
}

// 64 samples of a round, 64 children of a family, and 4 families of 16 from one place.
TEST(SequenceTest, OneOf64SamplesIsInEachStratum) {
  for (const Named& s : {kGrid, kStratified, kSobol, kBlueNoise}) {
    for (const std::uint32_t dimension : {0U, 2U, 4U, 14U}) {
      for (const std::uint32_t round : {0U, 1U, 5U, 33554432U}) {
        std::set<std::uint32_t> samples;
        std::set<std::uint32_t> children;
        std::set<std::uint32_t> families;
        const auto stratum = [&](const Sampler& sampler) {
          const auto [x, y] = pair_at(sampler, dimension);
          return x >> 29 << 3 | y >> 29;
        };
        for (std::uint32_t i = 0; i < 64; ++i) {
          samples.insert(stratum(Sampler(s.sequence, 1, 8, 9, round * 64 + i)));
          Sampler parent(s.sequence, 2, 8, 9, round);
          children.insert(stratum(parent.split(i, 64)));
          Sampler one_of_four(s.sequence, 3, 8, 9, round * 4 + i / 16);
          one_of_four.seek(4);
          families.insert(stratum(one_of_four.split(i % 16, 16)));
        }
        EXPECT_EQ(samples.size(), 64U) << s.name << ' ' << dimension << ' ' << round;
        EXPECT_EQ(children.size(), 64U) << s.name << ' ' << dimension << ' ' << round;
        EXPECT_EQ(families.size(), 64U) << s.name << ' ' << dimension << ' ' << round;
      }
    }
  }
}

// Every box of the size of one point has one: of the first 2^m samples, of 2^m children, of grandchildren.
TEST(SequenceTest, SobolPointsAreNets) {
  const auto expect_net = [](const std::vector<Bits>& points, const char* name) {
    const auto m = static_cast<std::uint32_t>(std::bit_width(points.size()) - 1);
    for (std::uint32_t wide = 0; wide <= m; ++wide) {
      std::set<std::uint64_t> boxes;
      for (const auto& [x, y] : points) {
        boxes.insert((std::uint64_t{x} >> (32 - wide)) << 32 | std::uint64_t{y} >> (32 - (m - wide)));
      }
      EXPECT_EQ(boxes.size(), points.size()) << name << ", 2^" << wide << " boxes wide of 2^" << m;
    }
  };
  for (const Named& s : {kSobol, kBlueNoise}) {
    for (const std::uint32_t dimension : {0U, 2U, 12U, 22U}) {
      for (std::uint32_t m = 0; m <= 9; ++m) {
        std::vector<Bits> samples;
        std::vector<Bits> children;
        std::vector<Bits> grandchildren;
        for (std::uint32_t i = 0; i < 1U << m; ++i) {
          samples.push_back(pair_at(Sampler(s.sequence, m, 70, 80, i), dimension));
          Sampler parent(s.sequence, m, 70, 80, 3);
          parent.seek(4);
          children.push_back(pair_at(parent.split(i, 1U << m), dimension));
          const std::uint32_t first = m / 2;
          Sampler child = parent.split(i >> (m - first), 1U << first);
          child.seek(12);
          const std::uint32_t grandchild = i & ((1U << (m - first)) - 1);
          grandchildren.push_back(pair_at(child.split(grandchild, 1U << (m - first)), dimension));
        }
        expect_net(samples, s.name);
        expect_net(children, s.name);
        expect_net(grandchildren, s.name);
      }
    }
  }
}

// 2^24 samples by 256, and again: indices of 40 bits and more, that may not come around.
TEST(SequenceTest, DeepSplitsDoNotRepeat) {
  for (const Named& s : kUnbiased) {
    std::set<std::uint64_t> seen;
    constexpr std::uint32_t kSamples = 64;
    for (std::uint32_t i = 0; i < kSamples; ++i) {
      Sampler sampler(s.sequence, 1, 2, 3, i << 24);
      for (std::uint32_t depth = 0; depth < 6; ++depth) {
        sampler.seek(4 + 8 * depth);
        sampler = sampler.split(0, 256);
        const auto [a, b] = pair_at(sampler, 4 + 8 * depth);
        EXPECT_TRUE(seen.insert(std::uint64_t{a} << 32 | b).second) << s.name << ' ' << i << ' ' << depth;
      }
    }
  }
}

TEST(SequenceTest, SplittingInOneIsTheSameSample) {
  for (const Named& s : kAll) {
    Sampler sampler(s.sequence, 1, 2, 3, 4);
    sampler.seek(12);
    EXPECT_EQ(pair_at(sampler.split(0, 1), 12), pair_at(sampler, 12)) << s.name;
  }
}

TEST(SequenceTest, AnyDimensionCanBeSought) {
  for (const Named& s : kAll) {
    Sampler in_order(s.sequence, 1, 2, 3, 4);
    for (std::uint32_t dimension = 0; dimension < 50; ++dimension) {
      EXPECT_EQ(in_order.next_bits(), bits_at(Sampler(s.sequence, 1, 2, 3, 4), dimension)) << s.name;
    }
  }
}

TEST(SequenceTest, TheGridIsTheSameInEveryPixel) {
  for (std::uint32_t sample = 0; sample < 200; ++sample) {
    for (std::uint32_t dimension = 0; dimension < 40; ++dimension) {
      const std::uint32_t bits = bits_at(Sampler(Sequence::kGrid, 1, 0, 0, sample), dimension);
      EXPECT_EQ(bits & 0x1fffffffU, 0x10000000U) << "not the middle of one of 8 cells";
      EXPECT_EQ(bits, bits_at(Sampler(Sequence::kGrid, 9, 13 + sample, 77, sample), dimension));
    }
  }
}

// A way to take one sample of an integral, and the integral.
struct Integrand {
  const char* name;
  double exact;
  std::function<double(Sampler&)> sample;
};
double next(Sampler& sampler) { return sampler.next_bits() * 0x1p-32 + 0x1p-33; }

const Integrand& smooth() {
  static const Integrand integrand{"smooth", std::numbers::e - 1.0, [](Sampler& s) {
                                     const double x = next(s);
                                     const double y = next(s);
                                     return std::exp(x) * (y + 0.5);
                                   }};
  return integrand;
}
const std::vector<Integrand>& integrands() {
  constexpr double kDisc = std::numbers::pi / 8.0;
  static const std::vector<Integrand> list{
      smooth(),
      {"disc", kDisc,
       [](Sampler& s) {
         const double x = next(s);
         const double y = next(s);
         return x * x + y * y < 0.5 ? 1.0 : 0.0;
       }},
      {"disc in the last two of four", kDisc,
       [](Sampler& s) {
         s.seek(6);
         const double x = next(s);
         const double y = next(s);
         return x * x + y * y < 0.5 ? 1.0 : 0.0;
       }},
      {"eight dimensions", 1.0,
       [](Sampler& s) {
         double product = 1.0;
         for (int i = 0; i < 8; ++i) product *= 0.5 * next(s) + 0.75;
         return product;
       }},
      // Both sides of the comparison are distributed symmetrically about 3/4.
      {"five shadow rays", 0.5,
       [](Sampler& s) {
         const double x = next(s);
         const double y = next(s);
         s.seek(4);
         double sum = 0.0;
         for (std::uint32_t i = 0; i < 5; ++i) {
           Sampler ray = s.split(i, 5);
           const double u = next(ray);
           const double v = next(ray);
           sum += u + 0.5 * v < 0.5 * (x + y) + 0.25 ? 0.2 : 0.0;
         }
         return sum;
       }},
      {"branches", 1.0,
       [](Sampler& s) {
         double sum = 0.0;
         for (std::uint32_t i = 0; i < 4; ++i) {
           s.seek(8);
           Sampler child = s.split(i, 4);
           double first = next(child) + 0.5;
           first *= next(child) + 0.5;
           for (std::uint32_t j = 0; j < 3; ++j) {
             child.seek(16);
             Sampler grandchild = child.split(j, 3);
             double second = next(grandchild) + 0.5;
             second *= next(grandchild) + 0.5;
             sum += first * second / 12.0;
           }
         }
         return sum;
       }},
  };
  return list;
}

double mean_of(const Integrand& integrand, Sequence sequence, std::uint64_t seed, std::uint32_t samples) {
  double sum = 0.0;
  for (std::uint32_t i = 0; i < samples; ++i) {
    Sampler sampler(sequence, seed, 11, 12, i);
    sum += integrand.sample(sampler);
  }
  return sum / samples;
}

TEST(SequenceTest, AnyNumberOfSamplesIsUnbiasedAndNoWorseThanRandom) {
  constexpr std::array<std::uint32_t, 7> kCounts{1, 2, 3, 7, 16, 50, 64};
  constexpr std::uint32_t kSeeds = 800;
  const std::size_t comparisons = kUnbiased.size() * integrands().size() * kCounts.size();
  for (const Integrand& integrand : integrands()) {
    for (const std::uint32_t count : kCounts) {
      double variance_of_random = 0.0;
      for (const Named& s : kUnbiased) {
        std::vector<double> means;
        for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
          means.push_back(mean_of(integrand, s.sequence, seed, count));
        }
        const Estimate all = estimate(means);
        EXPECT_LT(std::abs(z_score(all, exactly(integrand.exact))), sidak_limit(comparisons, kSignificance))
            << s.name << ", " << integrand.name << ", " << count << " samples";
        if (s.sequence == Sequence::kRandom) variance_of_random = all.variance;
        // Each variance is known to some 5 to 10 %.
        EXPECT_LT(all.variance, 1.3 * variance_of_random)
            << s.name << ", " << integrand.name << ", " << count << " samples";
      }
    }
  }
}

// The root mean square error falls as samples^slope: -1/2 if they are independent.
TEST(SequenceTest, SobolConvergesFaster) {
  const auto slope = [](Sequence sequence) {
    const auto log_error = [&](std::uint32_t samples) {
      double squares = 0.0;
      for (std::uint32_t seed = 0; seed < 100; ++seed) {
        const double error = mean_of(smooth(), sequence, seed, samples) - smooth().exact;
        squares += error * error / 100.0;
      }
      return 0.5 * std::log(squares);
    };
    return (log_error(1024) - log_error(4)) / std::log(1024.0 / 4.0);
  };
  EXPECT_NEAR(slope(Sequence::kRandom), -0.5, 0.06);
  EXPECT_LT(slope(Sequence::kSobol), -1.2);
  EXPECT_LT(slope(Sequence::kBlueNoise), -1.2);
}

// The power of the picture's error in its lowest frequencies, those of waves longer than 8 pixels, relative
// to that of white noise with the same variance.
double low_frequency_power(Sequence sequence, const Integrand& integrand, std::uint32_t samples) {
  constexpr std::uint32_t kSize = 48;
  constexpr int kLowest = kSize / 8;
  constexpr std::uint32_t kSeeds = 4;
  double low = 0.0;
  double all = 0.0;
  int frequencies = 0;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    std::vector<double> error;
    for (std::uint32_t i = 0; i < kSize * kSize; ++i) {
      double sum = 0.0;
      for (std::uint32_t n = 0; n < samples; ++n) {
        Sampler sampler(sequence, seed, 100 + i % kSize, 37 + i / kSize, n);
        sum += integrand.sample(sampler);
      }
      error.push_back(sum / samples - integrand.exact);
      all += error.back() * error.back();
    }
    for (int fy = 0; fy <= kLowest; ++fy) {
      std::array<std::complex<double>, kSize> columns{};
      const auto wave = [&](int f, std::uint32_t at) {
        return std::polar(1.0, 2.0 * std::numbers::pi * f * at / kSize);
      };
      for (std::uint32_t i = 0; i < kSize * kSize; ++i) columns[i % kSize] += error[i] * wave(fy, i / kSize);
      for (int fx = -kLowest; fx <= kLowest; ++fx) {
        if (fx * fx + fy * fy > kLowest * kLowest) continue;
        std::complex<double> amplitude = 0.0;
        for (std::uint32_t x = 0; x < kSize; ++x) amplitude += columns[x] * wave(fx, x);
        low += std::norm(amplitude);
        ++frequencies;
      }
    }
  }
  return low / frequencies / (all / kSeeds);
}

// At any number of samples, though the pixel does not know how many there will be. Measured: 0.05 to 0.11 for
// the smooth integrand, 0.2 to 0.4 for one with an edge.
TEST(SequenceTest, ErrorOnTheScreenIsBlue) {
  for (const std::uint32_t samples : {1U, 4U, 16U}) {
    EXPECT_LT(low_frequency_power(Sequence::kBlueNoise, integrands()[0], samples), 0.2) << samples;
    EXPECT_LT(low_frequency_power(Sequence::kBlueNoise, integrands()[1], samples), 0.5) << samples;
    EXPECT_LT(low_frequency_power(Sequence::kBlueNoise, integrands()[2], samples), 0.5) << samples;
    EXPECT_NEAR(low_frequency_power(Sequence::kSobol, integrands()[0], samples), 1.0, 0.25) << samples;
  }
}

// The same bits on every machine.
TEST(SequenceTest, Golden) {
  struct Golden {
    Named s;
    std::array<std::uint32_t, 4> bits;
  };
  const std::array<Golden, 5> expected{{
      {kRandom, {1464424581U, 166116396U, 1190846795U, 3644940273U}},
      {kGrid, {1342177280U, 1879048192U, 3489660928U, 2952790016U}},
      {kStratified, {3487656827U, 105361897U, 34133080U, 4074364628U}},
      {kSobol, {1246236360U, 2628400299U, 543270503U, 1281616002U}},
      {kBlueNoise, {1450031264U, 2158944216U, 3431953021U, 1134760006U}},
  }};
  for (const Golden& golden : expected) {
    Sampler sampler(golden.s.sequence, 123456789012U, 640, 359, 77);
    std::array<std::uint32_t, 4> bits{sampler.next_bits()};
    sampler.seek(7);
    bits[1] = sampler.next_bits();
    const Sampler child = sampler.split(5, 16);
    bits[2] = bits_at(child, 8);
    bits[3] = bits_at(child.split(2, 1U << 30), 22);  // beyond 32 bits of index
    EXPECT_EQ(bits, golden.bits) << golden.s.name;
  }
}

}  // namespace
}  // namespace vitrine
