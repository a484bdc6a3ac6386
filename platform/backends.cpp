#include "backends.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "headless_display.h"
#include "merged_buttons.h"
#include "nearest_name.h"
#include "picture_frame.h"
#include "script_buttons.h"
#if VITRINE_EVDEV
#include "evdev_buttons.h"
#include "input_codes.h"
#endif
#if VITRINE_GPIO
#include "gpio_buttons.h"
#include "gpio_places.h"
#endif
#if VITRINE_SDL
#include "sdl_window.h"
#endif
#if VITRINE_DRM
#include "drm_display.h"
#endif
#if VITRINE_FBDEV
#include "fbdev_display.h"
#endif

namespace vitrine {
namespace {

const SystemClock kSystemClock;

// clang-format off: it cannot indent a table with conditional rows
constexpr auto kDisplays = std::to_array<DisplayBackend>({
#if VITRINE_SDL
  {"sdl", "a window on the desktop that simulates the box",
   [](const DisplayRequest& request) -> Panel {
     const TimeSource& clock = request.clock != nullptr ? *request.clock : kSystemClock;
     const auto [width, height] = or_usual({request.width, request.height});
     const auto window = std::make_shared<SdlWindow>(width, height, request.title, request.buttons, clock);
     return {.display = window, .buttons = window};
   }},
#endif
#if VITRINE_DRM
      {"drm", "a screen of a KMS card, without a desktop",
       [](const DisplayRequest& request) -> Panel {
         const auto display = std::make_shared<DrmDisplay>(Extent{request.width, request.height},
                                                           request.options, request.insists);
         return {.notice = display->notice(), .display = display};
       },
       list_drm_cards},
#endif
#if VITRINE_FBDEV
      {"fbdev", "a framebuffer device, such as a small SPI panel",
       [](const DisplayRequest& request) -> Panel {
         const auto display = std::make_shared<FbdevDisplay>(Extent{request.width, request.height},
                                                             request.options, request.insists);
         return {.notice = display->notice(), .display = display};
       },
       list_framebuffers},
#endif
      {"headless", "frames in memory, without a screen", [](const DisplayRequest& request) -> Panel {
         const auto [width, height] = or_usual({request.width, request.height});
         return {.display = std::make_shared<HeadlessDisplay>(width, height)};
       }},
});

constexpr auto kButtons = std::to_array<ButtonsBackend>({
#if VITRINE_GPIO
  {"gpio",
   "buttons on GPIO lines",
   "[[gpio]] tables in the configuration",
   [](const Panel&, const ButtonsRequest& request) { return !request.wiring.gpio.empty(); },
   [](const Panel&, const ButtonsRequest& request) -> std::shared_ptr<Buttons> {
     if (request.wiring.gpio.empty()) return nullptr;
     return std::make_shared<GpioButtons>(request.wiring.gpio);
   },
   [](std::span<const ButtonSpec>) { return ButtonInventory{.gpio = find_gpio_chips(), .input = {}}; }},
#endif
#if VITRINE_EVDEV
      {"evdev", "keyboards, gpio-keys and rotary encoders", "",
       // A window has keys of its own, and those pressed in other windows are not for us.
       [](const Panel& panel, const ButtonsRequest& request) {
         return !request.wiring.evdev.empty() || (panel.buttons == nullptr && panel.backend != "headless");
       },
       [](const Panel&, const ButtonsRequest& request) -> std::shared_ptr<Buttons> {
         return std::make_shared<EvdevButtons>(request.wiring.evdev, request.buttons);
       },
       [](std::span<const ButtonSpec> buttons) {
         return ButtonInventory{.gpio = {}, .input = find_input_devices(buttons)};
       },
       unknown_key_remedy},
#endif
#if VITRINE_SDL
      {"sdl", "keys and on-screen buttons of the SDL window", "the display 'sdl'",
       [](const Panel& panel, const ButtonsRequest&) { return panel.backend == "sdl"; },
       [](const Panel& panel, const ButtonsRequest&) {
         return panel.backend == "sdl" ? panel.buttons : nullptr;
       }},
#endif
      {"script", "scripted presses on synthetic time", "a script file and a synthetic clock",
       [](const Panel&, const ButtonsRequest& request) { return !request.script.empty(); },
       [](const Panel&, const ButtonsRequest& request) -> std::shared_ptr<Buttons> {
         if (request.script.empty() || request.clock == nullptr) return nullptr;
         return std::make_shared<ScriptButtons>(*request.clock, read_script(request.script, request.buttons));
       }},
});
// clang-format on

/// The row of a key. `kind` is for the message.
template <class Row, std::size_t N>
const Row& find_row(const std::array<Row, N>& table, std::string_view key, const std::string& kind) {
  const auto row = std::ranges::find(table, key, &Row::key);
  if (row != table.end()) return *row;
  std::vector<std::string> known{"auto"};
  for (const Row& candidate : table) known.emplace_back(candidate.key);
  throw std::runtime_error("this build has no " + kind + " '" + std::string(key) + "'; " +
                           name_remedy(key, known));
}

Panel opened(const DisplayBackend& backend, const DisplayRequest& request) {
  Panel panel = backend.open(request);
  panel.backend = backend.key;
  return panel;
}

}  // namespace

std::span<const DisplayBackend> display_backends() { return kDisplays; }
std::span<const ButtonsBackend> buttons_backends() { return kButtons; }

ScreenInventory list_screens() {
  ScreenInventory all;
  for (const DisplayBackend& backend : kDisplays) {
    if (backend.list == nullptr) continue;
    ScreenInventory some = backend.list();
    std::ranges::move(some.cards, std::back_inserter(all.cards));
    std::ranges::move(some.framebuffers, std::back_inserter(all.framebuffers));
  }
  return all;
}

Panel open_display(std::string_view key, const DisplayRequest& request) {
  if (key != "auto") {
    DisplayRequest named = request;
    named.insists = true;
    return opened(find_row(kDisplays, key, "display"), named);
  }
  std::string notice;
  for (const DisplayBackend& backend : std::span(kDisplays).first(kDisplays.size() - 1)) {
    try {
      return opened(backend, request);
    } catch (const DisplayUnavailable& error) {
      notice += std::string(backend.key) + ": " + error.what() + ". ";
    }
  }
  Panel panel = opened(kDisplays.back(), request);
  panel.notice = notice + "Frames go to memory only (display '" + panel.backend + "')";
  return panel;
}

std::shared_ptr<Buttons> open_buttons(std::string_view list, const Panel& panel,
                                      const ButtonsRequest& request) {
  std::vector<std::shared_ptr<Buttons>> sources;
  if (list == "auto") {
    for (const ButtonsBackend& backend : kButtons) {
      if (!backend.wanted(panel, request)) continue;
      if (auto source = backend.open(panel, request)) sources.push_back(std::move(source));
    }
  } else {
    std::istringstream keys{std::string(list)};
    for (std::string key; std::getline(keys, key, ',');) {
      const ButtonsBackend& backend = find_row(kButtons, key, "buttons");
      auto source = backend.open(panel, request);
      if (!source) {
        throw std::runtime_error("buttons '" + std::string(backend.key) + "' need " +
                                 std::string(backend.needs) + "; supply that or leave them out of the list");
      }
      sources.push_back(std::move(source));
    }
  }
  if (sources.size() == 1) return sources.front();
  return std::make_shared<MergedButtons>(std::move(sources));
}

std::string key_remedy(const std::string& name) {
  for (const ButtonsBackend& backend : kButtons) {
    if (backend.unknown_key_remedy != nullptr) return backend.unknown_key_remedy(name);
  }
  return "";
}

ButtonInventory list_buttons(std::span<const ButtonSpec> buttons) {
  ButtonInventory all;
  for (const ButtonsBackend& backend : kButtons) {
    if (backend.list == nullptr) continue;
    ButtonInventory some = backend.list(buttons);
    if (some.gpio) all.gpio = std::move(some.gpio);
    if (some.input) all.input = std::move(some.input);
  }
  return all;
}

}  // namespace vitrine
