#include "scene/bake.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "numeric/color.h"
#include "numeric/fixed_numbers.h"
#include "numeric/float_numbers.h"
#include "numeric/host_conversion.h"
#include "scene/environment_lattice.h"
#include "scene/framing.h"
#include "scene/input_error.h"
#include "scene/light_emissions.h"
#include "scene/material_baker.h"
#include "scene/tangents.h"

namespace vitrine {
namespace {

double srgb_to_linear(double x) { return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4); }

double max_of(const glm::vec3& v) { return static_cast<double>(std::max({v.x, v.y, v.z})); }

// Centre of what can be seen and the half extent of a box around it that holds everything a ray may start
// from.
struct Extent {
  glm::dvec3 center{0.0};
  double radius = 1.0;
};

Extent measure(const Scene& scene) {
  const Bounds geometry = world_bounds(scene);
  Extent extent;
  extent.center = 0.5 * (geometry.low + geometry.high);
  double radius = 0.0;
  const auto include = [&](const glm::dvec3& p) {
    const glm::dvec3 d = glm::abs(p - extent.center);
    radius = std::max({radius, d.x, d.y, d.z});
  };
  include(geometry.high);
  const double geometry_radius = radius;
  for (const PunctualLight& light : scene.lights) {
    if (light.kind != PunctualKind::kDirectional) include(light.position);
  }
  for (const CameraView& camera : scene.cameras) {
    const glm::dvec3 eye(camera.to_world[3]);
    const double film = camera.orthographic ? std::hypot(camera.xmag, camera.ymag) * 4.0 : 0.0;
    include(eye + film);
    include(eye - film);
  }
  if (!std::isfinite(radius) || !(radius > 0.0)) {
    throw InputError(scene.file, "", "the scene has no extent or an infinite one",
                     "check its positions and transforms");
  }
  if (geometry_radius < radius * 0x1p-12) {
    throw InputError(scene.file, "",
                     "a camera or a light is over 4096 times as far away as the geometry is large",
                     "move it closer");
  }
  extent.radius = radius * 1.001;
  return extent;
}

template <class N>
class Baker {
  using Unit = typename N::Unit;
  using Length = typename N::Length;
  using Radiance = typename N::Radiance;
  using TexCoord = typename N::TexCoord;

 public:
  explicit Baker(const Scene& scene) : scene_(scene), extent_(measure(scene)) {
    if (scene.environment_picture) lattice_ = make_environment_lattice(*scene.environment_picture);
    world_.center = extent_.center;
    world_.scale = 1.0 / extent_.radius;
  }

  World<N> bake() {
    world_.exponent = radiance_exponent();
    for (std::size_t i = 0; i < 256; ++i) {
      const double x = static_cast<double>(i) / 255.0;
      world_.linear_table[i] = from_host<Unit>(x);
      world_.srgb_table[i] = from_host<Unit>(srgb_to_linear(x));
    }
    world_.images = scene_.images;
    MaterialBaker<N> materials(world_.images, world_.scale, world_.exponent);
    for (const Material& material : scene_.materials) world_.materials.push_back(materials.bake(material));
    world_.materials.push_back(materials.bake(default_material_));
    uv_sets_.assign(materials.uv_sets().begin(), materials.uv_sets().end());
    world_.uv_sets.resize(uv_sets_.size());
    for (const Instance& instance : scene_.instances) {
      for (const Primitive& p : scene_.meshes[static_cast<std::size_t>(instance.mesh)].primitives) {
        const TextureUse& map = material_of(p).normal_texture;
        if (map && p.tangents.empty()) {
          add(instance, with_tangents(p, map));
        } else {
          add(instance, p);
        }
      }
    }
    world_.see_through =
        !std::ranges::all_of(world_.materials, [](const auto& m) { return m.coverage.complete; });
    world_.absorbs = std::ranges::any_of(world_.materials, [](const auto& m) { return bool{m.absorption}; });
    world_.bvh = Bvh<N>(std::move(positions_), std::move(triangles_));
    bake_punctual_lights();
    bake_environment();
    world_.light_selectors = LightSelectors<N>(light_emissions(world_));
    return std::move(world_);
  }

 private:
  // Such that the brightest light has radiance about 1; a point light is taken at a sixteenth of the scene's
  // extent.
  [[nodiscard]] int radiance_exponent() const {
    double brightest = 0.0;
    for (const Material& m : scene_.materials) brightest = std::max(brightest, max_of(m.emission));
    for (const glm::dvec3& point : lattice_.radiance)
      brightest = std::max({brightest, point.x, point.y, point.z});
    if (const auto& sky = scene_.environment; sky && !scene_.environment_picture) {
      brightest = std::max({brightest, max_of(sky->zenith), max_of(sky->horizon), max_of(sky->ground)});
    }
    for (const PunctualLight& light : scene_.lights) {
      const double distance = light.kind == PunctualKind::kDirectional ? 1.0 : extent_.radius / 16.0;
      brightest = std::max(brightest, max_of(light.intensity) / (std::numbers::pi * distance * distance));
    }
    return brightest > 0.0 ? static_cast<int>(std::ceil(std::log2(brightest))) : 0;
  }

  [[nodiscard]] Vec3<Radiance> radiance(const glm::dvec3& nits) const {
    return from_host<Radiance>(nits * std::ldexp(1.0, -world_.exponent));
  }
  [[nodiscard]] Vec3<Length> position(const glm::dvec3& metres) const {
    return from_host<Length>((metres - world_.center) * world_.scale);
  }

  // glTF's default material comes after the scene's own.
  [[nodiscard]] std::uint32_t material_index(const Primitive& primitive) const {
    return static_cast<std::uint32_t>(primitive.material < 0 ? static_cast<int>(scene_.materials.size())
                                                             : primitive.material);
  }
  [[nodiscard]] const Material& material_of(const Primitive& primitive) const {
    return primitive.material < 0 ? default_material_ : scene_.materials[material_index(primitive)];
  }

  void add(const Instance& instance, const Primitive& primitive) {
    const auto first = static_cast<std::uint32_t>(positions_.size());
    const glm::dmat3 linear(instance.to_world);
    const double determinant = glm::determinant(linear);
    // The cofactors transform normals, also where the matrix has no inverse; their sign follows a mirrored
    // winding.
    const glm::dmat3 cofactors(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                               glm::cross(linear[0], linear[1]));
    for (std::size_t i = 0; i < primitive.positions.size(); ++i) {
      positions_.push_back(
          position(glm::dvec3(instance.to_world * glm::dvec4(glm::dvec3(primitive.positions[i]), 1.0))));
      glm::dvec3 normal(0.0);
      if (!primitive.normals.empty()) {
        normal = cofactors * glm::dvec3(primitive.normals[i]);
        const double length = glm::length(normal);
        normal = length > 0.0 ? normal / (determinant < 0.0 ? -length : length) : glm::dvec3(0.0);
      }
      world_.normals.push_back(from_host<Unit>(normal));
    }
    add_attributes(primitive, first);
    if (material_of(primitive).normal_texture) add_tangents(primitive, first, linear, determinant < 0.0);
    add_triangles(primitive, first, determinant < 0.0);
  }

  void add_attributes(const Primitive& primitive, std::uint32_t first) {
    const std::size_t count = positions_.size();
    for (std::size_t set = 0; set < uv_sets_.size(); ++set) {
      const auto& source = primitive.uv[static_cast<std::size_t>(uv_sets_[set].texcoord)];
      auto& target = world_.uv_sets[set];
      target.resize(count, Vec2<TexCoord>(TexCoord(0), TexCoord(0)));
      for (std::size_t i = 0; i < source.size(); ++i) {
        const glm::vec3 uv = uv_sets_[set].transform * glm::vec3(source[i], 1.0F);
        target[first + i] = {from_host<TexCoord>(static_cast<double>(uv.x)),
                             from_host<TexCoord>(static_cast<double>(uv.y))};
      }
    }
    add_optional(primitive.colors, first, Vec3<Unit>(1), world_.colors,
                 [](const glm::vec3& color) { return from_host<Unit>(glm::clamp(color, 0.0F, 1.0F)); });
    add_optional(primitive.alphas, first, Unit(1), world_.alphas, [](float alpha) {
      return from_host<Unit>(std::clamp(static_cast<double>(alpha), 0.0, 1.0));
    });
    if (!primitive.alphas.empty() && material_of(primitive).alpha_mode != AlphaMode::kOpaque) {
      world_.materials[material_index(primitive)].coverage.complete = false;
    }
  }

  // They turn with the edges. A mirror image has its bitangents on the other side.
  void add_tangents(const Primitive& primitive, std::uint32_t first, const glm::dmat3& linear,
                    bool mirrored) {
    const Tangent<N> none{Vec3<Unit>(0), Unit(1)};
    add_optional(primitive.tangents, first, none, world_.tangents, [&](const glm::vec4& tangent) {
      const glm::dvec3 along = linear * glm::dvec3(tangent);
      const double length = glm::length(along);
      const bool turned = (tangent.w < 0.0F) != mirrored;
      return Tangent<N>{from_host<Unit>(length > 0.0 ? along / length : glm::dvec3(0.0)),
                        turned ? Unit(-1) : Unit(1)};
    });
  }

  // An array that is empty as long as no primitive has the attribute; vertices without it have `missing`.
  template <class T, class Source, class Convert>
  void add_optional(const std::vector<Source>& source, std::uint32_t first, const T& missing,
                    std::vector<T>& target, const Convert& convert) {
    if (source.empty() && target.empty()) return;
    target.resize(positions_.size(), missing);
    std::ranges::transform(source, target.begin() + static_cast<std::ptrdiff_t>(first), convert);
  }

  // Triangles without area are left out: nothing can hit them, and as lights they would have no density.
  void add_triangles(const Primitive& primitive, std::uint32_t first, bool mirrored) {
    const std::uint32_t material = material_index(primitive);
    const BakedMaterial<N>& baked = world_.materials[material];
    std::vector<EmissiveTriangle<N>> emissive;
    for (const glm::uvec3& t : primitive.triangles) {
      glm::uvec3 corners = t + first;
      if (mirrored) std::swap(corners.y, corners.z);
      const Vec3<Length>& a = positions_[corners.x];
      const Vec3<Length> edge_u = positions_[corners.y] - a;
      const Vec3<Length> edge_v = positions_[corners.z] - a;
      const glm::dvec3 normal = glm::cross(to_host(edge_u), to_host(edge_v));
      const double twice_area = glm::length(normal);
      if (!(twice_area > 0.0)) continue;
      const auto index = static_cast<std::uint32_t>(triangles_.size());
      triangles_.push_back(corners);
      typename World<N>::TriangleInfo info{.normal = from_host<Unit>(normal / twice_area),
                                           .material = material};
      if (baked.emits) {
        info.light = static_cast<std::uint32_t>(world_.lights.meshes.size());
        info.light_triangle = static_cast<std::uint32_t>(emissive.size());
        emissive.push_back({a, edge_u, edge_v, info.normal, index, 0.5 * twice_area});
      }
      world_.triangles.push_back(info);
    }
    if (!emissive.empty()) world_.lights.meshes.emplace_back(std::move(emissive), baked.two_sided);
  }

  void bake_punctual_lights() {
    for (const PunctualLight& light : scene_.lights) {
      if (light.kind == PunctualKind::kDirectional) {
        world_.lights.directional.push_back({from_host<Unit>(-light.direction), radiance(light.intensity)});
        continue;
      }
      const double cos_outer = std::cos(light.outer_cone_rad);
      const double ramp = std::max(1e-3, std::cos(light.inner_cone_rad) - cos_outer);
      world_.lights.points.push_back(
          {.position = position(light.position),
           .intensity = radiance(glm::dvec3(light.intensity) * (world_.scale * world_.scale)),
           .spot = light.kind == PunctualKind::kSpot,
           .axis = from_host<Unit>(light.direction),
           .cos_outer = from_host<Unit>(cos_outer),
           .cone_scale = from_host<typename N::Density>(1.0 / ramp)});
    }
  }

  void bake_environment() {
    if (scene_.environment_picture) {
      for (glm::dvec3& point : lattice_.radiance) point *= std::ldexp(1.0, -world_.exponent);
      world_.lights.sky = EnvironmentMap<N>(lattice_.cells, lattice_.radiance);
    } else if (const auto& sky = scene_.environment) {
      world_.lights.sky = Sky<N>(radiance(sky->zenith), radiance(sky->horizon), radiance(sky->ground));
    }
  }

  const Scene& scene_;
  const Material default_material_{};
  Extent extent_;
  EnvironmentLattice lattice_;
  World<N> world_;
  std::vector<TextureUse> uv_sets_;
  std::vector<Vec3<Length>> positions_;
  std::vector<glm::uvec3> triangles_;
};

}  // namespace

template <class N>
World<N> bake_world(const Scene& scene) {
  return Baker<N>(scene).bake();
}

template <class N>
Camera<N> bake_camera(const CameraView& view, const World<N>& world, int width, int height) {
  using Unit = typename N::Unit;
  using Length = typename N::Length;
  const glm::dvec3 x = glm::normalize(glm::dvec3(view.to_world[0]));
  const glm::dvec3 z = glm::normalize(glm::dvec3(view.to_world[2]));
  const glm::dvec3 y = glm::normalize(glm::dvec3(view.to_world[1]));
  const double aspect = static_cast<double>(width) / height;
  double half_height = view.orthographic ? view.ymag : std::tan(view.yfov_rad / 2.0);
  const double promised = view.orthographic ? view.xmag / view.ymag : view.aspect.value_or(0.0);
  if (aspect < promised) half_height *= promised / aspect;
  const double half_width = half_height * aspect;

  Camera<N> camera{};
  camera.orthographic = view.orthographic;
  camera.step_x = N::pixel_step(static_cast<std::uint32_t>(width));
  camera.step_y = N::pixel_step(static_cast<std::uint32_t>(height));
  const glm::dvec3 eye = (glm::dvec3(view.to_world[3]) - world.center) * world.scale;
  camera.origin = from_host<Length>(eye);
  camera.direction = from_host<Unit>(-z);
  if (view.orthographic) {
    camera.film_corner = from_host<Length>(eye + (y * half_height - x * half_width) * world.scale);
    camera.film_right = from_host<Length>(x * (2.0 * half_width * world.scale));
    camera.film_down = from_host<Length>(y * (-2.0 * half_height * world.scale));
  } else {
    const double longest = std::max({1.0, half_width, half_height});  // keeps every component within a Unit
    camera.corner = from_host<Unit>((y * half_height - x * half_width - z) / longest);
    camera.right = from_host<Unit>(x * (2.0 * half_width / longest));
    camera.down = from_host<Unit>(y * (-2.0 * half_height / longest));
  }
  return camera;
}

template World<FloatNumbers> bake_world(const Scene&);
template World<FixedNumbers> bake_world(const Scene&);
template Camera<FloatNumbers> bake_camera(const CameraView&, const World<FloatNumbers>&, int, int);
template Camera<FixedNumbers> bake_camera(const CameraView&, const World<FixedNumbers>&, int, int);

}  // namespace vitrine
