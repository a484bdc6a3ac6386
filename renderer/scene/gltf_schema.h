// The types, ranges and references that glTF 2.0 prescribes, as one table, and the walk that holds a JSON
// document against it. A glTF reader that skips what it does not understand turns a typing error into a wrong
// picture; here it is refused with its place. What the table does not list is removed, so that nothing
// unchecked is read later.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "scene/gltf_file.h"

namespace vitrine {

/// Refuses the first member of a wrong type, out of range, missing, or referring to nothing. Afterwards
/// `document` holds listed members only, integers as integers and numbers as floating point (within the range
/// of a float).
void check_gltf_schema(const GltfFile& file, nlohmann::json& document);

}  // namespace vitrine
