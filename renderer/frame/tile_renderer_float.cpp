#include "frame/tile_renderer.h"
#include "numeric/float_numbers.h"

namespace vitrine {

template <>
std::unique_ptr<Renderer> make_tile_renderer(const World<FloatNumbers>& world,
                                             const Camera<FloatNumbers>& camera, const RenderOptions& options,
                                             const DisplayCurve& curve) {
  return std::make_unique<TileRenderer<FloatNumbers>>(world, camera, options, curve);
}

}  // namespace vitrine
