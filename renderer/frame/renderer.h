// The renderer as its host sees it: free of number systems and modes. bake() turns a Scene into a BakedScene;
// that makes a Renderer for a mode and a size; a Renderer traces tiles onto a Film and develops the film for
// a display.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>

#include "film/film.h"
#include "frame/exposure.h"
#include "integrators/modes.h"
#include "integrators/trace_stats.h"
#include "scene/scene.h"

namespace vitrine {

enum class Numbers : std::uint8_t { kFloat, kFixed };

/// "float" or "fixed", and back (nothing for other words).
std::string_view numbers_name(Numbers numbers);
std::optional<Numbers> numbers_from_name(std::string_view name);

enum class Driver : std::uint8_t {
  kWave,  ///< thousands of paths a thread together, stage by stage
  kPath,  ///< one path at a time
};

struct RenderOptions {
  const Mode* mode = nullptr;            ///< of modes()
  std::optional<SamplingParts> parts{};  ///< nothing: the mode's own
  int camera = 0;                        ///< index into Scene::cameras
  int width = 0;
  int height = 0;
  std::uint64_t seed = 0;
  int max_depth = 256;  ///< scattering events a path may have; a guard, not a stopping rule
  Driver driver = Driver::kWave;
  int wave_size = 4096;  ///< paths of a wave

  /// What the pictures are made by.
  [[nodiscard]] const SamplingParts& sampling() const { return parts ? *parts : mode->parts; }
};

/// One mode at work on one scene at one size. Immutable: any number of threads may call it at once, on tiles
/// that do not overlap.
class Renderer {
 public:
  virtual ~Renderer() = default;
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// A film of this renderer's size and scale.
  [[nodiscard]] virtual Film make_film() const = 0;
  /// Adds `samples` of every pixel of `tile` to `film`; gives up soon after `cancel` becomes true. The result
  /// does not depend on how a picture is cut into tiles, sample ranges, waves or threads.
  virtual TraceStats trace(const Tile& tile, SampleRange samples, Film& film,
                           const std::atomic<bool>& cancel) const = 0;
  /// The exposure that makes the film's middle luminance a middle grey.
  [[nodiscard]] virtual Exposure meter(const Film& film) const = 0;
  /// Writes the pixels of `tile` as display-referred sRGB into `rgb`: 3 bytes a pixel, rows of the whole
  /// film's width, top to bottom.
  virtual void develop(const Film& film, const Tile& tile, Exposure exposure, std::uint8_t* rgb) const = 0;

 protected:
  Renderer() = default;
};

/// A scene ready to be traced in one number system. Must outlive its renderers.
class BakedScene {
 public:
  virtual ~BakedScene() = default;
  BakedScene(const BakedScene&) = delete;
  BakedScene& operator=(const BakedScene&) = delete;

  [[nodiscard]] virtual std::unique_ptr<Renderer> make_renderer(const RenderOptions& options) const = 0;
  [[nodiscard]] virtual std::size_t triangle_count() const = 0;
  [[nodiscard]] virtual std::size_t light_count() const = 0;

 protected:
  BakedScene() = default;
};

/// Throws InputError when the scene does not fit the number system.
std::unique_ptr<const BakedScene> bake(const Scene& scene, Numbers numbers);

}  // namespace vitrine
