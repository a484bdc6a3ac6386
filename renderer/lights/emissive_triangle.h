// A triangle of a mesh that shines.
#pragma once

#include <cstdint>

#include "numeric/vec.h"

namespace vitrine {

template <class N>
struct EmissiveTriangle {
  Vec3<typename N::Length> corner;
  Vec3<typename N::Length> edge_u;
  Vec3<typename N::Length> edge_v;
  Vec3<typename N::Unit> normal;
  std::uint32_t triangle;  ///< of the World
  double area;             ///< for building only
};

}  // namespace vitrine
