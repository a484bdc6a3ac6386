// Materials, their extensions, textures and images.
#include "scene/gltf_scratch.h"

namespace vitrine {
namespace {

using GltfMaterialsTest = GltfTest;

// Only the header of a PNG of 30000x30000 texels.
constexpr const char* kHugePng = "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAdTAAAHUwCAYAAABmJ/i6";

GltfDocument with_material(const json& material) {
  GltfDocument document = triangle_document();
  document.root["materials"] = json::array({material});
  document.root["meshes"][0]["primitives"][0]["material"] = 0;
  return document;
}

GltfDocument with_texture(const json& texture_info, const std::string& image_uri = kRedAndBluePng) {
  GltfDocument document = with_material({{"pbrMetallicRoughness", {{"baseColorTexture", texture_info}}}});
  document.root["textures"] = json::array({{{"source", 0}}});
  document.root["images"] = json::array({{{"uri", image_uri}}});
  return document;
}

TEST_F(GltfMaterialsTest, DefaultsAreThoseOfGltf) {
  const Material material = import(with_material(json::object())).materials.at(0);
  EXPECT_EQ(material.base_color, glm::vec3(1));
  EXPECT_EQ(material.metallic, 1.0F);
  EXPECT_EQ(material.roughness, 1.0F);
  EXPECT_EQ(material.emission, glm::vec3(0));
  EXPECT_EQ(material.ior, 1.5F);
  EXPECT_EQ(material.specular, 1.0F);
  EXPECT_EQ(material.transmission, 0.0F);
  EXPECT_FALSE(material.double_sided);
  EXPECT_FALSE(material.refracts);
  EXPECT_EQ(only_primitive(import(triangle_document())).material, -1);
}

TEST_F(GltfMaterialsTest, ReadsFactorsAndExtensions) {
  const Material material =
      import(with_material(
                 {{"name", "glass"},
                  {"doubleSided", true},
                  {"pbrMetallicRoughness",
                   {{"baseColorFactor", {0.1, 0.2, 0.3, 0.4}},
                    {"metallicFactor", 0},
                    {"roughnessFactor", 0.25}}},
                  {"emissiveFactor", {1, 0.5, 0}},
                  {"extensions",
                   {{"KHR_materials_emissive_strength", {{"emissiveStrength", 5'000'000'000}}},
                    {"KHR_materials_ior", {{"ior", 1.33}}},
                    {"KHR_materials_specular", {{"specularFactor", 0.5}, {"specularColorFactor", {1, 0, 2}}}},
                    {"KHR_materials_transmission", {{"transmissionFactor", 1}}},
                    {"KHR_materials_volume", {{"thicknessFactor", 0.01}}}}}}))
          .materials.at(0);
  EXPECT_EQ(material.name, "glass");
  EXPECT_TRUE(material.double_sided);
  EXPECT_EQ(material.base_color, glm::vec3(0.1F, 0.2F, 0.3F));
  EXPECT_EQ(material.metallic, 0.0F);
  EXPECT_EQ(material.roughness, 0.25F);
  EXPECT_EQ(material.emission, glm::vec3(5e9F, 2.5e9F, 0));
  EXPECT_EQ(material.ior, 1.33F);
  EXPECT_EQ(material.specular, 0.5F);
  EXPECT_EQ(material.specular_color, glm::vec3(1, 0, 2));
  EXPECT_EQ(material.transmission, 1.0F);
  EXPECT_TRUE(material.refracts);
}

// A member of an extension of the only material, with the one texture.
GltfDocument with_extension(const std::string& name, const json& members) {
  GltfDocument document = with_texture({{"index", 0}});
  document.root["materials"][0]["extensions"][name] = members;
  return document;
}

TEST_F(GltfMaterialsTest, ReadsSpecularTextures) {
  const Scene scene =
      import(with_extension("KHR_materials_specular", {{"specularTexture", {{"index", 0}, {"texCoord", 1}}},
                                                       {"specularColorTexture", {{"index", 0}}}}));
  const Material& material = scene.materials.at(0);
  EXPECT_EQ(material.specular, 1.0F);
  EXPECT_TRUE(material.specular_texture);
  EXPECT_EQ(material.specular_texture.texcoord, 1);
  EXPECT_TRUE(material.specular_color_texture);
  EXPECT_FALSE(has_note(scene, "specular"));
}

TEST_F(GltfMaterialsTest, ReadsSheen) {
  GltfDocument document =
      with_extension("KHR_materials_sheen", {{"sheenColorFactor", {0.5, 0.25, 1}},
                                             {"sheenColorTexture", {{"index", 0}}},
                                             {"sheenRoughnessFactor", 0.75},
                                             {"sheenRoughnessTexture", {{"index", 0}, {"texCoord", 1}}}});
  document.root["extensionsUsed"] = {"KHR_materials_sheen"};
  document.root["extensionsRequired"] = {"KHR_materials_sheen"};
  const Scene scene = import(document);
  const Material& material = scene.materials.at(0);
  EXPECT_EQ(material.sheen_color, glm::vec3(0.5F, 0.25F, 1));
  EXPECT_TRUE(material.sheen_color_texture);
  EXPECT_EQ(material.sheen_roughness, 0.75F);
  EXPECT_EQ(material.sheen_roughness_texture.texcoord, 1);
  EXPECT_FALSE(has_note(scene, "sheen"));
}

TEST_F(GltfMaterialsTest, ReadsClearcoat) {
  GltfDocument document = with_extension("KHR_materials_clearcoat",
                                         {{"clearcoatFactor", 0.5},
                                          {"clearcoatTexture", {{"index", 0}}},
                                          {"clearcoatRoughnessFactor", 0.25},
                                          {"clearcoatRoughnessTexture", {{"index", 0}, {"texCoord", 1}}},
                                          {"clearcoatNormalTexture", {{"index", 0}, {"scale", 2}}}});
  document.root["extensionsUsed"] = {"KHR_materials_clearcoat"};
  document.root["extensionsRequired"] = {"KHR_materials_clearcoat"};
  document.root["materials"][0]["emissiveFactor"] = {1, 1, 1};
  const Scene scene = import(document);
  const Material& material = scene.materials.at(0);
  EXPECT_EQ(material.clearcoat, 0.5F);
  EXPECT_TRUE(material.clearcoat_texture);
  EXPECT_EQ(material.clearcoat_roughness, 0.25F);
  EXPECT_EQ(material.clearcoat_roughness_texture.texcoord, 1);
  EXPECT_TRUE(has_note(scene, "clearcoatNormalTexture ignored"));
  EXPECT_TRUE(has_note(scene, "not dimmed by its clear coat"));
  EXPECT_FALSE(has_note(scene, "extension KHR_materials_clearcoat"));
}

TEST_F(GltfMaterialsTest, RefusesWrongValuesOfTheLayers) {
  const std::tuple<const char*, json, const char*> cases[] = {
      {"KHR_materials_sheen",
       {{"sheenColorFactor", {0.5, 1.5, 0}}},
       "/sheenColorFactor/1: 1.5 is more than 1"},
      {"KHR_materials_sheen", {{"sheenColorFactor", {0.5}}}, "/sheenColorFactor: has 1 numbers, not 3"},
      {"KHR_materials_sheen", {{"sheenRoughnessFactor", -1}}, "/sheenRoughnessFactor: -1 is less than 0"},
      {"KHR_materials_sheen", {{"sheenColorTexture", {{"index", 7}}}}, "refers to /textures/7"},
      {"KHR_materials_clearcoat", {{"clearcoatFactor", 2}}, "/clearcoatFactor: 2 is more than 1"},
      {"KHR_materials_clearcoat", {{"clearcoatRoughnessFactor", "x"}}, "is string where a number belongs"},
      {"KHR_materials_clearcoat", {{"clearcoatTexture", json::object()}}, "\"index\" is missing"},
      {"KHR_materials_specular", {{"specularTexture", 3}}, "is 3 where an object belongs"}};
  for (const auto& [name, members, problem] : cases) {
    const std::string message = refusal(with_extension(name, members));
    EXPECT_NE(message.find(problem), std::string::npos) << message;
    EXPECT_NE(message.find(std::string("/materials/0/extensions/") + name), std::string::npos) << message;
  }
}

TEST_F(GltfMaterialsTest, TransmissionWithoutThicknessIsAThinWall) {
  EXPECT_FALSE(import(with_material({{"extensions",
                                      {{"KHR_materials_transmission", {{"transmissionFactor", 1}}},
                                       {"KHR_materials_volume", {{"thicknessFactor", 0}}}}}}))
                   .materials.at(0)
                   .refracts);
}

TEST_F(GltfMaterialsTest, UnlitEmitsItsBaseColour) {
  const Scene scene =
      import(with_material({{"pbrMetallicRoughness", {{"baseColorFactor", {0.5, 0.25, 1, 1}}}},
                            {"extensions", {{"KHR_materials_unlit", json::object()}}}}));
  const Material& material = scene.materials.at(0);
  EXPECT_EQ(material.base_color, glm::vec3(0));
  EXPECT_EQ(material.specular, 0.0F);
  ASSERT_TRUE(scene.environment) << "unlit surfaces are no lamps";
  EXPECT_EQ(material.emission, 1000.0F * glm::vec3(0.5F, 0.25F, 1));
  EXPECT_TRUE(has_note(scene, "/materials/0 is unlit"));
}

TEST_F(GltfMaterialsTest, ReadsTexturesWithTheirSampler) {
  GltfDocument document = with_texture({{"index", 0}, {"texCoord", 1}});
  document.root["samplers"] = json::array({{{"magFilter", 9728}, {"wrapS", 33071}, {"wrapT", 33648}}});
  document.root["textures"][0]["sampler"] = 0;
  const Scene scene = import(document);
  const TextureUse& use = scene.materials.at(0).base_color_texture;
  EXPECT_EQ(use.image, 0);
  EXPECT_EQ(use.texcoord, 1);
  EXPECT_EQ(use.wrap_s, TextureWrap::kClampToEdge);
  EXPECT_EQ(use.wrap_t, TextureWrap::kMirroredRepeat);
  EXPECT_TRUE(use.nearest);
  const Image& image = scene.images.at(0);
  EXPECT_EQ(image.width, 2);
  EXPECT_EQ(image.height, 1);
  EXPECT_EQ(image.rgba, (std::vector<std::uint8_t>{255, 0, 0, 255, 0, 128, 255, 255}));
}

TEST_F(GltfMaterialsTest, ReadsAnImageInABufferViewAndKeepsItOnce) {
  GltfDocument document = with_texture({{"index", 0}});
  const json png = {{"uri", kRedAndBluePng}};
  document.root["textures"] = json::array({{{"source", 0}}, {{"source", 0}}});
  document.root["materials"][0]["emissiveTexture"] = {{"index", 1}};
  const Scene scene = import(document);
  EXPECT_EQ(scene.images.size(), 1U);
  EXPECT_EQ(scene.materials.at(0).emission_texture.image, 0);

  const std::vector<unsigned char> encoded{
      0x89, 'P',  'N',  'G',  0x0D, 0x0A, 0x1A, 0x0A, 0,   0,    0,    13,   'I',  'H',  'D',
      'R',  0,    0,    0,    2,    0,    0,    0,    1,   8,    6,    0,    0,    0,    0xF4,
      0x22, 0x7F, 0x8A, 0,    0,    0,    0x11, 'I',  'D', 'A',  'T',  0x78, 0xDA, 0x63, 0xF8,
      0xCF, 0xC0, 0xF0, 0x9F, 0xA1, 0xE1, 0xFF, 0x7F, 0,   0x11, 0x79, 0x04, 0x7D, 0x64, 0xEB,
      0x4D, 0xCC, 0,    0,    0,    0,    'I',  'E',  'N', 'D',  0xAE, 0x42, 0x60, 0x82};
  document.root["images"][0] = {{"bufferView", document.add_view(encoded)}, {"mimeType", "image/png"}};
  EXPECT_EQ(import(document).images.at(0).rgba, scene.images.at(0).rgba);
}

TEST_F(GltfMaterialsTest, TransformsTextureCoordinates) {
  const auto transformed = [&](const json& transform, glm::vec2 uv) {
    const Scene scene =
        import(with_texture({{"index", 0}, {"extensions", {{"KHR_texture_transform", transform}}}}));
    return glm::vec2(scene.materials.at(0).base_color_texture.transform * glm::vec3(uv, 1.0F));
  };
  EXPECT_EQ(transformed({{"offset", {0.5, 0.25}}, {"scale", {2, 3}}}, {1, 1}), glm::vec2(2.5F, 3.25F));
  // A quarter turn takes u to -v; the scale comes first.
  const glm::vec2 turned = transformed({{"rotation", 1.5707963267948966}, {"scale", {2, 1}}}, {1, 0});
  EXPECT_NEAR(turned.x, 0, 1e-6);
  EXPECT_NEAR(turned.y, -2, 1e-6);
  const Scene scene = import(with_texture(
      {{"index", 0}, {"texCoord", 0}, {"extensions", {{"KHR_texture_transform", {{"texCoord", 1}}}}}}));
  EXPECT_EQ(scene.materials.at(0).base_color_texture.texcoord, 1);
}

TEST_F(GltfMaterialsTest, UsesTheFallbackOfAnOptionalFormat) {
  GltfDocument document = with_texture({{"index", 0}});
  document.root["extensionsUsed"] = {"EXT_texture_webp"};
  document.root["textures"][0]["extensions"] = {{"EXT_texture_webp", {{"source", 1}}}};
  document.root["images"].push_back({{"uri", "absent.webp"}});
  const Scene with_fallback = import(document);
  EXPECT_TRUE(with_fallback.materials.at(0).base_color_texture);
  EXPECT_TRUE(has_note(with_fallback, "EXT_texture_webp ignored"));

  document.root["textures"][0].erase("source");
  const Scene without_fallback = import(document);
  EXPECT_FALSE(without_fallback.materials.at(0).base_color_texture);
  EXPECT_TRUE(has_note(without_fallback, "its texture has no PNG or JPEG image"));

  document.root["extensionsRequired"] = {"EXT_texture_webp"};
  EXPECT_NE(refusal(document).find("/extensionsRequired/0: the extension EXT_texture_webp is not supported"),
            std::string::npos);
}

TEST_F(GltfMaterialsTest, RefusesImagesThatCannotBeShown) {
  write("picture.webp", std::string("RIFF\x10\0\0\0WEBPVP8 ", 16));
  write("broken.png", "not a picture");
  const std::pair<const char*, const char*> cases[] = {
      {"picture.webp", "/images/0: WebP images are not supported"},
      {"broken.png", "/images/0: the image cannot be decoded"},
      {"absent.png", "/images/0/uri: \""},
      {"../absent.png", "outside of the scene's folder"},
      {kHugePng, "/images/0: "}};
  for (const auto& [uri, problem] : cases) {
    const std::string message = refusal(with_texture({{"index", 0}}, uri));
    EXPECT_NE(message.find(problem), std::string::npos) << message;
  }
}

TEST_F(GltfMaterialsTest, DoesNotReadImagesThatNothingShows) {
  GltfDocument document = triangle_document();
  document.root["images"] = json::array({{{"uri", "absent.png"}}});
  EXPECT_TRUE(import(document).images.empty());
}

TEST_F(GltfMaterialsTest, AlphaBelongsToTheBaseColour) {
  GltfDocument document = with_texture({{"index", 0}, {"texCoord", 1}});
  document.root["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = {1, 1, 1, 0.25};
  const auto imported = [&] { return import(document).materials.at(0); };
  EXPECT_EQ(imported().alpha_mode, AlphaMode::kOpaque);
  document.root["materials"][0]["alphaMode"] = "BLEND";
  EXPECT_EQ(imported().alpha_mode, AlphaMode::kBlend);
  EXPECT_EQ(imported().alpha, 0.25F);
  EXPECT_EQ(imported().alpha_texture.image, 0);
  EXPECT_EQ(imported().alpha_texture.texcoord, 1);
  document.root["materials"][0]["alphaMode"] = "MASK";
  EXPECT_EQ(imported().alpha_mode, AlphaMode::kMask);
  EXPECT_EQ(imported().alpha_cutoff, 0.5F);
  document.root["materials"][0]["alphaCutoff"] = 0.75;
  EXPECT_EQ(imported().alpha_cutoff, 0.75F);
  document.root["materials"][0]["extensions"] = {{"KHR_materials_unlit", json::object()}};
  EXPECT_EQ(imported().alpha_mode, AlphaMode::kMask);
  EXPECT_EQ(imported().alpha, 0.25F);
  EXPECT_EQ(imported().alpha_texture.image, 0);
  EXPECT_FALSE(has_note(import(document), "alpha"));
}

TEST_F(GltfMaterialsTest, ReadsANormalMap) {
  GltfDocument document = with_texture({{"index", 0}});
  document.root["materials"][0]["normalTexture"] = {
      {"index", 0},
      {"texCoord", 1},
      {"scale", -0.5},
      {"extensions", {{"KHR_texture_transform", {{"offset", {0.5, 0.25}}}}}}};
  const Scene scene = import(document);
  const Material& material = scene.materials.at(0);
  EXPECT_EQ(material.normal_texture.image, 0);
  EXPECT_EQ(material.normal_texture.texcoord, 1);
  EXPECT_EQ(material.normal_texture.transform * glm::vec3(0, 0, 1), glm::vec3(0.5F, 0.25F, 1));
  EXPECT_EQ(material.normal_scale, -0.5F);
  EXPECT_FALSE(has_note(scene, "normalTexture"));
  document.root["materials"][0]["normalTexture"] = {{"index", 0}};
  EXPECT_EQ(import(document).materials.at(0).normal_scale, 1.0F);
}

TEST_F(GltfMaterialsTest, ReadsTheAbsorptionOfASolid) {
  GltfDocument document = with_material(
      {{"extensions",
        {{"KHR_materials_transmission", {{"transmissionFactor", 1}}},
         {"KHR_materials_volume", {{"thicknessFactor", 1}, {"attenuationColor", {0.5, 0, 1}}}}}}});
  EXPECT_FALSE(import(document).materials.at(0).attenuation_distance) << "infinite by default";
  json& volume = document.root["materials"][0]["extensions"]["KHR_materials_volume"];
  volume["attenuationDistance"] = 0.25;
  const Material material = import(document).materials.at(0);
  EXPECT_EQ(material.attenuation_color, glm::vec3(0.5F, 0, 1));
  EXPECT_EQ(material.attenuation_distance, 0.25F);
  EXPECT_FALSE(has_note(import(document), "volume"));
  document.root["textures"] = json::array({{{"source", 0}}});
  document.root["images"] = json::array({{{"uri", kRedAndBluePng}}});
  volume["thicknessTexture"] = {{"index", 0}};
  EXPECT_TRUE(has_note(import(document), "thicknessTexture ignored, the way through the solid is traced"));
}

TEST_F(GltfMaterialsTest, NotesWhatItLeavesOut) {
  GltfDocument document = with_texture({{"index", 0}});
  document.root["materials"][0]["occlusionTexture"] = {{"index", 0}};
  document.root["materials"][0]["emissiveTexture"] = {{"index", 0}, {"texCoord", 2}};
  document.root["extensionsUsed"] = {"KHR_materials_iridescence"};
  const Scene scene = import(document);
  for (const char* part :
       {"occlusionTexture", "texture coordinate sets 0 and 1", "KHR_materials_iridescence"}) {
    EXPECT_TRUE(has_note(scene, part)) << part;
  }
}

}  // namespace
}  // namespace vitrine
