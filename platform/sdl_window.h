// The box on a desktop: an SDL window with the panel's picture and, beneath it, its buttons. One object is
// both the display and the buttons; keys, mouse and fingers press the same buttons.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "button_strip.h"
#include "buttons.h"
#include "display.h"
#include "surface.h"

struct SDL_Renderer;
struct SDL_Texture;
struct SDL_Window;
union SDL_Event;

namespace vitrine {

/// Used from the main thread only. There is at most one at a time.
class SdlWindow final : public Display, public Buttons {
 public:
  /// A window whose panel is width x height pixels. Events carry the time of `clock`, which must outlive it.
  /// Throws DisplayUnavailable when no window can be opened, std::runtime_error when a key name is unknown.
  SdlWindow(int width, int height, const std::string& title, const std::vector<ButtonSpec>& buttons,
            const TimeSource& clock);
  ~SdlWindow() override;

  [[nodiscard]] DisplayMode mode() const override;
  Surface acquire() override;
  void present() override;
  [[nodiscard]] Surface shown() const override { return frame_.surface(); }

  /// Closing the window presses and releases the button "quit".
  std::vector<ButtonEvent> poll(std::chrono::milliseconds timeout) override;

 private:
  /// What can hold a button: a key, a mouse button or a finger, with its number.
  enum class Holder : std::uint8_t { kKey, kMouse, kFinger };
  using HolderId = std::pair<Holder, std::int64_t>;

  struct Library {  // SDL's video part, for as long as the window lives
    Library();
    ~Library();
  };
  struct Deleter {
    void operator()(SDL_Window* window) const;
    void operator()(SDL_Renderer* renderer) const;
    void operator()(SDL_Texture* texture) const;
  };
  using Texture = std::unique_ptr<SDL_Texture, Deleter>;

  void take_events();
  void take(const SDL_Event& event);
  void press(HolderId holder, const std::string& button, std::uint32_t ticks);
  /// Presses the on-screen button at a point of the window, if there is one.
  void press_at(int x, int y, HolderId holder, std::uint32_t ticks);
  void release(HolderId holder, std::uint32_t ticks);
  void add_event(const std::string& button, Edge edge, std::uint32_t ticks);
  [[nodiscard]] std::set<std::string> held_buttons() const;
  void measure();
  void draw_strip();
  void redraw();
  /// Copies a surface to a texture of its size, made anew when the size changed.
  void upload(const Surface& surface, Texture& texture);

  const TimeSource& clock_;
  ButtonStrip strip_;
  Library library_;
  std::unique_ptr<SDL_Window, Deleter> window_;
  std::unique_ptr<SDL_Renderer, Deleter> renderer_;
  Texture frame_texture_;
  Texture strip_texture_;
  SurfaceMemory frame_;
  std::map<std::int32_t, std::string> button_of_key_;
  std::map<HolderId, std::string> held_;
  std::vector<ButtonEvent> events_;
  Clock::time_point latest_event_ = Clock::time_point::min();
  int width_ = 0;   // of window and panel
  int height_ = 0;  // of the panel
  bool needs_redraw_ = false;
};

}  // namespace vitrine
