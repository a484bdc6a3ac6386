#include "backends.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <stdexcept>

#include "headless_display.h"
#include "merged_buttons.h"
#include "nearest_name.h"
#include "script_buttons.h"
#if VITRINE_SDL
#include "sdl_window.h"
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
     const auto window =
         std::make_shared<SdlWindow>(request.width, request.height, request.title, request.buttons, clock);
     return {.display = window, .buttons = window};
   }},
#endif
      {"headless", "frames in memory, without a screen", [](const DisplayRequest& request) -> Panel {
         return {.display = std::make_shared<HeadlessDisplay>(request.width, request.height)};
       }},
});

constexpr auto kButtons = std::to_array<ButtonsBackend>({
#if VITRINE_SDL
  {"sdl", "keys and on-screen buttons of the SDL window", "the display 'sdl'",
   [](const Panel& panel, const ButtonsRequest&) {
     return panel.backend == "sdl" ? panel.buttons : nullptr;
   }},
#endif
      {"script", "scripted presses on synthetic time", "a script file and a synthetic clock",
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

Panel open_display(std::string_view key, const DisplayRequest& request) {
  if (key != "auto") return opened(find_row(kDisplays, key, "display"), request);
  std::string notice;
  for (const DisplayBackend& backend : std::span(kDisplays).first(kDisplays.size() - 1)) {
    try {
      Panel panel = opened(backend, request);
      panel.notice = notice;
      return panel;
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

}  // namespace vitrine
