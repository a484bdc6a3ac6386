// What programs read: one JSON value on stdout.
#pragma once

#include <nlohmann/json.hpp>

namespace vitrine {

/// An object whose keys stay in the order they are written in.
using Json = nlohmann::ordered_json;

/// Prints `value` on stdout; bytes of names that are no UTF-8 are replaced.
void print_json(const Json& value);

}  // namespace vitrine
