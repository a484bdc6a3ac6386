// The modes as the program offers them: their keys, for help and for messages, and the one to begin with.
#pragma once

#include <string>
#include <vector>

#include "integrators/modes.h"

namespace vitrine {

inline std::vector<std::string> mode_keys() {
  std::vector<std::string> keys;
  for (const Mode& mode : modes()) keys.emplace_back(mode.key);
  return keys;
}

/// What pictures are made in when nobody says: the one that copes with every scene.
inline const Mode* default_mode() { return find_mode("mis"); }

}  // namespace vitrine
