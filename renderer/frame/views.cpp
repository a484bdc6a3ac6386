#include "frame/views.h"

#include <algorithm>
#include <array>

#include "frame/variance_map.h"

namespace vitrine {
namespace {

constexpr auto kViews = std::to_array<View>({
    {"picture", "", "",
     [](const Renderer& renderer, const Film& film, const Tile& tile, Exposure exposure, std::uint8_t* rgb) {
       renderer.develop(film, tile, exposure, rgb);
     }},
    {"variance", "Variance map", "relative error of each pixel: black 0.4 %, red 10 %, white 100 %",
     [](const Renderer& /*renderer*/, const Film& film, const Tile& tile, Exposure /*exposure*/,
        std::uint8_t* rgb) { develop_variance_map(film, tile, rgb); }},
});

}  // namespace

std::span<const View> views() { return kViews; }

const View* find_view(std::string_view key) {
  const auto found = std::ranges::find(kViews, key, &View::key);
  return found == kViews.end() ? nullptr : &*found;
}

}  // namespace vitrine
