#include <system_error>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/network/parts.h"

namespace macula::network {
namespace {

void checkSize(std::uintmax_t bytes, const std::string& name) {
  if (bytes > kMaxFileBytes) {
    failInput("{}: the file has {} bytes, the limit is {}; name the file of a network for Macula",
              name, bytes, kMaxFileBytes);
  }
}

}  // namespace

Network parseNetwork(std::span<const std::byte> bytes, const std::string& name) {
  checkSize(bytes.size(), name);
  const Container container = parseSafetensors(bytes, name);
  Network network = parseMetadata(container.metadata, name);
  network.layers =
      layersOf(container.tensors, network.features.size(), network.outputs.size(), name);
  return network;
}

Network readNetwork(const std::filesystem::path& path) {
  // Before it is read: large models of others have the same extension.
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (!error) checkSize(size, path.string());
  const std::string bytes = readTextFile(path);
  return parseNetwork(std::as_bytes(std::span(bytes.data(), bytes.size())), path.string());
}

}  // namespace macula::network
