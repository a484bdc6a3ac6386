// Both number systems, for tests that hold in either: TYPED_TEST_SUITE(Suite, NumberSystems,
// NumberSystemNames).
#pragma once

#include <string>

#include <gtest/gtest.h>

#include "numeric/fixed_numbers.h"
#include "numeric/float_numbers.h"

namespace vitrine {

using NumberSystems = testing::Types<FloatNumbers, FixedNumbers>;

struct NumberSystemNames {
  template <class N>
  static std::string GetName(int /*index*/) {  // NOLINT: the name that GoogleTest asks for
    return std::same_as<N, FixedNumbers> ? "Fixed" : "Float";
  }
};

/// For bounds on errors: what fits each system.
template <class N>
constexpr double bound(double float_bound, double fixed_bound) {
  return std::same_as<N, FixedNumbers> ? fixed_bound : float_bound;
}

}  // namespace vitrine
