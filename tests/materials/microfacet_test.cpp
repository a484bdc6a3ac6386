// The GGX lobes, each alone: against the papers' equations, and their samples against their densities.
#include <gtest/gtest.h>

#include "materials/microfacet_reflection.h"
#include "materials/microfacet_transmission.h"
#include "materials/test_surfaces.h"
#include "materials/textbook_ggx.h"
#include "number_systems.h"
#include "statistics/direction_bins.h"
#include "statistics/random_inputs.h"

namespace vitrine {
namespace {

constexpr std::uint32_t kSamples = 150000;
constexpr std::array kAlphas{0.001, 0.03, 0.3, 1.0};
constexpr std::array kCosines{0.95, 0.5, 0.1};
constexpr std::array kEtas{1.5, 1.0 / 1.5, 2.4};
constexpr int kComparisons = 2 * (2 * 4 * 3 + 3 * 3 * 3 + 3 * 2);

template <class N>
class MicrofacetTest : public testing::Test {
 protected:
  using Direction = Vec3<typename N::Unit>;

  static LobeValue<N> eval_reflection(const Ggx<N>& ggx, const Direction& wo, const Direction& wi) {
    return eval_microfacet_reflection(ggx, wo, wi, [](typename N::Unit) { return Direction(1); });
  }
  static void expect_relative(double value, double exact, double tolerance, const std::string& where) {
    ASSERT_NEAR(value, exact, exact * tolerance + 1e-12) << where;
  }
  // A narrow lobe turns the rounding of its half vector into an error of its height.
  static double tolerance(double alpha, double least) { return least + bound<N>(2e-6, 4e-8) / alpha; }
};
TYPED_TEST_SUITE(MicrofacetTest, NumberSystems, NumberSystemNames);

TYPED_TEST(MicrofacetTest, ReflectionIsThePapers) {
  using Unit = typename TypeParam::Unit;
  RandomInputs random(1);
  for (int i = 0; i < 100000; ++i) {
    const double alpha = random.log_uniform(0.001, 1.0);
    const glm::dvec3 exact_wo = random.upwards(0.02);
    // half of the pairs near the mirror direction, where the lobe is
    glm::dvec3 exact_wi = random.upwards(0.02);
    if (i % 2 == 0)
      exact_wi = glm::normalize(glm::dvec3(-exact_wo.x, -exact_wo.y, exact_wo.z) + random.in_cube(alpha));
    if (exact_wi.z < 0.02) continue;
    const auto wo = from_host<Unit>(exact_wo);
    const auto wi = from_host<Unit>(exact_wi);
    const auto a = from_host<Unit>(alpha);
    const LobeValue<TypeParam> value = this->eval_reflection(Ggx<TypeParam>(a), wo, wi);
    const textbook::Lobe exact = textbook::reflection(to_host(wo), to_host(wi), to_host(a));
    const double tolerance = this->tolerance(alpha, bound<TypeParam>(2e-5, 2e-6));
    const std::string where = std::to_string(alpha) + ' ' + std::to_string(exact_wo.z);
    this->expect_relative(to_host(value.scale), exact.f_cos, tolerance, where);
    this->expect_relative(to_host(value.pdf_w), exact.pdf_w, tolerance, where);
  }
}

TYPED_TEST(MicrofacetTest, TransmissionIsThePapers) {
  using Unit = typename TypeParam::Unit;
  RandomInputs random(2);
  int lit = 0;
  for (int i = 0; i < 100000; ++i) {
    const double alpha = random.log_uniform(0.01, 1.0);
    const double eta = random.index(2) == 0 ? random.uniform(1.1, 2.9) : 1.0 / random.uniform(1.1, 2.9);
    const auto wo = from_host<Unit>(random.upwards(0.05));
    const auto wi = from_host<Unit>(-random.upwards(0.05));
    const auto a = from_host<Unit>(alpha);
    const auto e = from_host<Unit>(eta);
    const textbook::Lobe exact = textbook::transmission(to_host(wo), to_host(wi), to_host(e), to_host(a));
    const glm::dvec3 h = glm::normalize(to_host(wi) * to_host(e) + to_host(wo));
    const double cos_o = std::abs(glm::dot(h, to_host(wo)));
    const double cos_i = std::abs(glm::dot(h, to_host(wi)));
    if (std::min({cos_o, cos_i, std::abs(h.z)}) < 0.05)
      continue;  // where the lobe begins or Fresnel's term is steep
    const LobeValue<TypeParam> value =
        eval_microfacet_transmission(Ggx<TypeParam>(a), Vec3<Unit>(1), e, wo, wi);
    const double tolerance = this->tolerance(alpha, bound<TypeParam>(3e-4, 5e-6));
    const std::string where = std::to_string(alpha) + ' ' + std::to_string(eta) + ' ' + std::to_string(cos_i);
    this->expect_relative(to_host(value.tint.x) * to_host(value.scale), exact.f_cos, tolerance, where);
    this->expect_relative(to_host(value.pdf_w), exact.pdf_w, tolerance, where);
    lit += exact.f_cos > 0.0;
  }
  EXPECT_GT(lit, 10000);
}

// Over the whole sphere, with the directions that leave below the surface: there are facets for them too.
TYPED_TEST(MicrofacetTest, ReflectionSamplesByItsDensity) {
  using Unit = typename TypeParam::Unit;
  for (const double alpha : kAlphas) {
    for (const double cosine : kCosines) {
      const auto wo = from_host<Unit>(at_cosine(cosine));
      const Ggx<TypeParam> ggx(from_host<Unit>(alpha));
      const DirectionBins bins({-to_host(wo.x), -to_host(wo.y), to_host(wo.z)}, std::min(1.5, 2.0 * alpha));
      const DirectionComparison result = compare_directions(
          bins, kSamples,
          [&](Sampler& sampler) {
            const auto u = sampler.next<TypeParam>();
            const auto v = sampler.next<TypeParam>();
            return std::optional(to_host(sample_microfacet_reflection(ggx, wo, u, v)));
          },
          [&](const glm::dvec3& w) {
            const auto wi = from_host<Unit>(w);
            return wi.z + wo.z > 0 ? to_host(this->eval_reflection(ggx, wo, wi).pdf_w) : 0.0;
          });
      EXPECT_NEAR(result.integral, 1.0, 1e-3) << alpha << ' ' << cosine;
      EXPECT_GT(result.chi_square.p_value, sidak(kComparisons)) << alpha << ' ' << cosine;
      EXPECT_GT(result.chi_square.degrees, 100) << alpha << ' ' << cosine;
    }
  }
}

TYPED_TEST(MicrofacetTest, TransmissionSamplesByItsDensity) {
  using Unit = typename TypeParam::Unit;
  for (const double alpha : {0.03, 0.3, 1.0}) {
    for (const double cosine : kCosines) {
      for (const double eta : kEtas) {
        const auto wo = from_host<Unit>(at_cosine(cosine));
        const auto e = from_host<Unit>(eta);
        const Ggx<TypeParam> ggx(from_host<Unit>(alpha));
        const double sine_ratio = std::min(0.99, std::sqrt(1.0 - cosine * cosine) / eta);
        const glm::dvec3 refracted = -at_cosine(std::sqrt(1.0 - sine_ratio * sine_ratio));
        const DirectionBins bins(refracted, std::min(1.0, 2.0 * alpha));
        const DirectionComparison result = compare_directions(
            bins, kSamples,
            [&](Sampler& sampler) -> std::optional<glm::dvec3> {
              const auto u = sampler.next<TypeParam>();
              const auto v = sampler.next<TypeParam>();
              const auto wi = sample_microfacet_transmission(ggx, e, wo, u, v);
              return wi ? std::optional(to_host(*wi)) : std::nullopt;
            },
            [&](const glm::dvec3& w) {
              return to_host(
                  eval_microfacet_transmission(ggx, Vec3<Unit>(1), e, wo, from_host<Unit>(w)).pdf_w);
            });
        EXPECT_LT(result.integral, 1.001) << alpha << ' ' << cosine << ' ' << eta;
        EXPECT_GT(result.chi_square.p_value, sidak(kComparisons)) << alpha << ' ' << cosine << ' ' << eta;
      }
    }
  }
}

// By all facets, seen or not: what looks away from wo reflects nothing.
TYPED_TEST(MicrofacetTest, AnyFacetsSampleByTheirDensity) {
  using Unit = typename TypeParam::Unit;
  for (const double alpha : kAlphas) {
    for (const double cosine : kCosines) {
      const auto wo = from_host<Unit>(at_cosine(cosine));
      const Ggx<TypeParam> ggx(from_host<Unit>(alpha));
      const DirectionBins bins({-to_host(wo.x), -to_host(wo.y), to_host(wo.z)}, std::min(1.5, 2.0 * alpha));
      const DirectionComparison result = compare_directions(
          bins, kSamples,
          [&](Sampler& sampler) -> std::optional<glm::dvec3> {
            const auto u = sampler.next<TypeParam>();
            const auto v = sampler.next<TypeParam>();
            const auto wi = sample_microfacet_reflection(ggx, wo, u, v, DirectionSampling::kBrdf);
            return wi.z > 0 ? std::optional(to_host(wi)) : std::nullopt;
          },
          [&](const glm::dvec3& w) {
            const auto wi = from_host<Unit>(w);
            const auto tint = [](Unit) { return Vec3<Unit>(1); };
            return wi.z > 0
                       ? to_host(
                             eval_microfacet_reflection(ggx, wo, wi, tint, DirectionSampling::kBrdf).pdf_w)
                       : 0.0;
          });
      EXPECT_LT(result.integral, 1.001) << alpha << ' ' << cosine;
      EXPECT_GT(result.chi_square.p_value, sidak(kComparisons)) << alpha << ' ' << cosine;
      EXPECT_GT(result.chi_square.degrees, 100) << alpha << ' ' << cosine;
    }
  }
  for (const double cosine : kCosines) {
    for (const double eta : {1.5, 1.0 / 1.5}) {
      const auto wo = from_host<Unit>(at_cosine(cosine));
      const auto e = from_host<Unit>(eta);
      const Ggx<TypeParam> ggx(Unit(0.3));
      const DirectionComparison result = compare_directions(
          DirectionBins(), kSamples,
          [&](Sampler& sampler) -> std::optional<glm::dvec3> {
            const auto u = sampler.next<TypeParam>();
            const auto v = sampler.next<TypeParam>();
            const auto wi = sample_microfacet_transmission(ggx, e, wo, u, v, DirectionSampling::kBrdf);
            return wi && wi->z < 0 ? std::optional(to_host(*wi)) : std::nullopt;
          },
          [&](const glm::dvec3& w) {
            if (w.z >= 0.0) return 0.0;
            return to_host(eval_microfacet_transmission(ggx, Vec3<Unit>(1), e, wo, from_host<Unit>(w),
                                                        DirectionSampling::kBrdf)
                               .pdf_w);
          });
      EXPECT_LT(result.integral, 1.001) << cosine << ' ' << eta;
      EXPECT_GT(result.chi_square.p_value, sidak(kComparisons)) << cosine << ' ' << eta;
    }
  }
}

// The facets, projected, make up the surface: the integral of D(h) h.z is 1.
TYPED_TEST(MicrofacetTest, FacetsCoverTheSurface) {
  using Unit = typename TypeParam::Unit;
  for (const double alpha : {0.001, 0.01, 0.1, 0.5, 1.0}) {
    const Ggx<TypeParam> ggx(from_host<Unit>(alpha));
    double area = 0.0;
    for (const double cell :
         DirectionBins({0, 0, 1}, std::min(1.5, 2.0 * alpha)).integrate([&](const glm::dvec3& h) {
           return h.z > 0.0 ? to_host(ggx.d(from_host<Unit>(h))) * h.z : 0.0;
         })) {
      area += cell;
    }
    EXPECT_NEAR(area, 1.0, 1e-3) << alpha;
  }
}

}  // namespace
}  // namespace vitrine
