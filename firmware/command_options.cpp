#include "command_options.h"

#include "mode_choice.h"
#include "nearest_name.h"

namespace vitrine {
namespace {

/// Runs `parse`; what it does not know becomes wrong usage of `option`.
template <class Parse>
void or_refuse(const std::string& option, const Parse& parse) {
  try {
    parse();
  } catch (const UnknownChoice& unknown) {
    refuse_value(option, std::string(unknown.what()) + "; " + unknown.remedy());
  }
}

}  // namespace

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

void add_parameter_options(CLI::App& app, std::vector<ParameterChange>& changes) {
  for (const Parameter& parameter : parameters()) {
    const std::string option = "--" + std::string(parameter.name);
    add_text_option(app, option, std::string(parameter.values),
                    std::string(parameter.meaning) + " (the mode's)",
                    [&changes, &parameter, option](const std::string& value) {
                      or_refuse(option, [&] { changes.push_back(parse_change(parameter.name, value)); });
                    });
  }
}

void add_compare_options(CLI::App& app, std::vector<Technique>& compare, Fairness& fairness) {
  add_text_option(app, "--compare", "A,B",
                  "two modes side by side; each may change its parameters: \"nee,nee shadow-rays=16\"",
                  [&compare](const std::string& text) {
                    or_refuse("--compare", [&] { compare = parse_comparison(text); });
                  });
  app.get_option("--compare")->excludes("--mode");
  app.add_flag_callback(
         "--equal-time", [&fairness] { fairness = Fairness::kEqualTime; },
         "compare at equal time, not at equal samples")
      ->needs("--compare");
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

void add_environment_options(CLI::App& app, const std::string& replaced,
                             std::optional<EnvironmentChoice>& choice) {
  add_text_option(app, "--environment", "FILE.hdr",
                  "light from an equirectangular Radiance picture, instead of " + replaced,
                  [&choice](const std::string& file) { choice = EnvironmentChoice{.file = file}; });
  app.add_option_function<double>(
         "--environment-nits",
         [&choice](double nits) {
           if (choice) choice->nits = nits;
         },
         "nits that the picture's value 1 stands for (1000)")
      ->check(CLI::Range(1e-6, kMaxEnvironmentNits))
      ->needs("--environment")
      ->type_name("N");
  app.add_option_function<double>(
         "--environment-rotation",
         [&choice](double degrees) {
           if (choice) choice->rotation_deg = degrees;
         },
         "turns the picture to the left: its middle is +x, with 90 it is -z (0)")
      ->check(CLI::Range(-kMaxEnvironmentRotation_deg, kMaxEnvironmentRotation_deg))
      ->needs("--environment")
      ->type_name("DEGREES");
}

void add_json_flag(CLI::App& app, bool& json) {
  app.add_flag("--json", json, "print one JSON value on stdout");
}

}  // namespace vitrine
