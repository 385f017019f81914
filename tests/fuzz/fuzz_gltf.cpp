// Any bytes as a .gltf or .glb file: a scene with valid indices, or an InputError.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "engine/core/error.h"
#include "engine/scene/gltf_loader.h"
#include "engine/scene/scene_info.h"

using namespace macula::scene;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // Small, so that one input takes milliseconds and a few megabytes.
  GltfLimits limits;
  limits.vertices = 1U << 16U;
  limits.indices = 3U << 16U;
  limits.instances = 1U << 12U;
  limits.imageSide = 256;
  limits.imageBytes = 1U << 20U;
  try {
    const Scene scene =
        loadGltfFromMemory(std::as_bytes(std::span(data, size)), {}, "fuzz", limits);
    for (const Instance& instance : scene.instances) {
      if (instance.primitive >= scene.primitives.size()) std::abort();
    }
    for (const Primitive& primitive : scene.primitives) {
      if (primitive.positions.size() != primitive.attributes.size()) std::abort();
      for (const std::uint32_t index : primitive.indices) {
        if (index >= primitive.positions.size()) std::abort();
      }
    }
    static_cast<void>(describe(scene));
  } catch (const macula::InputError&) {
    // The expected answer to most inputs.
  }
  return 0;
}
