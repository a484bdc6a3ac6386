// Which glTF extensions vitrine knows, as one table. A file that requires another one cannot be shown as it
// was meant and is refused by that name; one that merely uses another one is shown without it, with a note.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "scene/gltf_file.h"

namespace vitrine {

/// Refuses an asset version other than 2.x and a required extension that vitrine lacks; notes every other
/// extension that is used but ignored.
void check_gltf_extensions(const GltfFile& file, const nlohmann::json& document,
                           std::vector<std::string>& notes);

}  // namespace vitrine
