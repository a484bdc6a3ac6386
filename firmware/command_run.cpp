#include "command_run.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <optional>
#include <thread>

#include "backends.h"
#include "command_check.h"
#include "config_reload.h"
#include "exit_status.h"
#include "film/image_files.h"
#include "json_output.h"
#include "kiosk.h"
#include "notify_socket.h"
#include "output_file.h"
#include "picture_tour.h"
#include "picture_view.h"
#include "runtime_folder.h"
#include "scene/input_error.h"
#include "session.h"
#include "stop_signals.h"

namespace vitrine {
namespace {

std::string environment(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

void require_png(const std::filesystem::path& out) {
  if (out.extension() != ".png")
    throw UsageError("--out " + out.string() + ": the last frame becomes a PNG; name a file.png");
  require_writable(out);
}

void report(const RunRequest& request, const Panel& panel, const KioskReport& report) {
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
}

int show_kiosk(const RunRequest& request, const BoxConfig& box, KioskSettings settings, Panel& panel,
               SyntheticClock& synthetic, Workers& workers, const std::atomic<bool>& stop) {
  if (request.out) require_png(*request.out);
  RewirableButtons buttons([&] { return open_buttons_of(request, box, panel, synthetic); });

  const NotifySocket socket(environment("NOTIFY_SOCKET"));
  Supervisor supervisor(
      supervisor_settings(request, box),
      Supervision([&socket](const std::string& message) { socket.send(message); },
                  watchdog_time(std::getenv("WATCHDOG_USEC"), std::getenv("WATCHDOG_PID"))));
  KioskCare care{.supervisor = &supervisor};
  std::optional<ConfigReload> reload;
  if (request.config && !request.safe) {
    reload.emplace(request, box, watch_reload_signal(), panel, synthetic, buttons, supervisor);
    care.take_refit = [&reload] { return reload->take(); };
  }

  const SystemClock system;
  const bool stepped = request.script.has_value();
  Kiosk kiosk(*panel.display, buttons, stepped ? static_cast<const TimeSource&>(synthetic) : system,
              stepped ? &synthetic : nullptr, workers, load_scene, std::move(settings), care);
  const KioskReport session = kiosk.run(stop);
  supervisor.manager().stopping();

  if (request.out) {
    const DevelopedPicture shown = read_picture(panel.display->shown());
    write_png(*request.out, shown.width, shown.height, shown.rgb);
  }
  report(request, panel, session);
  if (kiosk.held_by_a_load()) {
    panel = {};  // the screen and its console are given back
    leave_now(kDone);
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

/// What the box shows; where the config's files are no good, nothing but the built-in scene and why.
struct Programme {
  KioskSettings settings;
  std::exception_ptr failure{};  ///< why it is not what was asked for
};

Programme choose_programme(const RunRequest& request, const BoxConfig& box) {
  if (request.safe) return {stand_in_settings(request, box, why_it_failed(runtime_folder_of(request)))};
  try {
    return {kiosk_settings(request, box)};
  } catch (const InputError& error) {
    // Who has typed a name wants to hear that it is wrong.
    if (!request.scenes.empty() || request.box.playlist || request.box.lecture || request.box.environment)
      throw;
    return {stand_in_settings(request, box, error.what()), std::current_exception()};
  }
}

/// The safe box ignores a config that is wrong: that may be why it is needed.
BoxConfig choose_box(const RunRequest& request) {
  if (!request.safe) return box_of(request);
  try {
    return box_of(request);
  } catch (const InputError& error) {
    std::cerr << "vitrine: " << error.what() << '\n';
    return request.box;
  }
}

/// The display of the box. A service never makes do with memory for want of a screen: the driver may come
/// late, so it asks the service manager for patience and looks again, until `stop`.
Panel open_screen(const std::string& key, const DisplayRequest& request, const std::atomic<bool>& stop) {
  Panel panel = open_display(key, request);
  const std::string address = environment("NOTIFY_SOCKET");
  if (key != "auto" || panel.backend != "headless" || address.empty()) return panel;
  std::cerr << "vitrine: " << panel.notice << "; waiting for a screen\n";
  const NotifySocket socket(address);
  Supervision manager([&socket](const std::string& message) { socket.send(message); }, std::nullopt);
  while (panel.backend == "headless" && !stop) {
    manager.waiting_for_screen(Clock::now());
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    panel = open_display(key, request);
  }
  return panel;
}

int run(const RunRequest& request) {
  const BoxConfig box = choose_box(request);
  Programme programme = choose_programme(request, box);
  const std::atomic<bool>& stop = watch_stop_signals();
  SyntheticClock synthetic;
  // Without a size the picture is as large as the screen.
  const PictureSize size = box.size.value_or(PictureSize{});
  const DisplayRequest display{.width = size.width,
                               .height = size.height,
                               .title = "vitrine",
                               .buttons = button_specs_of(box),
                               .options = box.hardware.display.options(),
                               .clock = request.script ? &synthetic : nullptr};
  Panel panel = open_screen(box.display_key(), display, stop);
  if (stop) return kDone;
  if (!panel.notice.empty()) std::cerr << "vitrine: " << panel.notice << '\n';
  const bool headless = panel.backend == "headless";
  if (programme.failure && headless) std::rethrow_exception(programme.failure);
  if (!programme.settings.complaint.empty()) std::cerr << "vitrine: " << programme.settings.complaint << '\n';

  Workers workers(box.threads.value_or(default_thread_count()));
  if (headless && !request.frames && !request.script && !request.safe)
    return show_tour(request, programme.settings.exhibit, workers, stop);
  return show_kiosk(request, box, std::move(programme.settings), panel, synthetic, workers, stop);
}

}  // namespace

int execute(const RunRequest& request) {
  if (request.check_config) return check_config(request);
  const std::optional<std::filesystem::path> folder = runtime_folder_of(request);
  if (!folder || request.safe) return run(request);
  keep_last_words(*folder, "");
  try {
    return run(request);
  } catch (const std::exception& error) {
    keep_last_words(*folder, error.what());
    throw;
  }
}

}  // namespace vitrine
