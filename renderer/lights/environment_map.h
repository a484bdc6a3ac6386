// The environment as a picture of all directions: radiance at the points of a lattice over the octahedral
// square, bilinear between them. A light sample chooses a point in proportion to the power of its share and
// then a place by the weight that this point has there, a tent. So the density is the bilinear blend of the
// points' densities, and a small sun is found as often as it deserves, with little noise (Pharr, Jakob,
// Humphreys, "Infinite Area Lights").
//
//   pdf_w = sum over the four points around of weight prob / area of the tent / (|w.x| + |w.y| + |w.z|)^3
#pragma once

#include <cstddef>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>
#include <vector>

#include "geometry/octahedral.h"
#include "lights/light_sample.h"
#include "numeric/color.h"
#include "numeric/host_conversion.h"
#include "sampling/discrete_distribution.h"

namespace vitrine {

template <class N>
class EnvironmentMap {
  using Unit = typename N::Unit;
  using Density = typename N::Density;
  using Radiance = typename N::Radiance;

 public:
  /// `radiance`: of the (cells + 1)^2 points of the lattice, rows from y = -1 to 1, each from x = -1 to 1;
  /// points of the rim that are the same direction have the same radiance. Somewhere it is above 0. `cells`
  /// is a power of two, up to 2^12.
  EnvironmentMap(int cells, std::span<const glm::dvec3> radiance)
      : cells_(cells),
        cell_width_(from_host<Unit>(1.0 / cells)),
        step_(N::pixel_step(static_cast<std::uint32_t>(cells))) {
    std::vector<double> powers;
    for (std::uint32_t i = 0; i < radiance.size(); ++i) {
      powers.push_back(luminance<double>(radiance[i]) * tent_area(i) * solid_angle_density(i));
    }
    mean_luminance_ = std::accumulate(powers.begin(), powers.end(), 0.0) / (4.0 * std::numbers::pi);
    chosen_ = DiscreteDistribution<N>(powers);
    for (std::uint32_t i = 0; i < radiance.size(); ++i) {
      points_.push_back(
          {from_host<Radiance>(radiance[i]), chosen_.prob(i) / from_host<Density>(tent_area(i))});
    }
  }

  [[nodiscard]] Vec3<Radiance> radiance(const Vec3<Unit>& direction) const {
    return around(octahedral_point(direction)).blend([](const Point& point) { return point.radiance; });
  }

  /// Nothing where rounding led to a direction without light.
  [[nodiscard]] std::optional<LightSample<N>> sample(std::uint32_t bits, Unit u, Unit v) const {
    const std::uint32_t point = chosen_.sample(bits);
    const Unit across = place_in_tent(column_of(point), u);
    const Unit along = place_in_tent(row_of(point), v);
    const Vec3<Unit> wi = octahedral_direction<Unit>(across + across - 1, along + along - 1);
    const Density pdf_w = this->pdf_w(wi);
    if (!(pdf_w > 0)) return std::nullopt;
    return LightSample<N>{.wi = wi, .end = std::nullopt, .radiance = radiance(wi), .pdf_w = pdf_w};
  }

  [[nodiscard]] Density pdf_w(const Vec3<Unit>& direction) const {
    const OctahedralPoint<Unit> at = octahedral_point(direction);
    const Density taxicab(at.taxicab);
    return around(at).blend([](const Point& point) { return point.pdf_xy; }) / (taxicab * taxicab * taxicab);
  }

  /// Over all directions; of use while building.
  [[nodiscard]] double mean_luminance() const { return mean_luminance_; }

 private:
  struct Point {
    Vec3<Radiance> radiance;
    Density pdf_xy;  ///< per area of the square
  };

  // The four points around a place of the square, and where it lies between them.
  struct Surroundings {
    const Point* upper;  // and the one behind
    const Point* lower;
    Unit u;
    Unit v;

    template <class Value>
    [[nodiscard]] auto blend(const Value& value) const {
      const auto between = [](const auto& a, const auto& b, Unit x) { return a * (1 - x) + b * x; };
      return between(between(value(upper[0]), value(upper[1]), u),
                     between(value(lower[0]), value(lower[1]), u), v);
    }
  };
  [[nodiscard]] Surroundings around(const OctahedralPoint<Unit>& at) const {
    const auto cell_at = [&](Unit x) {
      typename N::Cell cell = N::grid_cell(x * Unit(0.5) + Unit(0.5), cells_);
      if (cell.index < 0) return typename N::Cell{0, Unit(0)};
      if (cell.index >= cells_) return typename N::Cell{cells_ - 1, Unit(1)};
      return cell;
    };
    const typename N::Cell column = cell_at(at.x);
    const typename N::Cell row = cell_at(at.y);
    const Point* const upper = points_.data() + row.index * (cells_ + 1) + column.index;
    return {upper, upper + cells_ + 1, column.fraction, row.fraction};
  }

  // A place in [0, 1] around the i-th of the points of a row or column: the nearer, the more likely. On the
  // rim it is half a tent.
  [[nodiscard]] Unit place_in_tent(std::uint32_t i, Unit u) const {
    const Unit middle = N::pixel_coordinate(i, Unit(0), step_);
    if (i == 0) return middle + (1 - sqrt(u)) * cell_width_;
    if (i == static_cast<std::uint32_t>(cells_)) return middle - (1 - sqrt(u)) * cell_width_;
    if (u < Unit(0.5)) return middle - (1 - sqrt(u + u)) * cell_width_;
    const Unit rest = 1 - u;
    return middle + (1 - sqrt(rest + rest)) * cell_width_;
  }

  [[nodiscard]] std::uint32_t column_of(std::uint32_t point) const {
    return point % static_cast<std::uint32_t>(cells_ + 1);
  }
  [[nodiscard]] std::uint32_t row_of(std::uint32_t point) const {
    return point / static_cast<std::uint32_t>(cells_ + 1);
  }

  // Only while building: what a tent covers of the square, of area 4, and d omega / dx dy at its top.
  [[nodiscard]] double tent_area(std::uint32_t point) const {
    const auto width = [&](std::uint32_t i) {
      return (i == 0 || i == static_cast<std::uint32_t>(cells_) ? 1.0 : 2.0) / cells_;
    };
    return width(column_of(point)) * width(row_of(point));
  }
  [[nodiscard]] double solid_angle_density(std::uint32_t point) const {
    const auto on_square = [&](std::uint32_t i) { return 2.0 * i / cells_ - 1.0; };
    const double taxicab =
        octahedral_point(octahedral_direction(on_square(column_of(point)), on_square(row_of(point)))).taxicab;
    return taxicab * taxicab * taxicab;
  }

  int cells_;
  Unit cell_width_;
  decltype(N::pixel_step(1U)) step_;
  std::vector<Point> points_;
  DiscreteDistribution<N> chosen_;
  double mean_luminance_ = 0.0;
};

}  // namespace vitrine
