// Surfaces to scatter from, described on the host.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "materials/bsdf.h"
#include "numeric/host_conversion.h"

namespace vitrine {

struct TestSurface {
  const char* name;
  glm::dvec3 diffuse{0.0};
  glm::dvec3 f0{0.0};
  double f90 = 0.0;
  glm::dvec3 transmit{0.0};
  Transmission transmission = Transmission::kThin;
  double eta = 1.5;
  double alpha = 0.3;
  bool smooth = false;
  glm::dvec3 sheen{0.0};
  double sheen_roughness = 0.5;
  double coat = 0.0;
  double coat_alpha = 0.2;
  bool coat_smooth = false;
};

/// Every combination of lobes that the importer can make, all rough.
inline std::vector<TestSurface> rough_surfaces() {
  const glm::dvec3 white(1.0);
  const glm::dvec3 dielectric(0.04);
  return {
      {.name = "lambert", .diffuse = {0.9, 0.5, 0.1}},
      {.name = "plastic", .diffuse = {0.2, 0.6, 0.7}, .f0 = dielectric, .f90 = 1.0},
      {.name = "gold", .f0 = {1.0, 0.77, 0.34}, .f90 = 1.0, .alpha = 0.1},
      {.name = "paper",
       .diffuse = {0.3, 0.3, 0.3},
       .f0 = dielectric,
       .f90 = 1.0,
       .transmit = {0.2, 0.5, 0.2},
       .alpha = 0.6},
      {.name = "thin glass", .f0 = dielectric, .f90 = 1.0, .transmit = white},
      {.name = "tinted wall", .transmit = {0.9, 0.2, 0.2}},
      {.name = "glass", .transmit = white, .transmission = Transmission::kRefract, .eta = 1.5},
      {.name = "out of glass", .transmit = white, .transmission = Transmission::kRefract, .eta = 1.0 / 1.5},
      {.name = "diamond",
       .transmit = {0.9, 0.9, 1.0},
       .transmission = Transmission::kRefract,
       .eta = 2.4,
       .alpha = 0.5},
      {.name = "milk glass",
       .diffuse = {0.4, 0.4, 0.4},
       .transmit = {0.5, 0.5, 0.5},
       .transmission = Transmission::kRefract,
       .eta = 1.3},
      {.name = "velvet", .diffuse = {0.2, 0.1, 0.5}, .sheen = {0.8, 0.9, 0.4}},
      {.name = "sharp sheen on paper",
       .diffuse = {0.3, 0.3, 0.3},
       .f0 = dielectric,
       .f90 = 1.0,
       .transmit = {0.2, 0.5, 0.2},
       .alpha = 0.6,
       .sheen = {1.0, 0.5, 1.0},
       .sheen_roughness = 0.15},
      {.name = "varnish",
       .diffuse = {0.4, 0.3, 0.1},
       .f0 = dielectric,
       .f90 = 1.0,
       .alpha = 0.6,
       .coat = 1.0},
      {.name = "coated milk glass",
       .diffuse = {0.4, 0.4, 0.4},
       .transmit = {0.5, 0.5, 0.5},
       .transmission = Transmission::kRefract,
       .eta = 1.3,
       .sheen = {0.3, 0.3, 0.6},
       .coat = 0.7,
       .coat_alpha = 0.5},
  };
}

template <class N>
SurfaceScattering<N> baked(const TestSurface& s) {
  using Unit = typename N::Unit;
  return {.diffuse = from_host<Unit>(s.diffuse),
          .f0 = from_host<Unit>(s.f0),
          .f90 = from_host<Unit>(s.f90),
          .transmit = from_host<Unit>(s.transmit),
          .transmission = s.transmission,
          .eta = from_host<Unit>(s.eta),
          .alpha = from_host<Unit>(s.alpha),
          .smooth = s.smooth,
          .sheen = {.color = from_host<Unit>(s.sheen),
                    .roughness = from_host<Unit>(s.sheen_roughness),
                    .albedo = s.sheen == glm::dvec3(0.0) ? nullptr : &SheenAlbedo<N>::table()},
          .coat = {.weight = from_host<Unit>(s.coat),
                   .alpha = from_host<Unit>(s.coat_alpha),
                   .smooth = s.coat_smooth}};
}

inline constexpr std::array kAllSamplings{DirectionSampling::kUniform, DirectionSampling::kCosine,
                                          DirectionSampling::kBrdf, DirectionSampling::kBrdfCosine};

/// The direction at an angle of this cosine to the normal.
inline glm::dvec3 at_cosine(double cosine, double phi = 0.7) {
  const double sine = std::sqrt(1.0 - cosine * cosine);
  return {sine * std::cos(phi), sine * std::sin(phi), cosine};
}

}  // namespace vitrine
