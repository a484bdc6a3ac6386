#include "scene/hdr_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <string_view>
#include <vector>

#include "scene/input_error.h"

namespace vitrine {
namespace {

constexpr const char* kSaveAgain = "save the picture again as a Radiance .hdr (RGBE)";

using Rgbe = std::array<unsigned char, 4>;

class HdrDecoder {
 public:
  HdrDecoder(std::span<const unsigned char> bytes, const std::string& file, const std::string& place)
      : rest_(bytes), file_(file), place_(place) {}

  EnvironmentPicture decode() {
    read_header();
    read_resolution();
    picture_.values.reserve(static_cast<std::size_t>(picture_.width) *
                            static_cast<std::size_t>(picture_.height));
    std::vector<Rgbe> row(static_cast<std::size_t>(picture_.width));
    bool black = true;
    for (row_ = 0; row_ < picture_.height; ++row_) {
      read_row(row);
      for (const Rgbe& pixel : row) {
        const glm::vec3 value = value_of(pixel);
        black = black && value == glm::vec3(0.0F);
        picture_.values.push_back(value);
      }
    }
    if (black) refuse("pixels", "all are black", "leave the environment out, or give one that shines");
    return std::move(picture_);
  }

 private:
  [[noreturn]] void refuse(const std::string& where, const std::string& problem,
                           const std::string& remedy = kSaveAgain) const {
    throw InputError(file_, place_.empty() ? where : place_ + ": " + where, problem, remedy);
  }
  [[noreturn]] void refuse_row(const std::string& problem) const {
    refuse("row " + std::to_string(row_), problem);
  }

  std::string_view read_line(const std::string& where) {
    constexpr std::size_t kMaxLine = 4096;
    const auto end = std::ranges::find(rest_.first(std::min(rest_.size(), kMaxLine)), '\n');
    const auto length = static_cast<std::size_t>(end - rest_.begin());
    if (length == rest_.size() || length == kMaxLine) refuse(where, "the header does not end");
    const std::string_view line(reinterpret_cast<const char*>(rest_.data()), length);
    rest_ = rest_.subspan(length + 1);
    return line.ends_with('\r') ? line.substr(0, length - 1) : line;
  }

  // "#?...", then variables, then an empty line.
  void read_header() {
    if (rest_.size() < 2 || rest_[0] != '#' || rest_[1] != '?')
      refuse("header", "it does not begin with #?RADIANCE: this is no Radiance picture");
    int number = 1;
    for (std::string_view line = read_line("header"); !line.empty();) {
      const std::string where = "header line " + std::to_string(++number);
      line = read_line(where);
      if (line.starts_with("FORMAT=") && line != "FORMAT=32-bit_rle_rgbe")
        refuse(where, "the format is not 32-bit_rle_rgbe");
      constexpr std::string_view kExposure = "EXPOSURE=";
      if (line.starts_with(kExposure)) take_exposure(line.substr(kExposure.size()), where);
    }
  }

  // What the values were multiplied by; several count together.
  void take_exposure(std::string_view text, const std::string& where) {
    while (text.starts_with(' ')) text.remove_prefix(1);
    double factor = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), factor);
    exposure_ *= factor;
    if (error != std::errc{} || !(exposure_ > 1e-12 && exposure_ < 1e12))
      refuse(where, "the exposure is no number that a picture could have");
  }

  void read_resolution() {
    constexpr const char* kWhere = "resolution line";
    const std::string_view line = read_line(kWhere);
    const char* at = line.data();
    const char* const end = at + line.size();
    const auto number_after = [&](std::string_view axis) {
      int number = -1;
      if (std::string_view(at, static_cast<std::size_t>(end - at)).starts_with(axis)) {
        const auto read = std::from_chars(at + axis.size(), end, number);
        if (read.ec != std::errc{}) number = -1;
        at = read.ptr;
      }
      return number;
    };
    picture_.height = number_after("-Y ");
    picture_.width = picture_.height < 0 ? -1 : number_after(" +X ");
    if (picture_.width < 0 || at != end) {
      refuse(kWhere, "it is not of the form -Y HEIGHT +X WIDTH",
             "save the picture with its rows from top to bottom");
    }
    const std::string size = std::to_string(picture_.width) + "x" + std::to_string(picture_.height);
    if (picture_.width > hdr_limits::kMaxWidth) {
      refuse(kWhere, size + " pixels are too many",
             "scale it down to a width of " + std::to_string(hdr_limits::kMaxWidth) + " or less");
    }
    if (picture_.height < 1 || picture_.width != 2 * picture_.height) {
      refuse(kWhere, size + " pixels are no equirectangular picture",
             "make it one: twice as wide as high, all directions");
    }
  }

  unsigned char read_byte() {
    if (rest_.empty()) refuse_row("the file ends");
    const unsigned char byte = rest_.front();
    rest_ = rest_.subspan(1);
    return byte;
  }
  Rgbe read_pixel() {
    Rgbe pixel;
    for (unsigned char& byte : pixel) byte = read_byte();
    return pixel;
  }

  // A row that is encoded by components begins with 2, 2 and its width, which no raw pixel can be.
  void read_row(std::span<Rgbe> row) {
    const Rgbe first = read_pixel();
    const bool by_components =
        row.size() >= 8 && row.size() < 0x8000 && first[0] == 2 && first[1] == 2 && first[2] < 128;
    if (!by_components) {
      read_pixels(first, row);
      return;
    }
    if (std::size_t{first[2]} * 256 + first[3] != row.size()) refuse_row("its width is not the picture's");
    for (std::size_t component = 0; component < 4; ++component) read_component(component, row);
  }

  // Counts above 128 repeat the byte that follows, others precede as many bytes.
  void read_component(std::size_t component, std::span<Rgbe> row) {
    constexpr unsigned kRepeat = 128;
    for (std::size_t x = 0; x < row.size();) {
      const unsigned count = read_byte();
      const bool repeats = count > kRepeat;
      const std::size_t end = x + (repeats ? count - kRepeat : count);
      if (count == 0 || end > row.size()) refuse_row("a run of equal bytes leaves the row");
      const unsigned char repeated = repeats ? read_byte() : static_cast<unsigned char>(0);
      for (; x < end; ++x) row[x][component] = repeats ? repeated : read_byte();
    }
  }

  // Whole pixels; 1, 1, 1, n repeats the last one n times, the next such pixel 256 n times, and so on.
  void read_pixels(Rgbe pixel, std::span<Rgbe> row) {
    int shift = 0;
    for (std::size_t x = 0; x < row.size();) {
      if (pixel[0] == 1 && pixel[1] == 1 && pixel[2] == 1) {
        const std::size_t count = shift > 16 ? row.size() + 1 : std::size_t{pixel[3]} << shift;
        if (x == 0 || count > row.size() - x) refuse_row("a run of equal pixels leaves the row");
        for (const std::size_t end = x + count; x < end; ++x) row[x] = row[x - 1];
        shift += 8;
      } else {
        row[x++] = pixel;
        shift = 0;
      }
      if (x < row.size()) pixel = read_pixel();
    }
  }

  [[nodiscard]] glm::vec3 value_of(const Rgbe& pixel) const {
    if (pixel[3] == 0) return glm::vec3(0.0F);
    const double unit = std::ldexp(1.0 / exposure_, static_cast<int>(pixel[3]) - (128 + 8));
    const glm::dvec3 value = unit * glm::dvec3(pixel[0], pixel[1], pixel[2]);
    if (!(std::max({value.x, value.y, value.z}) <= static_cast<double>(hdr_limits::kMaxValue)))
      refuse_row("a value is larger than 1e12");
    return glm::vec3(value);
  }

  std::span<const unsigned char> rest_;
  const std::string& file_;
  const std::string& place_;
  EnvironmentPicture picture_;
  double exposure_ = 1.0;
  int row_ = 0;
};

}  // namespace

EnvironmentPicture decode_hdr(std::span<const unsigned char> bytes, const std::string& file,
                              const std::string& place) {
  return HdrDecoder(bytes, file, place).decode();
}

EnvironmentPicture read_hdr(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
    throw InputError(path.string(), "", "there is no such file", "name a Radiance .hdr picture");
  const auto size = std::filesystem::file_size(path, error);
  if (error || size > hdr_limits::kMaxFileBytes)
    throw InputError(path.string(), "", "the file is larger than 64 MiB", "scale the picture down");
  std::vector<unsigned char> bytes(static_cast<std::size_t>(size));
  std::ifstream stream(path, std::ios::binary);
  stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (!stream) throw InputError(path.string(), "", "it cannot be read", "check the permissions of the file");
  return decode_hdr(bytes, path.string());
}

}  // namespace vitrine
