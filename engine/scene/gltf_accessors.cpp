#include "engine/scene/gltf_accessors.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <type_traits>

#include "engine/core/plural.h"

namespace macula::scene::gltf {
namespace {

// Where the elements of an accessor, or of its sparse part, lie; already checked.
struct Layout {
  const std::byte* first = nullptr;
  std::size_t stride = 0;
};

std::size_t componentBytes(int type) {
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
      return 0;  // INT and DOUBLE are tinygltf's, not glTF's
  }
}

std::size_t componentCount(const tinygltf::Accessor& accessor) {
  switch (accessor.type) {
    case TINYGLTF_TYPE_SCALAR:
      return 1;
    case TINYGLTF_TYPE_VEC2:
      return 2;
    case TINYGLTF_TYPE_VEC3:
      return 3;
    case TINYGLTF_TYPE_VEC4:
      return 4;
    // MAT2 and MAT3 have padded columns, and nothing that is read here uses them.
    case TINYGLTF_TYPE_MAT4:
      return 16;
    default:
      return 0;
  }
}

// Checks that `count` elements of `elementBytes` lie inside a buffer view.
Layout layoutOf(const Document& document, std::int32_t view, std::size_t byteOffset,
                std::size_t elementBytes, std::size_t count, bool strided, std::string_view place) {
  const std::span<const std::byte> bytes = document.viewBytes(view, place);
  const std::size_t declared =
      document.model.bufferViews[static_cast<std::size_t>(view)].byteStride;
  const std::size_t stride = strided && declared != 0 ? declared : elementBytes;
  if (stride < elementBytes) {
    document.fail(place,
                  "byteStride {} of buffer view {} is less than an element of {} bytes; "
                  "export the file again",
                  stride, view, elementBytes);
  }
  const std::size_t room = byteOffset > bytes.size() ? 0 : bytes.size() - byteOffset;
  const std::size_t most = room < elementBytes ? 0 : (room - elementBytes) / stride + 1;
  if (count > most) {
    document.fail(place, "{} asked for, and buffer view {} holds {}; export the file again",
                  counted(count, "element"), view, most);
  }
  // Without elements there may be no bytes to point at.
  return {count == 0 ? nullptr : bytes.data() + byteOffset, stride};
}

template <typename T>
T loadAs(const std::byte* from) {
  T value{};
  std::memcpy(&value, from, sizeof value);  // glTF bytes are little-endian and may be unaligned
  return value;
}

// Specification section 3.11: the normalized integers as floats.
template <typename T>
float toFloat(T value, bool normalized) {
  if constexpr (std::is_floating_point_v<T>) {
    return value;
  } else {
    const auto number = static_cast<float>(value);
    if (!normalized) return number;
    return std::max(number / static_cast<float>(std::numeric_limits<T>::max()), -1.0F);
  }
}

template <typename T>
void copyElements(const Layout& from, std::size_t count, std::size_t components, bool normalized,
                  float* to) {
  for (std::size_t i = 0; i < count; ++i) {
    const std::byte* element = from.first + i * from.stride;
    for (std::size_t c = 0; c < components; ++c) {
      *to++ = toFloat(loadAs<T>(element + c * sizeof(T)), normalized);
    }
  }
}

void copyAs(int componentType, const Layout& from, std::size_t count, std::size_t components,
            bool normalized, float* to) {
  switch (componentType) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return copyElements<std::int8_t>(from, count, components, normalized, to);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return copyElements<std::uint8_t>(from, count, components, normalized, to);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return copyElements<std::int16_t>(from, count, components, normalized, to);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return copyElements<std::uint16_t>(from, count, components, normalized, to);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return copyElements<std::uint32_t>(from, count, components, normalized, to);
    default:
      return copyElements<float>(from, count, components, normalized, to);
  }
}

std::uint32_t indexAt(int componentType, const Layout& from, std::size_t i) {
  const std::byte* element = from.first + i * from.stride;
  switch (componentType) {
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return loadAs<std::uint8_t>(element);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return loadAs<std::uint16_t>(element);
    default:
      return loadAs<std::uint32_t>(element);
  }
}

std::uint32_t largestIndex(int componentType) {
  switch (componentType) {
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return std::numeric_limits<std::uint8_t>::max();
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return std::numeric_limits<std::uint16_t>::max();
    default:
      return std::numeric_limits<std::uint32_t>::max();
  }
}

bool isIndexType(int componentType) {
  return componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
         componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
         componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

// Specification section 3.6.2.3: replaces the elements that the sparse part names. Calls
// replace(index, layout of the values, place in them).
template <typename Replace>
void applySparse(const Document& document, const tinygltf::Accessor& accessor,
                 std::size_t elementBytes, std::string_view place, const Replace& replace) {
  const auto& sparse = accessor.sparse;
  if (!sparse.isSparse) return;
  if (sparse.count < 0 || static_cast<std::size_t>(sparse.count) > accessor.count ||
      sparse.indices.byteOffset < 0 || sparse.values.byteOffset < 0 ||
      !isIndexType(sparse.indices.componentType)) {
    document.fail(place, "its sparse part is malformed; export the file again");
  }
  const auto count = static_cast<std::size_t>(sparse.count);
  const Layout indices = layoutOf(
      document, sparse.indices.bufferView, static_cast<std::size_t>(sparse.indices.byteOffset),
      componentBytes(sparse.indices.componentType), count, false, place);
  const Layout values = layoutOf(document, sparse.values.bufferView,
                                 static_cast<std::size_t>(sparse.values.byteOffset), elementBytes,
                                 count, false, place);
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t index = indexAt(sparse.indices.componentType, indices, i);
    if (index >= accessor.count) {
      document.fail(place, "its sparse part replaces element {} of {}; export the file again",
                    index, accessor.count);
    }
    replace(index, Layout{values.first + i * values.stride, values.stride});
  }
}

}  // namespace

const tinygltf::Accessor& accessorAt(const Document& document, std::int32_t index,
                                     std::string_view place) {
  if (index < 0 || static_cast<std::size_t>(index) >= document.model.accessors.size()) {
    document.fail(place, "names accessor {} of {}; export the file again", index,
                  document.model.accessors.size());
  }
  return document.model.accessors[static_cast<std::size_t>(index)];
}

Elements readElements(const Document& document, std::int32_t index, std::size_t count,
                      std::string_view place, Integers integers) {
  const tinygltf::Accessor& accessor = accessorAt(document, index, place);
  const std::size_t components = componentCount(accessor);
  const std::size_t elementBytes = components * componentBytes(accessor.componentType);
  if (elementBytes == 0) {
    document.fail(place, "accessor {} has a type that cannot be read; export the file again",
                  index);
  }
  if (count > accessor.count) {
    document.fail(place, "accessor {} has {} where {} needed; export the file again", index,
                  counted(accessor.count, "element"), counted(count, "is", "are"));
  }
  const bool normalized = accessor.normalized || integers == Integers::Normalized;
  Elements elements{count, components, {}};
  Layout layout;
  if (accessor.bufferView != kNone) {
    layout = layoutOf(document, accessor.bufferView, accessor.byteOffset, elementBytes,
                      accessor.count, true, place);
  }
  elements.values.resize(count * components);
  if (layout.first != nullptr) {
    copyAs(accessor.componentType, layout, count, components, normalized, elements.values.data());
  }
  applySparse(document, accessor, elementBytes, place,
              [&](std::uint32_t element, const Layout& value) {
                if (element >= count) return;
                copyAs(accessor.componentType, value, 1, components, normalized,
                       &elements.values[element * components]);
              });
  return elements;
}

std::vector<std::uint32_t> readIndices(const Document& document, std::int32_t index,
                                       std::string_view place) {
  const tinygltf::Accessor& accessor = accessorAt(document, index, place);
  const int type = accessor.componentType;
  if (accessor.type != TINYGLTF_TYPE_SCALAR || !isIndexType(type)) {
    document.fail(place, "its indices are not unsigned integers; export the file again");
  }
  const Layout layout = layoutOf(document, accessor.bufferView, accessor.byteOffset,
                                 componentBytes(type), accessor.count, true, place);
  std::vector<std::uint32_t> indices(accessor.count);
  for (std::size_t i = 0; i < indices.size(); ++i) indices[i] = indexAt(type, layout, i);
  applySparse(document, accessor, componentBytes(type), place,
              [&](std::uint32_t element, const Layout& value) {
                indices[element] = indexAt(type, value, 0);
              });
  if (std::find(indices.begin(), indices.end(), largestIndex(type)) != indices.end()) {
    document.fail(place,
                  "its indices hold the primitive restart value {}, which glTF forbids; "
                  "export the file again",
                  largestIndex(type));
  }
  return indices;
}

}  // namespace macula::scene::gltf
