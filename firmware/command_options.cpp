#include "command_options.h"

#include "mode_choice.h"
#include "nearest_name.h"

namespace vitrine {

void refuse_value(const std::string& option, const std::string& reason) {
  throw CLI::ValidationError(option, reason);
}

void add_text_option(CLI::App& app, const std::string& name, const std::string& value_name,
                     const std::string& description, const std::function<void(const std::string&)>& take) {
  app.add_option_function<std::string>(name, take, description)->type_name(value_name);
}

void add_scene_argument(CLI::App& app, std::string& scene) {
  app.add_option("SCENE", scene, "a .gltf or .glb file, or the name of a scene of the playlist")
      ->required()
      ->type_name("");
}

void add_playlist_option(CLI::App& app, std::optional<std::filesystem::path>& playlist) {
  add_text_option(app, "--playlist", "FILE", "TOML file that lists the scenes (the installed one)",
                  [&playlist](const std::string& file) { playlist = file; });
}

void add_mode_option(CLI::App& app, const std::string& fallback,
                     const std::function<void(const Mode*)>& take) {
  std::string description = "sampling mode (" + fallback + "):";
  for (const Mode& mode : modes())
    description += "\n  " + std::string(mode.key) + ": " + std::string(mode.label);
  add_text_option(app, "--mode", "KEY", description, [take](const std::string& key) {
    const Mode* mode = find_mode(key);
    if (mode == nullptr) refuse_value("--mode", "no mode '" + key + "'; " + name_remedy(key, mode_keys()));
    take(mode);
  });
}

void add_numbers_option(CLI::App& app, const std::function<void(Numbers)>& take) {
  add_text_option(app, "--numbers", "float|fixed", "number system to render in (float)",
                  [take](const std::string& name) {
                    const std::optional<Numbers> numbers = numbers_from_name(name);
                    if (!numbers)
                      refuse_value("--numbers", "no number system '" + name + "'; use float or fixed");
                    take(*numbers);
                  });
}

void add_size_option(CLI::App& app, const std::string& fallback,
                     const std::function<void(PictureSize)>& take) {
  add_text_option(app, "--size", "WxH", "pixels (" + fallback + ")", [take](const std::string& text) {
    const std::optional<PictureSize> size = parse_size(text);
    if (!size) {
      refuse_value("--size", "'" + text + "' is no size; write it like 640x480, each side 1 to " +
                                 std::to_string(kMaxPictureSide));
    }
    take(*size);
  });
}

void add_threads_option(CLI::App& app, const std::function<void(int)>& take) {
  app.add_option_function<int>("--threads", take, "threads to work on (one a core)")
      ->check(CLI::Range(1, kMaxThreads))
      ->type_name("N");
}

void add_seed_option(CLI::App& app, std::uint64_t& seed) {
  app.add_option("--seed", seed, "of the random numbers (0)")->check(CLI::NonNegativeNumber)->type_name("N");
}

void add_json_flag(CLI::App& app, bool& json) {
  app.add_flag("--json", json, "print one JSON value on stdout");
}

}  // namespace vitrine
