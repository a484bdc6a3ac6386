// The lecture as a tour: stops in its order, each a scene that shows one of its sections best, by one way of
// sampling or by two side by side, and a sentence about it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "comparison.h"
#include "playlist.h"
#include "technique.h"

namespace vitrine {

struct LectureStop {
  std::string section;
  std::string caption;
  PlaylistScene scene;
  std::vector<Technique> techniques;  ///< one, or two side by side
  Fairness fairness = Fairness::kEqualSamples;
};

/// Reads a lecture: `[[stop]]` tables with `section`, `caption`, `scene` (a file relative to the lecture) and
/// either `mode = "KEY"` or `compare = "A,B"`; optionally the parameters of the mode (for both sides of a
/// comparison; a side's own are written into it, see parse_comparison()) and `equal = "samples"|"time"`.
/// Scene files must exist but are not opened. Throws InputError.
std::vector<LectureStop> read_lecture(const std::filesystem::path& path);

/// The stops of `path`, or else of the installed lecture; none when that does not exist. Throws InputError.
std::vector<LectureStop> find_lecture(const std::optional<std::filesystem::path>& path);

/// Where a visitor is in the lecture.
class LectureTour {
 public:
  explicit LectureTour(std::vector<LectureStop> stops) : stops_(std::move(stops)) {}

  [[nodiscard]] bool empty() const { return stops_.empty(); }
  /// Goes on to the next stop, after the last to the first; after leave() back to the one that was left.
  const LectureStop& go_on();
  void leave() { under_way_ = false; }
  /// The next visitor begins with the first stop.
  void restart() {
    index_ = 0;
    under_way_ = false;
  }
  /// Nothing unless under way.
  [[nodiscard]] const LectureStop* stop() const { return under_way_ ? &stops_[index_] : nullptr; }
  /// "3/12 Russian roulette", of stop().
  [[nodiscard]] std::string title() const;

 private:
  std::vector<LectureStop> stops_;
  std::size_t index_ = 0;
  bool under_way_ = false;
};

}  // namespace vitrine
