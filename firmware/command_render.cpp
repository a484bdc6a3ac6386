#include "command_render.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <span>
#include <vector>

#include <sys/resource.h>

#include "exit_status.h"
#include "film/image_files.h"
#include "json_output.h"
#include "loaded_scene.h"
#include "nearest_name.h"
#include "output_file.h"
#include "picture_view.h"
#include "rendered_side.h"
#include "side_label.h"

namespace vitrine {
namespace {

/// The index of the camera that `text` names or counts.
int find_camera(const LoadedScene& scene, const std::string& text, const std::string& file) {
  const std::vector<std::string>& names = scene.cameras;
  const auto named = std::ranges::find(names, text);
  if (named != names.end()) return static_cast<int>(named - names.begin());
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
  if (error == std::errc{} && end == text.data() + text.size() && index < names.size())
    return static_cast<int>(index);
  throw UsageError(file + ": no camera '" + text + "'; it has " + std::to_string(names.size()) +
                   ", counted from 0: " + name_remedy(text, names));
}

std::uint64_t peak_rss_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

/// Both sides are exposed alike: as the one that shows best how bright the scene is.
Exposure meter(std::span<const RenderedSide> sides) {
  const auto error = [](const RenderedSide& side) { return side.error.value_or(HUGE_VAL); };
  return std::ranges::min_element(sides, {}, error)->picture->meter();
}

/// As a screen would show them, with labels if there are two.
DevelopedPicture develop_sides(const RenderRequest& request, std::span<const RenderedSide> sides) {
  const Exposure exposure = meter(sides);
  DevelopedPicture left;
  sides.front().picture->develop(*request.view, exposure, left);
  if (sides.size() == 1) return left;
  DevelopedPicture right;
  sides.back().picture->develop(*request.view, exposure, right);

  const SurfaceMemory memory(left.width, left.height, PixelFormat::kRgb888);
  const Surface& surface = memory.surface();
  const int column = split_column(request.split, left.width);
  show_picture(surface, left, false, 0, column);
  show_picture(surface, right, false, column, left.width);
  draw_split(surface, column);
  std::vector<HudSide> labels;
  for (const RenderedSide& side : sides) {
    const RenderedSide& other = &side == &sides.front() ? sides.back() : sides.front();
    labels.push_back(side_label(side.technique, &other.technique, side.picture->samples(), side.error));
  }
  draw_side_labels(surface, labels, request.split, 8);
  return read_picture(surface);
}

void write_sides(const RenderRequest& request, std::span<const RenderedSide> sides) {
  if (request.out.extension() == ".pfm") {
    const Film& left = sides.front().picture->film();
    write_pfm(request.out, left, sides.back().picture->film(), split_column(request.split, left.width()));
  } else {
    const DevelopedPicture picture = develop_sides(request, sides);
    write_png(request.out, picture.width, picture.height, picture.rgb);
  }
}

/// Traces one sample on its own: what a record of a dropped one is for.
int replay_sample(const RenderRequest& request, const std::string& name, const Renderer& renderer) {
  const SampleAddress& at = *request.replay;
  Film film = renderer.make_film();
  const std::atomic<bool> never{false};
  const TraceStats stats = renderer.trace({at.x, at.y, at.x + 1, at.y + 1}, {at.sample, 1}, film, never);
  const glm::dvec3 radiance = film.mean_nits(at.x, at.y);
  if (request.json) {
    print_json({{"scene", name},
                {"mode", request.techniques.front().mode->key},
                {"numbers", numbers_name(request.numbers)},
                {"x", at.x},
                {"y", at.y},
                {"sample", at.sample},
                {"seed", request.options.seed},
                {"rays", stats.rays},
                {"dropped", stats.dropped > 0},
                {"radiance", {radiance.r, radiance.g, radiance.b}}});
  } else if (stats.dropped > 0) {
    std::cout << "dropped: the radiance is not finite or out of the film's range\n";
  } else {
    std::cout << radiance.r << ' ' << radiance.g << ' ' << radiance.b << " nits\n";
  }
  return kDone;
}

void report(const RenderRequest& request, const std::string& name, const LoadedScene& scene,
            std::span<const RenderedSide> sides) {
  if (request.json) {
    Json report{{"scene", name},
                {"numbers", numbers_name(request.numbers)},
                {"width", request.options.width},
                {"height", request.options.height},
                {"max_depth", request.options.max_depth},
                {"triangles", scene.baked->triangle_count()},
                {"lights", scene.baked->light_count()},
                {"peak_rss_bytes", peak_rss_bytes()}};
    if (sides.size() == 1) {
      report.update(figures(sides.front()));
    } else {
      report["equal"] = request.fairness == Fairness::kEqualSamples ? "samples" : "time";
      report["split"] = request.split;
      for (const RenderedSide& side : sides) report["sides"].push_back(figures(side));
    }
    print_json(report);
    return;
  }
  for (const RenderedSide& side : sides) {
    const TraceStats& stats = side.picture->stats();
    const std::string of_mode = sides.size() == 1 ? "" : std::string(side.technique.mode->key) + ", ";
    std::printf("%s: %s%u spp in %.2f s, %.3g samples/s, %.3g rays/s%s\n", request.out.c_str(),
                of_mode.c_str(), side.picture->samples(), side.seconds,
                static_cast<double>(stats.samples) / side.seconds,
                static_cast<double>(stats.rays) / side.seconds,
                side.error ? (", error " + percent(*side.error)).c_str() : "");
    if (const std::string dropped = dropped_line(side); !dropped.empty()) std::puts(dropped.c_str());
  }
}

}  // namespace

int execute(const RenderRequest& request) {
  if (!request.replay) require_writable(request.out);
  if (request.time_s != 0.0) {
    std::cerr << "vitrine: --time: this version plays no animation; the picture is that of time 0\n";
  }
  PlaylistScene scene = resolve_scene(request.scene, find_playlist(request.playlist));
  if (request.environment) scene.environment = request.environment;
  const std::shared_ptr<const LoadedScene> loaded = load_scene(scene, request.numbers);
  RenderOptions options = request.options;
  options.camera = find_camera(*loaded, request.camera, scene.file.string());
  if (request.replay) {
    options.mode = request.techniques.front().mode;
    options.parts = request.techniques.front().parts;
    return replay_sample(request, scene.name, *loaded->baked->make_renderer(options));
  }

  Workers workers(request.threads > 0 ? request.threads : default_thread_count());
  std::vector<RenderedSide> sides;
  for (const Technique& technique : request.techniques) {
    RenderedSide side = begin_side(technique, *loaded->baked, options, workers);
    if (!sides.empty() && request.fairness == Fairness::kEqualTime) {
      trace_seconds(side, sides.front().seconds, kMaxSpp);
    } else {
      trace_samples(side, request.spp);
    }
    sides.push_back(std::move(side));
  }
  write_sides(request, sides);
  report(request, scene.name, *loaded, sides);
  return kDone;
}

}  // namespace vitrine
