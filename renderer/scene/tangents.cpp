#include "scene/tangents.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vitrine {
namespace {

constexpr std::uint32_t kNone = 0xffffffffU;

template <class T>
void repeat(std::vector<T>& of_vertices, std::uint32_t vertex) {
  if (of_vertices.empty()) return;
  const T copy = of_vertices[vertex];
  of_vertices.push_back(copy);
}

// A copy of a vertex; returns its index.
std::uint32_t split(Primitive& primitive, std::uint32_t vertex) {
  repeat(primitive.positions, vertex);
  repeat(primitive.normals, vertex);
  for (auto& uv : primitive.uv) repeat(uv, vertex);
  repeat(primitive.colors, vertex);
  repeat(primitive.alphas, vertex);
  return static_cast<std::uint32_t>(primitive.positions.size()) - 1;
}

// Flat triangles do not share what depends on their normal.
void separate_triangles(Primitive& primitive) {
  std::vector<bool> used(primitive.positions.size(), false);
  for (glm::uvec3& triangle : primitive.triangles) {
    for (int corner = 0; corner < 3; ++corner) {
      if (used[triangle[corner]]) {
        triangle[corner] = split(primitive, triangle[corner]);
      } else {
        used[triangle[corner]] = true;
      }
    }
  }
}

struct TriangleTangent {
  glm::dvec3 along_u{0.0};  // unit, or 0
  std::size_t side = 0;     // 0: cross(normal, along_u) points along falling v; 1: mirrored
};

TriangleTangent tangent_of(const Primitive& primitive, const TextureUse& use, const glm::uvec3& triangle) {
  const auto& uv = primitive.uv[static_cast<std::size_t>(use.texcoord)];
  if (uv.empty()) return {};
  const auto position = [&](std::uint32_t i) { return glm::dvec3(primitive.positions[i]); };
  const auto coordinate = [&](std::uint32_t i) {
    return glm::dvec2(glm::dmat3(use.transform) * glm::dvec3(glm::dvec2(uv[i]), 1.0));
  };
  const glm::dvec3 edge_1 = position(triangle.y) - position(triangle.x);
  const glm::dvec3 edge_2 = position(triangle.z) - position(triangle.x);
  const glm::dvec2 step_1 = coordinate(triangle.y) - coordinate(triangle.x);
  const glm::dvec2 step_2 = coordinate(triangle.z) - coordinate(triangle.x);
  const double area = step_1.x * step_2.y - step_2.x * step_1.y;  // v points down: negative where unmirrored
  const glm::dvec3 along_u = (edge_1 * step_2.y - edge_2 * step_1.y) * (area < 0.0 ? -1.0 : 1.0);
  const double length = glm::length(along_u);
  if (area == 0.0 || !(length > 0.0)) return {};
  return {along_u / length, area < 0.0 ? 0U : 1U};
}

double angle_at(const Primitive& primitive, const glm::uvec3& triangle, int corner) {
  const auto from = [&](int to) {
    return glm::normalize(glm::dvec3(primitive.positions[triangle[to % 3]]) -
                          glm::dvec3(primitive.positions[triangle[corner]]));
  };
  return std::acos(std::clamp(glm::dot(from(corner + 1), from(corner + 2)), -1.0, 1.0));
}

glm::dvec3 unit_or_zero(const glm::dvec3& v) {
  const double length = glm::length(v);
  return length > 0.0 ? v / length : glm::dvec3(0.0);
}

}  // namespace

Primitive with_tangents(Primitive primitive, const TextureUse& normal_map) {
  if (primitive.normals.empty()) separate_triangles(primitive);
  struct Side {
    std::uint32_t vertex = kNone;
    glm::dvec3 sum{0.0};
  };
  std::vector<std::array<Side, 2>> sides(primitive.positions.size());
  for (glm::uvec3& triangle : primitive.triangles) {
    const TriangleTangent tangent = tangent_of(primitive, normal_map, triangle);
    std::array<std::uint32_t, 3> vertices{};
    for (int corner = 0; corner < 3; ++corner) {
      const std::uint32_t shared = triangle[corner];
      Side& side = sides[shared][tangent.side];
      if (side.vertex == kNone) {
        const bool taken = sides[shared][1 - tangent.side].vertex != kNone;
        side.vertex = taken ? split(primitive, shared) : shared;
      }
      vertices[static_cast<std::size_t>(corner)] = side.vertex;
      glm::dvec3 along_u = tangent.along_u;
      if (!primitive.normals.empty()) {
        const glm::dvec3 normal(primitive.normals[shared]);
        along_u = unit_or_zero(along_u - normal * glm::dot(normal, along_u));
      }
      side.sum += along_u * angle_at(primitive, triangle, corner);
    }
    triangle = {vertices[0], vertices[1], vertices[2]};
  }
  primitive.tangents.assign(primitive.positions.size(), glm::vec4(0.0F));
  for (const auto& both : sides) {
    for (std::size_t side = 0; side < 2; ++side) {
      if (both[side].vertex == kNone) continue;
      primitive.tangents[both[side].vertex] =
          glm::vec4(glm::vec3(unit_or_zero(both[side].sum)), side == 0 ? 1.0F : -1.0F);
    }
  }
  return primitive;
}

}  // namespace vitrine
