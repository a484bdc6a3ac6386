#include "command_run.h"

#include <cstdio>
#include <iostream>

#include "backends.h"
#include "exit_status.h"
#include "film/image_files.h"
#include "json_output.h"
#include "kiosk.h"
#include "output_file.h"
#include "picture_tour.h"
#include "picture_view.h"
#include "scene/input_error.h"
#include "stop_signals.h"

namespace vitrine {
namespace {

constexpr PictureSize kDefaultSize{800, 480};

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

/// A script is one more source of presses.
std::string choose_buttons(const RunRequest& request, const BoxConfig& box) {
  const std::string list = box.buttons.value_or("auto");
  const bool has_script = list == "auto" || list.find("script") != std::string::npos;
  return request.script && !has_script ? list + ",script" : list;
}

void require_png(const std::filesystem::path& out) {
  if (out.extension() != ".png")
    throw UsageError("--out " + out.string() + ": the last frame becomes a PNG; name a file.png");
  require_writable(out);
}

int show_kiosk(const RunRequest& request, const BoxConfig& box, ExhibitSettings exhibit, Panel& panel,
               SyntheticClock& synthetic, Workers& workers, const std::atomic<bool>& stop) {
  if (request.out) require_png(*request.out);
  ButtonsRequest sources{.buttons = button_specs(), .script = {}, .clock = &synthetic};
  if (request.script) sources.script = *request.script;
  const std::shared_ptr<Buttons> buttons = open_buttons(choose_buttons(request, box), panel, sources);

  const SystemClock system;
  const bool stepped = request.script.has_value();
  KioskSettings settings{.exhibit = std::move(exhibit), .lecture = find_lecture(box.lecture)};
  if (request.frames) settings.frames = *request.frames;
  Kiosk kiosk(*panel.display, *buttons, stepped ? static_cast<const TimeSource&>(synthetic) : system,
              stepped ? &synthetic : nullptr, workers, load_scene, std::move(settings));
  const KioskReport report = kiosk.run(stop);

  if (request.out) {
    const DevelopedPicture shown = read_picture(panel.display->shown());
    write_png(*request.out, shown.width, shown.height, shown.rgb);
  }
  if (request.json) {
    print_json({{"display", panel.backend},
                {"frames", report.frames},
                {"seconds", report.seconds},
                {"presses", report.presses},
                {"slowest_press_ms", report.slowest_press_ms}});
  } else {
    std::fprintf(stderr, "%llu frames in %.1f s, %llu presses, slowest press to label %.1f ms\n",
                 static_cast<unsigned long long>(report.frames), report.seconds,
                 static_cast<unsigned long long>(report.presses), report.slowest_press_ms);
  }
  return kDone;
}

int show_tour(const RunRequest& request, const ExhibitSettings& exhibit, Workers& workers,
              const std::atomic<bool>& stop) {
  const std::filesystem::path folder = request.out.value_or(".");
  if (!std::filesystem::is_directory(folder)) {
    throw UsageError("--out " + folder.string() +
                     ": no folder for the pictures of all scenes; name one, or give --frames");
  }
  Json pictures = Json::array();
  const bool all_shown =
      take_tour(exhibit, folder, workers, load_scene, stop, [&](const std::filesystem::path& file) {
        pictures.push_back(file.string());
        if (!request.json) std::cout << file.string() << std::endl;  // at once: the next one takes a while
      });
  if (request.json) print_json({{"pictures", pictures}});
  return all_shown ? kDone : kBadInput;
}

}  // namespace

int execute(const RunRequest& request) {
  const BoxConfig box = request.config ? overlay(read_box_config(*request.config), request.box) : request.box;
  const PictureSize size = box.size.value_or(kDefaultSize);
  const ExhibitSettings exhibit{.scenes = choose_scenes(request, box),
                                .mode = box.mode.value_or(nullptr),
                                .changes = request.changes,
                                .compare = request.compare,
                                .fairness = request.fairness,
                                .numbers = box.numbers.value_or(Numbers::kFloat),
                                .seed = request.seed,
                                .size = size};
  const std::atomic<bool>& stop = watch_stop_signals();
  SyntheticClock synthetic;
  const DisplayRequest display{.width = size.width,
                               .height = size.height,
                               .title = "vitrine",
                               .buttons = button_specs(),
                               .clock = request.script ? &synthetic : nullptr};
  Panel panel = open_display(box.display.value_or("auto"), display);
  if (!panel.notice.empty()) std::cerr << "vitrine: " << panel.notice << '\n';

  Workers workers(box.threads.value_or(default_thread_count()));
  if (panel.backend == "headless" && !request.frames && !request.script) {
    return show_tour(request, exhibit, workers, stop);
  }
  return show_kiosk(request, box, exhibit, panel, synthetic, workers, stop);
}

}  // namespace vitrine
