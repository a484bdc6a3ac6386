// The scene that is always there, whatever became of the files: a small room with a lamp and two blocks, in
// the program itself. What cannot be shown, and says why on a card, is shown over it.
#pragma once

#include "playlist.h"
#include "scene/scene.h"

namespace vitrine {

[[nodiscard]] Scene built_in_scene();

/// The row of a playlist that stands for it.
[[nodiscard]] PlaylistScene built_in_row();
[[nodiscard]] bool is_built_in(const PlaylistScene& scene);

}  // namespace vitrine
