// Checked access to glTF accessors: strided and interleaved buffer views, byte offsets, normalised integers
// (glTF 2.0, section 3.6.2.2: c / (2^n - 1), signed max(c / (2^(n-1) - 1), -1)) and sparse substitution.
// Every byte that is read lies within its buffer view, every number that is returned is finite.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "scene/gltf_model.h"

namespace vitrine {

class GltfAccessors {
 public:
  explicit GltfAccessors(const GltfModel& gltf) : gltf_(gltf) {}

  std::size_t count(int accessor) const {
    return gltf_.model.accessors[static_cast<std::size_t>(accessor)].count;
  }

  /// Components of an element: 1 for SCALAR to 4 for VEC4, more for matrices.
  int components(int accessor) const;

  /// `components` numbers an element. `user` is the place that refers to the accessor, for messages.
  std::vector<float> read_numbers(int accessor, int components, const std::string& user);

  /// Unsigned integers of an accessor of scalars.
  std::vector<std::uint32_t> read_indices(int accessor, const std::string& user);

  template <int N>
  std::vector<glm::vec<N, float>> read_vectors(int accessor, const std::string& user) {
    const std::vector<float> values = read_numbers(accessor, N, user);
    std::vector<glm::vec<N, float>> vectors(values.size() / N);
    for (std::size_t i = 0; i < values.size(); ++i) vectors[i / N][static_cast<int>(i % N)] = values[i];
    return vectors;
  }

 private:
  struct Elements {
    const unsigned char* first;
    std::size_t stride;
  };
  Elements locate(int view, std::size_t offset, std::size_t stride, std::size_t element_bytes,
                  std::size_t elements, const std::string& place) const;
  const tinygltf::Accessor& admit(int accessor);
  template <class Store>
  void visit(int accessor, const Store& store) const;

  const GltfModel& gltf_;
  std::uint64_t elements_read_ = 0;
};

}  // namespace vitrine
