// The labels over the picture: what is shown, how it is sampled, how far it is. Plain text on a dark plate,
// sized with the panel.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "pixel_shift.h"
#include "surface.h"

namespace vitrine {

/// What the label over a side says.
struct HudSide {
  std::string mode;
  std::string changes;  ///< of its parameters; may be empty
  std::string bias;     ///< why it never comes to the true picture; empty: it does
  std::uint32_t samples_per_pixel = 0;
  std::optional<double> error;  ///< relative, 1 being 100 %; nothing: not known yet
};

/// Everything the labels say.
struct HudState {
  bool visible = true;
  std::string title;
  std::string caption;
  std::vector<HudSide> sides = std::vector<HudSide>(1);  ///< one, or the left and the right one
  double split = 0.5;                                    ///< the part of the width that is the left side's
  std::string fairness;                                  ///< what is equal of two sides
  std::string view;                                      ///< unless it is the picture itself
  std::string view_legend;                               ///< how to read it
  std::string numbers;
  double frames_per_second = 0.0;        ///< 0: not known yet
  double rays_per_second = 0.0;          ///< 0: not known yet
  double seconds = 0.0;                  ///< that the picture took so far
  std::optional<double> exposure_stops;  ///< when set by hand
  bool paused = false;
  bool loading = false;
  bool done = false;          ///< the picture has all the samples that it gets
  std::string governor;       ///< why it is slower than it could be
  std::string notice;         ///< of the moment: "saved ..."
  std::string error;          ///< why there is no picture; shown even when the labels are not
  std::string error_title;    ///< what the error is about
  bool over_picture = false;  ///< the error has a picture behind it: its card leaves that visible
  PixelOffset offset;         ///< of all labels, to spare the panel
};

/// A ratio in two digits that count: "43 %", "3.2 %", "0.57 %".
std::string percent(double ratio);

/// The lines of a side: mode, what of it was changed, its bias, how far it is.
std::vector<std::string> side_lines(const HudSide& side);

/// The lines at the top: title, the only side, how the session runs, and what is out of the ordinary. None
/// when they are not visible.
std::vector<std::string> hud_lines(const HudState& state);

/// Everything that draw_hud() writes: what has to change before it is worth drawing again.
std::vector<std::string> hud_text(const HudState& state);

/// The first column of the right side.
int split_column(double split, int width);

/// Draws the labels of two sides, each over its side, beginning `top` pixels down and `shift` to the right.
void draw_side_labels(const Surface& surface, std::span<const HudSide> sides, double split, int top,
                      int shift = 0);

/// Draws the lines at the top left, the labels of two sides beneath them, and the caption at the bottom. An
/// error is a card there instead, that fills the surface beneath them where there is no picture.
void draw_hud(const Surface& surface, const HudState& state);

}  // namespace vitrine
