// The checkout's own files, for tests that read them. One source file knows where it lies: with the path in
// every compiler command, no compiler cache could serve another checkout.
#pragma once

#include <string>

namespace vitrine {

/// The path of a file or folder of the checkout, by its name there: "scenes/cornell.gltf".
std::string source_file(const std::string& name);

}  // namespace vitrine
