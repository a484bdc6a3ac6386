// The backend tables: every display and every source of buttons this build knows, by key. A new one is a file
// of its own and a row in backends.cpp; the command line, the probe and the tests read the tables.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "buttons.h"
#include "clocks.h"
#include "display.h"

namespace vitrine {

/// A display that was opened.
struct Panel {
  std::string backend{};  ///< key of its row
  std::string notice{};   ///< one line to tell the user, or empty: why "auto" could not open a better one
  std::shared_ptr<Display> display{};
  std::shared_ptr<Buttons> buttons{};  ///< of the display itself (a window has keys), or none
};

struct DisplayRequest {
  int width = 0;
  int height = 0;
  std::string title;
  std::vector<ButtonSpec> buttons;
  const TimeSource* clock =
      nullptr;  ///< of the panel's button events, outlives it; none: the machine's clock
};

struct DisplayBackend {
  std::string_view key;
  std::string_view description;
  Panel (*open)(const DisplayRequest& request);
};

/// In the order in which "auto" tries them; the last one always works.
[[nodiscard]] std::span<const DisplayBackend> display_backends();

/// Opens a display by key, or for "auto" the first that this machine can show. Throws std::runtime_error,
/// one line with a remedy; it is a DisplayUnavailable when the machine lacks what the display needs.
[[nodiscard]] Panel open_display(std::string_view key, const DisplayRequest& request);

struct ButtonsRequest {
  std::vector<ButtonSpec> buttons;
  std::filesystem::path script{};         ///< of scripted presses; empty: none
  const SyntheticClock* clock = nullptr;  ///< the script's time; outlives the buttons
};

struct ButtonsBackend {
  std::string_view key;
  std::string_view description;
  std::string_view needs;  ///< without which open() gives none
  std::shared_ptr<Buttons> (*open)(const Panel& panel, const ButtonsRequest& request);
};

[[nodiscard]] std::span<const ButtonsBackend> buttons_backends();

/// Opens all sources of a comma-separated list of keys as one; "auto" stands for every one that is to be had.
/// Throws std::runtime_error, one line with a remedy, and ScriptError for a bad script.
[[nodiscard]] std::shared_ptr<Buttons> open_buttons(std::string_view list, const Panel& panel,
                                                    const ButtonsRequest& request);

}  // namespace vitrine
