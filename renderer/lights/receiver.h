// What a selection of lights is asked, and what it answers.
#pragma once

#include <cstdint>

#include "numeric/vec.h"

namespace vitrine {

/// Where light is wanted.
template <class N>
struct Receiver {
  Vec3<typename N::Length> position;
  Vec3<typename N::Unit> normal;  ///< geometric, towards the viewer
  bool both_sides = false;        ///< light from behind counts too
};

template <class N>
struct SelectedLight {
  std::uint32_t light;
  typename N::Density prob;
};

}  // namespace vitrine
