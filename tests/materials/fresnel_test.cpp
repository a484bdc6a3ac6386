#include "materials/fresnel.h"

#include <gtest/gtest.h>

#include "materials/test_surfaces.h"
#include "materials/textbook_ggx.h"
#include "number_systems.h"
#include "statistics/random_inputs.h"

namespace vitrine {
namespace {

template <class N>
class FresnelTest : public testing::Test {};
TYPED_TEST_SUITE(FresnelTest, NumberSystems, NumberSystemNames);

TYPED_TEST(FresnelTest, DielectricIsTheClosedForm) {
  using Unit = typename TypeParam::Unit;
  RandomInputs random(1);
  for (int i = 0; i < 300000; ++i) {
    const auto eta = from_host<Unit>(random.log_uniform(1.0 / 2.9, 2.9));
    const auto cosine = from_host<Unit>(random.uniform());
    const double sin_t = std::sqrt(1.0 - std::pow(to_host(cosine), 2)) / to_host(eta);
    const DielectricFresnel<Unit> result = fresnel_dielectric(cosine, eta);
    const double exact = textbook::fresnel(to_host(cosine), to_host(eta));
    // Where total reflection begins, cos_t is the root of a difference: an error in its square is doubled
    // over cos_t.
    const double square_error = bound<TypeParam>(1e-6, 2e-8);
    const double cos_t = sin_t < 1.0 ? std::sqrt(1.0 - sin_t * sin_t) : 0.0;
    const double cos_t_error = std::min(std::sqrt(square_error), square_error / std::max(cos_t, 1e-12));
    ASSERT_NEAR(to_host(result.cos_t), cos_t, cos_t_error) << to_host(cosine) << ' ' << to_host(eta);
    ASSERT_NEAR(to_host(result.reflectance), exact, 10.0 * cos_t_error)
        << to_host(cosine) << ' ' << to_host(eta);
    ASSERT_TRUE(result.reflectance >= 0 && !(result.reflectance > Unit(1.000001)));
  }
}

TYPED_TEST(FresnelTest, DielectricAtItsEnds) {
  using Unit = typename TypeParam::Unit;
  const double tolerance = bound<TypeParam>(1e-6, 1e-8);
  const auto reflectance = [](double cosine, double eta) {
    return to_host(fresnel_dielectric(from_host<Unit>(cosine), from_host<Unit>(eta)).reflectance);
  };
  EXPECT_NEAR(reflectance(1.0, 1.5), 0.04, tolerance);
  EXPECT_NEAR(reflectance(1.0, 1.0 / 1.5), 0.04, tolerance);
  EXPECT_NEAR(reflectance(0.0, 1.5), 1.0, tolerance);
  EXPECT_EQ(reflectance(0.0, 1.0 / 1.5), 1.0);
  EXPECT_EQ(reflectance(0.7, 1.0 / 1.5), 1.0) << "total reflection: the critical cosine is 0.745";
  EXPECT_LT(reflectance(0.75, 1.0 / 1.5), 0.8);
  EXPECT_NEAR(reflectance(0.3, 1.0), 0.0, 1e-6) << "no boundary";
}

TYPED_TEST(FresnelTest, Schlick) {
  using Unit = typename TypeParam::Unit;
  RandomInputs random(2);
  for (int i = 0; i < 10000; ++i) {
    const auto f0 = from_host<Unit>(glm::dvec3(random.uniform(), random.uniform(), random.uniform()));
    const auto f90 = from_host<Unit>(random.uniform());
    const auto cosine = from_host<Unit>(random.uniform());
    const glm::dvec3 result = to_host(fresnel_schlick(f0, f90, cosine));
    for (int c = 0; c < 3; ++c) {
      ASSERT_NEAR(result[c], textbook::schlick(to_host(f0[c]), to_host(f90), to_host(cosine)),
                  bound<TypeParam>(4e-7, 2e-8));
    }
  }
  const Vec3<Unit> f0(Unit(0.04), Unit(0.5), Unit(1));
  EXPECT_EQ(fresnel_schlick(f0, Unit(1), Unit(1)), f0);
  EXPECT_LE(glm::length(to_host(fresnel_schlick(f0, Unit(1), Unit(0))) - 1.0), 1e-6);
}

TYPED_TEST(FresnelTest, DirectionsObeyTheirLaws) {
  using Unit = typename TypeParam::Unit;
  RandomInputs random(3);
  const double tolerance = bound<TypeParam>(2e-6, 5e-8);
  for (int i = 0; i < 50000; ++i) {
    const glm::dvec3 facet = random.direction();
    glm::dvec3 to_viewer = random.direction();
    if (glm::dot(facet, to_viewer) < 0.0) to_viewer = -to_viewer;
    const auto h = from_host<Unit>(facet);
    const auto wo = from_host<Unit>(to_viewer);
    const Unit cos_o = dot(wo, h);
    const glm::dvec3 mirrored = to_host(reflect(wo, h, cos_o));
    ASSERT_LE(glm::length(mirrored - (2.0 * glm::dot(facet, to_viewer) * facet - to_viewer)), tolerance);
    const auto eta = from_host<Unit>(random.log_uniform(1.0 / 2.9, 2.9));
    const Unit cos_t = fresnel_dielectric(cos_o, eta).cos_t;
    if (!(cos_t > Unit(0.05))) continue;
    const glm::dvec3 wi = to_host(refract(wo, h, cos_o, cos_t, eta));
    ASSERT_NEAR(glm::length(wi), 1.0, tolerance);
    ASSERT_LT(glm::dot(wi, facet), 0.0);
    // Snell: the tangential parts are opposite and in the ratio of the indices.
    const glm::dvec3 tangent_o = to_viewer - facet * glm::dot(to_viewer, facet);
    const glm::dvec3 tangent_i = wi - facet * glm::dot(wi, facet);
    ASSERT_LE(glm::length(tangent_o + tangent_i * to_host(eta)), 20.0 * tolerance);
  }
}

}  // namespace
}  // namespace vitrine
