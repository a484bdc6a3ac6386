// Radiance pictures: every way to write the same pixels, and every way to get it wrong.
#include "scene/hdr_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/gltf_scratch.h"
#include "scene/hdr_bytes.h"

namespace vitrine {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

EnvironmentPicture decode(const std::string& text) {
  return decode_hdr(std::span(reinterpret_cast<const unsigned char*>(text.data()), text.size()), "sky.hdr");
}

std::string refusal(const std::string& text) {
  try {
    (void)decode(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing was refused";
}

const std::string kGrey = rgbe(128, 128, 128, 129);  // 1

/// 16 x 8 pixels, the first row as given.
std::string file_with_row(const std::string& row) {
  std::string file = hdr_header(16, 8) + row;
  for (int i = 0; i < 16 * 7; ++i) file += kGrey;
  return file;
}
std::string component_row(int width) { return rgbe(2, 2, width >> 8, width & 255); }
std::string component(std::initializer_list<int> bytes) {
  std::string text;
  for (const int byte : bytes) text += static_cast<char>(static_cast<unsigned char>(byte));
  return text;
}
const std::string kRun16 = component({128 + 16, 128});  // one component of a grey row
const std::string kExponents16 = component({128 + 16, 129});

TEST(HdrFile, ReadsRawPixels) {
  const EnvironmentPicture picture =
      decode(hdr_header(2, 1) + rgbe(255, 128, 0, 128) + rgbe(10, 20, 40, 140));
  EXPECT_EQ(picture.width, 2);
  EXPECT_EQ(picture.height, 1);
  ASSERT_EQ(picture.values.size(), 2U);
  EXPECT_EQ(picture.values[0], glm::vec3(255.0F / 256.0F, 0.5F, 0.0F));
  EXPECT_EQ(picture.values[1], glm::vec3(160.0F, 320.0F, 640.0F));
  EXPECT_EQ(picture.nits, 1000.0);
}

TEST(HdrFile, ReadsEveryEncodingOfARow) {
  const std::string literal = component({3, 128, 128, 128, 128 + 12, 128, 1, 128});
  std::string raw;
  for (int i = 0; i < 16; ++i) raw += kGrey;
  for (const std::string& row : {raw, component_row(16) + kRun16 + kRun16 + kRun16 + kExponents16,
                                 component_row(16) + literal + kRun16 + literal + kExponents16,
                                 kGrey + rgbe(1, 1, 1, 15),  // the old runs
                                 kGrey + rgbe(1, 1, 1, 3) + kGrey + rgbe(1, 1, 1, 11)}) {
    const EnvironmentPicture picture = decode(file_with_row(row));
    ASSERT_EQ(picture.values.size(), 128U);
    for (const glm::vec3& value : picture.values) EXPECT_EQ(value, glm::vec3(1.0F));
  }
  // Two old runs in sequence: the second counts 256-fold.
  std::string wide = hdr_header(1024, 512) + kGrey + rgbe(1, 1, 1, 255) + rgbe(1, 1, 1, 3);
  for (int i = 0; i < 1024 * 511; ++i) wide += rgbe(0, 0, 0, 0);
  const EnvironmentPicture picture = decode(wide);
  EXPECT_EQ(picture.values[1023], glm::vec3(1.0F));
  EXPECT_EQ(picture.values[1024], glm::vec3(0.0F));
}

TEST(HdrFile, UndoesTheExposures) {
  const std::string pixels = kGrey + kGrey;
  EXPECT_EQ(decode(hdr_header(2, 1, "EXPOSURE=2\nSOFTWARE=x\nEXPOSURE= 4.0\n") + pixels).values[1],
            glm::vec3(0.125F));
  EXPECT_THAT(refusal(hdr_header(2, 1, "EXPOSURE=bright\n") + pixels), HasSubstr("header line 3"));
  EXPECT_THAT(refusal(hdr_header(2, 1, "EXPOSURE=0\n") + pixels), HasSubstr("exposure"));
  EXPECT_THAT(refusal(hdr_header(2, 1, "EXPOSURE=-1\n") + pixels), HasSubstr("exposure"));
  EXPECT_THAT(refusal(hdr_header(2, 1, "EXPOSURE=nan\n") + pixels), HasSubstr("exposure"));
}

TEST(HdrFile, RefusesBrokenHeaders) {
  EXPECT_THAT(refusal(""), StartsWith("sky.hdr: header: it does not begin with #?RADIANCE"));
  EXPECT_THAT(refusal("\x89PNG"), HasSubstr("no Radiance picture"));
  EXPECT_THAT(refusal("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n"), HasSubstr("the header does not end"));
  EXPECT_THAT(refusal("#?" + std::string(100000, 'x')), HasSubstr("the header does not end"));
  EXPECT_THAT(refusal("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 2\n"), HasSubstr("header line 2"));
  for (const char* line : {"", "-Y 1", "+Y 1 +X 2", "+X 2 -Y 1", "-Y 1 +X 2 ", "-Y 1 +X 2x", "-Y a +X b",
                           "-Y -1 +X -2", "-Y 99999999999 +X 2"}) {
    EXPECT_THAT(refusal("#?RGBE\n\n" + std::string(line) + "\n" + kGrey + kGrey),
                HasSubstr("resolution line"))
        << line;
  }
}

TEST(HdrFile, RefusesSizesThatAreNoEquirectangularPicture) {
  EXPECT_THAT(refusal(hdr_header(0, 0)), HasSubstr("0x0"));
  EXPECT_THAT(refusal(hdr_header(64, 64)), HasSubstr("twice as wide as high"));
  EXPECT_THAT(refusal(hdr_header(8192, 4096)), HasSubstr("width of 4096"));
  EXPECT_THAT(refusal(hdr_header(2000000000, 1000000000)), HasSubstr("too many"));
}

TEST(HdrFile, RefusesBrokenPixels) {
  const std::string whole = file_with_row(component_row(16) + kRun16 + kRun16 + kRun16 + kExponents16);
  for (std::size_t length = hdr_header(16, 8).size(); length < whole.size(); ++length) {
    EXPECT_THAT(refusal(whole.substr(0, length)), HasSubstr("the file ends")) << length;
  }
  EXPECT_THAT(refusal(whole.substr(0, whole.size() - 1)), HasSubstr("row 7"));
  EXPECT_THAT(refusal(file_with_row(component_row(15))), HasSubstr("row 0: its width"));
  for (const std::string& bad : {component({0, 1}), component({128 + 17, 1}),
                                 component({10}) + kGrey + kGrey + "xx" + component({7})}) {
    EXPECT_THAT(refusal(file_with_row(component_row(16) + bad)), HasSubstr("leaves the row"));
  }
  EXPECT_THAT(refusal(file_with_row(rgbe(1, 1, 1, 4))), HasSubstr("leaves the row")) << "nothing to repeat";
  EXPECT_THAT(refusal(file_with_row(kGrey + rgbe(1, 1, 1, 16))), HasSubstr("leaves the row"));
  EXPECT_THAT(refusal(file_with_row(kGrey + rgbe(1, 1, 1, 0) + rgbe(1, 1, 1, 255))), HasSubstr("leaves"));
  EXPECT_THAT(refusal(hdr_header(2, 1) + kGrey + rgbe(255, 0, 0, 255)), HasSubstr("larger than 1e12"));
  EXPECT_THAT(refusal(hdr_header(2, 1) + rgbe(0, 0, 0, 0) + rgbe(0, 0, 0, 200)), HasSubstr("black"));
}

TEST(HdrFile, RefusesWhatIsNoFile) {
  EXPECT_THROW((void)read_hdr("/nowhere/sky.hdr"), InputError);
  EXPECT_THROW((void)read_hdr(std::filesystem::temp_directory_path()), InputError);
}

class EnvironmentOfGltf : public GltfTest {};

TEST_F(EnvironmentOfGltf, MayBeAPicture) {
  write("sky.hdr", hdr_header(2, 1) + kGrey + rgbe(0, 0, 0, 0));
  GltfDocument document = triangle_document();
  auto& environment = document.root["scenes"][0]["extras"]["vitrine"]["environment"];
  environment = {{"image", "sky.hdr"}, {"nits", 250}, {"rotation", 90}};
  const Scene scene = import(document);
  ASSERT_TRUE(scene.environment_picture);
  EXPECT_FALSE(scene.environment);
  EXPECT_FALSE(scene.has_default_light);
  EXPECT_EQ(scene.environment_picture->width, 2);
  EXPECT_EQ(scene.environment_picture->nits, 250.0);
  EXPECT_NEAR(scene.environment_picture->rotation_rad, 1.5707963267948966, 1e-12);

  environment = {{"image", "gone.hdr"}};
  EXPECT_THAT(GltfTest::refusal(document), HasSubstr("/scenes/0/extras/vitrine/environment/image"));
  write("broken.hdr", hdr_header(2, 1) + kGrey);
  environment = {{"image", "broken.hdr"}};
  EXPECT_THAT(GltfTest::refusal(document), HasSubstr("environment/image: row 0: the file ends"));
  environment = {{"image", "sky.hdr"}, {"nits", -1}};
  EXPECT_THAT(GltfTest::refusal(document), HasSubstr("environment/nits"));
}

}  // namespace
}  // namespace vitrine
