#include "materials/texture.h"

#include <cmath>

#include <gtest/gtest.h>

#include "number_systems.h"
#include "numeric/host_conversion.h"
#include "statistics/random_inputs.h"

namespace vitrine {
namespace {

double srgb_to_linear(double x) { return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4); }

// An image of random texels, looked up in double precision by glTF's rules.
struct TestImage {
  int width;
  int height;
  std::vector<std::uint8_t> rgba;

  TestImage(int w, int h) : width(w), height(h) {
    RandomInputs random(static_cast<std::uint64_t>(w * h));
    for (int i = 0; i < 4 * w * h; ++i) rgba.push_back(static_cast<std::uint8_t>(random.index(256)));
  }
  [[nodiscard]] glm::dvec3 texel(int x, int y) const {
    const std::uint8_t* p = &rgba[static_cast<std::size_t>(4 * (y * width + x))];
    return {p[0] / 255.0, p[1] / 255.0, p[2] / 255.0};
  }
  // Any integer coordinate, as the sampler's wrap mode repeats the texels.
  static int wrapped(int i, int size, Wrap wrap) {
    if (wrap == Wrap::kClamp) return std::clamp(i, 0, size - 1);
    const int period = wrap == Wrap::kMirror ? 2 * size : size;
    const int inside = (i % period + period) % period;
    return inside < size ? inside : 2 * size - 1 - inside;
  }
  [[nodiscard]] glm::dvec3 sample(double u, double v, Wrap s, Wrap t, bool nearest) const {
    const auto at = [&](int x, int y) { return texel(wrapped(x, width, s), wrapped(y, height, t)); };
    if (nearest) {
      return at(static_cast<int>(std::floor(u * width)), static_cast<int>(std::floor(v * height)));
    }
    const double x = std::floor(u * width - 0.5);
    const double y = std::floor(v * height - 0.5);
    const auto i = static_cast<int>(x);
    const auto j = static_cast<int>(y);
    const glm::dvec3 upper = glm::mix(at(i, j), at(i + 1, j), u * width - 0.5 - x);
    const glm::dvec3 lower = glm::mix(at(i, j + 1), at(i + 1, j + 1), u * width - 0.5 - x);
    return glm::mix(upper, lower, v * height - 0.5 - y);
  }
};

template <class N>
class TextureTest : public testing::Test {
 protected:
  static TexelTable<N> linear() {
    TexelTable<N> table;
    for (std::size_t i = 0; i < 256; ++i)
      table[i] = from_host<typename N::Unit>(static_cast<double>(i) / 255.0);
    return table;
  }
  static Texture<N> texture(const TestImage& image, Wrap s, Wrap t, bool nearest) {
    return {.rgba = image.rgba.data(),
            .width = image.width,
            .height = image.height,
            .wrap_s = s,
            .wrap_t = t,
            .nearest = nearest};
  }
  static Vec2<typename N::TexCoord> uv(double u, double v) {
    return {from_host<typename N::TexCoord>(u), from_host<typename N::TexCoord>(v)};
  }
};
TYPED_TEST_SUITE(TextureTest, NumberSystems, NumberSystemNames);

TYPED_TEST(TextureTest, WrapsAndBlendsAsGltfSays) {
  const TexelTable<TypeParam> table = this->linear();
  RandomInputs random(1);
  for (const TestImage& image : {TestImage(1, 1), TestImage(2, 3), TestImage(16, 8), TestImage(13, 64)}) {
    for (const Wrap s : {Wrap::kRepeat, Wrap::kMirror, Wrap::kClamp}) {
      for (const Wrap t : {Wrap::kRepeat, Wrap::kMirror, Wrap::kClamp}) {
        const auto bilinear = this->texture(image, s, t, false);
        const auto nearest = this->texture(image, s, t, true);
        for (int i = 0; i < 500; ++i) {
          const auto at = this->uv(random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0));
          const double u = to_host(at.x);
          const double v = to_host(at.y);
          const glm::dvec3 blended = to_host(bilinear.sample(at, table));
          ASSERT_LE(glm::length(blended - image.sample(u, v, s, t, false)), bound<TypeParam>(5e-5, 1e-7))
              << u << ' ' << v;
          const auto near_border = [](double x) { return std::abs(x - std::round(x)) < 1e-4; };
          if (near_border(u * image.width) || near_border(v * image.height))
            continue;  // either neighbour may be right
          const glm::dvec3 one = to_host(nearest.sample(at, table));
          ASSERT_LE(glm::length(one - image.sample(u, v, s, t, true)), 1e-6) << u << ' ' << v;
        }
      }
    }
  }
}

TYPED_TEST(TextureTest, AlphaIsFilteredLikeAnyChannel) {
  const TestImage image(13, 8);
  TestImage alpha_in_red = image;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) alpha_in_red.rgba[i] = image.rgba[i + 3];
  const TexelTable<TypeParam> table = this->linear();
  RandomInputs random(2);
  for (const bool nearest : {false, true}) {
    const auto texture = this->texture(image, Wrap::kRepeat, Wrap::kMirror, nearest);
    const auto red = this->texture(alpha_in_red, Wrap::kRepeat, Wrap::kMirror, nearest);
    for (int i = 0; i < 500; ++i) {
      const auto at = this->uv(random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0));
      ASSERT_EQ(texture.sample_alpha(at, table), red.sample(at, table).x);
    }
  }
}

TYPED_TEST(TextureTest, CornersAndCenters) {
  const TestImage image(4, 2);
  const TexelTable<TypeParam> table = this->linear();
  for (const Wrap wrap : {Wrap::kRepeat, Wrap::kMirror, Wrap::kClamp}) {
    const auto bilinear = this->texture(image, wrap, wrap, false);
    const auto nearest = this->texture(image, wrap, wrap, true);
    for (int y = 0; y < 2; ++y) {
      for (int x = 0; x < 4; ++x) {  // at its centre a texel is itself
        const auto at = this->uv((x + 0.5) / 4, (y + 0.5) / 2);
        EXPECT_LE(glm::length(to_host(bilinear.sample(at, table)) - image.texel(x, y)), 1e-6);
        EXPECT_LE(glm::length(to_host(nearest.sample(at, table)) - image.texel(x, y)), 1e-6);
      }
    }
    EXPECT_LE(glm::length(to_host(nearest.sample(this->uv(0.0, 0.0), table)) - image.texel(0, 0)), 1e-6);
    // Exactly 1 begins the next period; the clamped end is the last texel.
    const glm::dvec3 last = wrap == Wrap::kRepeat ? image.texel(0, 0) : image.texel(3, 1);
    EXPECT_LE(glm::length(to_host(nearest.sample(this->uv(1.0, 1.0), table)) - last), 1e-6);
    EXPECT_LE(glm::length(to_host(nearest.sample(this->uv(100.0, 100.0), table)) -
                          (wrap == Wrap::kClamp ? image.texel(3, 1) : image.texel(0, 0))),
              1e-6);
  }
}

TYPED_TEST(TextureTest, TheTableDecodesBeforeTheBlend) {
  const TestImage image(8, 8);
  TexelTable<TypeParam> srgb;
  for (std::size_t i = 0; i < 256; ++i) {
    srgb[i] = from_host<typename TypeParam::Unit>(srgb_to_linear(static_cast<double>(i) / 255.0));
  }
  const auto texture = this->texture(image, Wrap::kRepeat, Wrap::kRepeat, false);
  const auto decoded = [&](int x) {
    const glm::dvec3 c = image.texel(x, 0);
    return glm::dvec3(srgb_to_linear(c.x), srgb_to_linear(c.y), srgb_to_linear(c.z));
  };
  const glm::dvec3 between = to_host(texture.sample(this->uv(3.0 / 8, 0.5 / 8), srgb));
  EXPECT_LE(glm::length(between - 0.5 * (decoded(2) + decoded(3))), 1e-6);
}

}  // namespace
}  // namespace vitrine
