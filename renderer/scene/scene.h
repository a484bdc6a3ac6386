// What a scene file describes, in the host's arithmetic and the file's own units (metres, nits, candela,
// lux): meshes placed by instances, materials with their textures, cameras, lights. glTF import fills it,
// `bake` turns it into the World<N> that is traced.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

namespace vitrine {

/// 8-bit RGBA rows from top to bottom, exactly as the file stores them (no transfer function applied).
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;  ///< width * height * 4 bytes
};

enum class TextureWrap : std::uint8_t { kRepeat, kMirroredRepeat, kClampToEdge };

/// A use of an image: which texture coordinates, how they are transformed (KHR_texture_transform), wrapped,
/// filtered.
struct TextureUse {
  int image = -1;             ///< index into Scene::images; -1: no texture
  int texcoord = 0;           ///< 0 or 1: which set of Primitive::uv
  glm::mat3 transform{1.0F};  ///< applied to (u, v, 1)
  TextureWrap wrap_s = TextureWrap::kRepeat;
  TextureWrap wrap_t = TextureWrap::kRepeat;
  bool nearest = false;  ///< nearest texel rather than bilinear

  explicit operator bool() const { return image >= 0; }
};

/// How much of a surface is there, by its alpha.
enum class AlphaMode : std::uint8_t {
  kOpaque,  ///< all of it
  kMask,    ///< all of it where alpha reaches the cutoff, nothing elsewhere
  kBlend    ///< that share of it
};

/// glTF 2.0 metallic-roughness with the extensions that vitrine reads. Factors multiply textures.
struct Material {
  std::string name;
  glm::vec3 base_color{1.0F};
  TextureUse base_color_texture;  ///< sRGB
  AlphaMode alpha_mode = AlphaMode::kOpaque;
  float alpha = 1.0F;
  float alpha_cutoff = 0.5F;  ///< kMask; beyond 1: nothing is there
  TextureUse alpha_texture;   ///< linear: A
  TextureUse normal_texture;  ///< linear: a tangent-space normal in RGB, 0..255 for -1..1
  float normal_scale = 1.0F;  ///< of its X and Y
  float metallic = 1.0F;
  float roughness = 1.0F;
  TextureUse metallic_roughness_texture;  ///< linear: G roughness, B metallic
  glm::vec3 emission{0.0F};               ///< emissiveFactor * emissiveStrength, nits
  TextureUse emission_texture;            ///< sRGB
  bool double_sided = false;              ///< emits from both sides (both sides always reflect)
  float ior = 1.5F;
  float specular = 1.0F;        ///< 0: pure Lambert
  TextureUse specular_texture;  ///< linear: A
  glm::vec3 specular_color{1.0F};
  TextureUse specular_color_texture;  ///< sRGB
  float transmission = 0.0F;
  TextureUse transmission_texture;    ///< linear: R
  bool refracts = false;              ///< volume thickness > 0: a solid that refracts; otherwise a thin wall
  glm::vec3 attenuation_color{1.0F};  ///< of white light after attenuation_distance inside of the solid
  std::optional<float> attenuation_distance;  ///< metres; nothing: the solid is clear
  glm::vec3 sheen_color{0.0F};
  TextureUse sheen_color_texture;  ///< sRGB
  float sheen_roughness = 0.0F;
  TextureUse sheen_roughness_texture;  ///< linear: A
  float clearcoat = 0.0F;
  TextureUse clearcoat_texture;  ///< linear: R
  float clearcoat_roughness = 0.0F;
  TextureUse clearcoat_roughness_texture;  ///< linear: G
};

/// Triangles of one material, in the mesh's own space. Empty attribute arrays mean "not given".
struct Primitive {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;            ///< unit; empty: flat shading
  std::array<std::vector<glm::vec2>, 2> uv;  ///< texture coordinate sets 0 and 1
  /// Along growing u of the normal map, perpendicular to the normal; w: cross(normal, tangent) times it, +-1,
  /// points along falling v. Empty: as the texture coordinates say.
  std::vector<glm::vec4> tangents;
  std::vector<glm::vec3> colors;      ///< linear, multiplies the base colour
  std::vector<float> alphas;          ///< multiplies alpha
  std::vector<glm::uvec3> triangles;  ///< indices into positions
  int material = -1;                  ///< index into Scene::materials; -1: glTF's default material
};

struct Mesh {
  std::string name;
  std::vector<Primitive> primitives;
};

/// A mesh placed in the world.
struct Instance {
  std::string name;
  int mesh = 0;
  glm::dmat4 to_world{1.0};
};

/// Looks along -z of its own space, y up.
struct CameraView {
  std::string name;
  glm::dmat4 to_world{1.0};
  bool orthographic = false;
  double yfov_rad = 0.8;         ///< perspective: full vertical angle
  double xmag = 1.0;             ///< orthographic: half width, metres
  double ymag = 1.0;             ///< orthographic: half height, metres
  std::optional<double> aspect;  ///< width / height that must stay visible
};

enum class PunctualKind : std::uint8_t { kPoint, kSpot, kDirectional };

/// KHR_lights_punctual. Shines along -z of its node.
struct PunctualLight {
  std::string name;
  PunctualKind kind = PunctualKind::kPoint;
  glm::vec3 intensity{1.0F};  ///< colour * intensity: candela (point, spot) or lux (directional)
  glm::dvec3 position{0.0};
  glm::dvec3 direction{0.0, 0.0, -1.0};  ///< unit
  double inner_cone_rad = 0.0;
  double outer_cone_rad = 0.7853981633974483;
};

/// A sky: radiance (nits) blends from `horizon` to `zenith` above and is `ground` below.
struct Environment {
  glm::vec3 zenith{0.0F};
  glm::vec3 horizon{0.0F};
  glm::vec3 ground{0.0F};
};

/// A picture of all directions, equirectangular, rows from top to bottom. Its middle is the direction +x,
/// what is to the right of the middle is +z (as in Blender and three.js, exported to glTF).
struct EnvironmentPicture {
  int width = 0;
  int height = 0;                 ///< half the width
  std::vector<glm::vec3> values;  ///< linear Rec.709
  double nits = 1000.0;           ///< that the value 1 stands for
  double rotation_rad = 0.0;      ///< around +y: a quarter turn brings the middle to -z
};

struct Scene {
  std::string file;  ///< where it was read from, for messages
  std::string name;
  std::vector<Image> images;
  std::vector<Material> materials;
  std::vector<Mesh> meshes;
  std::vector<Instance> instances;
  std::vector<CameraView> cameras;  ///< never empty after import: a camera is made where the file has none
  std::vector<PunctualLight> lights;
  std::optional<Environment> environment;
  std::optional<EnvironmentPicture> environment_picture;  ///< counts instead of `environment`
  bool has_default_light = false;  ///< the file brings none: `environment` is the default one
  std::vector<std::string>
      notes;  ///< what was ignored or approximated and why, a line each, for `vitrine info`
};

}  // namespace vitrine
