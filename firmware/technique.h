// A way of sampling as it is used: a mode, with whatever parameters of it were changed. How people write one:
// "nee", "nee shadow-rays=16", and two of them to be compared: "nee,nee shadow-rays=16".
#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "integrators/modes.h"
#include "integrators/parameters.h"

namespace vitrine {

struct Technique {
  const Mode* mode = nullptr;
  SamplingParts parts;

  bool operator==(const Technique&) const = default;
};

/// A parameter and what it is to be; the value is one that the parameter takes.
struct ParameterChange {
  const Parameter* parameter = nullptr;
  std::string value;
};

/// What was written is no mode, no parameter, no value: the problem, and the remedy.
class UnknownChoice : public std::runtime_error {
 public:
  UnknownChoice(const std::string& problem, std::string remedy)
      : std::runtime_error(problem), remedy_(std::move(remedy)) {}
  [[nodiscard]] const std::string& remedy() const { return remedy_; }

 private:
  std::string remedy_;
};

/// A mode with those of `changes` that it has.
Technique technique_of(const Mode& mode, std::span<const ParameterChange> changes = {});

/// Throws UnknownChoice when there is no such parameter or it takes no such value.
ParameterChange parse_change(std::string_view name, std::string_view value);
/// Throws UnknownChoice when the mode has no such parameter.
void apply(const ParameterChange& change, Technique& technique);
/// "KEY" or "KEY NAME=VALUE ...". Throws UnknownChoice.
Technique parse_technique(std::string_view text);
/// "A,B", each a technique. Throws UnknownChoice.
std::vector<Technique> parse_comparison(std::string_view text);

/// The technique with the next value of the parameter's cycle; itself when its mode does not have it.
Technique turned(const Technique& technique, const Parameter& parameter);
/// What it is compared with when nobody says: its mode's partner, as that mode is by itself.
Technique partner(const Technique& technique);

/// What differs from the mode's own choice, for a visitor: "Shadow rays 16, Sequence grid". Empty: nothing.
/// With another technique of the same mode `beside` it, what differs between the two is named as well.
std::string describe_changes(const Technique& technique, const Technique* beside = nullptr);

}  // namespace vitrine
