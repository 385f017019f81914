// An opened glTF file: container and JSON checked, buffers and objects read.
#pragma once

#include <tiny_gltf.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "engine/core/error.h"
#include "engine/scene/scene.h"

namespace macula::scene::gltf {

/// Lines about features that are not drawn, each once, in the order of their appearance.
class Warnings {
 public:
  /// Adds a line unless it is there already. After kMaxLines the rest are only counted, so that a
  /// file with a million faults stays readable.
  void add(const std::string& line);
  /// All lines, with a last one that counts those left out.
  [[nodiscard]] std::vector<std::string> lines() const;

  static constexpr std::size_t kMaxLines = 100;

 private:
  std::vector<std::string> lines_;
  std::unordered_set<std::string> seen_;
  std::size_t leftOut_ = 0;
};

/// An image as the file names it, not yet read.
struct ImageSource {
  std::string name;
  std::string uri;  ///< relative or data URI; empty where bufferView is given
  std::int32_t bufferView = kNone;
};

struct Document {
  std::string name;              ///< of the file, for messages
  std::filesystem::path folder;  ///< where relative URIs lead; empty: nowhere
  tinygltf::Model model;         ///< without buffers, images and animations
  std::vector<ImageSource> images;
  std::vector<std::span<const std::byte>> buffers;  ///< empty where a buffer names no bytes
  std::vector<std::vector<std::byte>> storage;      ///< bytes behind `buffers` outside the .glb
  Warnings warnings;

  /// Throws an InputError "file: place: what".
  template <typename... Args>
  [[noreturn]] void fail(std::string_view place, fmt::format_string<Args...> format,
                         Args&&... args) const {
    failInput("{}: {}: {}", name, place, fmt::format(format, std::forward<Args>(args)...));
  }
  /// Adds the warning "place: what".
  template <typename... Args>
  void warn(std::string_view place, fmt::format_string<Args...> format, Args&&... args) {
    warnings.add(
        oneLine(fmt::format("{}: {}", place, fmt::format(format, std::forward<Args>(args)...))));
  }
  /// The bytes of a buffer view. @throws InputError where it does not lie inside its buffer
  [[nodiscard]] std::span<const std::byte> viewBytes(std::int32_t view,
                                                     std::string_view place) const;
};

/// Checks the container and the JSON, refuses unsupported required extensions, finds the buffers
/// and images and reads the rest as tinygltf's objects.
/// @param bytes must outlive the document
/// @throws InputError on malformed input
[[nodiscard]] Document openDocument(std::span<const std::byte> bytes,
                                    const std::filesystem::path& folder, const std::string& name);

/// Whether an extension is drawn as it asks.
[[nodiscard]] bool isSupportedExtension(std::string_view extension);

}  // namespace macula::scene::gltf
