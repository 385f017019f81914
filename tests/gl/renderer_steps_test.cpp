// What a recording relies on: the steps that a renderer counts are all that outlives a frame.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/settings/registry.h"
#include "tests/gl/gl_fixture.h"

namespace macula::test {
namespace {

/// Settings behind a registry, as the tools have them.
struct Settings {
  Settings() { passes::registerSettings(registry, fields); }
  passes::RenderSettings fields;
  settings::Registry registry;
};

/// One frame of a walk as a recording keeps it.
struct Recorded {
  passes::RendererSteps before;  ///< steps of the renderer after the last frame
  passes::RendererSteps after;
  std::vector<settings::Value> settings;
  std::size_t scene = 0;
  glm::ivec2 size{0};
  scene::Camera camera;
  glm::vec2 gaze{0.5F};
  bool cut = false;
  std::vector<std::uint8_t> rgb;
};

/// Two scenes, one much deeper than the other, so that pools and limits grow.
struct Scenes {
  scene::GpuScene few{tangle(30, 1), nullptr};
  scene::GpuScene many{tangle(300, 2), nullptr};
  scene::Camera camera = tangle(30, 1).cameras.front();
  [[nodiscard]] const scene::GpuScene& at(std::size_t i) const { return i == 0 ? few : many; }
};

/// A walk in which anything may happen between two frames.
class Walk {
 public:
  Walk(const Scenes& scenes, passes::DeviceContext& device, std::uint32_t seed)
      : scenes_(scenes), renderer_(settings_.fields, device), random_(seed) {
    // Each frame's number then matters.
    settings_.registry.setText("importance.noisePerFrame", "on", "test");
    renderer_.setScene(scenes.at(0));
    renderer_.resize(now_.size = {40, 32});
    renderer_.restart();
    now_.camera = scenes.camera;
  }

  std::vector<Recorded> run(int frames) {
    std::vector<Recorded> walk;
    for (int i = 0; i < frames; ++i) {
      happen();
      now_.after = renderer_.steps();
      now_.settings.clear();
      for (const settings::Entry& entry : settings_.registry.entries()) {
        now_.settings.push_back(entry.get());
      }
      renderer_.readDisplay(now_.rgb);
      walk.push_back(now_);
      now_.before = now_.after;
    }
    return walk;
  }
  [[nodiscard]] int refused() const { return refused_; }

 private:
  bool oneIn(unsigned n) { return random_() % n == 0; }

  /// Another value for some setting; one that is a choice, or a number that is small enough here.
  void changeSetting() {
    const std::vector<std::pair<std::string, std::vector<std::string>>> changes{
        {"oit.method",
         {"blend", "wboit", "peel", "ab-array", "ab-list", "ab-sbuffer", "kb-atomic", "kb-fixed",
          "kb-plus", "kb-variable", "kb-variable", "kb-stencil"}},
        {"oit.kAve", {"0.5", "2", "3.7"}},
        {"oit.fill", {"on", "off"}},
        {"oit.tail", {"none", "mean"}},
        {"oit.importance", {"published", "transmittance", "error"}},
        {"oit.count", {"drawn", "predicted"}},
        {"oit.cull", {"none", "occupancy"}},
        {"importance.noisePerFrame", {"on", "off"}},
        {"frame.ssaa", {"1", "2"}},
        {"scene.background", {"0,0,0", "0.2,0.1,0.5"}},
        {"view.heatmap", {"none", "k", "depth-complexity", "fresnel"}},
        {"tonemap.curve", {"neutral", "aces"}}};
    const auto& [key, values] = changes[random_() % changes.size()];
    settings::Entry& entry = settings_.registry.at(key, key);
    const settings::Value before = entry.get();
    entry.setText(values[random_() % values.size()], key);
    renderer_.resize(now_.size);
    try {
      draw();
    } catch (const InputError&) {
      ++refused_;
      const std::uint64_t restarts = renderer_.steps().restarts;
      entry.set(before);
      renderer_.resize(now_.size);
      now_.cut = true;
      draw();
      EXPECT_EQ(renderer_.steps().restarts, restarts + 1) << "a refused frame leaves nothing";
    }
  }

  void happen() {
    now_.cut = oneIn(8);
    now_.gaze = {static_cast<float>(random_() % 64) / 63.0F,
                 static_cast<float>(random_() % 64) / 63.0F};
    now_.camera.position.x += 0.01F * static_cast<float>(random_() % 8);
    if (oneIn(12)) now_.camera.position.x = -1.0F;  // a jump that the cameras tell
    if (oneIn(10)) renderer_.resize(now_.size = oneIn(2) ? glm::ivec2(48, 24) : glm::ivec2(33, 37));
    if (oneIn(12)) renderer_.setScene(scenes_.at(now_.scene = random_() % 2));
    if (oneIn(30)) renderer_.restart();
    if (oneIn(2)) return changeSetting();
    draw();
  }

  void draw() {
    renderer_.render(now_.camera, now_.gaze, now_.cut);
    ASSERT_EQ(renderer_.wasCut(), now_.cut);
    ASSERT_EQ(renderer_.inputs().view.camera.position, now_.camera.position);
  }

  const Scenes& scenes_;
  Settings settings_;
  passes::FrameRenderer renderer_;
  std::mt19937 random_;
  Recorded now_;
  int refused_ = 0;
};

/// Draws recorded frames with a renderer of its own. @returns how many images differ
int unlikeFrames(std::span<const Recorded> walk, const Scenes& scenes,
                 passes::DeviceContext& device) {
  Settings settings;
  passes::FrameRenderer renderer(settings.fields, device);
  std::size_t scene = walk[0].scene;
  renderer.setScene(scenes.at(scene));
  int unlike = 0;
  std::vector<std::uint8_t> rgb;
  for (const Recorded& frame : walk) {
    auto value = frame.settings.begin();
    for (settings::Entry& entry : settings.registry.entries()) entry.set(*value++);
    if (frame.after.scenes != frame.before.scenes) renderer.setScene(scenes.at(frame.scene));
    if (frame.after.restarts != frame.before.restarts) renderer.restart();
    if (frame.after.resets != frame.before.resets) renderer.resize(frame.size);
    if (frame.after.restarts != frame.before.restarts) renderer.resize(frame.size);
    renderer.render(frame.camera, frame.gaze, frame.cut);
    renderer.readDisplay(rgb);
    unlike += rgb == frame.rgb ? 0 : 1;
  }
  return unlike;
}

TEST_F(GlTest, TheSameStepsDrawTheSameBits) {
  const Scenes scenes;
  int refused = 0;
  for (const std::uint32_t seed : {1U, 2U, 3U}) {
    Walk walk(scenes, device(), seed);
    const std::vector<Recorded> frames = walk.run(100);
    if (HasFatalFailure()) return;
    refused += walk.refused();
    EXPECT_EQ(frames.back().after.frames, frames.size());
    EXPECT_EQ(unlikeFrames(frames, scenes, device()), 0) << "seed " << seed;
    // From every restart on, nothing before it matters.
    for (std::size_t i = 1; i < frames.size(); ++i) {
      if (frames[i].after.restarts == frames[i].before.restarts) continue;
      const std::span rest =
          std::span(frames).subspan(i, std::min<std::size_t>(12, frames.size() - i));
      EXPECT_EQ(unlikeFrames(rest, scenes, device()), 0) << "seed " << seed << " from frame " << i;
    }
  }
  EXPECT_GT(refused, 5) << "combinations that make no sense are part of it";
}

}  // namespace
}  // namespace macula::test
