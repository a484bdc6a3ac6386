#include "scene/gltf_nodes.h"

#include <cmath>
#include <numbers>
#include <utility>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include "scene/gltf_limits.h"

namespace vitrine {
namespace {

constexpr const char* kInstancing = "EXT_mesh_gpu_instancing";
constexpr const char* kLights = "KHR_lights_punctual";

std::string node_place(int node) { return "/nodes/" + std::to_string(node); }

// Columns whose triple product is this small beside their lengths span no volume that doubles can invert.
constexpr double kFlat = 1e-12;

bool is_flat(const glm::dmat4& m) {
  const glm::dvec3 x(m[0]);
  const glm::dvec3 y(m[1]);
  const glm::dvec3 z(m[2]);
  const double box = glm::length(x) * glm::length(y) * glm::length(z);
  return !(std::abs(glm::dot(glm::cross(x, y), z)) > kFlat * box) || box == 0.0;
}

bool is_finite(const glm::dmat4& m) {
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      if (!(std::abs(m[column][row]) < 1e30)) return false;
    }
  }
  return true;
}

// glTF's rotations are x, y, z, w; GLM's constructor takes w first.
glm::dquat rotation_of(double x, double y, double z, double w) {
  return glm::normalize(glm::dquat(w, x, y, z));
}

glm::dmat4 composed(const glm::dvec3& translation, const glm::dquat& rotation, const glm::dvec3& scale) {
  return glm::translate(glm::dmat4(1.0), translation) * glm::mat4_cast(rotation) *
         glm::scale(glm::dmat4(1.0), scale);
}

// The rotation nearest to where a transform turns the z and y axes: cameras have no scale, and no mirror
// image.
glm::dmat4 without_scale(const glm::dmat4& m) {
  const glm::dvec3 z = glm::normalize(glm::dvec3(m[2]));
  const glm::dvec3 x = glm::normalize(glm::cross(glm::dvec3(m[1]), z));
  return {glm::dvec4(x, 0.0), glm::dvec4(glm::cross(z, x), 0.0), glm::dvec4(z, 0.0), m[3]};
}

class NodeWalk {
 public:
  NodeWalk(GltfModel& gltf, GltfAccessors& accessors) : gltf_(gltf), accessors_(accessors) {}

  GltfPlacements walk() {
    find_parents();
    for (const int root : roots()) descend_from(root);
    return std::move(placements_);
  }

 private:
  const tinygltf::Node& node(int index) const { return gltf_.model.nodes[static_cast<std::size_t>(index)]; }

  void find_parents() {
    const int count = static_cast<int>(gltf_.model.nodes.size());
    parent_.assign(gltf_.model.nodes.size(), -1);
    for (int parent = 0; parent < count; ++parent) {
      for (const int child : node(parent).children) {
        if (parent_[static_cast<std::size_t>(child)] >= 0) {
          refuse(node_place(parent) + "/children",
                 "node " + std::to_string(child) + " is already a child of node " +
                     std::to_string(parent_[static_cast<std::size_t>(child)]));
        }
        parent_[static_cast<std::size_t>(child)] = parent;
      }
    }
    // With one parent each, a node is in a cycle, or below one, if and only if no parentless node is above
    // it.
    std::vector<int> reached;
    for (int i = 0; i < count; ++i) {
      if (parent_[static_cast<std::size_t>(i)] < 0) reached.push_back(i);
    }
    std::vector<bool> is_reached(gltf_.model.nodes.size(), false);
    for (std::size_t i = 0; i < reached.size(); ++i) {
      is_reached[static_cast<std::size_t>(reached[i])] = true;
      reached.insert(reached.end(), node(reached[i]).children.begin(), node(reached[i]).children.end());
    }
    for (int i = 0; i < count; ++i) {
      if (!is_reached[static_cast<std::size_t>(i)])
        refuse(node_place(i), "the node is in or below a cycle of nodes");
    }
  }

  std::vector<int> roots() const {
    const int scene = default_gltf_scene(gltf_.model);
    std::vector<int> roots;
    if (scene < 0) {
      for (int i = 0; i < static_cast<int>(parent_.size()); ++i) {
        if (parent_[static_cast<std::size_t>(i)] < 0) roots.push_back(i);
      }
      return roots;
    }
    std::vector<bool> listed(parent_.size(), false);
    const auto& nodes = gltf_.model.scenes[static_cast<std::size_t>(scene)].nodes;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const auto root = static_cast<std::size_t>(nodes[i]);
      const std::string place = "/scenes/" + std::to_string(scene) + "/nodes/" + std::to_string(i);
      if (parent_[root] >= 0) refuse(place, "node " + std::to_string(root) + " is the child of another node");
      if (listed[root]) refuse(place, "node " + std::to_string(root) + " is listed twice");
      listed[root] = true;
      roots.push_back(nodes[i]);
    }
    return roots;
  }

  // Depth first in the order of the file, without recursion: files nest thousands of nodes.
  void descend_from(int root) {
    std::vector<std::pair<int, glm::dmat4>> pending{{root, glm::dmat4(1.0)}};
    while (!pending.empty()) {
      const auto [index, parent_to_world] = pending.back();
      pending.pop_back();
      const glm::dmat4 to_world = parent_to_world * local_transform(index);
      if (!is_finite(to_world)) {
        gltf_.file.refuse(node_place(index), "its transform is not finite", "correct the transform");
      }
      place(index, to_world);
      const auto& children = node(index).children;
      for (auto child = children.rbegin(); child != children.rend(); ++child)
        pending.emplace_back(*child, to_world);
    }
  }

  glm::dmat4 local_transform(int index) const {
    const tinygltf::Node& source = node(index);
    if (!source.matrix.empty()) {
      glm::dmat4 matrix(1.0);
      for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = source.matrix[static_cast<std::size_t>(i)];
      if (glm::dvec4(matrix[0][3], matrix[1][3], matrix[2][3], matrix[3][3]) != glm::dvec4(0, 0, 0, 1)) {
        gltf_.file.refuse(node_place(index) + "/matrix", "its last row is not 0 0 0 1",
                          "use an affine matrix");
      }
      return matrix;
    }
    const auto vector = [](const std::vector<double>& v, double otherwise) {
      return v.empty() ? glm::dvec3(otherwise) : glm::dvec3(v[0], v[1], v[2]);
    };
    glm::dquat rotation(1.0, 0.0, 0.0, 0.0);
    if (!source.rotation.empty()) {
      const auto& q = source.rotation;
      if (q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3] < 1e-12) {
        gltf_.file.refuse(node_place(index) + "/rotation", "the quaternion is zero", "use 0 0 0 1");
      }
      rotation = rotation_of(q[0], q[1], q[2], q[3]);
    }
    return composed(vector(source.translation, 0.0), rotation, vector(source.scale, 1.0));
  }

  void place(int index, const glm::dmat4& to_world) {
    const tinygltf::Node& source = node(index);
    const bool flat = is_flat(to_world);
    if (flat && (source.mesh >= 0 || source.camera >= 0 || source.extensions.count(kLights) != 0)) {
      gltf_.note(node_place(index) + " skipped: its scale is zero");
    }
    if (flat) return;
    if (source.mesh >= 0) place_mesh(index, to_world);
    if (source.camera >= 0) place_camera(index, to_world);
    const auto light = source.extensions.find(kLights);
    if (light != source.extensions.end())
      place_light(index, light->second.Get("light").GetNumberAsInt(), to_world);
  }

  void add_mesh(int index, const glm::dmat4& to_world) {
    if (placements_.meshes.size() >= gltf_limits::kMaxInstances) {
      gltf_.file.refuse(
          node_place(index),
          "the scene has more than " + std::to_string(gltf_limits::kMaxInstances) + " instances",
          "place fewer meshes");
    }
    placements_.meshes.push_back({node(index).mesh, index, to_world});
  }

  void place_mesh(int index, const glm::dmat4& to_world) {
    const auto instancing = node(index).extensions.find(kInstancing);
    if (instancing == node(index).extensions.end()) return add_mesh(index, to_world);

    const std::string place = node_place(index) + "/extensions/" + kInstancing + "/attributes";
    const tinygltf::Value& attributes = instancing->second.Get("attributes");
    const auto accessor = [&](const char* name) {
      return attributes.Has(name) ? attributes.Get(name).GetNumberAsInt() : -1;
    };
    const int translation = accessor("TRANSLATION");
    const int rotation = accessor("ROTATION");
    const int scale = accessor("SCALE");
    std::size_t count = 0;
    for (const int given : {translation, rotation, scale}) {
      if (given < 0) continue;
      if (count != 0 && accessors_.count(given) != count) {
        gltf_.file.refuse(place, "its accessors differ in count", "export the file again");
      }
      count = accessors_.count(given);
    }
    const auto translations = translation < 0
                                  ? std::vector<glm::vec3>(count, glm::vec3(0.0F))
                                  : accessors_.read_vectors<3>(translation, place + "/TRANSLATION");
    const auto rotations = rotation < 0 ? std::vector<glm::vec4>(count, glm::vec4(0.0F, 0.0F, 0.0F, 1.0F))
                                        : accessors_.read_vectors<4>(rotation, place + "/ROTATION");
    const auto scales = scale < 0 ? std::vector<glm::vec3>(count, glm::vec3(1.0F))
                                  : accessors_.read_vectors<3>(scale, place + "/SCALE");
    for (std::size_t i = 0; i < count; ++i) {
      const glm::vec4 q = rotations[i];
      if (glm::length(q) < 1e-6F)
        gltf_.file.refuse(place + "/ROTATION", "a quaternion is zero", "use 0 0 0 1");
      const glm::dmat4 copy =
          to_world * composed(translations[i], rotation_of(q.x, q.y, q.z, q.w), scales[i]);
      if (!is_finite(copy)) gltf_.file.refuse(place, "a transform is not finite", "correct the transform");
      if (!is_flat(copy)) add_mesh(index, copy);
    }
  }

  void place_camera(int index, const glm::dmat4& to_world) {
    const auto& source = gltf_.model.cameras[static_cast<std::size_t>(node(index).camera)];
    const std::string place = "/cameras/" + std::to_string(node(index).camera);
    CameraView view;
    view.name =
        one_line(!source.name.empty()        ? source.name
                 : !node(index).name.empty() ? node(index).name
                                             : "camera " + std::to_string(placements_.cameras.size()));
    view.to_world = without_scale(to_world);
    view.orthographic = source.type == "orthographic";
    if (view.orthographic) {
      view.xmag = std::abs(source.orthographic.xmag);
      view.ymag = std::abs(source.orthographic.ymag);
      if (!(view.xmag > 1e-9 && view.ymag > 1e-9)) {
        gltf_.file.refuse(place + "/orthographic", "xmag or ymag is zero", "give the camera a size");
      }
    } else {
      view.yfov_rad = source.perspective.yfov;
      if (source.perspective.aspectRatio > 0.0) view.aspect = source.perspective.aspectRatio;
    }
    placements_.cameras.push_back(view);
  }

  void place_light(int index, int light_index, const glm::dmat4& to_world) {
    const auto& source = gltf_.model.lights[static_cast<std::size_t>(light_index)];
    const std::string place =
        std::string("/extensions/") + kLights + "/lights/" + std::to_string(light_index);
    PunctualLight light;
    light.name = one_line(source.name.empty() ? node(index).name : source.name);
    light.position = glm::dvec3(to_world[3]);
    light.direction = -glm::normalize(glm::dvec3(to_world[2]));
    if (!source.color.empty()) {
      light.intensity = {static_cast<float>(source.color[0]), static_cast<float>(source.color[1]),
                         static_cast<float>(source.color[2])};
    }
    light.intensity *= static_cast<float>(source.intensity);
    if (!(glm::length(glm::dvec3(light.intensity)) < 1e12)) {
      gltf_.file.refuse(place + "/intensity", "is more than 1e12", "lower it");
    }
    if (source.range > 0.0)
      gltf_.note(place + ": range ignored, light falls off with the square of the distance");
    if (source.type == "directional") light.kind = PunctualKind::kDirectional;
    if (source.type == "spot") {
      light.kind = PunctualKind::kSpot;
      light.inner_cone_rad = source.spot.innerConeAngle;
      light.outer_cone_rad = std::min(source.spot.outerConeAngle, std::numbers::pi / 2);
      if (!(light.inner_cone_rad < light.outer_cone_rad)) {
        gltf_.file.refuse(place + "/spot", "innerConeAngle is not less than outerConeAngle",
                          "correct the angles");
      }
    }
    placements_.lights.push_back(light);
  }

  [[noreturn]] void refuse(const std::string& place, const std::string& problem) const {
    gltf_.file.refuse(place, problem, "make the nodes a tree or export the file again");
  }

  GltfModel& gltf_;
  GltfAccessors& accessors_;
  std::vector<int> parent_;
  GltfPlacements placements_;
};

}  // namespace

int default_gltf_scene(const tinygltf::Model& model) {
  if (model.scenes.empty()) return -1;
  return model.defaultScene < 0 ? 0 : model.defaultScene;
}

GltfPlacements place_gltf_nodes(GltfModel& gltf, GltfAccessors& accessors) {
  return NodeWalk(gltf, accessors).walk();
}

}  // namespace vitrine
