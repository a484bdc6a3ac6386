#include "command_line.h"

#include <algorithm>
#include <charconv>
#include <iostream>
#include <sstream>

#include "actions.h"
#include "backends.h"
#include "command_options.h"
#include "exit_status.h"
#include "mode_choice.h"
#include "nearest_name.h"

namespace vitrine {
namespace {

constexpr int kMaxDepth = 1'000'000;
constexpr int kMaxWaveSize = 1 << 20;

/// Refuses what is neither "auto" nor a key of the backend table.
template <class Row>
void require_backend(const std::string& option, const std::string& key, std::span<const Row> rows) {
  std::vector<std::string> known{"auto"};
  for (const Row& row : rows) known.emplace_back(row.key);
  if (std::ranges::find(known, key) == known.end()) {
    refuse_value(option, "this build has no '" + key + "'; " + name_remedy(key, known));
  }
}

template <class Row>
std::string describe(const std::string& what, std::span<const Row> rows) {
  std::string text = what + ":\n  auto: whatever there is";
  for (const Row& row : rows) text += "\n  " + std::string(row.key) + ": " + std::string(row.description);
  return text;
}

void define_run(CLI::App& app, RunRequest& request) {
  BoxConfig& box = request.box;
  app.add_option("SCENE", request.scenes, "scene files or names from the playlist (the whole playlist)")
      ->type_name("");
  add_text_option(app, "--display", "KEY", describe("where to show", display_backends()),
                  [&](const std::string& key) {
                    require_backend("--display", key, display_backends());
                    box.display = key;
                  });
  add_text_option(app, "--buttons", "LIST",
                  describe("comma-separated sources of presses", buttons_backends()),
                  [&](const std::string& list) {
                    std::istringstream keys(list);
                    for (std::string key; std::getline(keys, key, ',');)
                      require_backend("--buttons", key, buttons_backends());
                    box.buttons = list;
                  });
  add_text_option(app, "--config", "FILE", "TOML file that sets up the box; options given here go first",
                  [&](const std::string& file) { request.config = file; });
  app.add_flag("--check-config", request.check_config,
               "read config, board file, playlist, lecture and scenes, say what is wrong, and end");
  add_text_option(app, "--runtime-dir", "DIR",
                  "where health file and screenshots go, if the config does not say ($RUNTIME_DIRECTORY)",
                  [&](const std::string& folder) { request.runtime_folder = folder; });
  app.add_flag("--safe", request.safe,
               "show only the built-in scene and a card that says why the box's service failed");
  add_playlist_option(app, box.playlist);
  add_size_option(app, "800x480", [&](PictureSize size) { box.size = size; });
  add_mode_option(app, "the playlist's, or " + std::string(default_mode()->key),
                  [&](const Mode* mode) { box.mode = mode; });
  add_parameter_options(app, request.changes);
  add_compare_options(app, request.compare, request.fairness);
  add_text_option(app, "--lecture", "FILE",
                  "TOML file with the stops of the button 'lecture' (the installed one)",
                  [&](const std::string& file) { box.lecture = file; });
  add_numbers_option(app, [&](Numbers numbers) { box.numbers = numbers; });
  add_threads_option(app, [&](int threads) { box.threads = threads; });
  add_environment_options(app, "the default sky over scenes that bring no light at all", box.environment);
  add_seed_option(app, request.seed);
  app.add_option_function<std::uint64_t>(
         "--frames", [&](std::uint64_t frames) { request.frames = frames; }, "end after so many frames")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1} << 53U))
      ->type_name("N");
  add_text_option(
      app, "--script", "FILE",
      "presses to play, one a line: SECONDS press|release|tap BUTTON. Time is synthetic then, each frame "
      "adds one sample: the same script shows the same frames everywhere",
      [&](const std::string& file) { request.script = file; });
  add_text_option(
      app, "--out", "FILE.png",
      "write the last frame at the end. With the display 'headless' and neither --frames nor --script: "
      "the folder for a picture of every scene (.)",
      [&](const std::string& file) { request.out = file; });
  add_json_flag(app, request.json);

  std::string keys = "Buttons and their keys in the window:";
  for (const ActionButton& row : action_buttons()) {
    keys += "\n  " + std::string(row.button) + std::string(18 - row.button.size(), ' ') +
            std::string(row.key) + std::string(8 - row.key.size(), ' ') + std::string(row.meaning);
  }
  app.footer(keys);
}

/// "X,Y"
void take_pixel(const std::string& text, SampleAddress& at) {
  const char* const end = text.data() + text.size();
  const auto x = std::from_chars(text.data(), end, at.x);
  const bool comma = x.ec == std::errc{} && x.ptr != end && *x.ptr == ',';
  const auto y = std::from_chars(comma ? x.ptr + 1 : end, end, at.y);
  if (!comma || y.ec != std::errc{} || y.ptr != end) {
    refuse_value("--pixel", "'" + text + "' is no pixel; write it like 12,34");
  }
}

void add_view_option(CLI::App& app, const View*& view) {
  std::vector<std::string> keys;
  for (const View& row : views()) keys.emplace_back(row.key);
  std::string names;
  for (const std::string& key : keys) names += (names.empty() ? "" : "|") + key;
  add_text_option(app, "--view", names, "what a PNG shows (" + keys.front() + ")",
                  [&view, keys](const std::string& key) {
                    view = find_view(key);
                    if (view == nullptr)
                      refuse_value("--view", "no view '" + key + "'; " + name_remedy(key, keys));
                  });
}

void define_render(CLI::App& app, RenderRequest& request) {
  RenderOptions& options = request.options;
  options.mode = default_mode();
  options.width = 640;
  options.height = 480;

  add_scene_argument(app, request.scene);
  add_text_option(app, "-o,--out", "OUT.{pfm,png}",
                  "PFM: linear radiance in nits; PNG: exposed and tone mapped",
                  [&](const std::string& file) { request.out = file; });
  add_mode_option(app, std::string(options.mode->key), [&](const Mode* mode) { options.mode = mode; });
  add_parameter_options(app, request.changes);
  add_compare_options(app, request.compare, request.fairness);
  app.add_option("--split", request.split, "part of the width that shows A (0.5)")
      ->check(CLI::Range(0.0, 1.0))
      ->needs("--compare")
      ->type_name("F");
  add_view_option(app, request.view);
  add_size_option(app, "640x480", [&](PictureSize size) {
    options.width = size.width;
    options.height = size.height;
  });
  app.add_option("--spp", request.spp, "samples per pixel (64)")
      ->check(CLI::Range(1U, kMaxSpp))
      ->type_name("N");
  add_seed_option(app, options.seed);
  add_threads_option(app, [&](int threads) { request.threads = threads; });
  app.add_option("--max-depth", options.max_depth, "scattering events a path may have; a guard (256)")
      ->check(CLI::Range(1, kMaxDepth))
      ->type_name("N");
  add_numbers_option(app, [&](Numbers numbers) { request.numbers = numbers; });
  app.add_option("--camera", request.camera, "camera of the scene (0)")->type_name("NAME|INDEX");
  app.add_option("--time", request.time_s, "moment of the scene's animation (0)")
      ->check(CLI::Range(0.0, 1e9))
      ->type_name("SECONDS");
  add_environment_options(app, "the scene's own", request.environment);
  add_playlist_option(app, request.playlist);
  add_text_option(app, "--driver", "wave|path",
                  "how rays are traced, in waves or path by path; the picture is the same (wave)",
                  [&](const std::string& name) {
                    if (name != "wave" && name != "path") refuse_value("--driver", "use wave or path");
                    options.driver = name == "wave" ? Driver::kWave : Driver::kPath;
                  });
  app.add_option("--wave-size", options.wave_size, "paths that a wave begins with (4096)")
      ->check(CLI::Range(1, kMaxWaveSize))
      ->type_name("N");
  add_text_option(app, "--pixel", "X,Y",
                  "trace one sample of this pixel again and print its radiance; writes no file",
                  [&](const std::string& text) {
                    if (!request.replay) request.replay.emplace();
                    take_pixel(text, *request.replay);
                  });
  app.add_option_function<std::uint32_t>(
         "--sample",
         [&](std::uint32_t sample) {
           if (!request.replay) request.replay.emplace();
           request.replay->sample = sample;
         },
         "number of the sample that --pixel traces (0)")
      ->needs("--pixel")
      ->type_name("N");
  add_json_flag(app, request.json);
}

/// The ways of sampling that were asked for; a parameter that none of them has is a mistake.
std::vector<Technique> resolve_techniques(const RenderRequest& request) {
  std::vector<Technique> techniques = request.compare;
  if (techniques.empty()) techniques.push_back(technique_of(*request.options.mode));
  for (const ParameterChange& change : request.changes) {
    const auto has = [&](const Technique& technique) { return change.parameter->belongs(technique.parts); };
    for (Technique& technique : techniques) {
      if (has(technique) || std::ranges::none_of(techniques, has)) apply(change, technique);
    }
  }
  return techniques;
}

/// What no single option can tell.
void check(const RenderRequest& request) {
  if (request.replay && !request.compare.empty())
    throw UsageError("render: --pixel traces by one mode; leave --compare out");
  if (request.replay) {
    const SampleAddress& at = *request.replay;
    if (at.x < 0 || at.y < 0 || at.x >= request.options.width || at.y >= request.options.height) {
      throw UsageError("render: --pixel lies outside the picture of " +
                       std::to_string(request.options.width) + "x" + std::to_string(request.options.height) +
                       "; give the --size it belongs to");
    }
    return;
  }
  const std::string ending = request.out.extension().string();
  if (ending != ".pfm" && ending != ".png") {
    throw UsageError("render: the picture needs a file; name it with -o OUT.pfm or -o OUT.png");
  }
  if (ending == ".pfm" && request.view != &views().front())
    throw UsageError("render: a PFM holds radiance; name a file.png for --view " +
                     std::string(request.view->key));
}

constexpr const char* kExitCodes =
    "Exit codes: 0 done, 1 failed at run time, 2 wrong usage, 3 bad input file.";

/// Whether CLI11 knows what to do; otherwise the box is meant.
bool begins_with_command(const CLI::App& app, const std::string& argument) {
  if (argument == "--help" || argument == "-h" || argument == "--version") return true;
  const auto is_named = [&](const CLI::App* command) { return command->get_name() == argument; };
  return std::ranges::any_of(app.get_subcommands([](const CLI::App*) { return true; }), is_named);
}

std::string one_line(std::string text) {
  std::ranges::replace(text, '\n', ' ');
  return text;
}

}  // namespace

int execute(const TextRequest& request) {
  std::cout << request.text;
  return kDone;
}

Request parse_command_line(std::vector<std::string> arguments) {
  RunRequest run;
  RenderRequest render;
  ModesRequest modes;
  ScenesRequest scenes;
  InfoRequest info;
  ProbeRequest probe;

  CLI::App app("vitrine: a path tracer that lives in a small display box. Without a command it runs the box.",
               "vitrine");
  app.set_version_flag("--version", "vitrine " VITRINE_VERSION);
  app.require_subcommand(1);
  app.footer(kExitCodes);
  define_run(*app.add_subcommand("run", "show scenes on a display, changed by buttons (the default command)"),
             run);
  define_render(*app.add_subcommand("render", "render one picture of a scene into a file"), render);
  add_json_flag(*app.add_subcommand("modes", "list the sampling modes"), modes.json);
  CLI::App& scenes_app = *app.add_subcommand("scenes", "list the playlist as resolved");
  add_playlist_option(scenes_app, scenes.playlist);
  add_json_flag(scenes_app, scenes.json);
  CLI::App& info_app = *app.add_subcommand("info", "tell what a scene file holds and what of it is ignored");
  add_scene_argument(info_app, info.scene);
  add_playlist_option(info_app, info.playlist);
  add_json_flag(info_app, info.json);
  add_json_flag(*app.add_subcommand(
                    "probe", "list screens, modes, pins and input devices of this machine, to wire a box"),
                probe.json);

  if (arguments.empty() || !begins_with_command(app, arguments.front()))
    arguments.insert(arguments.begin(), "run");

  std::ranges::reverse(arguments);  // as CLI11 takes them
  try {
    app.parse(arguments);
  } catch (const CLI::CallForHelp&) {
    const bool all = app.get_subcommands().empty();
    return TextRequest{app.help("", all ? CLI::AppFormatMode::All : CLI::AppFormatMode::Normal)};
  } catch (const CLI::CallForVersion& version) {
    return TextRequest{std::string(version.what()) + "\n"};
  } catch (const CLI::ParseError& error) {
    const auto chosen = app.get_subcommands();
    const std::string command = chosen.empty() ? "" : " " + chosen.front()->get_name();
    throw UsageError(one_line(error.what()) + "; see vitrine" + command + " --help");
  }

  const std::string command = app.get_subcommands().front()->get_name();
  if (command == "render") {
    check(render);
    try {
      render.techniques = resolve_techniques(render);
    } catch (const UnknownChoice& unknown) {
      throw UsageError("render: " + std::string(unknown.what()) + "; " + unknown.remedy());
    }
    return render;
  }
  if (command == "modes") return modes;
  if (command == "scenes") return scenes;
  if (command == "info") return info;
  if (command == "probe") return probe;
  return run;
}

}  // namespace vitrine
