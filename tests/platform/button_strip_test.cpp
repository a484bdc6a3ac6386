// The strip of on-screen buttons: every button lies apart on the strip at any width, can be hit, and shows a
// press.
#include "button_strip.h"

#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace vitrine {
namespace {

const std::vector<ButtonSpec> kBox = {{"scene", "Scene", "Right"}, {"back", "Previous scene", "Left"},
                                      {"mode", "Sampling", "M"},   {"scene", "", "Space"},
                                      {"hud", "Figures", ""},      {"quit", "", "Escape"}};
constexpr std::size_t kFaces = 4;

TEST(ButtonStrip, ButtonsLieApartAndWithinAtEveryWidth) {
  const ButtonStrip strip(kBox);
  for (int width = 200; width < 1400; width += 37) {
    const int height = strip.height(width);
    for (std::size_t n = 0; n < kFaces; ++n) {
      const PixelRect a = strip.rect(width, n);
      EXPECT_GT(a.width, 40);
      EXPECT_GE(a.x, 0);
      EXPECT_GE(a.y, 0);
      EXPECT_LE(a.x + a.width, width);
      EXPECT_LT(a.y + a.height, height);
      for (std::size_t m = 0; m < n; ++m) {
        const PixelRect b = strip.rect(width, m);
        EXPECT_TRUE(a.x >= b.x + b.width || b.x >= a.x + a.width || a.y >= b.y + b.height) << width;
      }
    }
  }
  EXPECT_GT(strip.height(200), strip.height(1000)) << "a narrow strip has several rows";
}

TEST(ButtonStrip, FindsTheButtonBeneathAPoint) {
  const ButtonStrip strip(kBox);
  const std::vector<std::string> names = {"scene", "back", "mode", "hud"};
  for (const int width : {240, 640, 1280}) {
    for (std::size_t n = 0; n < kFaces; ++n) {
      const PixelRect rect = strip.rect(width, n);
      EXPECT_EQ(strip.button_at(width, rect.x + rect.width / 2, rect.y + rect.height / 2), names[n]);
      EXPECT_EQ(strip.button_at(width, rect.x, rect.y), names[n]);
      EXPECT_NE(strip.button_at(width, rect.x + rect.width, rect.y), names[n]);
      EXPECT_NE(strip.button_at(width, rect.x, rect.y - 1), names[n]);
    }
    EXPECT_EQ(strip.button_at(width, 0, 0), std::nullopt);
  }
}

TEST(ButtonStrip, IsNotThereWithoutCaptions) {
  const std::vector<ButtonSpec> keys_only = {{"quit", "", "Escape"}};
  const ButtonStrip strip(keys_only);
  EXPECT_EQ(strip.height(640), 0);
  EXPECT_EQ(strip.button_at(640, 5, 5), std::nullopt);
}

TEST(ButtonStrip, APressShowsOnItsButtonAlone) {
  const ButtonStrip strip(kBox);
  constexpr int kWidth = 640;
  const SurfaceMemory idle(kWidth, strip.height(kWidth), PixelFormat::kXrgb8888);
  const SurfaceMemory pressed(kWidth, strip.height(kWidth), PixelFormat::kXrgb8888);
  strip.draw(idle.surface(), {});
  strip.draw(pressed.surface(), {"mode"});
  PixelRect mode = strip.rect(kWidth, 2);
  mode.height += 2;  // the cap goes down into its shadow
  int changed = 0;
  for (int y = 0; y < idle.surface().height; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const bool differs = read_pixel(idle.surface(), x, y) != read_pixel(pressed.surface(), x, y);
      changed += differs ? 1 : 0;
      if (!mode.contains(x, y)) {
        EXPECT_FALSE(differs) << x << "," << y;
      }
    }
  }
  EXPECT_GT(changed, mode.width * mode.height * 8 / 10);
}

/// A box of many buttons: the smaller the panel, the smaller they are, so that they do not outgrow it.
TEST(ButtonStrip, ManyButtonsStaySmallerThanTheirPanel) {
  std::vector<ButtonSpec> many;
  for (int n = 0; n < 26; ++n)
    many.push_back({"b" + std::to_string(n), n % 4 == 0 ? "A longer one" : "Button", "K"});
  const ButtonStrip strip(many);
  for (const auto& [width, height] : {std::pair{320, 240}, {480, 320}, {800, 480}, {1280, 720}}) {
    EXPECT_LT(strip.height(width), height) << width;
    for (std::size_t n = 0; n < many.size(); ++n) {
      const PixelRect rect = strip.rect(width, n);
      EXPECT_LE(rect.x + rect.width, width);
      EXPECT_GE(rect.height, 24);
      EXPECT_EQ(strip.button_at(width, rect.x + rect.width / 2, rect.y + rect.height / 2), many[n].name);
    }
  }
}

}  // namespace
}  // namespace vitrine
