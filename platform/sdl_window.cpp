#include "sdl_window.h"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

#include <SDL.h>

namespace vitrine {
namespace {

constexpr int kLeastWidth = 240;
constexpr int kLeastPanelHeight = 64;

[[noreturn]] void fail(const std::string& what, const std::string& remedy) {
  throw DisplayUnavailable("SDL cannot " + what + ": " + SDL_GetError() + "; " + remedy);
}

constexpr const char* kHeadlessRemedy = "check the desktop session or use the display 'headless'";

std::map<std::int32_t, std::string> keys_of(const std::vector<ButtonSpec>& buttons) {
  std::map<std::int32_t, std::string> keys;
  for (const ButtonSpec& button : buttons) {
    if (button.key.empty()) continue;
    const SDL_Keycode key = SDL_GetKeyFromName(button.key.c_str());
    if (key == SDLK_UNKNOWN) {
      throw std::runtime_error("button '" + button.name + "': SDL knows no key '" + button.key +
                               "'; use a name like S, Right, Escape or Space");
    }
    keys.emplace(key, button.name);
  }
  return keys;
}

}  // namespace

SdlWindow::Library::Library() {
  const bool has_wayland = std::getenv("WAYLAND_DISPLAY") != nullptr;
  if (!has_wayland && std::getenv("DISPLAY") == nullptr && std::getenv("SDL_VIDEODRIVER") == nullptr) {
    throw DisplayUnavailable(
        "no desktop session: neither DISPLAY nor WAYLAND_DISPLAY is set; start one or use the display "
        "'headless'");
  }
  // SDL would otherwise take over the console, or draw where nobody sees it, when it cannot reach the
  // desktop. SDL_VIDEODRIVER in the environment still wins.
  SDL_SetHint(SDL_HINT_VIDEODRIVER, has_wayland ? "x11,wayland" : "x11");
  SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");  // signals are the program's business, in every backend
  SDL_SetHint(SDL_HINT_VIDEO_X11_NET_WM_BYPASS_COMPOSITOR, "0");
  SDL_SetHint(SDL_HINT_VIDEO_ALLOW_SCREENSAVER, "1");
  if (SDL_InitSubSystem(SDL_INIT_VIDEO) != 0) fail("use this desktop", kHeadlessRemedy);
}

SdlWindow::Library::~Library() { SDL_QuitSubSystem(SDL_INIT_VIDEO); }

void SdlWindow::Deleter::operator()(SDL_Window* window) const { SDL_DestroyWindow(window); }
void SdlWindow::Deleter::operator()(SDL_Renderer* renderer) const { SDL_DestroyRenderer(renderer); }
void SdlWindow::Deleter::operator()(SDL_Texture* texture) const { SDL_DestroyTexture(texture); }

SdlWindow::SdlWindow(int width, int height, const std::string& title, const std::vector<ButtonSpec>& buttons,
                     const TimeSource& clock)
    : clock_(clock),
      strip_(buttons),
      frame_(width, height, PixelFormat::kXrgb8888),
      button_of_key_(keys_of(buttons)) {
  window_.reset(SDL_CreateWindow(title.c_str(), SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, width,
                                 height + strip_.height(width), SDL_WINDOW_RESIZABLE));
  if (!window_) fail("open a window", kHeadlessRemedy);
  const int least_width = std::min(width, kLeastWidth);
  SDL_SetWindowMinimumSize(window_.get(), least_width,
                           std::min(height, kLeastPanelHeight) + strip_.height(least_width));
  renderer_.reset(SDL_CreateRenderer(window_.get(), -1, SDL_RENDERER_PRESENTVSYNC));
  if (!renderer_) renderer_.reset(SDL_CreateRenderer(window_.get(), -1, SDL_RENDERER_SOFTWARE));
  if (!renderer_) fail("draw into its window", kHeadlessRemedy);
  measure();
  present();
}

SdlWindow::~SdlWindow() = default;

DisplayMode SdlWindow::mode() const {
  SDL_DisplayMode desktop{};
  SDL_GetCurrentDisplayMode(std::max(SDL_GetWindowDisplayIndex(window_.get()), 0), &desktop);
  return {width_, height_, PixelFormat::kXrgb8888,
          desktop.refresh_rate > 0 ? desktop.refresh_rate : DisplayMode{}.refresh_hz};
}

Surface SdlWindow::acquire() {
  if (frame_.surface().width != width_ || frame_.surface().height != height_) {
    frame_ = SurfaceMemory(width_, height_, PixelFormat::kXrgb8888);
  }
  return frame_.surface();
}

void SdlWindow::present() {
  upload(frame_.surface(), frame_texture_);
  redraw();
  take_events();
}

std::vector<ButtonEvent> SdlWindow::poll(std::chrono::milliseconds timeout) {
  const Clock::time_point deadline = Clock::now() + timeout;
  take_events();
  while (events_.empty()) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now());
    if (left.count() <= 0) break;
    if (SDL_WaitEventTimeout(nullptr, static_cast<int>(left.count())) != 0) take_events();
  }
  return std::exchange(events_, {});
}

void SdlWindow::take_events() {
  // Not SDL_PollEvent(): it stops at the mark of a call before and keeps what is behind it for the next time.
  SDL_PumpEvents();
  SDL_Event event;
  while (SDL_PeepEvents(&event, 1, SDL_GETEVENT, SDL_FIRSTEVENT, SDL_LASTEVENT) == 1) take(event);
  if (needs_redraw_) redraw();
}

void SdlWindow::take(const SDL_Event& event) {
  switch (event.type) {
    case SDL_QUIT:
      add_event("quit", Edge::kPress, event.quit.timestamp);
      add_event("quit", Edge::kRelease, event.quit.timestamp);
      break;
    case SDL_WINDOWEVENT:
      if (event.window.event == SDL_WINDOWEVENT_SIZE_CHANGED) measure();
      if (event.window.event == SDL_WINDOWEVENT_EXPOSED) needs_redraw_ = true;
      break;
    case SDL_KEYDOWN: {
      const auto key = button_of_key_.find(event.key.keysym.sym);
      if (event.key.repeat != 0 || key == button_of_key_.end()) break;
      press({Holder::kKey, event.key.keysym.scancode}, key->second, event.key.timestamp);
      break;
    }
    case SDL_KEYUP:
      release({Holder::kKey, event.key.keysym.scancode}, event.key.timestamp);
      break;
    case SDL_MOUSEBUTTONDOWN:
      if (event.button.which == SDL_TOUCH_MOUSEID) break;  // the finger's own event does it
      press_at(event.button.x, event.button.y, {Holder::kMouse, event.button.button}, event.button.timestamp);
      break;
    case SDL_MOUSEBUTTONUP:
      release({Holder::kMouse, event.button.button}, event.button.timestamp);
      break;
    case SDL_FINGERDOWN: {
      int width = 0;
      int height = 0;
      SDL_GetWindowSize(window_.get(), &width, &height);
      press_at(static_cast<int>(event.tfinger.x * static_cast<float>(width)),
               static_cast<int>(event.tfinger.y * static_cast<float>(height)),
               {Holder::kFinger, event.tfinger.fingerId}, event.tfinger.timestamp);
      break;
    }
    case SDL_FINGERUP:
      release({Holder::kFinger, event.tfinger.fingerId}, event.tfinger.timestamp);
      break;
    default:
      break;
  }
}

void SdlWindow::press(HolderId holder, const std::string& button, std::uint32_t ticks) {
  const bool was_held = held_buttons().contains(button);
  if (!held_.emplace(holder, button).second || was_held) return;
  add_event(button, Edge::kPress, ticks);
  draw_strip();
}

void SdlWindow::press_at(int x, int y, HolderId holder, std::uint32_t ticks) {
  const auto button = strip_.button_at(width_, x, y - height_);
  if (button) press(holder, *button, ticks);
}

void SdlWindow::release(HolderId holder, std::uint32_t ticks) {
  const auto held = held_.extract(holder);
  if (held.empty() || held_buttons().contains(held.mapped())) return;
  add_event(held.mapped(), Edge::kRelease, ticks);
  draw_strip();
}

void SdlWindow::add_event(const std::string& button, Edge edge, std::uint32_t ticks) {
  // Ages are rounded to milliseconds: what came later must not seem earlier.
  latest_event_ = std::max(latest_event_, clock_.now() - std::chrono::milliseconds{SDL_GetTicks() - ticks});
  events_.push_back({button, edge, latest_event_});
}

std::set<std::string> SdlWindow::held_buttons() const {
  std::set<std::string> names;
  for (const auto& [holder, name] : held_) names.insert(name);
  return names;
}

void SdlWindow::measure() {
  int width = 0;
  int height = 0;
  SDL_GetRendererOutputSize(renderer_.get(), &width, &height);
  width_ = std::max(width, 1);
  height_ = std::max(height - strip_.height(width_), 1);
  draw_strip();
}

void SdlWindow::draw_strip() {
  needs_redraw_ = true;
  if (strip_.height(width_) == 0) return;
  const SurfaceMemory picture(width_, strip_.height(width_), PixelFormat::kXrgb8888);
  strip_.draw(picture.surface(), held_buttons());
  upload(picture.surface(), strip_texture_);
}

void SdlWindow::redraw() {
  // A frame of another size, just before the next one follows a resize, is stretched.
  const SDL_Rect panel{0, 0, width_, height_};
  const SDL_Rect strip{0, height_, width_, strip_.height(width_)};
  SDL_RenderCopy(renderer_.get(), frame_texture_.get(), nullptr, &panel);
  if (strip_texture_) SDL_RenderCopy(renderer_.get(), strip_texture_.get(), nullptr, &strip);
  SDL_RenderPresent(renderer_.get());
  needs_redraw_ = false;
}

void SdlWindow::upload(const Surface& surface, Texture& texture) {
  int width = 0;
  int height = 0;
  if (texture) SDL_QueryTexture(texture.get(), nullptr, nullptr, &width, &height);
  if (width != surface.width || height != surface.height) {
    texture.reset(SDL_CreateTexture(renderer_.get(), SDL_PIXELFORMAT_XRGB8888, SDL_TEXTUREACCESS_STREAMING,
                                    surface.width, surface.height));
    if (!texture) fail("make a picture of the window's size", "make the window smaller");
  }
  SDL_UpdateTexture(texture.get(), nullptr, surface.pixels, static_cast<int>(surface.stride_bytes));
}

}  // namespace vitrine
