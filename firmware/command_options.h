// The options that several commands share, each defined once: names, check, help.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "comparison.h"
#include "environment_choice.h"
#include "frame/renderer.h"
#include "frame/views.h"
#include "picture_size.h"
#include "technique.h"

namespace vitrine {

inline constexpr int kMaxThreads = 1024;

/// The value of `option` will not do: becomes wrong usage.
[[noreturn]] void refuse_value(const std::string& option, const std::string& reason);

/// An option whose text goes to `take`, which may refuse_value().
void add_text_option(CLI::App& app, const std::string& name, const std::string& value_name,
                     const std::string& description, const std::function<void(const std::string&)>& take);

void add_scene_argument(CLI::App& app, std::string& scene);
void add_playlist_option(CLI::App& app, std::optional<std::filesystem::path>& playlist);
void add_mode_option(CLI::App& app, const std::string& fallback,
                     const std::function<void(const Mode*)>& take);
/// An option for each parameter of the modes.
void add_parameter_options(CLI::App& app, std::vector<ParameterChange>& changes);
/// To be added after the mode's.
void add_compare_options(CLI::App& app, std::vector<Technique>& compare, Fairness& fairness);
void add_numbers_option(CLI::App& app, const std::function<void(Numbers)>& take);
void add_size_option(CLI::App& app, const std::string& fallback,
                     const std::function<void(PictureSize)>& take);
void add_threads_option(CLI::App& app, const std::function<void(int)>& take);
void add_seed_option(CLI::App& app, std::uint64_t& seed);
/// `replaced` completes "instead of ...".
void add_environment_options(CLI::App& app, const std::string& replaced,
                             std::optional<EnvironmentChoice>& choice);
void add_json_flag(CLI::App& app, bool& json);

}  // namespace vitrine
