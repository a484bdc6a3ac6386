// Charlie alone: against the paper's formulas, and how much it scatters in all.
#include "materials/sheen.h"

#include <gtest/gtest.h>

#include "materials/sheen_albedo.h"
#include "materials/textbook_charlie.h"
#include "number_systems.h"
#include "numeric/host_conversion.h"
#include "statistics/direction_bins.h"
#include "statistics/random_inputs.h"

namespace vitrine {
namespace {

template <class N>
class SheenTest : public testing::Test {
 protected:
  static double f_cos(const Charlie<N>& charlie, const glm::dvec3& wo, const glm::dvec3& wi) {
    using Unit = typename N::Unit;
    return to_host(eval_sheen(charlie, Vec3<Unit>(1), from_host<Unit>(wo), from_host<Unit>(wi)).scale);
  }
};
TYPED_TEST_SUITE(SheenTest, NumberSystems, NumberSystemNames);

TYPED_TEST(SheenTest, IsThePapers) {
  using Unit = typename TypeParam::Unit;
  RandomInputs random(1);
  for (int i = 0; i < 50000; ++i) {
    const auto roughness = from_host<Unit>(random.uniform(0.1, 1.0));
    const double alpha = to_host(roughness) * to_host(roughness);
    const glm::dvec3 wo = random.upwards(0.01);
    const glm::dvec3 wi = random.upwards(0.01);
    const double exact = textbook::sheen_f_cos(wo, wi, alpha);
    if (exact < 1e-12) continue;
    ASSERT_NEAR(this->f_cos(Charlie<TypeParam>(roughness), wo, wi), exact,
                exact * bound<TypeParam>(1e-4, 2e-6) + 1e-8)
        << alpha << ' ' << wo.z << ' ' << wi.z;
  }
}

TYPED_TEST(SheenTest, BelowTheLeastRoughnessNothingChanges) {
  using Unit = typename TypeParam::Unit;
  const glm::dvec3 wo = glm::normalize(glm::dvec3(0.9, 0.1, 0.05));
  const glm::dvec3 wi = glm::normalize(glm::dvec3(-0.9, 0.2, 0.07));
  EXPECT_EQ(this->f_cos(Charlie<TypeParam>(Unit(0)), wo, wi),
            this->f_cos(Charlie<TypeParam>(Unit(0.1)), wo, wi));
  EXPECT_GT(this->f_cos(Charlie<TypeParam>(Unit(0)), wo, wi), 0.0);
}

// The table against the integral, also between its points. Where it errs, it may rather say too much: then
// what lies below is dimmed more than it need be.
TYPED_TEST(SheenTest, AlbedoIsTheIntegral) {
  using Unit = typename TypeParam::Unit;
  for (const double roughness : {0.1, 0.17, 0.35, 0.6, 0.83, 1.0}) {
    const Charlie<TypeParam> charlie(from_host<Unit>(roughness));
    for (const double cosine : {0.005, 0.02, 0.1, 0.3, 0.77, 1.0}) {
      const glm::dvec3 wo(std::sqrt(1.0 - cosine * cosine), 0.0, cosine);
      double albedo = 0.0;
      for (const double cell : DirectionBins({0, 0, 1}).integrate(
               [&](const glm::dvec3& wi) { return wi.z > 0.0 ? this->f_cos(charlie, wo, wi) : 0.0; })) {
        albedo += cell;
      }
      const double table =
          to_host(SheenAlbedo<TypeParam>::table()(from_host<Unit>(cosine), from_host<Unit>(roughness)));
      EXPECT_LE(table, albedo + 0.012) << roughness << ' ' << cosine;
      EXPECT_GE(table, albedo - 0.008 * std::max(1.0, albedo)) << roughness << ' ' << cosine;
    }
  }
}

}  // namespace
}  // namespace vitrine
