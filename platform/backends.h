// The backend tables: every display and every source of buttons this build knows, by key. A new one is a file
// of its own and a row in backends.cpp; the command line, the probe and the tests read the tables.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "button_inventory.h"
#include "button_wiring.h"
#include "buttons.h"
#include "clocks.h"
#include "display.h"
#include "display_options.h"
#include "screen_inventory.h"

namespace vitrine {

/// A display that was opened.
struct Panel {
  std::string backend{};  ///< key of its row
  std::string notice{};   ///< one line to tell the user, or empty: what was asked for and could not be had
  std::shared_ptr<Display> display{};
  std::shared_ptr<Buttons> buttons{};  ///< of the display itself (a window has keys), or none
};

struct DisplayRequest {
  int width = 0;  ///< of the picture to draw; without width or height: that of the screen
  int height = 0;
  std::string title{};
  std::vector<ButtonSpec> buttons{};
  DisplayOptions options{};
  bool insists = false;  ///< without a device yet, wait for one instead of failing; open_display() sets it
  const TimeSource* clock =
      nullptr;  ///< of the panel's button events, outlives it; none: the machine's clock
};

struct DisplayBackend {
  std::string_view key;
  std::string_view description;
  Panel (*open)(const DisplayRequest& request);
  ScreenInventory (*list)() = nullptr;  ///< the screens of this machine that it could show on, if it can tell
};

/// In the order in which "auto" tries them; the last one always works.
[[nodiscard]] std::span<const DisplayBackend> display_backends();

/// Opens a display by key, or for "auto" the first that this machine can show. One that is named waits for
/// its screen where it can: devices may come late. Throws std::runtime_error, one line with a remedy; it is a
/// DisplayUnavailable when the machine lacks what the display needs.
[[nodiscard]] Panel open_display(std::string_view key, const DisplayRequest& request);

/// The screens of this machine that the backends of this build know of.
[[nodiscard]] ScreenInventory list_screens();

struct ButtonsRequest {
  std::vector<ButtonSpec> buttons;
  std::filesystem::path script{};         ///< of scripted presses; empty: none
  const SyntheticClock* clock = nullptr;  ///< the script's time; outlives the buttons
  ButtonWiring wiring{};                  ///< pins and input devices of the box
};

struct ButtonsBackend {
  std::string_view key;
  std::string_view description;
  std::string_view needs;  ///< without which open() gives none; empty: nothing
  bool (*wanted)(const Panel& panel, const ButtonsRequest& request);  ///< whether "auto" takes it
  std::shared_ptr<Buttons> (*open)(const Panel& panel, const ButtonsRequest& request);
  ButtonInventory (*list)(std::span<const ButtonSpec>) = nullptr;  ///< what of this machine it could read
  /// Of a name in EvdevDevice::keys that is no key: what to write instead. Empty for a good one.
  std::string (*unknown_key_remedy)(const std::string& name) = nullptr;
};

[[nodiscard]] std::span<const ButtonsBackend> buttons_backends();

/// Opens all sources of a comma-separated list of keys as one; "auto" stands for every one that is wanted.
/// Throws std::runtime_error, one line with a remedy, and ScriptError for a bad script.
[[nodiscard]] std::shared_ptr<Buttons> open_buttons(std::string_view list, const Panel& panel,
                                                    const ButtonsRequest& request);

/// What to write instead of a name in EvdevDevice::keys that is no key; empty when it is one, or when this
/// build reads no input devices.
[[nodiscard]] std::string key_remedy(const std::string& name);

/// What this machine offers as buttons; `buttons` says which keys the box knows.
[[nodiscard]] ButtonInventory list_buttons(std::span<const ButtonSpec> buttons);

}  // namespace vitrine
