#include "scene/environment_lattice.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "geometry/octahedral.h"

namespace vitrine {
namespace {

constexpr int kMinCells = 32;
constexpr int kMaxCells = 512;      // 12 MB a world in fixed point, 8 MB in float
constexpr double kSubdivision = 4;  // pieces that a texel is cut into, a cell's width

class Lattice {
 public:
  explicit Lattice(int cells)
      : cells_(cells), points_(static_cast<std::size_t>(cells + 1) * static_cast<std::size_t>(cells + 1)) {}

  /// Light of `radiance` from `solid_angle` around w.
  void add(const glm::dvec3& w, const glm::dvec3& radiance, double solid_angle) {
    const auto point = octahedral_point(w);
    const auto along = [&](double x) {
      const double position = std::clamp(0.5 * (x + 1.0) * cells_, 0.0, static_cast<double>(cells_));
      const int index = std::min(static_cast<int>(position), cells_ - 1);
      return std::pair(index, position - index);
    };
    const auto [column, u] = along(point.x);
    const auto [row, v] = along(point.y);
    spread(column, row, u, v, solid_angle, radiance * solid_angle);
  }

  void join_rim() {
    for (int i = 0; i < cells_ - i; ++i) {
      join(at(0, i), at(0, cells_ - i));
      join(at(cells_, i), at(cells_, cells_ - i));
    }
    for (int i = 0; i < cells_ - i; ++i) {
      join(at(i, 0), at(cells_ - i, 0));
      join(at(i, cells_), at(cells_ - i, cells_));
    }
  }

  [[nodiscard]] std::vector<glm::dvec3> means() const {
    std::vector<glm::dvec3> radiance;
    radiance.reserve(points_.size());
    for (const Point& point : points_) radiance.push_back(point.flux / point.solid_angle);
    return radiance;
  }

  /// The mean over all directions of the map that blends `radiance`: Gauss's 2 x 2 points in each cell.
  [[nodiscard]] glm::dvec3 mean_of_blend(const std::vector<glm::dvec3>& radiance) const {
    constexpr std::array<double, 2> kAt{0.2113248654051871, 0.7886751345948129};
    glm::dvec3 flux(0.0);
    double solid_angle = 0.0;
    for (int row = 0; row < cells_; ++row) {
      for (int column = 0; column < cells_; ++column) {
        const glm::dvec3* upper = &radiance[index(column, row)];
        const glm::dvec3* lower = upper + cells_ + 1;
        for (const double v : kAt) {
          for (const double u : kAt) {
            const auto on_square = [&](double x) { return 2.0 * x / cells_ - 1.0; };
            const auto w = octahedral_direction(on_square(column + u), on_square(row + v));
            const double density = std::pow(octahedral_point(w).taxicab, 3.0);
            flux += density * glm::mix(glm::mix(upper[0], upper[1], u), glm::mix(lower[0], lower[1], u), v);
            solid_angle += density;
          }
        }
      }
    }
    return flux / solid_angle;
  }

 private:
  struct Point {
    glm::dvec3 flux{0.0};
    double solid_angle = 0.0;
  };

  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(cells_ + 1) +
           static_cast<std::size_t>(column);
  }
  Point& at(int column, int row) { return points_[index(column, row)]; }

  void spread(int column, int row, double u, double v, double solid_angle, const glm::dvec3& flux) {
    const auto give = [&](int x, int y, double weight) {
      Point& point = at(x, y);
      point.flux += flux * weight;
      point.solid_angle += solid_angle * weight;
    };
    give(column, row, (1.0 - u) * (1.0 - v));
    give(column + 1, row, u * (1.0 - v));
    give(column, row + 1, (1.0 - u) * v);
    give(column + 1, row + 1, u * v);
  }

  // Two points of the rim that are one direction.
  static void join(Point& a, Point& b) {
    a.flux += b.flux;
    a.solid_angle += b.solid_angle;
    b = a;
  }

  int cells_;
  std::vector<Point> points_;
};

}  // namespace

EnvironmentLattice make_environment_lattice(const EnvironmentPicture& picture) {
  using std::numbers::pi;
  const int cells = std::clamp(static_cast<int>(std::bit_floor(static_cast<unsigned>(picture.width))),
                               kMinCells, kMaxCells);
  const double piece_rad = std::sqrt(4.0 * pi) / (cells * kSubdivision);
  const int pieces = static_cast<int>(std::ceil(2.0 * pi / picture.width / piece_rad));
  const int columns = picture.width * pieces;
  const int rows = picture.height * pieces;

  // The middle of the picture is +x, what is to the right of it +z; a rotation turns it around +y.
  std::vector<glm::dvec2> azimuths;
  for (int x = 0; x < columns; ++x) {
    const double angle = 2.0 * pi * ((x + 0.5) / columns - 0.5) - picture.rotation_rad;
    azimuths.emplace_back(std::cos(angle), std::sin(angle));
  }
  Lattice lattice(cells);
  glm::dvec3 flux(0.0);
  for (int y = 0; y < rows; ++y) {
    const double middle = pi * (y + 0.5) / rows;
    const double solid_angle = (std::cos(pi * y / rows) - std::cos(pi * (y + 1) / rows)) * 2.0 * pi / columns;
    const glm::vec3* const texels =
        &picture.values[static_cast<std::size_t>(y / pieces) * static_cast<std::size_t>(picture.width)];
    for (int x = 0; x < columns; ++x) {
      const glm::dvec3 radiance = glm::dvec3(texels[x / pieces]) * picture.nits;
      const glm::dvec2& azimuth = azimuths[static_cast<std::size_t>(x)];
      lattice.add({azimuth.x * std::sin(middle), std::cos(middle), azimuth.y * std::sin(middle)}, radiance,
                  solid_angle);
      flux += radiance * solid_angle;
    }
  }
  lattice.join_rim();

  EnvironmentLattice result{.cells = cells, .radiance = lattice.means()};
  // The pieces meet the cells as they happen to, which leaves an error of some 1e-3.
  const glm::dvec3 mean = lattice.mean_of_blend(result.radiance);
  for (int c = 0; c < 3; ++c) {
    if (!(mean[c] > 0.0)) continue;
    const double correction = flux[c] / (4.0 * pi) / mean[c];
    for (glm::dvec3& radiance : result.radiance) radiance[c] *= correction;
  }
  return result;
}

}  // namespace vitrine
