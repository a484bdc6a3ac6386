// Radiance pictures (.hdr): rows of RGBE pixels, three mantissas and one exponent in four bytes, raw or run
// length encoded (Ward 1991, "Real Pixels"; the Radiance manual, "File Formats").
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "scene/scene.h"

namespace vitrine {

namespace hdr_limits {
constexpr std::uint64_t kMaxFileBytes = std::uint64_t{64} << 20;
constexpr int kMaxWidth = 4096;     ///< half as many rows: an environment map has no use for more
constexpr float kMaxValue = 1e12F;  ///< no sun is that much brighter than its sky
}  // namespace hdr_limits

/// An equirectangular picture, twice as wide as high. Throws InputError with `file` and `place`.
EnvironmentPicture decode_hdr(std::span<const unsigned char> bytes, const std::string& file,
                              const std::string& place = "");

/// The same from a file. Throws InputError.
EnvironmentPicture read_hdr(const std::filesystem::path& path);

}  // namespace vitrine
