// Pictures on their way to a screen and back.
#pragma once

#include <memory>
#include <span>

#include "side.h"
#include "surface.h"

namespace vitrine {

/// Fills the columns [left, right) of `surface` with those of `picture`, stretched over the whole surface
/// where the sizes differ, black where it is empty. `dimmed` shows that it is about to be replaced.
void show_picture(const Surface& surface, const DevelopedPicture& picture, bool dimmed, int left, int right);

/// Fills `surface` with what the only side shows, or with that of the left one up to `column`, from there on
/// with that of the right one, and a line between them.
void show_sides(const Surface& surface, std::span<const std::unique_ptr<Side>> sides, int column);

/// The line between two pictures that are shown side by side.
void draw_split(const Surface& surface, int column);

/// Makes all of `surface` less bright: 0 is black, 1 leaves it alone.
void dim_surface(const Surface& surface, double level);

/// A copy of what `surface` shows.
DevelopedPicture read_picture(const Surface& surface);

}  // namespace vitrine
