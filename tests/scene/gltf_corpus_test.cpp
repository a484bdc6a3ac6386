// Public test suites of glTF, valid files and broken ones: each is imported or refused by an InputError,
// never anything else. The folder is not part of the project; VITRINE_SHARED says where it is.
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>
#include <vector>

#include <gtest/gtest.h>

#include "scene/gltf_import.h"
#include "scene/input_error.h"
#include "source_file.h"

namespace vitrine {
namespace {

std::filesystem::path corpus() {
  const char* shared = std::getenv("VITRINE_SHARED");
  return (shared != nullptr ? std::filesystem::path(shared)
                            : std::filesystem::path(source_file("../shared"))) /
         "gltf";
}

struct Outcome {
  int imported = 0;
  std::map<std::string, std::string> refused;  ///< file -> message
};

Outcome import_all(const std::filesystem::path& folder) {
  Outcome outcome;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const auto extension = entry.path().extension();
    if (extension != ".gltf" && extension != ".glb") continue;
    try {
      const Scene scene = import_gltf(entry.path());
      EXPECT_FALSE(scene.instances.empty()) << entry.path();
      EXPECT_FALSE(scene.cameras.empty()) << entry.path();
      ++outcome.imported;
    } catch (const InputError& error) {
      outcome.refused[entry.path().string()] = error.what();
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    }
  }
  return outcome;
}

void print(const char* name, const Outcome& outcome) {
  for (const auto& [file, message] : outcome.refused) std::cout << message << "\n";
  std::cout << name << ": " << outcome.imported << " imported, " << outcome.refused.size() << " refused\n";
}

TEST(GltfCorpus, ValidFilesAreImportedOrRefusedForAReason) {
  if (!std::filesystem::exists(corpus())) GTEST_SKIP() << "no corpus at " << corpus();
  const Outcome outcome = import_all(corpus() / "valid");
  print("valid", outcome);
  EXPECT_GT(outcome.imported, 0);
}

TEST(GltfCorpus, BrokenFilesDoNoHarm) {
  if (!std::filesystem::exists(corpus())) GTEST_SKIP() << "no corpus at " << corpus();
  const Outcome outcome = import_all(corpus() / "invalid");
  print("invalid", outcome);
  EXPECT_GT(outcome.refused.size(), 0U);
}

}  // namespace
}  // namespace vitrine
