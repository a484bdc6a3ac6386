#include "session.h"

#include "built_in_scene.h"
#include "runtime_folder.h"
#include "scene/input_error.h"

namespace vitrine {
namespace {

/// A picture with so many samples is as good as a panel can show.
constexpr std::uint32_t kDefaultMaxSpp = 4096;

std::vector<PlaylistScene> choose_scenes(const RunRequest& request, const BoxConfig& box) {
  const std::vector<PlaylistScene> playlist = find_playlist(box.playlist);
  std::vector<PlaylistScene> scenes;
  for (const std::string& argument : request.scenes) scenes.push_back(resolve_scene(argument, playlist));
  if (scenes.empty()) scenes = playlist;
  if (scenes.empty()) {
    throw InputError("playlist", "", "none is installed",
                     "name one with --playlist FILE, or name scene files");
  }
  if (box.environment) require_environment(*box.environment);
  for (PlaylistScene& scene : scenes) scene.default_environment = box.environment;
  return scenes;
}

ExhibitSettings exhibit_settings(const RunRequest& request, const BoxConfig& box,
                                 std::vector<PlaylistScene> scenes) {
  return {.scenes = std::move(scenes),
          .mode = box.mode.value_or(nullptr),
          .changes = request.changes,
          .compare = request.compare,
          .fairness = request.fairness,
          .numbers = box.numbers.value_or(Numbers::kFloat),
          .seed = request.seed,
          .size = box.size.value_or(kDefaultSize),
          .max_spp = box.max_spp.value_or(kDefaultMaxSpp),
          .stand_in = built_in_row()};
}

KioskSettings settings_around(const RunRequest& request, const BoxConfig& box, ExhibitSettings exhibit) {
  KioskSettings settings{.exhibit = std::move(exhibit), .lecture = {}};
  if (request.frames) settings.frames = *request.frames;
  settings.screenshot_folder = box.screenshots.value_or(runtime_folder_of(request).value_or("."));
  settings.gestures = box.hardware.rules();
  settings.manners.idle = box.idle.value_or(IdleSettings{});
  settings.manners.dim = box.dim;
  settings.manners.pixel_shift = box.pixel_shift.value_or(false);
  return settings;
}

}  // namespace

BoxConfig box_of(const RunRequest& request) {
  return request.config ? overlay(read_box_config(*request.config), request.box) : request.box;
}

std::optional<std::filesystem::path> runtime_folder_of(const RunRequest& request) {
  return request.runtime_folder ? request.runtime_folder : runtime_folder_of_service();
}

KioskSettings kiosk_settings(const RunRequest& request, const BoxConfig& box) {
  KioskSettings settings =
      settings_around(request, box, exhibit_settings(request, box, choose_scenes(request, box)));
  settings.lecture = find_lecture(box.lecture);
  return settings;
}

KioskSettings stand_in_settings(const RunRequest& request, const BoxConfig& box,
                                const std::string& complaint) {
  KioskSettings settings = settings_around(request, box, exhibit_settings(request, box, {built_in_row()}));
  settings.complaint = complaint;
  return settings;
}

Supervisor::Settings supervisor_settings(const RunRequest& request, const BoxConfig& box) {
  return {.governor = box.governor.value_or(GovernorSettings{}),
          .health = box.health.value_or(HealthSettings{}),
          .runtime_folder = runtime_folder_of(request)};
}

std::vector<ButtonSpec> button_specs_of(const BoxConfig& box) {
  std::vector<ButtonSpec> specs = button_specs();
  for (const std::string& name : box.hardware.wired_buttons()) {
    if (find_action(name) == nullptr) specs.push_back({name, "", ""});
  }
  return specs;
}

std::shared_ptr<Buttons> open_buttons_of(const RunRequest& request, const BoxConfig& box, const Panel& panel,
                                         const SyntheticClock& synthetic) {
  std::string list = box.buttons.value_or("auto");
  const bool has_script = list == "auto" || list.find("script") != std::string::npos;
  if (request.script && !has_script) list += ",script";
  ButtonsRequest sources{
      .buttons = button_specs_of(box), .script = {}, .clock = &synthetic, .wiring = box.hardware.wiring()};
  if (request.script) sources.script = *request.script;
  return open_buttons(list, panel, sources);
}

}  // namespace vitrine
