// What can be changed about a mode: one row a parameter. Options of the command line, buttons of the kiosk,
// `vitrine modes` and the tests iterate this table; to add a parameter, add a row in parameters.cpp.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "integrators/sampling_parts.h"

namespace vitrine {

struct Parameter {
  std::string_view name;                    ///< of the option and of the button
  std::string_view label;                   ///< for a visitor
  std::string_view key;                     ///< of the keyboard
  std::string_view values;                  ///< what may be written: "a|b|..."
  std::string_view meaning;                 ///< for the help
  std::span<const std::string_view> cycle;  ///< what a button goes through
  /// Whether a way of sampling made of `parts` heeds it.
  bool (*belongs)(const SamplingParts& parts);
  /// Sets it to what `value` says; false if that is no value.
  bool (*set)(SamplingParts& parts, std::string_view value);
  /// Its present value, as set() reads it.
  std::string (*show)(const SamplingParts& parts);
};

/// Every parameter, in the order of the help.
std::span<const Parameter> parameters();
/// The parameter of that name, or nullptr.
const Parameter* find_parameter(std::string_view name);

}  // namespace vitrine
