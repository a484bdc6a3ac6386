#include "command_render.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <iostream>

#include <sys/resource.h>
#include <unistd.h>

#include "exit_status.h"
#include "film/image_files.h"
#include "json_output.h"
#include "loaded_scene.h"
#include "nearest_name.h"
#include "output_file.h"
#include "picture.h"

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

void expose(Picture& picture, std::uint32_t spp) {
  const bool watched = isatty(STDERR_FILENO) != 0;
  picture.start_pass(spp);
  while (!picture.pass_ended(std::chrono::milliseconds(100))) {
    if (watched) std::fprintf(stderr, "\r%3.0f %%", 100.0 * picture.progress());
  }
  if (watched) std::fprintf(stderr, "\r     \r");
}

void write_picture(const Picture& picture, const std::filesystem::path& out) {
  if (out.extension() == ".pfm") {
    write_pfm(out, picture.film());
  } else {
    DevelopedPicture developed;
    picture.develop(picture.meter(), developed);
    write_png(out, developed.width, developed.height, developed.rgb);
  }
}

Json dropped_records(const TraceStats& stats) {
  Json records = Json::array();
  for (const DroppedSample& dropped : stats.dropped_samples) {
    records.push_back(
        {{"x", dropped.x}, {"y", dropped.y}, {"sample", dropped.sample}, {"seed", dropped.seed}});
  }
  return records;
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
                {"mode", request.options.mode->key},
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
            const TraceStats& stats, double seconds) {
  const double samples_per_s = static_cast<double>(stats.samples) / seconds;
  const double rays_per_s = static_cast<double>(stats.rays) / seconds;
  if (request.json) {
    print_json({{"scene", name},
                {"mode", request.options.mode->key},
                {"numbers", numbers_name(request.numbers)},
                {"width", request.options.width},
                {"height", request.options.height},
                {"spp", request.spp},
                {"max_depth", request.options.max_depth},
                {"seconds", seconds},
                {"samples_per_s", samples_per_s},
                {"rays", stats.rays},
                {"rays_per_s", rays_per_s},
                {"triangles", scene.baked->triangle_count()},
                {"lights", scene.baked->light_count()},
                {"peak_rss_bytes", peak_rss_bytes()},
                {"nonfinite_samples", stats.dropped},
                {"nonfinite_records", dropped_records(stats)}});
    return;
  }
  std::printf("%s: %.2f s, %.3g samples/s, %.3g rays/s\n", request.out.c_str(), seconds, samples_per_s,
              rays_per_s);
  if (stats.dropped > 0) {
    const DroppedSample& first = stats.dropped_samples.front();
    std::printf(
        "%llu samples dropped as not finite; see the first with --pixel %d,%d --sample %u --seed %llu\n",
        static_cast<unsigned long long>(stats.dropped), first.x, first.y, first.sample,
        static_cast<unsigned long long>(first.seed));
  }
}

}  // namespace

int execute(const RenderRequest& request) {
  if (!request.replay) require_writable(request.out);
  if (request.time_s != 0.0) {
    std::cerr << "vitrine: --time: this version plays no animation; the picture is that of time 0\n";
  }
  const PlaylistScene scene = resolve_scene(request.scene, find_playlist(request.playlist));
  const std::shared_ptr<const LoadedScene> loaded = load_scene(scene, request.numbers);
  RenderOptions options = request.options;
  options.camera = find_camera(*loaded, request.camera, scene.file.string());
  std::unique_ptr<const Renderer> renderer = loaded->baked->make_renderer(options);
  if (request.replay) return replay_sample(request, scene.name, *renderer);

  Workers workers(request.threads > 0 ? request.threads : default_thread_count());
  Picture picture(std::move(renderer), workers);
  const auto begin = std::chrono::steady_clock::now();
  expose(picture, request.spp);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
  write_picture(picture, request.out);
  report(request, scene.name, *loaded, picture.stats(), elapsed.count());
  return kDone;
}

}  // namespace vitrine
