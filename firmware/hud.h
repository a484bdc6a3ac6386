// The labels over the picture: what is shown, how it is sampled, how far it is. Plain text on a dark plate,
// sized with the panel.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "surface.h"

namespace vitrine {

/// Everything the labels say.
struct HudState {
  bool visible = true;
  std::string title;
  std::string caption;
  std::string mode;
  bool unbiased = true;
  std::string numbers;
  std::uint32_t samples_per_pixel = 0;
  double frames_per_second = 0.0;        ///< 0: not known yet
  double seconds = 0.0;                  ///< that the picture took so far
  std::optional<double> exposure_stops;  ///< when set by hand
  bool paused = false;
  bool loading = false;
  std::string notice;  ///< of the moment: "saved ..."
  std::string error;   ///< why there is no picture; shown even when the labels are not
};

/// The lines at the top: title, mode, progress, and what is out of the ordinary. None when they are not
/// visible.
std::vector<std::string> hud_lines(const HudState& state);

/// Draws the lines at the top left and the caption at the bottom. With an error, a card that tells it fills
/// the surface beneath them.
void draw_hud(const Surface& surface, const HudState& state);

}  // namespace vitrine
