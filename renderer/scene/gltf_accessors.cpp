#include "scene/gltf_accessors.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "scene/gltf_limits.h"

namespace vitrine {
namespace {

std::size_t component_bytes(int type) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return 2;
    default:
      return 4;
  }
}

bool is_unsigned_integer(int type) {
  return type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE || type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
         type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

template <class T>
T load(const unsigned char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}

template <class T>
double load_integer(const unsigned char* bytes, bool normalized) {
  const double value = load<T>(bytes);
  return normalized ? std::max(value / std::numeric_limits<T>::max(), -1.0) : value;
}

double load_component(const unsigned char* bytes, int type, bool normalized) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return load_integer<std::int8_t>(bytes, normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return load_integer<std::uint8_t>(bytes, normalized);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return load_integer<std::int16_t>(bytes, normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return load_integer<std::uint16_t>(bytes, normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return load_integer<std::uint32_t>(bytes, normalized);
    default:
      return load<float>(bytes);
  }
}

std::string accessor_place(int accessor) { return "/accessors/" + std::to_string(accessor); }

}  // namespace

int GltfAccessors::components(int accessor) const {
  const auto& described = gltf_.model.accessors[static_cast<std::size_t>(accessor)];
  return tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(described.type));
}

// The elements of a buffer view, the last of which ends within it. A stride of 0 means tightly packed.
GltfAccessors::Elements GltfAccessors::locate(int view_index, std::size_t offset, std::size_t stride,
                                              std::size_t element_bytes, std::size_t elements,
                                              const std::string& place) const {
  const auto& view = gltf_.model.bufferViews[static_cast<std::size_t>(view_index)];
  if (stride == 0) stride = element_bytes;
  if (stride < element_bytes) {
    gltf_.file.refuse(
        "/bufferViews/" + std::to_string(view_index) + "/byteStride",
        std::to_string(stride) + " is less than an element of " + std::to_string(element_bytes) + " bytes",
        "correct the stride or export the file again");
  }
  const std::size_t end = offset + stride * (elements - 1) + element_bytes;
  if (end > view.byteLength) {
    gltf_.file.refuse(place,
                      "its " + std::to_string(elements) + " elements end at byte " + std::to_string(end) +
                          " of buffer view " + std::to_string(view_index) + ", which has " +
                          std::to_string(view.byteLength),
                      "correct its count or byteOffset, or export the file again");
  }
  const auto& buffer = gltf_.model.buffers[static_cast<std::size_t>(view.buffer)];
  return {buffer.data.data() + view.byteOffset + offset, stride};
}

// The accessor, after its size has been found acceptable.
const tinygltf::Accessor& GltfAccessors::admit(int accessor) {
  const auto& described = gltf_.model.accessors[static_cast<std::size_t>(accessor)];
  const std::string place = accessor_place(accessor);
  elements_read_ += described.count;
  if (described.count > gltf_limits::kMaxAccessorElements || elements_read_ > gltf_limits::kMaxElementsRead) {
    gltf_.file.refuse(place + "/count",
                      "more than " + std::to_string(gltf_limits::kMaxAccessorElements) + " elements, or " +
                          std::to_string(gltf_limits::kMaxElementsRead) + " in all accessors",
                      "simplify the scene");
  }
  return described;
}

// Calls store(element, bytes) for the elements that have bytes: those of the buffer view, then the sparse
// ones.
template <class Store>
void GltfAccessors::visit(int accessor, const Store& store) const {
  const auto& described = gltf_.model.accessors[static_cast<std::size_t>(accessor)];
  const std::string place = accessor_place(accessor);
  const std::size_t element_bytes =
      component_bytes(described.componentType) * static_cast<std::size_t>(components(accessor));
  if (described.bufferView >= 0) {
    const std::size_t stride =
        gltf_.model.bufferViews[static_cast<std::size_t>(described.bufferView)].byteStride;
    const Elements all =
        locate(described.bufferView, described.byteOffset, stride, element_bytes, described.count, place);
    for (std::size_t i = 0; i < described.count; ++i) store(i, all.first + i * all.stride);
  }
  if (!described.sparse.isSparse) return;

  const auto& sparse = described.sparse;
  const int index_type = sparse.indices.componentType;
  const auto substituted = static_cast<std::size_t>(sparse.count);
  const Elements indices =
      locate(sparse.indices.bufferView, static_cast<std::size_t>(sparse.indices.byteOffset), 0,
             component_bytes(index_type), substituted, place + "/sparse/indices");
  const Elements values = locate(sparse.values.bufferView, static_cast<std::size_t>(sparse.values.byteOffset),
                                 0, element_bytes, substituted, place + "/sparse/values");
  for (std::size_t i = 0; i < substituted; ++i) {
    const double element = load_component(indices.first + i * indices.stride, index_type, false);
    if (element >= static_cast<double>(described.count)) {
      gltf_.file.refuse(place + "/sparse/indices",
                        "substitutes element " + std::to_string(static_cast<std::uint32_t>(element)) +
                            " of " + std::to_string(described.count),
                        "export the file again");
    }
    store(static_cast<std::size_t>(element), values.first + i * values.stride);
  }
}

std::vector<float> GltfAccessors::read_numbers(int accessor, int components_wanted, const std::string& user) {
  const tinygltf::Accessor& described = admit(accessor);
  if (components(accessor) != components_wanted) {
    gltf_.file.refuse(user,
                      "accessor " + std::to_string(accessor) + " has " +
                          std::to_string(components(accessor)) + " components where " +
                          std::to_string(components_wanted) + " belong",
                      "correct its type or export the file again");
  }
  const auto width = static_cast<std::size_t>(components_wanted);
  const std::size_t component_width = component_bytes(described.componentType);
  std::vector<float> numbers(described.count * width);
  visit(accessor, [&](std::size_t element, const unsigned char* bytes) {
    for (std::size_t c = 0; c < width; ++c) {
      const double value =
          load_component(bytes + c * component_width, described.componentType, described.normalized);
      if (!std::isfinite(value)) {
        gltf_.file.refuse(accessor_place(accessor),
                          "element " + std::to_string(element) + " is not a finite number",
                          "repair the data or export the file again");
      }
      numbers[element * width + c] = static_cast<float>(value);
    }
  });
  return numbers;
}

std::vector<std::uint32_t> GltfAccessors::read_indices(int accessor, const std::string& user) {
  const tinygltf::Accessor& described = admit(accessor);
  if (components(accessor) != 1 || !is_unsigned_integer(described.componentType)) {
    gltf_.file.refuse(user, "accessor " + std::to_string(accessor) + " does not hold unsigned integers",
                      "use SCALAR and 5121, 5123 or 5125");
  }
  std::vector<std::uint32_t> indices(described.count);
  visit(accessor, [&](std::size_t element, const unsigned char* bytes) {
    indices[element] = static_cast<std::uint32_t>(load_component(bytes, described.componentType, false));
  });
  return indices;
}

}  // namespace vitrine
