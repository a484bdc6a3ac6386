#include "picture_tour.h"

#include <iostream>

#include "film/image_files.h"

namespace vitrine {

bool take_tour(const ExhibitSettings& settings, const std::filesystem::path& folder, Workers& workers,
               const LoadScene& load, const std::atomic<bool>& stop,
               const std::function<void(const std::filesystem::path&)>& written) {
  bool all_shown = true;
  for (const PlaylistScene& scene : settings.scenes) {
    ExhibitSettings alone = settings;
    alone.scenes = {scene};
    Exhibit exhibit(std::move(alone), Pace::kStepped, workers, load);
    while (exhibit.samples() < kTourSamples && exhibit.error().empty() && !stop) exhibit.advance({});
    if (stop) break;
    if (!exhibit.error().empty()) {
      std::cerr << "vitrine: " << exhibit.error() << '\n';
      all_shown = false;
      continue;
    }
    const DevelopedPicture& picture = exhibit.picture();
    const std::filesystem::path file = folder / (scene.name + ".png");
    write_png(file, picture.width, picture.height, picture.rgb);
    written(file);
  }
  return all_shown;
}

}  // namespace vitrine
