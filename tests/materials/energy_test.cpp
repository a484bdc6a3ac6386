// How much light surfaces give back: the albedo, as a white furnace shows it, by quadrature over all
// directions.
#include <gtest/gtest.h>

#include "materials/bsdf.h"
#include "materials/test_surfaces.h"
#include "number_systems.h"
#include "statistics/direction_bins.h"

namespace vitrine {
namespace {

constexpr std::array kCosines{1.0, 0.7, 0.3, 0.03};

template <class N>
class EnergyTest : public testing::Test {
 protected:
  /// Of the green channel. Where light is refracted it counts as power: radiance times eta^2.
  static double albedo(const TestSurface& surface, double cosine) {
    using Unit = typename N::Unit;
    const glm::dvec3 wo = at_cosine(cosine);
    const Bsdf<N> bsdf(baked<N>(surface), from_host<Unit>(wo));
    const auto f_cos = [&](const glm::dvec3& wi) { return to_host(bsdf.eval(from_host<Unit>(wi)).f_cos.y); };
    const double half_angle = std::min(1.5, 2.0 * surface.alpha);
    double sum = 0.0;
    for (const double cell :
         DirectionBins({-wo.x, -wo.y, wo.z}, half_angle).integrate([&](const glm::dvec3& wi) {
           return wi.z > 0.0 ? f_cos(wi) : 0.0;
         })) {
      sum += cell;
    }
    const double eta = surface.transmission == Transmission::kRefract ? surface.eta : 1.0;
    const double sine = std::min(0.999, std::sqrt(1.0 - cosine * cosine) / eta);
    const glm::dvec3 refracted = -at_cosine(std::sqrt(1.0 - sine * sine));
    for (const double cell : DirectionBins(refracted, half_angle).integrate([&](const glm::dvec3& wi) {
           return wi.z < 0.0 ? f_cos(wi) * eta * eta : 0.0;
         })) {
      sum += cell;
    }
    return sum;
  }
};
TYPED_TEST_SUITE(EnergyTest, NumberSystems, NumberSystemNames);

TYPED_TEST(EnergyTest, LambertIsItsAlbedo) {
  for (const double cosine : kCosines) {
    for (const double albedo : {1.0, 0.5, 0.02}) {
      EXPECT_NEAR(this->albedo({.name = "", .diffuse = glm::dvec3(albedo)}, cosine), albedo, 1e-4);
    }
  }
}

// What single scattering keeps of a lossless conductor: the integral over its visible facets, on a grid of
// 3000 x 3000 in double precision. At alpha 1, seen from above, it is 1 - ln 2.
TYPED_TEST(EnergyTest, LosslessConductorKeepsWhatSingleScatteringKeeps) {
  struct Row {
    double alpha, cosine, albedo;
  };
  for (const Row& row :
       {Row{0.10, 1.00, 0.988303}, Row{0.10, 0.50, 0.969215}, Row{0.10, 0.20, 0.904812},
        Row{0.25, 1.00, 0.915812}, Row{0.25, 0.50, 0.857263}, Row{0.25, 0.20, 0.848183},
        Row{0.50, 1.00, 0.687849}, Row{0.50, 0.20, 0.789929}, Row{1.00, 1.00, 1.0 - std::numbers::ln2},
        Row{1.00, 0.80, 0.351256}, Row{1.00, 0.20, 0.641648}}) {
    const TestSurface conductor{.name = "", .f0 = glm::dvec3(1.0), .f90 = 1.0, .alpha = row.alpha};
    EXPECT_NEAR(this->albedo(conductor, row.cosine), row.albedo, 3e-4) << row.alpha << ' ' << row.cosine;
  }
}

TYPED_TEST(EnergyTest, NoLobeGivesMoreThanItGets) {
  for (const double alpha : {0.001, 0.1, 1.0}) {
    for (const double cosine : kCosines) {
      const auto expect_no_gain = [&](TestSurface surface) {
        surface.alpha = alpha;
        EXPECT_LE(this->albedo(surface, cosine), 1.0 + 5e-4) << surface.name << ' ' << alpha << ' ' << cosine;
      };
      const glm::dvec3 white(1.0);
      expect_no_gain({.name = "conductor", .f0 = white, .f90 = 1.0});
      expect_no_gain({.name = "thin wall", .transmit = white});
      expect_no_gain({.name = "thin glass", .f0 = glm::dvec3(0.04), .f90 = 1.0, .transmit = white});
      for (const double eta : {1.5, 1.0 / 1.5, 2.4}) {
        expect_no_gain(
            {.name = "glass", .transmit = white, .transmission = Transmission::kRefract, .eta = eta});
      }
    }
  }
}

// A coat and a sheen take from below what they give: over a base that loses nothing, nothing is gained, and
// over a rough one no more than was lost.
TYPED_TEST(EnergyTest, NoLayerGivesMoreThanItTakes) {
  const glm::dvec3 white(1.0);
  for (const double cosine : {1.0, 0.3, 0.03}) {
    const auto expect_no_gain = [&](const TestSurface& surface) {
      EXPECT_LE(this->albedo(surface, cosine), 1.0 + 2e-3)
          << surface.name << ' ' << surface.coat_alpha << ' ' << surface.sheen_roughness << ' ' << cosine;
    };
    for (const double rough : {0.1, 0.5}) {
      const double alpha = rough * rough;
      expect_no_gain({.name = "coated Lambert", .diffuse = white, .coat = 1.0, .coat_alpha = alpha});
      expect_no_gain({.name = "coated conductor", .f0 = white, .f90 = 1.0, .coat = 0.5, .coat_alpha = alpha});
      expect_no_gain({.name = "sheen alone", .sheen = white, .sheen_roughness = rough});
      expect_no_gain({.name = "velvet", .diffuse = white, .sheen = white, .sheen_roughness = rough});
      expect_no_gain(
          {.name = "faint sheen", .diffuse = white, .sheen = white * 0.3, .sheen_roughness = rough});
      expect_no_gain({.name = "all",
                      .diffuse = white * 0.5,
                      .transmit = white * 0.5,
                      .sheen = white,
                      .sheen_roughness = rough,
                      .coat = 1.0,
                      .coat_alpha = alpha});
    }
    // and what is taken comes back: a smooth coat, which eval() does not see, reflects exactly its share
    const TestSurface enamel{.name = "", .diffuse = white, .coat = 1.0, .coat_smooth = true};
    const double coat = 0.04 + 0.96 * std::pow(1.0 - cosine, 5);
    EXPECT_LE(this->albedo(enamel, cosine), 1.0 - coat + 1e-4) << cosine;
    EXPECT_GE(this->albedo(enamel, cosine), 0.9 * (1.0 - coat)) << cosine;
  }
}

// glTF takes from the Lambert lobe what a facet between wo and wi would reflect. At grazing angles that is
// less than the surface does reflect, so the model itself gains there: white plastic up to 80 % at 2 degrees
// above the surface.
TYPED_TEST(EnergyTest, GltfsMixGainsAtGrazingAnglesOnly) {
  for (const double alpha : {0.001, 0.1, 1.0}) {
    const TestSurface plastic{
        .name = "", .diffuse = glm::dvec3(1.0), .f0 = glm::dvec3(0.04), .f90 = 1.0, .alpha = alpha};
    TestSurface coat = plastic;
    coat.diffuse = glm::dvec3(0.0);
    for (const double cosine : kCosines) {
      const double albedo = this->albedo(plastic, cosine);
      EXPECT_LE(albedo, cosine >= 0.7 ? 1.002 : 1.0 + this->albedo(coat, cosine)) << alpha << ' ' << cosine;
      EXPECT_GE(albedo, 0.97) << alpha << ' ' << cosine;
    }
  }
}

}  // namespace
}  // namespace vitrine
