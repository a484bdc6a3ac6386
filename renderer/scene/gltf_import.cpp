// The order of work: the checked model, where its nodes put things, the meshes that are shown with the
// materials that they use, then what every scene must have in the end: triangles, bounds, a camera, light.
#include "scene/gltf_import.h"

#include <algorithm>
#include <map>
#include <numbers>

#include "scene/default_environment.h"
#include "scene/framing.h"
#include "scene/gltf_accessors.h"
#include "scene/gltf_geometry.h"
#include "scene/gltf_limits.h"
#include "scene/gltf_materials.h"
#include "scene/gltf_model.h"
#include "scene/gltf_nodes.h"
#include "scene/hdr_file.h"

namespace vitrine {
namespace {

// Unlit surfaces have no unit. Where the default sky lights the rest they are as bright as its horizon.
constexpr float kUnlitUnderDefaultSky_nits = kDefaultEnvironment.horizon.x;

class GltfImport {
 public:
  explicit GltfImport(const std::filesystem::path& path)
      : gltf_(load_gltf_model(path)), accessors_(gltf_), materials_(gltf_) {}

  Scene run() {
    GltfPlacements placements = place_gltf_nodes(gltf_, accessors_);
    scene_.file = gltf_.file.path();
    scene_.name = scene_name();
    for (const auto& placed : placements.meshes) place_mesh(placed);
    if (triangles_ == 0) {
      const int scene = default_gltf_scene(gltf_.model);
      gltf_.file.refuse(scene < 0 ? "/nodes" : "/scenes/" + std::to_string(scene),
                        "the scene has no triangles", "add a mesh of triangles to one of its nodes");
    }
    const Bounds bounds = checked_bounds();
    scene_.cameras = std::move(placements.cameras);
    if (scene_.cameras.empty()) {
      scene_.cameras.push_back(framing_camera(bounds));
      gltf_.note("no camera: the scene is framed automatically");
    }
    scene_.lights = std::move(placements.lights);
    read_own_environment();
    const bool dark = !is_lit();
    materials_.move_into(scene_);
    if (dark) light_with_default_sky();
    scene_.notes = std::move(gltf_.notes);
    return std::move(scene_);
  }

 private:
  std::string scene_name() const {
    const int scene = default_gltf_scene(gltf_.model);
    const std::string name = scene < 0 ? "" : gltf_.model.scenes[static_cast<std::size_t>(scene)].name;
    return one_line(name.empty() ? gltf_.file.stem() : name);
  }

  void place_mesh(const GltfPlacements::Mesh& placed) {
    const auto known = meshes_.find(placed.mesh);
    const int mesh = known != meshes_.end() ? known->second : read_mesh(placed.mesh);
    for (const Primitive& primitive : scene_.meshes[static_cast<std::size_t>(mesh)].primitives) {
      triangles_ += primitive.triangles.size();
    }
    if (triangles_ > gltf_limits::kMaxTriangles) {
      gltf_.file.refuse(
          "/nodes/" + std::to_string(placed.node),
          "the scene has more than " + std::to_string(gltf_limits::kMaxTriangles) + " triangles",
          "simplify the scene");
    }
    if (scene_.meshes[static_cast<std::size_t>(mesh)].primitives.empty()) return;
    const std::string& name = gltf_.model.nodes[static_cast<std::size_t>(placed.node)].name;
    scene_.instances.push_back({one_line(name), mesh, placed.to_world});
  }

  int read_mesh(int source) {
    const auto& described = gltf_.model.meshes[static_cast<std::size_t>(source)];
    Mesh mesh;
    mesh.name = one_line(described.name);
    for (int i = 0; i < static_cast<int>(described.primitives.size()); ++i) {
      auto primitive = read_gltf_primitive(gltf_, accessors_, source, i);
      if (!primitive) continue;
      primitive->material = materials_.use(described.primitives[static_cast<std::size_t>(i)].material);
      mesh.primitives.push_back(std::move(*primitive));
    }
    scene_.meshes.push_back(std::move(mesh));
    const int index = static_cast<int>(scene_.meshes.size()) - 1;
    meshes_[source] = index;
    return index;
  }

  Bounds checked_bounds() const {
    const Bounds bounds = world_bounds(scene_);
    const glm::dvec3 farthest = glm::max(glm::abs(bounds.low), glm::abs(bounds.high));
    if (!(std::max({farthest.x, farthest.y, farthest.z}) <= gltf_limits::kMaxCoordinate_m)) {
      gltf_.file.refuse("/nodes", "a vertex lies farther than 1e9 m from the origin", "scale the scene down");
    }
    return bounds;
  }

  // A gradient, or a picture.
  void read_own_environment() {
    const int scene = default_gltf_scene(gltf_.model);
    if (scene < 0) return;
    const tinygltf::Value& extras = gltf_.model.scenes[static_cast<std::size_t>(scene)].extras;
    if (!extras.Has("vitrine") || !extras.Get("vitrine").Has("environment")) return;
    const tinygltf::Value& described = extras.Get("vitrine").Get("environment");
    const std::string place = "/scenes/" + std::to_string(scene) + "/extras/vitrine/environment";
    if (described.Has("image")) {
      const std::string image = place + "/image";
      const auto bytes = gltf_.file.read_uri(described.Get("image").Get<std::string>(), image);
      EnvironmentPicture picture = decode_hdr(bytes, gltf_.file.path(), image);
      const auto number = [&](const char* key, double fallback) {
        return described.Has(key) ? described.Get(key).GetNumberAsDouble() : fallback;
      };
      picture.nits = number("nits", picture.nits);
      picture.rotation_rad = number("rotation", 0.0) * std::numbers::pi / 180.0;
      scene_.environment_picture = std::move(picture);
      return;
    }
    const auto nits = [&](const char* key) {
      if (!described.Has(key))
        gltf_.file.refuse(place, "\"" + std::string(key) + "\" is missing", "add it, or name an \"image\"");
      glm::vec3 color;
      for (int i = 0; i < 3; ++i)
        color[i] = static_cast<float>(described.Get(key).Get(i).GetNumberAsDouble());
      return color;
    };
    scene_.environment = Environment{nits("zenith"), nits("horizon"), nits("ground")};
  }

  bool is_lit() const {
    if (scene_.environment || scene_.environment_picture || !scene_.lights.empty()) return true;
    const auto& materials = materials_.materials();
    for (std::size_t i = 0; i < materials.size(); ++i) {
      if (is_lamp(materials[i]) && !materials_.is_unlit(static_cast<int>(i))) return true;
    }
    return false;
  }

  // A textured glow of at most 1 nit, all that glTF has without KHR_materials_emissive_strength, is a detail
  // of a surface (a display, an eye) that was meant to be seen by some other light.
  static bool is_lamp(const Material& material) {
    const float brightest_nits = std::max({material.emission.x, material.emission.y, material.emission.z});
    return brightest_nits > (material.emission_texture ? 1.0F : 0.0F);
  }

  void light_with_default_sky() {
    scene_.environment = kDefaultEnvironment;
    scene_.has_default_light = true;
    gltf_.note("no light: a default sky of 1000 nits is added");
    for (std::size_t i = 0; i < scene_.materials.size(); ++i) {
      if (materials_.is_unlit(static_cast<int>(i)))
        scene_.materials[i].emission *= kUnlitUnderDefaultSky_nits;
    }
  }

  GltfModel gltf_;
  GltfAccessors accessors_;
  GltfMaterials materials_;
  Scene scene_;
  std::map<int, int> meshes_;  // of the file -> of the scene
  std::uint64_t triangles_ = 0;
};

}  // namespace

Scene import_gltf(const std::filesystem::path& path) { return GltfImport(path).run(); }

}  // namespace vitrine
