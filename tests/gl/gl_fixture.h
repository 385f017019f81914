// A headless context whose debug output fails the test, and renderers on it.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "engine/gl/debug.h"
#include "engine/scene/gpu_scene.h"
#include "engine/window/headless.h"
#include "passes/device_context.h"
#include "passes/frame_renderer.h"
#include "passes/lod/resources.h"
#include "passes/oit/resources.h"
#include "passes/resources.h"

namespace macula::test {

/// One context for the test program; the debug log is looked at after every test.
class GlTest : public testing::Test {
 protected:
  void SetUp() override;
  void TearDown() override;
  static passes::DeviceContext& device();
  static gl::DebugLog& debugLog();
};

/// A scene in GPU memory and a renderer that draws it.
struct Bench {
  Bench(const scene::Scene& scene, const passes::RenderSettings& settings, glm::ivec2 size,
        passes::DeviceContext& device, scene::DrawOrder order = {});
  passes::FrameResult draw(glm::vec2 gaze = glm::vec2(0.5F), bool cut = false);
  [[nodiscard]] std::vector<std::uint8_t> display() const;
  /// The heat map, where one is drawn; the image otherwise.
  [[nodiscard]] std::vector<std::uint8_t> shown() const;
  [[nodiscard]] std::vector<float> linear() const;
  /// Level 0 of an integer texture, rows from the bottom, `channels` words a texel.
  [[nodiscard]] std::vector<std::uint32_t> words(const frame::Resource& resource,
                                                 int channels) const;
  /// A depth texture.
  [[nodiscard]] std::vector<float> depths(const frame::Resource& resource) const;
  [[nodiscard]] std::vector<float> floats(const frame::Resource& resource, int channels) const;
  [[nodiscard]] std::vector<std::uint32_t> bufferWords(const frame::Resource& resource) const;

  passes::RenderSettings settings;
  scene::GpuScene gpu;
  passes::FrameRenderer renderer;
  scene::Camera camera;
};

/// Settings for exact linear output by a method.
[[nodiscard]] passes::RenderSettings linearSettings(const std::string& method, double kAve = 4.0);

/// A small lit scene with opaque and transparent parts that intersect in depth.
[[nodiscard]] scene::Scene tangle(int triangles, std::uint32_t seed);

}  // namespace macula::test
