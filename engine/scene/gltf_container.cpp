#include "engine/scene/gltf_container.h"

#include <cstdint>

#include "engine/core/error.h"

namespace macula::scene::gltf {
namespace {

constexpr std::uint32_t kMagic = 0x46546C67;      // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;  // "JSON"
constexpr std::uint32_t kBinChunk = 0x004E4942;   // "BIN"
constexpr std::uint32_t kVersion = 2;
constexpr std::size_t kHeaderBytes = 12;
constexpr std::size_t kChunkHeaderBytes = 8;

std::uint32_t u32At(std::span<const std::byte> bytes, std::size_t offset) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    value |= std::to_integer<std::uint32_t>(bytes[offset + i]) << (8U * i);
  }
  return value;
}

std::string_view asText(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

struct Chunk {
  std::uint32_t type = 0;
  std::span<const std::byte> data;
};

// Takes the next chunk off the front of `rest`.
Chunk takeChunk(std::span<const std::byte>& rest, const std::string& name) {
  if (rest.size() < kChunkHeaderBytes) {
    failInput("{}: the .glb ends inside a chunk header; copy or export the file again", name);
  }
  const std::size_t length = u32At(rest, 0);
  Chunk chunk{u32At(rest, 4), {}};
  rest = rest.subspan(kChunkHeaderBytes);
  if (length > rest.size()) {
    failInput("{}: a .glb chunk of {} bytes has only {}; copy or export the file again", name,
              length, rest.size());
  }
  chunk.data = rest.first(length);
  rest = rest.subspan(length);
  return chunk;
}

Container splitBinary(std::span<const std::byte> bytes, const std::string& name) {
  if (bytes.size() < kHeaderBytes) {
    failInput("{}: the .glb ends inside its header; copy or export the file again", name);
  }
  if (const std::uint32_t version = u32At(bytes, 4); version != kVersion) {
    failInput("{}: the .glb has container version {}; export it as glTF 2.0", name, version);
  }
  const std::size_t length = u32At(bytes, 8);
  if (length > bytes.size()) {
    failInput(
        "{}: the .glb is cut off, its header says {} bytes and {} are there; copy or export "
        "the file again",
        name, length, bytes.size());
  }
  if (length <= kHeaderBytes) {
    failInput("{}: the .glb holds nothing behind its header; export the file again", name);
  }
  std::span<const std::byte> rest = bytes.subspan(kHeaderBytes, length - kHeaderBytes);
  const Chunk first = takeChunk(rest, name);
  if (first.type != kJsonChunk) {
    failInput("{}: the first .glb chunk is not JSON; export the file again", name);
  }
  Container container{asText(first.data), {}};
  // The BIN chunk, if any, comes second; chunks of other types are for extensions.
  for (bool second = true; !rest.empty(); second = false) {
    const Chunk chunk = takeChunk(rest, name);
    if (chunk.type != kBinChunk) continue;
    if (!second) {
      failInput("{}: the .glb has a BIN chunk that is not the second; export the file again", name);
    }
    container.binary = chunk.data;
  }
  return container;
}

}  // namespace

Container splitContainer(std::span<const std::byte> bytes, const std::string& name) {
  if (bytes.empty()) failInput("{}: the file is empty; name a .gltf or .glb file", name);
  Container container;
  const bool isBinary = bytes.size() >= 4 && u32At(bytes, 0) == kMagic;
  if (isBinary) {
    container = splitBinary(bytes, name);
  } else {
    container.json = asText(bytes);
  }
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (container.json.starts_with(kByteOrderMark)) container.json.remove_prefix(3);
  const std::size_t start = container.json.find_first_not_of(" \t\r\n");
  if (start == std::string_view::npos || container.json[start] != '{') {
    if (isBinary) failInput("{}: the JSON chunk holds no object; export the file again", name);
    failInput("{}: is neither a .glb nor the JSON of a .gltf; name a glTF 2.0 file", name);
  }
  return container;
}

}  // namespace macula::scene::gltf
