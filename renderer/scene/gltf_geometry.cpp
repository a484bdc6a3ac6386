#include "scene/gltf_geometry.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <utility>

namespace vitrine {
namespace {

constexpr std::uint32_t kUnused = 0xFFFFFFFF;

std::vector<glm::uvec3> assemble(const std::vector<std::uint32_t>& corners, int mode) {
  std::vector<glm::uvec3> triangles;
  const std::size_t n = corners.size();
  if (mode == TINYGLTF_MODE_TRIANGLES) {
    for (std::size_t i = 0; i + 2 < n; i += 3)
      triangles.emplace_back(corners[i], corners[i + 1], corners[i + 2]);
  } else if (mode == TINYGLTF_MODE_TRIANGLE_STRIP) {
    // Every other triangle swaps its last two corners, so that all face the same way.
    for (std::size_t i = 0; i + 2 < n; ++i) {
      triangles.emplace_back(corners[i], corners[i + 1 + i % 2], corners[i + 2 - i % 2]);
    }
  } else {
    for (std::size_t i = 1; i + 1 < n; ++i) triangles.emplace_back(corners[i], corners[i + 1], corners[0]);
  }
  return triangles;
}

glm::dvec3 area_vector(const Primitive& primitive, const glm::uvec3& triangle) {
  const glm::dvec3 a = primitive.positions[triangle.x];
  return glm::cross(glm::dvec3(primitive.positions[triangle.y]) - a,
                    glm::dvec3(primitive.positions[triangle.z]) - a);
}

void drop_degenerate(Primitive& primitive) {
  std::erase_if(primitive.triangles, [&](const glm::uvec3& triangle) {
    return area_vector(primitive, triangle) == glm::dvec3(0.0);
  });
}

template <class T>
std::vector<T> picked(const std::vector<T>& all, const std::vector<std::uint32_t>& chosen) {
  std::vector<T> result;
  if (all.empty()) return result;
  result.reserve(chosen.size());
  for (const std::uint32_t i : chosen) result.push_back(all[i]);
  return result;
}

void keep_used_vertices(Primitive& primitive) {
  std::vector<std::uint32_t> new_index(primitive.positions.size(), kUnused);
  std::vector<std::uint32_t> used;
  for (glm::uvec3& triangle : primitive.triangles) {
    for (int corner = 0; corner < 3; ++corner) {
      std::uint32_t& renamed = new_index[triangle[corner]];
      if (renamed == kUnused) {
        renamed = static_cast<std::uint32_t>(used.size());
        used.push_back(triangle[corner]);
      }
      triangle[corner] = renamed;
    }
  }
  primitive.positions = picked(primitive.positions, used);
  primitive.normals = picked(primitive.normals, used);
  primitive.tangents = picked(primitive.tangents, used);
  primitive.colors = picked(primitive.colors, used);
  primitive.alphas = picked(primitive.alphas, used);
  for (auto& uv : primitive.uv) uv = picked(uv, used);
}

// Makes normals unit length; one too short to have a direction becomes that of a triangle that uses it.
void make_normals_unit(Primitive& primitive) {
  if (primitive.normals.empty()) return;
  constexpr double kShortest = 1e-6;
  for (const glm::uvec3& triangle : primitive.triangles) {
    for (int corner = 0; corner < 3; ++corner) {
      glm::vec3& normal = primitive.normals[triangle[corner]];
      if (glm::length(glm::dvec3(normal)) < kShortest)
        normal = glm::normalize(area_vector(primitive, triangle));
    }
  }
  for (glm::vec3& normal : primitive.normals) normal = glm::normalize(glm::dvec3(normal));
}

class PrimitiveReader {
 public:
  PrimitiveReader(GltfModel& gltf, GltfAccessors& accessors, const tinygltf::Primitive& source,
                  std::string place)
      : gltf_(gltf), accessors_(accessors), source_(source), place_(std::move(place)) {}

  std::optional<Primitive> read() {
    if (source_.mode < TINYGLTF_MODE_TRIANGLES) {
      gltf_.note(place_ + " skipped: points and lines are not shown");
      return std::nullopt;
    }
    const auto position = source_.attributes.find("POSITION");
    if (position == source_.attributes.end()) {
      gltf_.note(place_ + " skipped: it has no POSITION");
      return std::nullopt;
    }
    if (!source_.targets.empty()) gltf_.note("morph targets ignored: meshes are shown in their base shape");

    Primitive primitive;
    primitive.positions = accessors_.read_vectors<3>(position->second, attribute_place("POSITION"));
    primitive.triangles = assemble(read_corners(primitive.positions.size()), source_.mode);
    drop_degenerate(primitive);
    if (primitive.triangles.empty()) return std::nullopt;
    primitive.normals = read_attribute<3>("NORMAL", primitive.positions.size());
    primitive.uv = {read_attribute<2>("TEXCOORD_0", primitive.positions.size()),
                    read_attribute<2>("TEXCOORD_1", primitive.positions.size())};
    read_colors(primitive);
    // Flat triangles are not what the tangents were made for (glTF 2.0, section 3.7.2.1).
    if (!primitive.normals.empty()) {
      primitive.tangents = read_attribute<4>("TANGENT", primitive.positions.size());
    }
    keep_used_vertices(primitive);
    make_normals_unit(primitive);
    return primitive;
  }

 private:
  std::string attribute_place(const std::string& name) const { return place_ + "/attributes/" + name; }

  std::vector<std::uint32_t> read_corners(std::size_t vertices) {
    std::vector<std::uint32_t> corners;
    if (source_.indices < 0) {
      corners.resize(vertices);
      std::iota(corners.begin(), corners.end(), 0U);
    } else {
      corners = accessors_.read_indices(source_.indices, place_ + "/indices");
    }
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (corners[i] < vertices) continue;
      gltf_.file.refuse(place_ + "/indices",
                        "index " + std::to_string(i) + " is " + std::to_string(corners[i]) +
                            ", but there are " + std::to_string(vertices) + " vertices",
                        "repair the mesh or export the file again");
    }
    if (source_.mode == TINYGLTF_MODE_TRIANGLES && corners.size() % 3 != 0) {
      gltf_.note(place_ + ": corners left over after the last triangle ignored");
    }
    return corners;
  }

  bool has_attribute(const char* name, std::size_t vertices) {
    const auto attribute = source_.attributes.find(name);
    if (attribute == source_.attributes.end()) return false;
    if (accessors_.count(attribute->second) != vertices) {
      gltf_.file.refuse(attribute_place(name),
                        "has " + std::to_string(accessors_.count(attribute->second)) + " elements for " +
                            std::to_string(vertices) + " vertices",
                        "export the file again");
    }
    return true;
  }

  template <int N>
  std::vector<glm::vec<N, float>> read_attribute(const char* name, std::size_t vertices) {
    if (!has_attribute(name, vertices)) return {};
    return accessors_.read_vectors<N>(source_.attributes.at(name), attribute_place(name));
  }

  // COLOR_0 is RGB or RGBA.
  void read_colors(Primitive& primitive) {
    if (!has_attribute("COLOR_0", primitive.positions.size())) return;
    const int accessor = source_.attributes.at("COLOR_0");
    const std::string place = attribute_place("COLOR_0");
    if (accessors_.components(accessor) == 4) {
      for (const glm::vec4& color : accessors_.read_vectors<4>(accessor, place)) {
        primitive.colors.emplace_back(color);
        primitive.alphas.push_back(std::clamp(color.a, 0.0F, 1.0F));
      }
      if (std::ranges::all_of(primitive.alphas, [](float alpha) { return alpha == 1.0F; })) {
        primitive.alphas.clear();
      }
    } else {
      primitive.colors = accessors_.read_vectors<3>(accessor, place);
    }
    for (glm::vec3& color : primitive.colors) color = glm::clamp(color, 0.0F, 1.0F);
  }

  GltfModel& gltf_;
  GltfAccessors& accessors_;
  const tinygltf::Primitive& source_;
  std::string place_;
};

}  // namespace

std::optional<Primitive> read_gltf_primitive(GltfModel& gltf, GltfAccessors& accessors, int mesh,
                                             int primitive) {
  const auto& source =
      gltf.model.meshes[static_cast<std::size_t>(mesh)].primitives[static_cast<std::size_t>(primitive)];
  const std::string place = "/meshes/" + std::to_string(mesh) + "/primitives/" + std::to_string(primitive);
  return PrimitiveReader(gltf, accessors, source, place).read();
}

}  // namespace vitrine
