// Pictures on their way to a screen and back.
#pragma once

#include "picture.h"
#include "surface.h"

namespace vitrine {

/// Fills `surface` with `picture`, stretched where the sizes differ, black where it is empty. `dimmed` shows
/// that it is about to be replaced.
void show_picture(const Surface& surface, const DevelopedPicture& picture, bool dimmed);

/// A copy of what `surface` shows.
DevelopedPicture read_picture(const Surface& surface);

}  // namespace vitrine
