// SPDX-License-Identifier: Apache-2.0
#include "runtime/gltf_accessor.h"

#include <fmt/format.h>
#include <string.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>

namespace texgraph::runtime {
namespace {

size_t ComponentBytes(int type) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return 2;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return 4;
    default:
      return 0;
  }
}

uint32_t Components(int type) {
  switch (type) {
    case TINYGLTF_TYPE_SCALAR:
      return 1;
    case TINYGLTF_TYPE_VEC2:
      return 2;
    case TINYGLTF_TYPE_VEC3:
      return 3;
    case TINYGLTF_TYPE_VEC4:
      return 4;
    default:
      return 0;
  }
}

template <class T>
T Load(const unsigned char* bytes) {
  T value;
  memcpy(&value, bytes, sizeof value);
  return value;
}

double Number(const unsigned char* bytes, int type, bool normalized) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE: {
      const double value = Load<int8_t>(bytes);
      return normalized ? std::max(value / 127, -1.0) : value;
    }
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return normalized ? bytes[0] / 255.0 : bytes[0];
    case TINYGLTF_COMPONENT_TYPE_SHORT: {
      const double value = Load<int16_t>(bytes);
      return normalized ? std::max(value / 32767, -1.0) : value;
    }
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return normalized ? Load<uint16_t>(bytes) / 65535.0 : Load<uint16_t>(bytes);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return Load<uint32_t>(bytes);
    default:
      return Load<float>(bytes);
  }
}

// Elements that were found to be inside of a buffer.
struct Elements {
  const unsigned char* first = nullptr;
  size_t stride = 0;
};

// `count` elements of `bytes` each, `offset` bytes into a view; nothing in it is trusted.
bool FindElements(const tinygltf::Model& model, int view_index, size_t offset, size_t count,
                  size_t bytes, Elements& elements, std::string& why_not) {
  if (view_index < 0 || static_cast<size_t>(view_index) >= model.bufferViews.size()) {
    why_not = fmt::format("there is no buffer view {}", view_index);
    return false;
  }
  const tinygltf::BufferView& view = model.bufferViews[static_cast<size_t>(view_index)];
  if (view.buffer < 0 || static_cast<size_t>(view.buffer) >= model.buffers.size()) {
    why_not = fmt::format("there is no buffer {}", view.buffer);
    return false;
  }
  const std::vector<unsigned char>& data = model.buffers[static_cast<size_t>(view.buffer)].data;
  if (view.byteOffset > data.size() || view.byteLength > data.size() - view.byteOffset) {
    why_not = fmt::format("buffer view {} reaches beyond its buffer", view_index);
    return false;
  }
  elements.stride = view.byteStride == 0 ? bytes : view.byteStride;
  if (elements.stride < bytes || elements.stride > 252) {
    why_not = fmt::format("buffer view {} has a stride of {} bytes", view_index, view.byteStride);
    return false;
  }
  const size_t needed = count == 0 ? 0 : elements.stride * (count - 1) + bytes;
  if (offset > view.byteLength || needed > view.byteLength - offset) {
    why_not = fmt::format("an accessor reaches beyond buffer view {}", view_index);
    return false;
  }
  elements.first = data.data() + view.byteOffset + offset;
  return true;
}

// Calls set(element, bytes) for all elements of the accessor that are not zero, its sparse ones
// last.
template <class Set>
bool Visit(const tinygltf::Model& model, const tinygltf::Accessor& accessor, size_t bytes,
           const Set& set, std::string& why_not) {
  Elements elements;
  if (accessor.bufferView >= 0 || !accessor.sparse.isSparse) {
    if (!FindElements(model, accessor.bufferView, accessor.byteOffset, accessor.count, bytes,
                      elements, why_not))
      return false;
    for (size_t i = 0; i < accessor.count; ++i) set(i, elements.first + i * elements.stride);
  }
  if (!accessor.sparse.isSparse) return true;
  const auto& sparse = accessor.sparse;
  const size_t index_bytes = ComponentBytes(sparse.indices.componentType);
  const bool is_index = sparse.indices.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                        sparse.indices.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
                        sparse.indices.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
  if (sparse.count < 1 || static_cast<size_t>(sparse.count) > accessor.count || !is_index ||
      sparse.indices.byteOffset < 0 || sparse.values.byteOffset < 0) {
    why_not = "a sparse accessor has an impossible count, offset or type";
    return false;
  }
  const auto count = static_cast<size_t>(sparse.count);
  Elements indices;
  if (!FindElements(model, sparse.indices.bufferView,
                    static_cast<size_t>(sparse.indices.byteOffset), count, index_bytes, indices,
                    why_not) ||
      !FindElements(model, sparse.values.bufferView, static_cast<size_t>(sparse.values.byteOffset),
                    count, bytes, elements, why_not))
    return false;
  for (size_t i = 0; i < count; ++i) {
    const double index =
        Number(indices.first + i * indices.stride, sparse.indices.componentType, false);
    if (index >= static_cast<double>(accessor.count)) {
      why_not = "a sparse accessor puts a value outside of itself";
      return false;
    }
    set(static_cast<size_t>(index), elements.first + i * elements.stride);
  }
  return true;
}

const tinygltf::Accessor* FindAccessor(const tinygltf::Model& model, int index, size_t limit,
                                       std::string& why_not) {
  if (index < 0 || static_cast<size_t>(index) >= model.accessors.size()) {
    why_not = fmt::format("there is no accessor {}", index);
    return nullptr;
  }
  const tinygltf::Accessor& accessor = model.accessors[static_cast<size_t>(index)];
  if (accessor.count >= 1 && accessor.count <= limit) return &accessor;
  why_not =
      fmt::format("accessor {} has {} elements; 1 to {} can be read", index, accessor.count, limit);
  return nullptr;
}

}  // namespace

bool ReadFloats(const tinygltf::Model& model, int index, uint32_t components, size_t limit,
                std::vector<float>& floats, std::string& why_not) {
  const tinygltf::Accessor* accessor = FindAccessor(model, index, limit, why_not);
  if (accessor == nullptr) return false;
  const size_t bytes = ComponentBytes(accessor->componentType);
  if (Components(accessor->type) != components || bytes == 0) {
    why_not = fmt::format("accessor {} has another type than {} numbers", index, components);
    return false;
  }
  floats.assign(accessor->count * components, 0.0f);
  bool finite = true;
  const auto set = [&](size_t element, const unsigned char* from) {
    for (uint32_t c = 0; c < components; ++c) {
      const double value = Number(from + c * bytes, accessor->componentType, accessor->normalized);
      finite = finite && std::isfinite(value);
      floats[element * components + c] = static_cast<float>(value);
    }
  };
  if (!Visit(model, *accessor, bytes * components, set, why_not)) return false;
  if (!finite) why_not = fmt::format("accessor {} has numbers that are not finite", index);
  return finite;
}

bool ReadIndices(const tinygltf::Model& model, int index, size_t limit,
                 std::vector<uint32_t>& indices, std::string& why_not) {
  const tinygltf::Accessor* accessor = FindAccessor(model, index, limit, why_not);
  if (accessor == nullptr) return false;
  const int type = accessor->componentType;
  if (accessor->type != TINYGLTF_TYPE_SCALAR || (type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE &&
                                                 type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT &&
                                                 type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT)) {
    why_not = fmt::format("accessor {} has no indices", index);
    return false;
  }
  indices.assign(accessor->count, 0);
  const auto set = [&](size_t element, const unsigned char* from) {
    indices[element] = static_cast<uint32_t>(Number(from, type, false));
  };
  return Visit(model, *accessor, ComponentBytes(type), set, why_not);
}

}  // namespace texgraph::runtime
