#define STB_IMAGE_WRITE_STATIC  // other libraries bring copies of their own
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>

#include "engine/scene/glb_buffer.h"

#include <algorithm>
#include <limits>

#include "engine/core/error.h"

namespace macula::scene {
namespace {

// Numbers of OpenGL that glTF uses.
constexpr int kUnsignedShort = 5123;
constexpr int kUnsignedInt = 5125;
constexpr int kFloat = 5126;
constexpr int kArrayBuffer = 34962;
constexpr int kElementArrayBuffer = 34963;
constexpr int kNoTarget = 0;

// Accessors must begin at a multiple of their component's size; 4 covers all.
constexpr std::size_t kAlignment = 4;
// glTF's indices are below the type's largest value, which would restart the primitive.
constexpr std::size_t kMostShortVertices = std::numeric_limits<std::uint16_t>::max();

const char* typeName(int components) {
  switch (components) {
    case 2:
      return "VEC2";
    case 3:
      return "VEC3";
    default:
      return "VEC4";
  }
}

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

std::size_t GlbBuffer::addView(std::span<const std::byte> bytes, int target) {
  bytes_.resize((bytes_.size() + kAlignment - 1) / kAlignment * kAlignment);
  GlbJson view{{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", bytes.size()}};
  if (target != kNoTarget) view["target"] = target;
  bytes_.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  views_.push_back(std::move(view));
  return views_.size() - 1;
}

std::size_t GlbBuffer::addFloats(const std::vector<float>& values, int components) {
  const std::size_t view = addView(std::as_bytes(std::span(values)), kArrayBuffer);
  accessors_.push_back({{"bufferView", view},
                        {"componentType", kFloat},
                        {"count", values.size() / static_cast<std::size_t>(components)},
                        {"type", typeName(components)}});
  return accessors_.size() - 1;
}

std::size_t GlbBuffer::addIndices(const Primitive& primitive) {
  const bool isShort = primitive.positions.size() <= kMostShortVertices;
  std::size_t view = 0;
  if (isShort) {
    const std::vector<std::uint16_t> indices(primitive.indices.begin(), primitive.indices.end());
    view = addView(std::as_bytes(std::span(indices)), kElementArrayBuffer);
  } else {
    view = addView(std::as_bytes(std::span(primitive.indices)), kElementArrayBuffer);
  }
  accessors_.push_back({{"bufferView", view},
                        {"componentType", isShort ? kUnsignedShort : kUnsignedInt},
                        {"count", primitive.indices.size()},
                        {"type", "SCALAR"}});
  return accessors_.size() - 1;
}

GlbJson GlbBuffer::addPrimitive(const Primitive& primitive, bool withTangents, bool withUv) {
  GlbJson attributes = GlbJson::object();
  std::vector<float> positions;
  Bounds bounds;
  for (const glm::vec3& p : primitive.positions) {
    positions.insert(positions.end(), {p.x, p.y, p.z});
    bounds.add(p);
  }
  const std::size_t position = addFloats(positions, 3);
  accessors_[position]["min"] = {bounds.min.x, bounds.min.y, bounds.min.z};
  accessors_[position]["max"] = {bounds.max.x, bounds.max.y, bounds.max.z};
  attributes["POSITION"] = position;

  const auto any = [&](const auto& differs) {
    return std::any_of(primitive.attributes.begin(), primitive.attributes.end(), differs);
  };
  attributes["NORMAL"] =
      addFloats(flatten(primitive, [](const VertexAttributes& v) { return v.normal; }), 3);
  if (withTangents) {
    attributes["TANGENT"] =
        addFloats(flatten(primitive, [](const VertexAttributes& v) { return v.tangent; }), 4);
  }
  const bool second = any([](const VertexAttributes& v) { return v.uv1 != glm::vec2(0.0F); });
  if (withUv || second) {
    attributes["TEXCOORD_0"] =
        addFloats(flatten(primitive, [](const VertexAttributes& v) { return v.uv0; }), 2);
  }
  if (second) {
    attributes["TEXCOORD_1"] =
        addFloats(flatten(primitive, [](const VertexAttributes& v) { return v.uv1; }), 2);
  }
  if (any([](const VertexAttributes& v) { return v.color != glm::vec4(1.0F); })) {
    attributes["COLOR_0"] = addFloats(
        flatten(primitive,
                // The specification's range.
                [](const VertexAttributes& v) { return glm::clamp(v.color, 0.0F, 1.0F); }),
        4);
  }
  GlbJson entry{{"attributes", std::move(attributes)}, {"indices", addIndices(primitive)}};
  if (primitive.material != kNone) entry["material"] = primitive.material;
  return entry;
}

GlbJson GlbBuffer::addImage(const Image& image) {
  GlbJson entry = GlbJson::object();
  if (!image.name.empty()) entry["name"] = image.name;
  entry["mimeType"] = "image/png";
  entry["bufferView"] = addView(pngBytes(image), kNoTarget);
  return entry;
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
