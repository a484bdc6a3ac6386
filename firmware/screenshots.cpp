#include "screenshots.h"

#include <algorithm>
#include <system_error>
#include <utility>
#include <vector>

#include "film/image_files.h"

namespace vitrine {
namespace {

void remove_oldest(const std::filesystem::path& folder, std::size_t kept) {
  std::vector<std::pair<std::filesystem::file_time_type, std::filesystem::path>> files;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with("vitrine-") || !name.ends_with(".png")) continue;
    files.emplace_back(entry.last_write_time(ignored), entry.path());
  }
  if (files.size() <= kept) return;
  std::ranges::sort(files);
  for (std::size_t i = 0; i < files.size() - kept; ++i) std::filesystem::remove(files[i].second, ignored);
}

}  // namespace

std::string save_screenshot(const std::filesystem::path& folder, const std::string& name,
                            const DevelopedPicture& picture, std::size_t kept) {
  std::string file = "vitrine-" + name + ".png";
  write_png(folder / file, picture.width, picture.height, picture.rgb);
  remove_oldest(folder, kept);
  return file;
}

}  // namespace vitrine
