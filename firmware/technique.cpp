#include "technique.h"

#include <algorithm>

#include "mode_choice.h"
#include "nearest_name.h"

namespace vitrine {
namespace {

std::vector<std::string> parameter_names(const auto& belongs) {
  std::vector<std::string> names;
  for (const Parameter& parameter : parameters()) {
    if (belongs(parameter)) names.emplace_back(parameter.name);
  }
  return names;
}

/// The parts of `text` between separators.
std::vector<std::string_view> parts_between(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

}  // namespace

Technique technique_of(const Mode& mode, std::span<const ParameterChange> changes) {
  Technique technique{&mode, mode.parts};
  for (const ParameterChange& change : changes) {
    if (change.parameter->belongs(technique.parts)) change.parameter->set(technique.parts, change.value);
  }
  return technique;
}

ParameterChange parse_change(std::string_view name, std::string_view value) {
  const Parameter* parameter = find_parameter(name);
  if (parameter == nullptr) {
    throw UnknownChoice("no parameter '" + std::string(name) + "'",
                        name_remedy(name, parameter_names([](const Parameter&) { return true; })));
  }
  SamplingParts any;
  if (!parameter->set(any, value)) {
    const std::vector<std::string> usual(parameter->cycle.begin(), parameter->cycle.end());
    throw UnknownChoice("'" + std::string(value) + "' is no value of " + std::string(name) + " (" +
                            std::string(parameter->values) + ")",
                        name_remedy(value, usual));
  }
  return {parameter, std::string(value)};
}

void apply(const ParameterChange& change, Technique& technique) {
  const auto belongs = [&](const Parameter& parameter) { return parameter.belongs(technique.parts); };
  if (!belongs(*change.parameter)) {
    throw UnknownChoice(
        "the mode '" + std::string(technique.mode->key) + "' has no " + std::string(change.parameter->name),
        name_remedy(change.parameter->name, parameter_names(belongs)));
  }
  change.parameter->set(technique.parts, change.value);
}

Technique parse_technique(std::string_view text) {
  std::vector<std::string_view> words = parts_between(text, ' ');
  std::erase(words, "");  // between several spaces
  const std::string_view key = words.empty() ? "" : words.front();
  const Mode* mode = find_mode(key);
  if (mode == nullptr)
    throw UnknownChoice("no mode '" + std::string(key) + "'", name_remedy(key, mode_keys()));
  Technique technique = technique_of(*mode);
  for (const std::string_view word : std::span(words).subspan(1)) {
    const std::size_t equals = word.find('=');
    if (equals == std::string_view::npos) {
      throw UnknownChoice("'" + std::string(word) + "' says no value", "write NAME=VALUE after the mode");
    }
    apply(parse_change(word.substr(0, equals), word.substr(equals + 1)), technique);
  }
  return technique;
}

std::vector<Technique> parse_comparison(std::string_view text) {
  const std::vector<std::string_view> sides = parts_between(text, ',');
  if (sides.size() != 2) {
    throw UnknownChoice("'" + std::string(text) + "' is no comparison", "write two modes like basic,nee");
  }
  return {parse_technique(sides[0]), parse_technique(sides[1])};
}

Technique turned(const Technique& technique, const Parameter& parameter) {
  if (!parameter.belongs(technique.parts)) return technique;
  const auto now = std::ranges::find(parameter.cycle, parameter.show(technique.parts));
  const bool last = now == parameter.cycle.end() || now + 1 == parameter.cycle.end();
  Technique next = technique;
  parameter.set(next.parts, last ? parameter.cycle.front() : *(now + 1));
  return next;
}

Technique partner(const Technique& technique) {
  return technique_of(*find_mode(technique.mode->compare_with));
}

std::string describe_changes(const Technique& technique, const Technique* beside) {
  const bool same_mode = beside != nullptr && beside->mode == technique.mode;
  std::string text;
  for (const Parameter& parameter : parameters()) {
    if (!parameter.belongs(technique.parts)) continue;
    const std::string value = parameter.show(technique.parts);
    const bool told_apart = same_mode && value != parameter.show(beside->parts);
    if (value == parameter.show(technique.mode->parts) && !told_apart) continue;
    text += (text.empty() ? "" : ", ") + std::string(parameter.label) + ' ' + value;
  }
  return text;
}

}  // namespace vitrine
