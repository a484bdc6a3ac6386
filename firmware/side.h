// One way of sampling on show: the picture that it makes, what of it is shown, how good it is and what it
// cost. An exhibit has one of them, or two that are compared.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include "comparison.h"
#include "picture.h"
#include "technique.h"

namespace vitrine {

struct Side {
  Side() = default;
  /// Before its first pass: `before` is what was on show in its place.
  Side(const Technique& how, DevelopedPicture before) : technique(how), shown(std::move(before)) {}

  Technique technique;
  std::unique_ptr<Picture> picture;  ///< in the making
  DevelopedPicture shown;  ///< the latest; before the first pass of `picture`, of what was on show before
  bool underdeveloped = false;       ///< exposure or view changed since
  std::uint32_t pass_samples = 1;    ///< of its next pass, if it is alone
  std::optional<double> error;       ///< relative, of the picture: 1 is 100 %
  std::uint32_t judged_samples = 0;  ///< how many a pixel had when that was estimated
  Clock::time_point judged;          ///< and when it was
  std::uint64_t rays = 0;            ///< of the passes that ended
  std::int64_t spent = 0;            ///< on its passes: nanoseconds, or rays where time must not count

  [[nodiscard]] std::uint32_t samples() const { return picture ? picture->samples() : 0; }
  [[nodiscard]] Share share() const { return {samples(), spent}; }
  /// Whether `shown` is of what was on show before.
  [[nodiscard]] bool outdated() const { return samples() == 0; }
};

}  // namespace vitrine
