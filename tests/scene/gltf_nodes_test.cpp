// Where the node hierarchy puts meshes, cameras and lights, and what a scene without them gets.
#include <numbers>

#include "scene/default_environment.h"
#include "scene/gltf_limits.h"
#include "scene/gltf_scratch.h"

namespace vitrine {
namespace {

using GltfNodesTest = GltfTest;

constexpr double kSqrtHalf = 0.5 * std::numbers::sqrt2;

glm::dvec3 placed(const Scene& scene, std::size_t instance, const glm::dvec3& p) {
  return glm::dvec3(scene.instances.at(instance).to_world * glm::dvec4(p, 1.0));
}

void expect_near(const glm::dvec3& a, const glm::dvec3& b) {
  EXPECT_LT(glm::length(a - b), 1e-7) << a.x << a.y << a.z;
}

TEST_F(GltfNodesTest, ComposesTranslationRotationScaleDownTheTree) {
  GltfDocument document = triangle_document();
  // A quarter turn about z takes x to y.
  document.root["nodes"][0]["rotation"] = {0, 0, kSqrtHalf, kSqrtHalf};
  document.root["nodes"][0]["scale"] = {2, 3, 4};
  document.root["nodes"][0]["translation"] = {10, 0, 0};
  document.root["nodes"].push_back({{"children", {0}}, {"translation", {0, 0, 5}}});
  document.root["scenes"][0]["nodes"] = {1};
  expect_near(placed(import(document), 0, {1, 0, 0}), {10, 2, 5});
}

TEST_F(GltfNodesTest, ReadsMatricesByColumn) {
  GltfDocument document = triangle_document();
  document.root["nodes"][0]["matrix"] = {0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 7, 8, 9, 1};
  expect_near(placed(import(document), 0, {1, 0, 0}), {7, 9, 9});
}

TEST_F(GltfNodesTest, ShowsTheDefaultSceneOrTheFirstOrAllRoots) {
  GltfDocument document = triangle_document();
  document.root["nodes"].push_back({{"mesh", 0}, {"translation", {1, 0, 0}}});
  document.root["scenes"] = json::array({{{"nodes", {0}}}, {{"nodes", {1}}, {"name", "second"}}});
  expect_near(placed(import(document), 0, {0, 0, 0}), {0, 0, 0});
  document.root["scene"] = 1;
  const Scene second = import(document);
  EXPECT_EQ(second.name, "second");
  expect_near(placed(second, 0, {0, 0, 0}), {1, 0, 0});
  document.root.erase("scene");
  document.root.erase("scenes");
  EXPECT_EQ(import(document).instances.size(), 2U);
}

TEST_F(GltfNodesTest, SharesMeshesBetweenInstances) {
  GltfDocument document = triangle_document();
  document.add_root_node({{"mesh", 0}, {"scale", {-1, 1, 1}}});
  const Scene scene = import(document);
  EXPECT_EQ(scene.meshes.size(), 1U);
  ASSERT_EQ(scene.instances.size(), 2U);
  EXPECT_LT(glm::determinant(glm::dmat3(scene.instances[1].to_world)), 0.0) << "a mirror image stays one";
}

TEST_F(GltfNodesTest, SkipsWhatIsScaledToNothing) {
  GltfDocument document = triangle_document();
  document.add_root_node({{"mesh", 0}, {"scale", {0, 0, 0}}});
  const Scene scene = import(document);
  EXPECT_EQ(scene.instances.size(), 1U);
  EXPECT_TRUE(has_note(scene, "/nodes/1 skipped: its scale is zero"));
}

TEST_F(GltfNodesTest, PlacesGpuInstances) {
  GltfDocument document = triangle_document();
  const int translations = document.add_positions({1, 0, 0, 2, 0, 0, 3, 0, 0});
  document.root["nodes"][0]["extensions"] = {
      {"EXT_mesh_gpu_instancing", {{"attributes", {{"TRANSLATION", translations}}}}}};
  document.root["nodes"][0]["translation"] = {0, 5, 0};
  document.root["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
  const Scene scene = import(document);
  ASSERT_EQ(scene.instances.size(), 3U);
  expect_near(placed(scene, 2, {0, 0, 0}), {3, 5, 0});
}

TEST_F(GltfNodesTest, ReadsCameras) {
  GltfDocument document = triangle_document();
  document.root["cameras"] = json::array(
      {{{"type", "perspective"},
        {"name", "eye"},
        {"perspective", {{"yfov", 1}, {"aspectRatio", 1.5}, {"znear", 0.1}}}},
       {{"type", "orthographic"}, {"orthographic", {{"xmag", 2}, {"ymag", 3}, {"znear", 0}, {"zfar", 10}}}}});
  document.add_root_node({{"camera", 0}, {"translation", {0, 0, 5}}, {"scale", {2, 2, -2}}});
  document.add_root_node({{"camera", 1}, {"name", "plan"}});
  const Scene scene = import(document);
  ASSERT_EQ(scene.cameras.size(), 2U);
  EXPECT_EQ(scene.cameras[0].name, "eye");
  EXPECT_EQ(scene.cameras[0].yfov_rad, 1.0);
  EXPECT_EQ(scene.cameras[0].aspect, 1.5);
  expect_near(scene.cameras[0].to_world[3], {0, 0, 5});
  EXPECT_NEAR(glm::determinant(scene.cameras[0].to_world), 1.0, 1e-12) << "neither scaled nor mirrored";
  EXPECT_TRUE(scene.cameras[1].orthographic);
  EXPECT_EQ(scene.cameras[1].name, "plan");
  EXPECT_EQ(scene.cameras[1].xmag, 2.0);
  EXPECT_EQ(scene.cameras[1].ymag, 3.0);
}

TEST_F(GltfNodesTest, FramesASceneWithoutACamera) {
  const Scene scene = import(triangle_document());
  ASSERT_EQ(scene.cameras.size(), 1U);
  EXPECT_EQ(scene.cameras[0].name, "auto");
  EXPECT_TRUE(has_note(scene, "no camera"));
}

GltfDocument with_light(const json& light) {
  GltfDocument document = triangle_document();
  document.root["extensions"]["KHR_lights_punctual"]["lights"] = json::array({light});
  // A quarter turn about x takes -z to +y.
  document.add_root_node({{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}},
                          {"translation", {1, 2, 3}},
                          {"rotation", {kSqrtHalf, 0, 0, kSqrtHalf}},
                          {"scale", {2, 2, 2}}});
  return document;
}

TEST_F(GltfNodesTest, ReadsPunctualLights) {
  const Scene spot = import(with_light({{"type", "spot"},
                                        {"color", {1, 0.5, 0}},
                                        {"intensity", 100},
                                        {"range", 5},
                                        {"spot", {{"innerConeAngle", 0.1}, {"outerConeAngle", 0.3}}}}));
  ASSERT_EQ(spot.lights.size(), 1U);
  EXPECT_EQ(spot.lights[0].kind, PunctualKind::kSpot);
  EXPECT_EQ(spot.lights[0].intensity, glm::vec3(100, 50, 0));
  EXPECT_EQ(spot.lights[0].inner_cone_rad, 0.1);
  EXPECT_EQ(spot.lights[0].outer_cone_rad, 0.3);
  expect_near(spot.lights[0].position, {1, 2, 3});
  expect_near(spot.lights[0].direction, {0, 1, 0});
  EXPECT_FALSE(spot.environment);
  EXPECT_TRUE(has_note(spot, "/extensions/KHR_lights_punctual/lights/0: range ignored"));

  EXPECT_EQ(import(with_light({{"type", "point"}})).lights.at(0).intensity, glm::vec3(1));
  EXPECT_EQ(import(with_light({{"type", "directional"}})).lights.at(0).kind, PunctualKind::kDirectional);
  EXPECT_NEAR(import(with_light({{"type", "spot"}, {"spot", json::object()}})).lights.at(0).outer_cone_rad,
              std::numbers::pi / 4, 1e-9);
}

TEST_F(GltfNodesTest, RefusesImpossibleCones) {
  const std::string message =
      refusal(with_light({{"type", "spot"}, {"spot", {{"innerConeAngle", 0.5}, {"outerConeAngle", 0.3}}}}));
  EXPECT_NE(message.find("/extensions/KHR_lights_punctual/lights/0/spot: innerConeAngle"), std::string::npos);
  EXPECT_NE(refusal(with_light({{"type", "spot"}})).find("\"spot\" is missing"), std::string::npos);
}

TEST_F(GltfNodesTest, LightsADarkSceneWithADefaultSky) {
  const Scene scene = import(triangle_document());
  ASSERT_TRUE(scene.environment);
  EXPECT_EQ(scene.environment->zenith, kDefaultEnvironment.zenith);
  EXPECT_TRUE(has_note(scene, "no light"));

  GltfDocument lamp = triangle_document();
  lamp.root["materials"] = json::array({{{"emissiveFactor", {0.1, 0, 0}}}});
  lamp.root["meshes"][0]["primitives"][0]["material"] = 0;
  EXPECT_FALSE(import(lamp).environment);

  lamp.root["meshes"][0]["primitives"][0].erase("material");
  EXPECT_TRUE(import(lamp).environment) << "a material that nothing has does not shine";

  lamp.root["meshes"][0]["primitives"][0]["material"] = 0;
  lamp.root["images"] = json::array({{{"uri", kRedAndBluePng}}});
  lamp.root["textures"] = json::array({{{"source", 0}}});
  lamp.root["materials"][0]["emissiveTexture"] = {{"index", 0}};
  EXPECT_TRUE(import(lamp).environment) << "a textured glow of less than 1 nit is no lamp";
}

TEST_F(GltfNodesTest, ReadsTheEnvironmentOfOurOwnScenes) {
  GltfDocument document = triangle_document();
  const json sky = {{"zenith", {1, 2, 3}}, {"horizon", {4, 5, 6}}, {"ground", {0, 0, 0.5}}};
  document.root["scenes"][0]["extras"]["vitrine"]["environment"] = sky;
  document.root["scenes"][0]["extras"]["author"] = "somebody";
  const Scene scene = import(document);
  ASSERT_TRUE(scene.environment);
  EXPECT_EQ(scene.environment->zenith, glm::vec3(1, 2, 3));
  EXPECT_EQ(scene.environment->horizon, glm::vec3(4, 5, 6));
  EXPECT_EQ(scene.environment->ground, glm::vec3(0, 0, 0.5F));

  auto& environment = document.root["scenes"][0]["extras"]["vitrine"]["environment"];
  environment["sun"] = 1;
  EXPECT_NE(refusal(document).find("/scenes/0/extras/vitrine/environment/sun: is not known"),
            std::string::npos);
  environment = sky;
  environment["zenith"][1] = -1;
  EXPECT_NE(refusal(document).find("/scenes/0/extras/vitrine/environment/zenith/1: -1 is less than 0"),
            std::string::npos);
  environment.erase("zenith");
  EXPECT_NE(refusal(document).find("\"zenith\" is missing"), std::string::npos);
  document.root["scenes"][0]["extras"] = "text";
  EXPECT_EQ(import(document).environment->zenith, kDefaultEnvironment.zenith);
}

TEST_F(GltfNodesTest, ShowsTheBindPoseWithANote) {
  GltfDocument document = triangle_document();
  document.root["animations"] = json::array({{{"channels", json::array()}, {"samplers", json::array()}}});
  document.root["skins"] = json::array({{{"joints", {0}}}});
  document.root["nodes"][0]["skin"] = 0;
  document.root["meshes"][0]["primitives"][0]["targets"] = json::array({{{"POSITION", 0}}});
  const Scene scene = import(document);
  EXPECT_TRUE(has_note(scene, "animations ignored"));
  EXPECT_TRUE(has_note(scene, "skins ignored"));
  EXPECT_TRUE(has_note(scene, "morph targets ignored"));
}

TEST_F(GltfNodesTest, FollowsDeepHierarchies) {
  GltfDocument document = triangle_document();
  constexpr int kDepth = 20000;
  for (int i = 1; i <= kDepth; ++i)
    document.root["nodes"].push_back({{"children", {i == kDepth ? 0 : i + 1}}});
  document.root["scenes"][0]["nodes"] = {1};
  EXPECT_EQ(import(document).instances.size(), 1U);
}

TEST_F(GltfNodesTest, RefusesWhatIsNoTree) {
  GltfDocument cycle = triangle_document();
  cycle.root["nodes"].push_back({{"children", {2}}});
  cycle.root["nodes"].push_back({{"children", {1}}});
  EXPECT_NE(refusal(cycle).find("/nodes/1: the node is in or below a cycle"), std::string::npos);

  GltfDocument doubling = triangle_document();
  for (int i = 0; i < 24; ++i) doubling.root["nodes"].push_back({{"children", {i, i}}});
  doubling.root["scenes"][0]["nodes"] = {24};
  EXPECT_NE(refusal(doubling).find("/nodes/1/children: node 0 is already a child of node 1"),
            std::string::npos);

  GltfDocument child = triangle_document();
  child.root["nodes"].push_back({{"children", {0}}});
  EXPECT_NE(refusal(child).find("/scenes/0/nodes/0: node 0 is the child of another node"), std::string::npos);

  GltfDocument twice = triangle_document();
  twice.root["scenes"][0]["nodes"] = {0, 0};
  EXPECT_NE(refusal(twice).find("/scenes/0/nodes/1: node 0 is listed twice"), std::string::npos);
}

TEST_F(GltfNodesTest, RefusesAnExplosionOfInstances) {
  GltfDocument document = triangle_document();
  const auto copies = gltf_limits::kMaxInstances + 1;
  const int translations =
      document.add_accessor({{"componentType", kFloat}, {"type", "VEC3"}, {"count", copies}});
  document.root["nodes"][0]["extensions"] = {
      {"EXT_mesh_gpu_instancing", {{"attributes", {{"TRANSLATION", translations}}}}}};
  EXPECT_NE(refusal(document).find("/nodes/0: the scene has more than 250000 instances"), std::string::npos);
}

TEST_F(GltfNodesTest, RefusesAnExplosionOfTriangles) {
  // 100 triangles, 100000 times.
  GltfDocument document;
  std::vector<float> positions;
  for (int i = 0; i < 100; ++i) positions.insert(positions.end(), {0, 0, 0, 1, 0, 0, 0, 1, 0});
  document.add_mesh_node({{"attributes", {{"POSITION", document.add_positions(positions)}}}});
  const int translations =
      document.add_accessor({{"componentType", kFloat}, {"type", "VEC3"}, {"count", 100000}});
  document.root["nodes"][0]["extensions"] = {
      {"EXT_mesh_gpu_instancing", {{"attributes", {{"TRANSLATION", translations}}}}}};
  EXPECT_NE(refusal(document).find("/nodes/0: the scene has more than 8000000 triangles"), std::string::npos);
}

TEST_F(GltfNodesTest, RefusesTransformsThatAreNotFinite) {
  GltfDocument document = triangle_document();
  document.root["nodes"][0]["scale"] = {1e30, 1e30, 1e30};
  document.root["nodes"].push_back({{"children", {0}}, {"scale", {1e30, 1e30, 1e30}}});
  document.root["scenes"][0]["nodes"] = {1};
  EXPECT_NE(refusal(document).find("/nodes/1: its transform is not finite"), std::string::npos);

  GltfDocument far = triangle_document();
  far.root["nodes"][0]["translation"] = {1e10, 0, 0};
  EXPECT_NE(refusal(far).find("farther than 1e9 m"), std::string::npos);
}

}  // namespace
}  // namespace vitrine
