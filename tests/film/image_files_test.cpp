#include "film/image_files.h"

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <stb/stb_image.h>

#include "film/pfm.h"

namespace vitrine {
namespace {

class ImageFiles : public testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::filesystem::path file(const char* name) const { return folder_ / name; }

 private:
  static std::filesystem::path make_folder() {
    std::string path = (std::filesystem::temp_directory_path() / "vitrine-images-XXXXXX").string();
    if (mkdtemp(path.data()) == nullptr) throw std::runtime_error("no temporary folder");
    return path;
  }

  std::filesystem::path folder_ = make_folder();
};

Film three_by_two() {
  Film film(3, 2, 4);
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 3; ++x) {
      const std::int64_t one = std::int64_t{1} << kFilmBits;
      film.add(x, y, {one * x, one * y, one / 4});
      film.add(x, y, {one * x, one * y, one / 2});
    }
  }
  return film;
}

TEST_F(ImageFiles, PfmHoldsMeanNitsTheRightWayUp) {
  write_pfm(file("a.pfm"), three_by_two());
  const Pfm pfm = read_pfm(file("a.pfm"));
  ASSERT_EQ(pfm.width, 3);
  ASSERT_EQ(pfm.height, 2);
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 3; ++x) EXPECT_EQ(pfm.at(x, y), glm::vec3(16 * x, 16 * y, 6));
  }
}

TEST_F(ImageFiles, PfmHeaderIsTheFormats) {
  write_pfm(file("a.pfm"), three_by_two());
  std::ifstream in(file("a.pfm"), std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  const std::string header = "PF\n3 2\n-1.0\n";
  EXPECT_EQ(bytes.substr(0, header.size()), header);
  EXPECT_EQ(bytes.size(), header.size() + 3 * 2 * 12);
}

TEST_F(ImageFiles, PngHoldsThePixels) {
  const std::vector<std::uint8_t> rgb{255, 0, 0, 0, 255, 0, 0, 0, 255, 1, 2, 3, 127, 128, 129, 255, 255, 255};
  write_png(file("a.png"), 3, 2, rgb);
  int width = 0;
  int height = 0;
  int channels = 0;
  unsigned char* pixels = stbi_load(file("a.png").c_str(), &width, &height, &channels, 0);
  ASSERT_NE(pixels, nullptr);
  EXPECT_EQ(width, 3);
  EXPECT_EQ(height, 2);
  ASSERT_EQ(channels, 3);
  EXPECT_EQ(std::vector<std::uint8_t>(pixels, pixels + 18), rgb);
  stbi_image_free(pixels);
}

template <class Write>
void expect_refusal(const std::filesystem::path& path, const Write& write) {
  try {
    write();
    FAIL() << path << " was written";
  } catch (const std::runtime_error& error) {
    const std::string message = error.what();
    EXPECT_TRUE(message.starts_with(path.string() + ": cannot be written: ")) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos);
    EXPECT_NE(message.find("; "), std::string::npos) << "no remedy: " << message;
  }
}

TEST_F(ImageFiles, SayWhyAFileCannotBeWritten) {
  const auto missing = file("no such folder/a");
  expect_refusal(missing, [&] { write_pfm(missing, three_by_two()); });
  expect_refusal(missing, [&] { write_png(missing, 1, 1, std::vector<std::uint8_t>(3)); });
  const auto folder = file(".");
  expect_refusal(folder, [&] { write_pfm(folder, three_by_two()); });
}

TEST_F(ImageFiles, SayThatTheDiskIsFull) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  expect_refusal("/dev/full", [] { write_pfm("/dev/full", three_by_two()); });
}

}  // namespace
}  // namespace vitrine
