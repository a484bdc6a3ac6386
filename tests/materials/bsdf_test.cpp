// What a Bsdf says of pairs of directions, and its delta lobes.
#include "materials/bsdf.h"

#include <gtest/gtest.h>

#include "materials/test_surfaces.h"
#include "materials/textbook_charlie.h"
#include "materials/textbook_ggx.h"
#include "number_systems.h"
#include "statistics/random_inputs.h"

namespace vitrine {
namespace {

constexpr int kPairs = 20000;

// glTF's metallic-roughness model with its extensions below the layers, in double precision.
glm::dvec3 textbook_base(const TestSurface& s, const glm::dvec3& wo, const glm::dvec3& wi) {
  const bool refracts = s.transmission == Transmission::kRefract && s.transmit != glm::dvec3(0.0);
  const bool specular = refracts || s.f90 > 0.0;
  const auto fresnel = [&](double cosine) {
    if (refracts) return glm::dvec3(textbook::fresnel(cosine, s.eta));
    return s.f0 + (s.f90 - s.f0) * std::pow(1.0 - cosine, 5);
  };
  if (wi.z > 0.0) {
    const glm::dvec3 reflected = fresnel(glm::dot(wo, glm::normalize(wo + wi)));
    const glm::dvec3 diffuse =
        s.diffuse * (specular ? 1.0 - reflected : glm::dvec3(1.0)) * wi.z / std::numbers::pi;
    return specular ? diffuse + reflected * textbook::reflection(wo, wi, s.alpha).f_cos : diffuse;
  }
  if (refracts) return s.transmit * textbook::transmission(wo, wi, s.eta, s.alpha).f_cos;
  const glm::dvec3 mirrored(wi.x, wi.y, -wi.z);
  const glm::dvec3 reflected =
      specular ? fresnel(glm::dot(wo, glm::normalize(wo + mirrored))) : glm::dvec3(0.0);
  return s.transmit * (1.0 - reflected) * textbook::reflection(wo, mirrored, s.alpha).f_cos;
}

// With them: each layer takes from what is below it what it gives itself, seen from the side where it gives
// more.
template <class N>
glm::dvec3 textbook_f_cos(const TestSurface& s, const glm::dvec3& wo, const glm::dvec3& wi) {
  using Unit = typename N::Unit;
  glm::dvec3 f_cos = textbook_base(s, wo, wi);
  const double cos_i = std::abs(wi.z);
  if (s.sheen != glm::dvec3(0.0)) {
    const auto albedo = [&](double cosine) {
      return to_host(SheenAlbedo<N>::table()(from_host<Unit>(cosine), from_host<Unit>(s.sheen_roughness)));
    };
    const double most = std::max(albedo(wo.z), albedo(cos_i));
    f_cos *= 1.0 - std::max({s.sheen.x, s.sheen.y, s.sheen.z}) * std::min(1.0, most);
    if (wi.z > 0.0) {
      const double alpha = s.sheen_roughness * s.sheen_roughness;
      f_cos += s.sheen * textbook::sheen_f_cos(wo, wi, alpha) / std::max(1.0, most);
    }
  }
  f_cos *= 1.0 - s.coat * textbook::schlick(0.04, 1.0, std::min(wo.z, cos_i));
  if (wi.z > 0.0 && !s.coat_smooth) {
    f_cos += s.coat * textbook::schlick(0.04, 1.0, glm::dot(wo, glm::normalize(wo + wi))) *
             textbook::reflection(wo, wi, s.coat_alpha).f_cos;
  }
  return f_cos;
}

template <class N>
class BsdfTest : public testing::Test {
 protected:
  using Direction = Vec3<typename N::Unit>;

  static Direction direction(const glm::dvec3& w) { return from_host<typename N::Unit>(w); }
  static Bsdf<N> bsdf(const TestSurface& surface, const glm::dvec3& wo,
                      DirectionSampling how = DirectionSampling::kBrdfCosine) {
    return Bsdf<N>(baked<N>(surface), direction(wo), how);
  }
};
TYPED_TEST_SUITE(BsdfTest, NumberSystems, NumberSystemNames);

TYPED_TEST(BsdfTest, IsTheGltfModel) {
  RandomInputs random(1);
  for (const TestSurface& surface : rough_surfaces()) {
    for (int i = 0; i < kPairs; ++i) {
      const glm::dvec3 wo = random.upwards(0.05);
      const glm::dvec3 wi = random.upwards(0.05) * (i % 2 == 0 ? 1.0 : -1.0);
      const glm::dvec3 f_cos = to_host(this->bsdf(surface, wo).eval(this->direction(wi)).f_cos);
      const glm::dvec3 exact = textbook_f_cos<TypeParam>(surface, wo, wi);
      for (int c = 0; c < 3; ++c) {
        ASSERT_NEAR(f_cos[c], exact[c], exact[c] * bound<TypeParam>(2e-3, 1e-4) + 1e-6)
            << surface.name << " wo.z " << wo.z << " wi.z " << wi.z;
      }
    }
  }
}

TYPED_TEST(BsdfTest, ReflectionIsReciprocal) {
  RandomInputs random(2);
  for (const TestSurface& surface : rough_surfaces()) {
    for (int i = 0; i < kPairs; ++i) {
      const glm::dvec3 a = random.upwards(0.05);
      const glm::dvec3 b = random.upwards(0.05);
      const glm::dvec3 there = to_host(this->bsdf(surface, a).eval(this->direction(b)).f_cos) / b.z;
      const glm::dvec3 back = to_host(this->bsdf(surface, b).eval(this->direction(a)).f_cos) / a.z;
      for (int c = 0; c < 3; ++c) {
        ASSERT_NEAR(there[c], back[c], there[c] * bound<TypeParam>(1e-4, 2e-6) + 1e-7) << surface.name;
      }
    }
  }
}

// Light the other way meets 1 / eta: f(wi, wo) = eta^2 f(wo, wi), since radiance is compressed by eta^2.
TYPED_TEST(BsdfTest, RefractionIsReciprocalButForEtaSquared) {
  RandomInputs random(3);
  int lit = 0;
  for (const double eta : {1.3, 1.5, 2.4}) {
    const TestSurface into{.name = "",
                           .transmit = glm::dvec3(1.0),
                           .transmission = Transmission::kRefract,
                           .eta = eta,
                           .coat = 0.5};
    TestSurface out_of = into;
    out_of.eta = 1.0 / eta;
    for (int i = 0; i < kPairs; ++i) {
      const glm::dvec3 a = random.upwards(0.1);
      const glm::dvec3 b = random.upwards(0.1);
      const glm::dvec3 across(1, 1, -1);  // the frame faces the viewer
      const glm::dvec3 h = glm::normalize(b * across * eta + a);
      if (std::min(std::abs(glm::dot(a, h)), std::abs(glm::dot(b * across, h))) < 0.05)
        continue;  // the lobe's end
      const double there = to_host(this->bsdf(into, a).eval(this->direction(b * across)).f_cos.x) / b.z;
      const double back = to_host(this->bsdf(out_of, b).eval(this->direction(a * across)).f_cos.x) / a.z;
      ASSERT_NEAR(back, eta * eta * there, back * bound<TypeParam>(5e-3, 1e-4) + 1e-5) << eta;
      lit += there > 0.01;
    }
  }
  EXPECT_GT(lit, 1000);
}

TYPED_TEST(BsdfTest, MirrorReflectsAllThatItSends) {
  const TestSurface mirror{.name = "", .f0 = {1.0, 0.5, 0.25}, .f90 = 1.0, .smooth = true};
  const glm::dvec3 wo = at_cosine(1.0 / std::sqrt(2.0));
  const Bsdf<TypeParam> bsdf = this->bsdf(mirror, wo);
  EXPECT_FALSE(bsdf.is_rough());
  EXPECT_EQ(to_host(bsdf.prob_delta()), 1.0);
  const auto sample = bsdf.sample(typename TypeParam::Unit(0.5), typename TypeParam::Unit(0.3),
                                  typename TypeParam::Unit(0.6));
  ASSERT_TRUE(sample);
  EXPECT_TRUE(sample->delta);
  EXPECT_LE(glm::length(to_host(sample->wi) - glm::dvec3(-wo.x, -wo.y, wo.z)), 1e-6);
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(to_host(sample->weight)[c], textbook::schlick(mirror.f0[c], 1.0, wo.z), 1e-6);
  const BsdfValue<TypeParam> seen = bsdf.eval(sample->wi);
  EXPECT_EQ(to_host(seen.f_cos), glm::dvec3(0.0));
  EXPECT_EQ(to_host(seen.pdf_w), 0.0);
}

// Averaged over the choices, each lobe carries its share: F, and (1 - F) / eta^2 through the boundary of a
// solid.
TYPED_TEST(BsdfTest, SmoothGlassSplitsByFresnel) {
  using Unit = typename TypeParam::Unit;
  for (const double eta : {1.5, 1.0 / 1.5, 2.4}) {
    for (const double cosine : {1.0, 0.8, 0.3}) {
      const TestSurface glass{.name = "",
                              .transmit = {0.5, 1.0, 0.9},
                              .transmission = Transmission::kRefract,
                              .eta = eta,
                              .smooth = true};
      const glm::dvec3 wo = at_cosine(cosine);
      const Bsdf<TypeParam> bsdf = this->bsdf(glass, wo);
      EXPECT_EQ(to_host(bsdf.prob_delta()), 1.0);
      glm::dvec3 reflected(0.0);
      glm::dvec3 transmitted(0.0);
      constexpr int kChoices = 20000;
      for (int i = 0; i < kChoices; ++i) {
        const auto choice = from_host<Unit>((i + 0.5) / kChoices);
        const auto sample = bsdf.sample(choice, Unit(0.5), Unit(0.5));
        if (!sample) continue;
        ASSERT_TRUE(sample->delta);
        (sample->wi.z > 0 ? reflected : transmitted) +=
            to_host(sample->weight) / static_cast<double>(kChoices);
        if (sample->wi.z < 0) {
          const glm::dvec3 wi = to_host(sample->wi);
          ASSERT_NEAR(wi.x * eta, -wo.x, 2e-6);
          ASSERT_NEAR(wi.y * eta, -wo.y, 2e-6);
        }
      }
      const double fresnel = textbook::fresnel(cosine, eta);
      const glm::dvec3 through = glass.transmit * (1.0 - fresnel) / (eta * eta);
      EXPECT_LE(glm::length(reflected - fresnel), 2e-4) << eta << ' ' << cosine;
      EXPECT_LE(glm::length(transmitted - through), 6e-4) << eta << ' ' << cosine;
    }
  }
}

TYPED_TEST(BsdfTest, SmoothPaneGoesStraightOn) {
  using Unit = typename TypeParam::Unit;
  const TestSurface pane{
      .name = "", .f0 = glm::dvec3(0.04), .f90 = 1.0, .transmit = {0.5, 1.0, 0.9}, .smooth = true};
  const glm::dvec3 wo = at_cosine(0.4);
  const auto sample = this->bsdf(pane, wo).sample(TypeParam::unit_from_bits(0xffffffffU), Unit(0), Unit(0));
  ASSERT_TRUE(sample);
  EXPECT_TRUE(sample->delta);
  EXPECT_LE(glm::length(to_host(sample->wi) + wo), 1e-6);
  const double fresnel = textbook::schlick(0.04, 1.0, 0.4);
  const double transmit_luminance = 0.5 * 0.2126 + 1.0 * 0.7152 + 0.9 * 0.0722;
  const double prob = (1.0 - fresnel) * transmit_luminance / (fresnel + (1.0 - fresnel) * transmit_luminance);
  EXPECT_LE(glm::length(to_host(sample->weight) - pane.transmit * (1.0 - fresnel) / prob), 1e-5);
}

TYPED_TEST(BsdfTest, SmoothCoatLeavesItsLambertLobeToBeSeen) {
  const TestSurface coat{
      .name = "", .diffuse = glm::dvec3(0.8), .f0 = glm::dvec3(0.04), .f90 = 1.0, .smooth = true};
  const glm::dvec3 wo = at_cosine(0.8);
  const glm::dvec3 wi = at_cosine(0.5, 3.0);
  const Bsdf<TypeParam> bsdf = this->bsdf(coat, wo);
  EXPECT_TRUE(bsdf.is_rough());
  EXPECT_FALSE(bsdf.is_rough_both_sides());
  EXPECT_GT(to_host(bsdf.prob_delta()), 0.04);
  EXPECT_LT(to_host(bsdf.prob_delta()), 0.06);
  const BsdfValue<TypeParam> value = bsdf.eval(this->direction(wi));
  const double left = 1.0 - textbook::schlick(0.04, 1.0, glm::dot(wo, glm::normalize(wo + wi)));
  EXPECT_NEAR(to_host(value.f_cos.x), 0.8 * left * wi.z / std::numbers::pi, 1e-6);
  EXPECT_NEAR(to_host(value.pdf_w), (1.0 - to_host(bsdf.prob_delta())) * wi.z / std::numbers::pi, 1e-6);
}

TYPED_TEST(BsdfTest, SmoothClearcoatLiesOverAll) {
  using Unit = typename TypeParam::Unit;
  const TestSurface enamel{.name = "", .diffuse = glm::dvec3(0.8), .coat = 0.5, .coat_smooth = true};
  const glm::dvec3 wo = at_cosine(0.4);
  const double coat = 0.5 * textbook::schlick(0.04, 1.0, 0.4);
  const double below = 0.8 * (1.0 - coat);
  for (const DirectionSampling how : kAllSamplings) {
    const Bsdf<TypeParam> bsdf = this->bsdf(enamel, wo, how);
    EXPECT_NEAR(to_host(bsdf.prob_delta()), coat / (coat + below), 1e-6);
    EXPECT_NEAR(to_host(bsdf.reflectance()), coat + below, 1e-6);
    const auto sample = bsdf.sample(Unit(0), Unit(0.3), Unit(0.6));
    ASSERT_TRUE(sample);
    EXPECT_TRUE(sample->delta);
    EXPECT_LE(glm::length(to_host(sample->wi) - glm::dvec3(-wo.x, -wo.y, wo.z)), 1e-6);
    EXPECT_LE(glm::length(to_host(sample->weight) - glm::dvec3(coat + below)), 2e-6);
    const glm::dvec3 wi = at_cosine(0.7, 2.0);
    EXPECT_NEAR(to_host(bsdf.eval(this->direction(wi)).f_cos.y), below * wi.z / std::numbers::pi, 1e-6);
  }
  // A mirror below it is dimmed as well.
  const TestSurface mirror{.name = "", .f0 = glm::dvec3(1.0), .f90 = 1.0, .smooth = true, .coat = 0.5};
  const auto sample =
      this->bsdf(mirror, wo).sample(TypeParam::unit_from_bits(0xffffffffU), Unit(0.3), Unit(0.6));
  ASSERT_TRUE(sample);
  EXPECT_TRUE(sample->delta);
  EXPECT_LE(glm::length(to_host(sample->weight) - glm::dvec3(1.0)), 2e-6);
}

TYPED_TEST(BsdfTest, UniformAndCosineKnowOnlyTheSides) {
  const TestSurface gold{.name = "", .f0 = {1.0, 0.77, 0.34}, .f90 = 1.0, .alpha = 0.1};
  const TestSurface pane{.name = "", .f0 = glm::dvec3(0.04), .f90 = 1.0, .transmit = glm::dvec3(1.0)};
  const TestSurface mirror{.name = "", .f0 = glm::dvec3(0.04), .f90 = 1.0, .smooth = true};
  const glm::dvec3 wo = at_cosine(0.9);
  const glm::dvec3 wi = at_cosine(0.25, 3.0);
  const auto pdf_w = [&](const TestSurface& surface, DirectionSampling how, double side) {
    return to_host(this->bsdf(surface, wo, how).eval(this->direction(wi * glm::dvec3(1, 1, side))).pdf_w);
  };
  constexpr double kHemisphere = 0.5 * std::numbers::inv_pi;
  EXPECT_NEAR(pdf_w(gold, DirectionSampling::kUniform, 1), kHemisphere, 1e-7);
  EXPECT_NEAR(pdf_w(gold, DirectionSampling::kCosine, 1), 0.25 * std::numbers::inv_pi, 1e-7);
  EXPECT_NEAR(pdf_w(pane, DirectionSampling::kUniform, 1), 0.5 * kHemisphere, 1e-7);
  EXPECT_NEAR(pdf_w(pane, DirectionSampling::kUniform, -1), 0.5 * kHemisphere, 1e-7);
  EXPECT_NEAR(pdf_w(pane, DirectionSampling::kCosine, -1), 0.125 * std::numbers::inv_pi, 1e-7);
  for (const DirectionSampling how : {DirectionSampling::kUniform, DirectionSampling::kCosine}) {
    EXPECT_EQ(pdf_w(gold, how, -1), 0.0);
    EXPECT_EQ(pdf_w(mirror, how, 1), 0.0);
  }
}

TYPED_TEST(BsdfTest, ReflectanceIsWhatIsExpected) {
  const glm::dvec3 wo = at_cosine(0.5);
  const auto reflectance = [&](const TestSurface& surface) {
    return to_host(this->bsdf(surface, wo).reflectance());
  };
  EXPECT_EQ(reflectance({.name = "black"}), 0.0);
  EXPECT_NEAR(reflectance({.name = "grey", .diffuse = glm::dvec3(0.3)}), 0.3, 1e-6);
  EXPECT_NEAR(reflectance({.name = "green", .diffuse = {0.0, 1.0, 0.0}}), 0.7152, 1e-6);
  EXPECT_NEAR(reflectance({.name = "mirror", .f0 = glm::dvec3(0.5), .f90 = 1.0, .smooth = true}),
              textbook::schlick(0.5, 1.0, 0.5), 1e-6);
  for (const TestSurface& surface : rough_surfaces()) EXPECT_LE(reflectance(surface), 1.0) << surface.name;
}

TYPED_TEST(BsdfTest, BlackScattersNothing) {
  using Unit = typename TypeParam::Unit;
  const Bsdf<TypeParam> bsdf = this->bsdf({.name = ""}, at_cosine(0.5));
  EXPECT_FALSE(bsdf.is_rough());
  EXPECT_FALSE(bsdf.is_rough_both_sides());
  EXPECT_EQ(to_host(bsdf.prob_delta()), 0.0);
  for (const Unit choice : {Unit(0), Unit(0.5), TypeParam::unit_from_bits(0xffffffffU)}) {
    EXPECT_FALSE(bsdf.sample(choice, Unit(0.5), Unit(0.5)));
  }
  EXPECT_EQ(to_host(bsdf.eval(this->direction(at_cosine(0.5))).f_cos), glm::dvec3(0.0));
}

TYPED_TEST(BsdfTest, SaysWhichSidesAreRough) {
  for (const TestSurface& surface : rough_surfaces()) {
    const Bsdf<TypeParam> bsdf = this->bsdf(surface, at_cosine(0.9));
    EXPECT_TRUE(bsdf.is_rough()) << surface.name;
    EXPECT_EQ(bsdf.is_rough_both_sides(), surface.transmit != glm::dvec3(0.0)) << surface.name;
    EXPECT_EQ(to_host(bsdf.prob_delta()), 0.0) << surface.name;
  }
}

}  // namespace
}  // namespace vitrine
