#include "source_file.h"

namespace vitrine {

std::string source_file(const std::string& name) { return VITRINE_SOURCE_DIR "/" + name; }

}  // namespace vitrine
