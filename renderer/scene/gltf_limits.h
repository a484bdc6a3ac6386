// What a glTF file may ask of a small machine. A file beyond a limit is refused with that limit in the
// message (images are shrunk first), so that a few bytes of input can never become minutes of work or
// gigabytes of memory.
#pragma once

#include <cstddef>
#include <cstdint>

namespace vitrine::gltf_limits {

constexpr std::size_t kMaxFileBytes = std::size_t{512} << 20;  ///< the scene file, and each file it refers to
constexpr std::size_t kMaxBufferBytes = std::size_t{1} << 30;  ///< all buffers together
constexpr std::size_t kMaxJsonDepth = 128;                     ///< nesting of arrays and objects
constexpr std::size_t kMaxJsonValues = 4'000'000;              ///< values in the JSON text
constexpr std::uint64_t kMaxTriangles = 8'000'000;  ///< in the world: a mesh counts once an instance
constexpr std::uint64_t kMaxInstances = 250'000;    ///< meshes placed in the world
constexpr std::size_t kMaxAccessorElements = 3 * kMaxTriangles;  ///< in one accessor
constexpr std::uint64_t kMaxElementsRead = 200'000'000;          ///< of all accessors, each time one is read
constexpr int kMaxImageSide = 4096;                              ///< larger images are halved until they fit
constexpr std::uint64_t kMaxImageTexels = std::uint64_t{64}
                                          << 20;               ///< in one image as it is stored in the file
constexpr std::uint64_t kMaxTexels = std::uint64_t{64} << 20;  ///< in all images together, after shrinking
constexpr double kMaxCoordinate_m = 1e9;                       ///< farthest a vertex may lie from the origin

}  // namespace vitrine::gltf_limits
