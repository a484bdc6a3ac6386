// The buttons of a simulated box: a strip of captions and key hints beneath the picture. Where they lie and
// how they look; the window that shows them says which are pressed.
#pragma once

#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "buttons.h"
#include "surface.h"

namespace vitrine {

class ButtonStrip {
 public:
  /// One on-screen button for each spec with a caption; its hint lists the keys of all specs of that name.
  explicit ButtonStrip(std::span<const ButtonSpec> buttons);

  /// Narrow strips have several rows; without buttons the height is 0.
  [[nodiscard]] int height(int width) const;
  /// The name of the button at (x, y) of a strip of this width.
  [[nodiscard]] std::optional<std::string> button_at(int width, int x, int y) const;
  /// Where the n-th on-screen button lies.
  [[nodiscard]] PixelRect rect(int width, std::size_t n) const;
  /// Fills the surface, whose height is height(its width).
  void draw(const Surface& surface, const std::set<std::string>& pressed) const;

 private:
  struct Face {
    std::string name;
    std::string caption;
    std::string hint;
  };

  [[nodiscard]] int rows(int width) const;

  std::vector<Face> faces_;
  int narrowest_ = 0;  // a button's least width: all captions fit
};

}  // namespace vitrine
