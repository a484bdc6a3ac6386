// The sphere cut into cells, to compare sampled directions with the density they should have. The cells are
// rows and columns around a pole; half of the rows lie within an angle of it, so that narrow lobes get cells
// too.
//
//   angle from the pole = 2 atan(s tan(pi x / 2)),  x in [0, 1] the row,  s = tan(half_angle / 2)
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <vector>

#include <glm/glm.hpp>

#include "sampling/sampler.h"
#include "statistics/chi_square.h"

namespace vitrine {

class DirectionBins {
 public:
  explicit DirectionBins(const glm::dvec3& pole = {0.0, 0.0, 1.0}, double half_angle = std::numbers::pi / 2)
      : pole_(glm::normalize(pole)), stretch_(std::tan(half_angle / 2)) {
    const glm::dvec3 aside = std::abs(pole_.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    s_ = glm::normalize(glm::cross(aside, pole_));
    t_ = glm::cross(pole_, s_);
  }

  static constexpr std::size_t size() { return kRows * kColumns; }

  [[nodiscard]] std::size_t cell(const glm::dvec3& w) const {
    const double half_tan = glm::length(w - pole_) / glm::length(w + pole_);
    const double x = std::atan(half_tan / stretch_) * 2.0 / std::numbers::pi;
    const double turns = std::atan2(glm::dot(w, t_), glm::dot(w, s_)) / (2.0 * std::numbers::pi);
    return index(x, kRows) * kColumns + index(turns < 0.0 ? turns + 1.0 : turns, kColumns);
  }

  /// The integral of density(w) over each cell.
  template <class Density>
  [[nodiscard]] std::vector<double> integrate(const Density& density) const {
    std::vector<double> cells;
    for (std::size_t row = 0; row < kRows; ++row) {
      for (std::size_t column = 0; column < kColumns; ++column) {
        const Patch patch{static_cast<double>(row) / kRows, static_cast<double>(column) / kColumns,
                          1.0 / kRows, 1.0 / kColumns};
        cells.push_back(refined(density, patch, integral(density, patch), kRefinements));
      }
    }
    return cells;
  }

 private:
  static constexpr std::size_t kRows = 24;
  static constexpr std::size_t kColumns = 20;
  static constexpr int kRefinements = 6;
  static constexpr double kTolerance = 1e-7;

  struct Patch {
    double x, y, width, height;
  };

  static std::size_t index(double x, std::size_t count) {
    return std::min(count - 1, static_cast<std::size_t>(x * static_cast<double>(count)));
  }

  // Halved both ways, at least twice, until it no longer changes the sum: lobes end abruptly within a cell.
  template <class Density>
  double refined(const Density& density, const Patch& p, double coarse, int refinements) const {
    std::array<Patch, 4> parts;
    std::array<double, 4> sums{};
    double fine = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
      parts[i] = {p.x + (i & 1U ? p.width / 2 : 0.0), p.y + (i & 2U ? p.height / 2 : 0.0), p.width / 2,
                  p.height / 2};
      sums[i] = integral(density, parts[i]);
      fine += sums[i];
    }
    const bool settled = refinements < kRefinements && std::abs(fine - coarse) < kTolerance;
    if (refinements == 0 || settled) return fine;
    double sum = 0.0;
    for (std::size_t i = 0; i < 4; ++i) sum += refined(density, parts[i], sums[i], refinements - 1);
    return sum;
  }

  // Gauss-Legendre, 3 x 3 points.
  template <class Density>
  double integral(const Density& density, const Patch& p) const {
    constexpr std::array<double, 3> kAt{0.1127016653792583, 0.5, 0.8872983346207417};
    constexpr std::array<double, 3> kWeight{5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
    double sum = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double angle = (p.x + kAt[i] * p.width) * std::numbers::pi / 2;
      const double near = std::cos(angle);
      const double far = stretch_ * std::sin(angle);
      const double q = near * near + far * far;
      const double sine = 2.0 * near * far / q;
      const glm::dvec3 along = pole_ * ((near * near - far * far) / q);
      const double jacobian = sine * std::numbers::pi * stretch_ / q * 2.0 * std::numbers::pi;
      for (std::size_t j = 0; j < 3; ++j) {
        const double phi = (p.y + kAt[j] * p.height) * 2.0 * std::numbers::pi;
        const glm::dvec3 w = along + (s_ * std::cos(phi) + t_ * std::sin(phi)) * sine;
        sum += kWeight[i] * kWeight[j] * jacobian * density(w);
      }
    }
    return sum * p.width * p.height;
  }

  glm::dvec3 pole_;
  glm::dvec3 s_;
  glm::dvec3 t_;
  double stretch_;
};

struct DirectionComparison {
  double integral;  ///< of the density over the sphere
  ChiSquare chi_square;
};

/// `draw(sampler)` gives directions, or nothing; `density(w)` says with which density per solid angle, and
/// its integral is how often there is one.
template <class Draw, class Density>
DirectionComparison compare_directions(const DirectionBins& bins, std::uint32_t samples, const Draw& draw,
                                       const Density& density) {
  std::vector<double> expected = bins.integrate(density);
  const double integral = std::accumulate(expected.begin(), expected.end(), 0.0);
  expected.push_back(1.0 - integral);  // nothing
  // An empty cell may have a corner that the quadrature overlooked: it is improbable, not impossible.
  constexpr double kOverlooked = 1e-8;
  for (double& cell : expected) cell = std::max(cell, kOverlooked) * samples;
  std::vector<std::uint64_t> observed(expected.size(), 0);
  for (std::uint32_t i = 0; i < samples; ++i) {
    Sampler sampler(Sequence::kRandom, 7, i, 0, 0);
    const std::optional<glm::dvec3> w = draw(sampler);
    ++observed[w ? bins.cell(*w) : DirectionBins::size()];
  }
  return {integral, chi_square(expected, observed)};
}

}  // namespace vitrine
