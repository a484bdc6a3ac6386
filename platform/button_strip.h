// The buttons of a simulated box: a strip of captions and key hints beneath the picture. Where they lie and
// how they look; the window that shows them says which are pressed.
#pragma once

#include <array>
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

  /// Narrow strips have several rows, of smaller buttons where they would be many; without buttons the height
  /// is 0.
  [[nodiscard]] int height(int width) const;
  /// The name of the button at (x, y) of a strip of this width.
  [[nodiscard]] std::optional<std::string> button_at(int width, int x, int y) const;
  /// Where the n-th on-screen button lies.
  [[nodiscard]] PixelRect rect(int width, std::size_t n) const;
  /// Fills the surface, whose height is height(its width).
  void draw(const Surface& surface, const std::set<std::string>& pressed) const;

 private:
  static constexpr std::size_t kStyles = 3;

  struct Face {
    std::string name;
    std::string caption;
    std::string hint;
    std::array<int, kStyles> widths;  ///< the least it needs in each style
  };
  /// Faces [first, last) beside each other.
  struct Row {
    std::size_t first;
    std::size_t last;
    int width;  ///< that they need, with the gaps on both sides of each
  };

  [[nodiscard]] std::vector<Row> fill_rows(int width, std::size_t style) const;
  /// As few rows as there can be, of about one length.
  [[nodiscard]] std::vector<Row> balanced_rows(int width, std::size_t style) const;
  /// The largest style that needs few rows, or else the smallest.
  [[nodiscard]] std::size_t choose_style(int width) const;
  /// Where each face lies.
  [[nodiscard]] std::vector<PixelRect> layout(int width) const;

  std::vector<Face> faces_;
};

}  // namespace vitrine
