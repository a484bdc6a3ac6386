#include "frame/tile_renderer.h"
#include "numeric/fixed_numbers.h"

namespace vitrine {

template <>
std::unique_ptr<Renderer> make_tile_renderer(const World<FixedNumbers>& world,
                                             const Camera<FixedNumbers>& camera, const RenderOptions& options,
                                             const DisplayCurve& curve) {
  return std::make_unique<TileRenderer<FixedNumbers>>(world, camera, options, curve);
}

}  // namespace vitrine
