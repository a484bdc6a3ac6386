// A scene file made ready to be traced: read, checked, baked.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "frame/renderer.h"
#include "playlist.h"

namespace vitrine {

struct LoadedScene {
  std::vector<std::string> cameras;  ///< their names, never empty; a name may be
  std::unique_ptr<const BakedScene> baked;
};

/// Imports, or takes what is built in, and bakes. Throws InputError, also when the scene does not fit the
/// number system.
std::shared_ptr<const LoadedScene> load_scene(const PlaylistScene& scene, Numbers numbers);

/// How the kiosk loads; load_scene, unless a test has scenes of its own.
using LoadScene = std::function<std::shared_ptr<const LoadedScene>(const PlaylistScene&, Numbers)>;

}  // namespace vitrine
