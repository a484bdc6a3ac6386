// Random lights of every kind, as a list to sample from and as what light selection is told of them.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "lights/light_emission.h"
#include "lights/light_list.h"
#include "numeric/host_conversion.h"
#include "statistics/random_inputs.h"

namespace vitrine {

template <class N>
class LightsOfAllKinds {
  using Unit = typename N::Unit;
  using Length = typename N::Length;
  using Radiance = typename N::Radiance;

 public:
  LightList<N> list;
  std::vector<LightEmission> emissions;  ///< by index of the list

  LightsOfAllKinds() = default;
  LightsOfAllKinds(RandomInputs& random, std::uint32_t count) {
    for (std::uint32_t i = 0; i < count; ++i) {
      switch (random.index(6)) {
        case 0:
          add_point(random.in_cube());
          break;
        case 1:
          add_spot(random);
          break;
        case 2:
          add_sun(random.direction());
          break;
        case 3:
          add_octahedron(random.in_cube(), random.log_uniform(0.003, 0.3));
          break;
        default: {
          const glm::dvec3 corner = random.in_cube();
          const double size = random.log_uniform(0.003, 1.0);
          add_quad(corner, random.direction() * size, random.direction() * size * random.uniform(0.05, 1.0),
                   random.index(2) == 0);
        }
      }
    }
    finish(random.index(3) == 0 ? std::optional(0.1) : std::nullopt);
  }
  static LightsOfAllKinds points(RandomInputs& random, std::uint32_t count) {
    LightsOfAllKinds lights;
    for (std::uint32_t i = 0; i < count; ++i) lights.add_point(random.in_cube());
    lights.finish({});
    return lights;
  }

  void add_point(const glm::dvec3& position) {
    list.points.push_back({.position = from_host<Length>(position), .intensity = grey(0.1)});
    points_.push_back(point_emission(to_host(list.points.back().position), 0.1));
  }
  void add_quad(const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v, bool two_sided) {
    add_mesh({{corner, corner + u, corner + u + v}, {corner, corner + u + v, corner + v}}, two_sided);
  }
  /// Once all are added; with an environment of that radiance.
  void finish(std::optional<double> sky) {
    for (const auto& group : {meshes_, points_, suns_})
      emissions.insert(emissions.end(), group.begin(), group.end());
    if (!sky) return;
    list.sky = Sky<N>(grey(*sky), grey(*sky), grey(*sky));
    emissions.push_back(environment_emission(*sky, 1.0));
  }

  /// Close to the light, as far as it is anywhere.
  Vec3<Length> place_near(RandomInputs& random, std::uint32_t light) const {
    if (emissions[light].is_far()) return from_host<Length>(random.in_cube());
    const Bounds& bounds = emissions[light].bounds;
    const double reach = emissions[light].radius + random.log_uniform(1e-4, 0.1);
    return from_host<Length>(0.5 * (bounds.low + bounds.high) +
                             random.direction() * reach * random.uniform());
  }

 private:
  static Vec3<Radiance> grey(double x) { return from_host<Radiance>(glm::dvec3(x)); }

  void add_spot(RandomInputs& random) {
    const double outer = random.uniform(0.05, 1.57);
    const double inner = outer * random.uniform(0.0, 0.99);
    add_point(random.in_cube());
    PointLight<N>& light = list.points.back();
    light.spot = true;
    light.axis = from_host<Unit>(random.direction());
    light.cos_outer = from_host<Unit>(std::cos(outer));
    light.cone_scale = from_host<typename N::Density>(1.0 / (std::cos(inner) - std::cos(outer)));
    points_.back() =
        spot_emission(to_host(light.position), 0.1, to_host(light.axis), std::cos(inner), std::cos(outer));
  }
  void add_sun(const glm::dvec3& wi) {
    list.directional.push_back({from_host<Unit>(wi), grey(0.1)});
    suns_.push_back(directional_emission(to_host(list.directional.back().wi), 0.1, 1.0));
  }
  void add_octahedron(const glm::dvec3& center, double radius) {
    std::vector<std::array<glm::dvec3, 3>> faces;
    for (unsigned i = 0; i < 8; ++i) {
      const auto corner = [&](int axis) {
        glm::dvec3 p = center;
        p[axis] += (i >> axis & 1U) != 0 ? radius : -radius;
        return p;
      };
      const bool odd = (std::popcount(i) & 1) != 0;
      faces.push_back({corner(0), corner(odd ? 1 : 2), corner(odd ? 2 : 1)});
    }
    add_mesh(faces, false);
  }
  void add_mesh(const std::vector<std::array<glm::dvec3, 3>>& triangles, bool two_sided) {
    std::vector<EmissiveTriangle<N>> emissive;
    std::vector<LightFacet> facets;
    for (const auto& [a, b, c] : triangles) {
      const glm::dvec3 across = glm::cross(b - a, c - a);
      const double area = 0.5 * glm::length(across);
      emissive.push_back({from_host<Length>(a), from_host<Length>(b - a), from_host<Length>(c - a),
                          from_host<Unit>(glm::normalize(across)), 0, area});
      facets.push_back({{a, b, c}, glm::normalize(across), area, 1.0});
    }
    list.meshes.push_back(MeshLight<N>(std::move(emissive), two_sided));
    meshes_.push_back(mesh_emission(facets, two_sided));
  }

  std::vector<LightEmission> meshes_;
  std::vector<LightEmission> points_;
  std::vector<LightEmission> suns_;
};

}  // namespace vitrine
