#include "frame/renderer.h"

#include <array>
#include <cstddef>
#include <vector>

#include "frame/tile_renderer.h"
#include "frame/tone_map.h"
#include "numeric/fixed_numbers.h"
#include "numeric/float_numbers.h"

namespace vitrine {
namespace {

template <class N>
class BakedSceneOf final : public BakedScene {
 public:
  explicit BakedSceneOf(const Scene& scene) : world_(bake_world<N>(scene)), cameras_(scene.cameras) {}

  [[nodiscard]] std::unique_ptr<Renderer> make_renderer(const RenderOptions& options) const override {
    const CameraView& view = cameras_.at(static_cast<std::size_t>(options.camera));
    return make_tile_renderer<N>(world_, bake_camera<N>(view, world_, options.width, options.height), options,
                                 srgb_display_curve());
  }
  [[nodiscard]] std::size_t triangle_count() const override { return world_.triangles.size(); }
  [[nodiscard]] std::size_t light_count() const override { return world_.lights.size(); }

 private:
  World<N> world_;
  std::vector<CameraView> cameras_;
};

template <class N>
std::unique_ptr<const BakedScene> bake_as(const Scene& scene) {
  return std::make_unique<BakedSceneOf<N>>(scene);
}

// The number systems, in the order of the enumeration.
struct NumbersRow {
  std::string_view name;
  std::unique_ptr<const BakedScene> (*bake)(const Scene&);
};
constexpr std::array kNumbers{NumbersRow{"float", bake_as<FloatNumbers>},
                              NumbersRow{"fixed", bake_as<FixedNumbers>}};

const NumbersRow& row(Numbers numbers) { return kNumbers[static_cast<std::size_t>(numbers)]; }

}  // namespace

std::string_view numbers_name(Numbers numbers) { return row(numbers).name; }

std::optional<Numbers> numbers_from_name(std::string_view name) {
  for (std::size_t i = 0; i < kNumbers.size(); ++i) {
    if (kNumbers[i].name == name) return static_cast<Numbers>(i);
  }
  return std::nullopt;
}

std::unique_ptr<const BakedScene> bake(const Scene& scene, Numbers numbers) {
  return row(numbers).bake(scene);
}

}  // namespace vitrine
