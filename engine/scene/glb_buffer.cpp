#define STB_IMAGE_WRITE_STATIC  // other libraries bring copies of their own
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>

#include "engine/scene/glb_buffer.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "engine/core/error.h"

namespace macula::scene {
namespace {

constexpr int kNoTarget = 0;

// Accessors must begin at a multiple of their component's size; 4 covers all.
constexpr std::size_t kAlignment = 4;
// glTF's indices are below the type's largest value, which would restart the primitive.
constexpr std::size_t kMostShortVertices = std::numeric_limits<std::uint16_t>::max();

/// The values of one attribute of all vertices, one after the other.
template <typename Get>
std::vector<float> flatten(const Primitive& primitive, const Get& get) {
  std::vector<float> values;
  for (const VertexAttributes& vertex : primitive.attributes) {
    const auto value = get(vertex);
    for (int c = 0; c < value.length(); ++c) values.push_back(value[c]);
  }
  return values;
}

}  // namespace

int GlbBuffer::addView(std::span<const std::byte> bytes, int target) {
  if (model_.buffers.empty()) model_.buffers.emplace_back();
  std::vector<unsigned char>& data = model_.buffers.front().data;
  data.resize((data.size() + kAlignment - 1) / kAlignment * kAlignment);
  tinygltf::BufferView& view = model_.bufferViews.emplace_back();
  view.buffer = 0;
  view.byteOffset = data.size();
  view.byteLength = bytes.size();
  view.target = target;
  const auto* first = reinterpret_cast<const unsigned char*>(bytes.data());
  data.insert(data.end(), first, first + bytes.size());
  return static_cast<int>(model_.bufferViews.size()) - 1;
}

int GlbBuffer::addAccessor(int view, int componentType, int type, std::size_t count) {
  tinygltf::Accessor& accessor = model_.accessors.emplace_back();
  accessor.bufferView = view;
  accessor.componentType = componentType;
  accessor.type = type;
  accessor.count = count;
  return static_cast<int>(model_.accessors.size()) - 1;
}

int GlbBuffer::addFloats(const std::vector<float>& values, int components) {
  const int view = addView(std::as_bytes(std::span(values)), TINYGLTF_TARGET_ARRAY_BUFFER);
  // TINYGLTF_TYPE_VEC2, _VEC3 and _VEC4 are 2, 3 and 4.
  return addAccessor(view, TINYGLTF_COMPONENT_TYPE_FLOAT, components,
                     values.size() / static_cast<std::size_t>(components));
}

int GlbBuffer::addIndices(const Primitive& primitive) {
  int view = 0;
  const bool isShort = primitive.positions.size() <= kMostShortVertices;
  if (isShort) {
    const std::vector<std::uint16_t> indices(primitive.indices.begin(), primitive.indices.end());
    view = addView(std::as_bytes(std::span(indices)), TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
  } else {
    view =
        addView(std::as_bytes(std::span(primitive.indices)), TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
  }
  return addAccessor(
      view, isShort ? TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT : TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT,
      TINYGLTF_TYPE_SCALAR, primitive.indices.size());
}

tinygltf::Primitive GlbBuffer::addPrimitive(const Primitive& primitive, bool withTangents,
                                            bool withUv) {
  tinygltf::Primitive entry;
  entry.mode = TINYGLTF_MODE_TRIANGLES;
  entry.material = primitive.material;
  std::vector<float> positions;
  Bounds bounds;
  for (const glm::vec3& p : primitive.positions) {
    positions.insert(positions.end(), {p.x, p.y, p.z});
    bounds.add(p);
  }
  const int position = addFloats(positions, 3);
  entry.attributes["POSITION"] = position;
  tinygltf::Accessor& described = model_.accessors[static_cast<std::size_t>(position)];
  described.minValues = {bounds.min.x, bounds.min.y, bounds.min.z};
  described.maxValues = {bounds.max.x, bounds.max.y, bounds.max.z};

  const auto any = [&](const auto& differs) {
    return std::any_of(primitive.attributes.begin(), primitive.attributes.end(), differs);
  };
  const auto add = [&](const char* semantic, int components, const auto& get) {
    entry.attributes[semantic] = addFloats(flatten(primitive, get), components);
  };
  add("NORMAL", 3, [](const VertexAttributes& v) { return v.normal; });
  if (withTangents) add("TANGENT", 4, [](const VertexAttributes& v) { return v.tangent; });
  const bool second = any([](const VertexAttributes& v) { return v.uv1 != glm::vec2(0.0F); });
  if (withUv || second) add("TEXCOORD_0", 2, [](const VertexAttributes& v) { return v.uv0; });
  if (second) add("TEXCOORD_1", 2, [](const VertexAttributes& v) { return v.uv1; });
  if (any([](const VertexAttributes& v) { return v.color != glm::vec4(1.0F); })) {
    add("COLOR_0", 4, [](const VertexAttributes& v) {
      return glm::clamp(v.color, 0.0F, 1.0F);  // the specification's range
    });
  }
  entry.indices = addIndices(primitive);
  return entry;
}

void GlbBuffer::addImage(const Image& image) {
  tinygltf::Image entry;
  entry.name = validName(image.name);
  entry.mimeType = "image/png";
  entry.bufferView = addView(pngBytes(image), kNoTarget);
  model_.images.push_back(std::move(entry));
}

std::string validName(const std::string& name) {
  using nlohmann::json;
  return json::parse(json(name).dump(-1, ' ', false, json::error_handler_t::replace))
      .get<std::string>();
}

std::vector<std::byte> pngBytes(const Image& image) {
  bool opaque = true;
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) opaque = opaque && image.rgba[i] == 255;
  std::vector<std::uint8_t> pixels;
  if (opaque) {
    for (std::size_t i = 0; i + 3 < image.rgba.size(); i += 4) {
      pixels.insert(pixels.end(), {image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]});
    }
  }
  const int channels = opaque ? 3 : 4;
  std::vector<std::byte> png;
  const auto collect = [](void* context, void* data, int size) {
    auto& bytes = *static_cast<std::vector<std::byte>*>(context);
    const auto* begin = static_cast<const std::byte*>(data);
    bytes.insert(bytes.end(), begin, begin + size);
  };
  if (stbi_write_png_to_func(collect, &png, image.width, image.height, channels,
                             opaque ? pixels.data() : image.rgba.data(),
                             image.width * channels) == 0) {
    failInput("image '{}': {} x {} pixels cannot be written as PNG; use a smaller one", image.name,
              image.width, image.height);
  }
  return png;
}

}  // namespace macula::scene
