// "Did you mean ...?": the known name that is closest to a mistyped one.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine {

/// A remedy for an unknown name: "did you mean 'scene'?" when one of `known` is at most two edits away, else
/// "known are a, b, c".
[[nodiscard]] std::string name_remedy(std::string_view name, std::span<const std::string> known);

/// The `count` of `known` that are closest, the closest first.
[[nodiscard]] std::vector<std::string> nearest_names(std::string_view name,
                                                     std::span<const std::string> known, std::size_t count);

}  // namespace vitrine
