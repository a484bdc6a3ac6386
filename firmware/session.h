// A session of the box as command line and config ask for it: what the kiosk shows and how it behaves. Made
// at the start, made again when the config is read anew, made only to be checked.
#pragma once

#include <optional>

#include "backends.h"
#include "box_config.h"
#include "command_run.h"
#include "kiosk.h"
#include "supervisor.h"

namespace vitrine {

inline constexpr PictureSize kDefaultSize{800, 480};

/// The config file, if one is named, under the command line. Throws InputError.
BoxConfig box_of(const RunRequest& request);

/// The folder that the box may write into; nothing: wherever it is told to.
std::optional<std::filesystem::path> runtime_folder_of(const RunRequest& request);

/// Reads playlist and lecture. Throws InputError.
KioskSettings kiosk_settings(const RunRequest& request, const BoxConfig& box);
/// The built-in scene alone, and a card that says why.
KioskSettings stand_in_settings(const RunRequest& request, const BoxConfig& box,
                                const std::string& complaint);

Supervisor::Settings supervisor_settings(const RunRequest& request, const BoxConfig& box);

/// Everything that the box's buttons may be called.
std::vector<ButtonSpec> button_specs_of(const BoxConfig& box);

/// Opens the sources of presses; a script is one more. Throws as open_buttons() does.
std::shared_ptr<Buttons> open_buttons_of(const RunRequest& request, const BoxConfig& box, const Panel& panel,
                                         const SyntheticClock& synthetic);

}  // namespace vitrine
