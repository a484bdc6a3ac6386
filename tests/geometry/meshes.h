// Meshes to shoot at.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include "geometry/bvh.h"
#include "numeric/host_conversion.h"
#include "statistics/random_inputs.h"

namespace vitrine {

struct TestMesh {
  std::vector<glm::dvec3> positions;
  std::vector<glm::uvec3> triangles;

  /// Each once, by its two vertices.
  [[nodiscard]] std::vector<glm::uvec2> edges() const {
    std::vector<glm::uvec2> result;
    for (const glm::uvec3& t : triangles) {
      for (int i = 0; i < 3; ++i) {
        if (t[i] < t[(i + 1) % 3]) result.emplace_back(t[i], t[(i + 1) % 3]);
      }
    }
    return result;
  }
};

/// In number system N's lengths.
template <class N>
std::vector<Vec3<typename N::Length>> baked_positions(const TestMesh& mesh) {
  std::vector<Vec3<typename N::Length>> result;
  for (const glm::dvec3& p : mesh.positions) result.push_back(from_host<typename N::Length>(p));
  return result;
}

/// A sphere: the icosahedron, each of whose triangles is cut into four `levels` times. Closed, convex.
inline TestMesh icosphere(int levels, double radius) {
  const double golden = (1.0 + std::sqrt(5.0)) / 2.0;
  TestMesh mesh;
  for (const double a : {-1.0, 1.0}) {
    for (const double b : {-golden, golden}) {
      mesh.positions.insert(mesh.positions.end(), {{a, b, 0.0}, {0.0, a, b}, {b, 0.0, a}});
    }
  }
  // The faces of the convex hull: the triples of neighbours, at distance 2.
  const auto neighbours = [&](std::uint32_t i, std::uint32_t j) {
    return std::abs(glm::distance(mesh.positions[i], mesh.positions[j]) - 2.0) < 1e-9;
  };
  for (std::uint32_t i = 0; i < 12; ++i) {
    for (std::uint32_t j = i + 1; j < 12; ++j) {
      for (std::uint32_t k = j + 1; k < 12; ++k) {
        if (!neighbours(i, j) || !neighbours(j, k) || !neighbours(k, i)) continue;
        const auto& p = mesh.positions;
        const bool outwards = glm::dot(glm::cross(p[j] - p[i], p[k] - p[i]), p[i]) > 0.0;
        mesh.triangles.push_back(outwards ? glm::uvec3(i, j, k) : glm::uvec3(i, k, j));
      }
    }
  }
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [at, added] = middles.try_emplace(std::minmax(a, b), mesh.positions.size());
      if (added) mesh.positions.push_back(glm::normalize(mesh.positions[a] + mesh.positions[b]));
      return at->second;
    };
    for (glm::dvec3& p : mesh.positions) p = glm::normalize(p);
    std::vector<glm::uvec3> finer;
    for (const glm::uvec3& t : mesh.triangles) {
      const glm::uvec3 m(middle(t.x, t.y), middle(t.y, t.z), middle(t.z, t.x));
      finer.insert(finer.end(), {{t.x, m.x, m.z}, {t.y, m.y, m.x}, {t.z, m.z, m.y}, m});
    }
    mesh.triangles = std::move(finer);
  }
  for (glm::dvec3& p : mesh.positions) p = glm::normalize(p) * radius;
  return mesh;
}

/// A box, each of whose faces is a grid of `cells` x `cells` pairs of triangles. Closed, convex.
inline TestMesh box(const glm::dvec3& half_extent, int cells) {
  TestMesh mesh;
  std::map<std::array<int, 3>, std::uint32_t> vertices;
  const auto vertex = [&](const std::array<int, 3>& at) {
    const auto [found, added] = vertices.try_emplace(at, mesh.positions.size());
    if (added) {
      const glm::dvec3 p(at[0], at[1], at[2]);
      mesh.positions.push_back((p * 2.0 / static_cast<double>(cells) - 1.0) * half_extent);
    }
    return found->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const int side : {0, cells}) {
      for (int i = 0; i < cells; ++i) {
        for (int j = 0; j < cells; ++j) {
          const auto corner = [&](int di, int dj) {
            std::array<int, 3> at{};
            at[axis] = side;
            at[(axis + 1) % 3] = i + di;
            at[(axis + 2) % 3] = j + dj;
            return vertex(at);
          };
          const std::uint32_t a = corner(0, 0);
          const std::uint32_t b = side == 0 ? corner(0, 1) : corner(1, 0);
          const std::uint32_t c = corner(1, 1);
          const std::uint32_t d = side == 0 ? corner(1, 0) : corner(0, 1);
          mesh.triangles.insert(mesh.triangles.end(), {{a, b, c}, {a, c, d}});
        }
      }
    }
  }
  return mesh;
}

/// `count` triangles anywhere within +-1, of all sizes up to `size`.
inline TestMesh soup(std::size_t count, double size, std::uint64_t seed) {
  RandomInputs random(seed);
  TestMesh mesh;
  for (std::uint32_t i = 0; i < count; ++i) {
    const glm::dvec3 center = random.in_cube(1.0 - size);
    const double reach = random.uniform(0.0, size);
    for (int corner = 0; corner < 3; ++corner) mesh.positions.push_back(center + random.in_cube(reach));
    mesh.triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
  }
  return mesh;
}

}  // namespace vitrine
