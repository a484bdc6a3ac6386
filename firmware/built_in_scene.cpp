#include "built_in_scene.h"

#include <array>
#include <cmath>
#include <numbers>

#include <glm/gtc/matrix_transform.hpp>

namespace vitrine {
namespace {

/// No file has this name: a path ends in no slash.
constexpr const char* kName = "built-in/";

enum MaterialIndex : int { kWhite, kRed, kGreen, kLamp };

Material matte(const std::string& name, const glm::vec3& color) {
  Material material;
  material.name = name;
  material.base_color = color;
  material.metallic = 0.0F;
  material.specular = 0.0F;
  return material;
}

/// Counter-clockwise as seen from where it is looked at.
using Quad = std::array<glm::vec3, 4>;

void add_quad(Primitive& primitive, const Quad& corners) {
  const auto first = static_cast<unsigned>(primitive.positions.size());
  primitive.positions.insert(primitive.positions.end(), corners.begin(), corners.end());
  primitive.triangles.emplace_back(first, first + 1, first + 2);
  primitive.triangles.emplace_back(first, first + 2, first + 3);
}

/// A block on the floor, turned about the vertical; its bottom is left out.
void add_block(Primitive& primitive, const glm::vec2& place, float width, float height, float turn_rad) {
  const glm::vec2 u = glm::vec2(std::cos(turn_rad), std::sin(turn_rad)) * (width / 2.0F);
  const glm::vec2 v(-u.y, u.x);
  const std::array<glm::vec2, 4> feet{place - u - v, place + u - v, place + u + v, place - u + v};
  const auto at = [](const glm::vec2& foot, float y) { return glm::vec3(foot.x, y, foot.y); };
  add_quad(primitive, {at(feet[3], height), at(feet[2], height), at(feet[1], height), at(feet[0], height)});
  for (std::size_t i = 0; i < 4; ++i) {
    const glm::vec2& a = feet[i];
    const glm::vec2& b = feet[(i + 1) % 4];
    add_quad(primitive, {at(b, 0.0F), at(a, 0.0F), at(a, height), at(b, height)});
  }
}

void place(Scene& scene, const std::string& name, MaterialIndex material, Primitive primitive) {
  primitive.material = material;
  scene.instances.push_back({.name = name, .mesh = static_cast<int>(scene.meshes.size())});
  scene.meshes.push_back({.name = name, .primitives = {std::move(primitive)}});
}

}  // namespace

Scene built_in_scene() {
  // A room of 2 x 2 x 2 m around the vertical, open towards the camera at +z.
  constexpr float kHalf = 1.0F;
  constexpr float kTop = 2.0F;
  const auto corner = [](float x, float y, float z) { return glm::vec3(x * kHalf, y * kTop, z * kHalf); };

  Scene scene;
  scene.file = kName;
  scene.name = "built-in";
  scene.materials = {matte("white", {0.73F, 0.71F, 0.68F}), matte("red", {0.63F, 0.065F, 0.05F}),
                     matte("green", {0.14F, 0.45F, 0.091F}), matte("lamp", {0.0F, 0.0F, 0.0F})};
  scene.materials[kLamp].emission = {1700.0F, 1200.0F, 400.0F};

  Primitive white;
  add_quad(white, {corner(-1, 0, 1), corner(1, 0, 1), corner(1, 0, -1), corner(-1, 0, -1)});    // floor
  add_quad(white, {corner(-1, 1, -1), corner(1, 1, -1), corner(1, 1, 1), corner(-1, 1, 1)});    // ceiling
  add_quad(white, {corner(-1, 0, -1), corner(1, 0, -1), corner(1, 1, -1), corner(-1, 1, -1)});  // back
  add_block(white, {-0.35F, -0.3F}, 0.6F, 1.2F, 0.3F);
  add_block(white, {0.4F, 0.3F}, 0.55F, 0.55F, -0.3F);
  place(scene, "room and blocks", kWhite, std::move(white));
  Primitive left;
  add_quad(left, {corner(-1, 0, 1), corner(-1, 0, -1), corner(-1, 1, -1), corner(-1, 1, 1)});
  place(scene, "left wall", kRed, std::move(left));
  Primitive right;
  add_quad(right, {corner(1, 0, -1), corner(1, 0, 1), corner(1, 1, 1), corner(1, 1, -1)});
  place(scene, "right wall", kGreen, std::move(right));
  Primitive lamp;
  constexpr float kLampHalf = 0.25F;
  constexpr float kLampHeight = 1.99F;
  add_quad(lamp, {glm::vec3(-kLampHalf, kLampHeight, -kLampHalf),
                  {kLampHalf, kLampHeight, -kLampHalf},
                  {kLampHalf, kLampHeight, kLampHalf},
                  {-kLampHalf, kLampHeight, kLampHalf}});
  place(scene, "lamp", kLamp, std::move(lamp));

  scene.cameras.push_back({.name = "camera",
                           .to_world = glm::translate(glm::dmat4(1.0), glm::dvec3(0.0, 1.0, 3.9)),
                           .yfov_rad = 38.0 * std::numbers::pi / 180.0,
                           .aspect = 1.0});
  return scene;
}

PlaylistScene built_in_row() {
  return {.name = "built-in", .file = kName, .title = "Built-in room", .caption = "", .mode = nullptr};
}

bool is_built_in(const PlaylistScene& scene) { return scene.file == kName; }

}  // namespace vitrine
