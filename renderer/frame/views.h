// What of a picture is shown: itself, or what it tells about how it was made. The command line, the kiosk's
// button and the labels iterate one table; to add a view, add a row in views.cpp.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "frame/renderer.h"

namespace vitrine {

struct View {
  std::string_view key;
  std::string_view label;   ///< for a visitor; empty: the picture itself
  std::string_view legend;  ///< how to read it
  /// Writes the pixels of a tile, as Renderer::develop() does.
  void (*develop)(const Renderer& renderer, const Film& film, const Tile& tile, Exposure exposure,
                  std::uint8_t* rgb);
};

/// Every view, in the order of the button cycle; the first is the picture itself.
std::span<const View> views();
/// The view of that key, or nullptr.
const View* find_view(std::string_view key);

}  // namespace vitrine
