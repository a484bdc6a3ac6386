#include "picture_tour.h"

#include <algorithm>
#include <iostream>

#include "film/image_files.h"
#include "picture_view.h"

namespace vitrine {

bool take_tour(const ExhibitSettings& settings, const std::filesystem::path& folder, Workers& workers,
               const LoadScene& load, const std::atomic<bool>& stop,
               const std::function<void(const std::filesystem::path&)>& written) {
  bool all_shown = true;
  for (const PlaylistScene& scene : settings.scenes) {
    ExhibitSettings alone = settings;
    alone.scenes = {scene};
    alone.stand_in.reset();  // a scene that cannot be shown has no picture
    Exhibit exhibit(std::move(alone), Pace::kStepped, workers, load);
    const auto unfinished = [](const std::unique_ptr<Side>& side) { return side->samples() < kTourSamples; };
    while (std::ranges::any_of(exhibit.sides(), unfinished) && exhibit.error().empty() && !stop)
      exhibit.advance({});
    if (stop) break;
    if (!exhibit.error().empty()) {
      std::cerr << "vitrine: " << exhibit.error() << '\n';
      all_shown = false;
      continue;
    }
    const SurfaceMemory memory(settings.size.width, settings.size.height, PixelFormat::kRgb888);
    show_sides(memory.surface(), exhibit.sides(), settings.size.width / 2);
    const DevelopedPicture picture = read_picture(memory.surface());
    const std::filesystem::path file = folder / (scene.name + ".png");
    write_png(file, picture.width, picture.height, picture.rgb);
    written(file);
  }
  return all_shown;
}

}  // namespace vitrine
