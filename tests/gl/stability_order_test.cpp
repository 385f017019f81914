// Reversing the draws and the triangles in them, ids kept, changes no bit.
#include <gmock/gmock.h>

#include <bit>

#include "engine/scene/procedural/recipes.h"
#include "oit_cases.h"
#include "shared/oit_constants.h"

namespace macula::test {
namespace {

using passes::OitSettings;
using passes::Tail;

/// Draws frames of a scene and of its reverse, and adds up the values that differ.
class Flip {
 public:
  Flip(const scene::Scene& scene, glm::ivec2 size, passes::DeviceContext& device)
      : forward_(scene, nullptr, {}),
        backward_(scene, nullptr, {.reversed = true}),
        camera_(scene.cameras.front()),
        size_(size),
        device_(device) {}

  void expectNoDifference(const OitSettings& oit, int tile = 1) {
    passes::RenderSettings settings = settingsOf(oit);
    settings.importance.tile = tile;
    settings.importance.networkTile = tile;
    passes::FrameRenderer a(settings, device_);
    passes::FrameRenderer b(settings, device_);
    a.resize(size_);
    b.resize(size_);
    a.setScene(forward_);
    b.setScene(backward_);
    std::vector<float> there;
    std::vector<float> back;
    for (int frame = 0; frame < 2; ++frame) {  // the second has history
      const passes::FrameResult one = a.render(camera_, {0.4F, 0.6F});
      const passes::FrameResult other = b.render(camera_, {0.4F, 0.6F});
      EXPECT_EQ(one.fragments->generated, other.fragments->generated) << describe(oit);
      EXPECT_EQ(one.fragments->stored, other.fragments->stored) << describe(oit);
      EXPECT_EQ(one.fragments->merged, other.fragments->merged) << describe(oit);
      EXPECT_EQ(one.lockFailures + other.lockFailures, 0U) << describe(oit);
      a.readLinear(there);
      b.readLinear(back);
      const std::size_t differing = countUnlike(there, back);
      EXPECT_EQ(differing, 0U) << describe(oit) << " frame " << frame;
      unlike_ += differing;
      compared_ += there.size();
    }
    ++cases_;
  }
  void report() const {
    note("cases", cases_);
    note("values compared", static_cast<double>(compared_));
    note("values unlike", static_cast<double>(unlike_));
  }

 private:
  scene::GpuScene forward_;
  scene::GpuScene backward_;
  scene::Camera camera_;
  glm::ivec2 size_;
  passes::DeviceContext& device_;
  int cases_ = 0;
  std::size_t compared_ = 0;
  std::size_t unlike_ = 0;
};

class Order : public GlTest {
 protected:
  void flipAll(const scene::Scene& scene, glm::ivec2 size, const std::vector<OitSettings>& cases) {
    Flip flip(scene, size, device());
    for (const OitSettings& oit : cases) {
      if (oit.sync == "ordered" && !device().ordered.passed) continue;
      flip.expectNoDifference(oit);
    }
    flip.report();
  }
};

TEST_F(Order, OfSortedBuffersWithScarceSlots) {
  flipAll(unlit(tangle(240, 7)), {48, 40}, sortedCases(2.0));
}

TEST_F(Order, OfSortedBuffersOnCoplanarLayers) {
  std::vector<Sheet> list;
  // Three planes of five sheets each: every kept set ends among equal depths.
  for (int i = 0; i < 15; ++i) {
    list.push_back({1.0F + static_cast<float>(i % 3), variedColor(i + 1, 0.3F)});
  }
  // Each number of slots ends at another place among equal depths.
  for (const double kAve : {2.0, 3.0, 4.0, 7.0}) {
    flipAll(sheets(list), {16, 12}, sortedCases(kAve));
  }
}

TEST_F(Order, OfDepthSlicesAndNetworksThatPixelsShare) {
  Flip flip(unlit(tangle(240, 7)), {47, 39}, device());  // no multiple of a tile
  for (const int tile : {2, 4}) {
    for (const OitSettings& oit : sortedCases(2.0)) {
      const bool shares = oit.importance != passes::Predictor::Published ||
                          passes::methodById(oit.method).learnsImportance();
      if (!shares || oit.fragmentBytes == 8) continue;
      if (oit.sync == "ordered" && !device().ordered.passed) continue;
      flip.expectNoDifference(oit, tile);
    }
  }
  flip.report();
}

TEST_F(Order, OfTheOtherMethods) {
  const std::vector<OitSettings> others{
      {.method = "peel", .layers = 6},
      {.method = "ab-sbuffer"},
      {.method = "ab-list"},
      {.method = "ab-list", .sync = "spinlock"},
      {.method = "ab-array", .layers = 64},
      {.method = "ab-array", .sync = "spinlock", .layers = 64},
      {.method = "kb-atomic", .kAve = 4.0},
      {.method = "kb-atomic", .kAve = 4.0, .tail = Tail::Mean},
  };
  flipAll(unlit(tangle(240, 7)), {48, 40}, others);
  std::vector<Sheet> list;
  for (int i = 0; i < 9; ++i) list.push_back({2.0F, variedColor(i + 1, 0.3F)});
  flipAll(sheets(list), {16, 12}, others);
}

TEST_F(Order, OfTailsAtTheEndOfTheirRange) {
  // 60 sheets of optical depth 16 (opaque) and colour 1: sums of 960, below 1,024.
  std::vector<Sheet> list;
  for (int i = 0; i < 60; ++i) {
    glm::vec4 color = variedColor(i, 1.0F);
    color.r = 1.0F;
    list.push_back({1.0F + 0.1F * static_cast<float>(i), color});
  }
  std::vector<OitSettings> tails{{.method = "kb-atomic", .kAve = 2.0, .tail = Tail::Mean}};
  for (const OitSettings& oit : sortedCases(2.0)) {
    if (oit.tail == Tail::Mean && oit.importance == passes::Predictor::Published) {
      tails.push_back(oit);
    }
  }
  flipAll(sheets(list), {16, 12}, tails);
}

/// The four sums of each pixel's tail, bit by bit; empty where it has none. The image, which is
/// stored in half floats, would hide their last bits.
std::vector<std::uint32_t> tailWords(const Bench& bench) {
  const passes::OitPlan& plan = bench.renderer.plan();
  std::vector<std::uint32_t> words;
  if (plan.denseTail()) {
    for (const float sum : bench.floats(passes::kTailSums, 4)) {
      words.push_back(std::bit_cast<std::uint32_t>(sum));
    }
    return words;
  }
  const auto fill = bench.words(passes::kFragmentFill, 1);
  const auto keys = bench.bufferWords(passes::kFragmentKeys);
  const auto colors = bench.bufferWords(passes::kFragmentColors);
  for (std::size_t p = 0; p < fill.size(); ++p) {
    if ((fill[p] & RANGE_TAIL) == 0) continue;
    const std::size_t at = 2 * (plan.layers * p + plan.layers - 1);  // the last slot
    words.insert(words.end(), {keys[at], keys[at + 1], colors[at], colors[at + 1]});
  }
  return words;
}

TEST_F(Order, OfTheSumsOfTailsThemselves) {
  const scene::Scene scene = unlit(tangle(900, 7));
  for (const char* method : {"kb-fixed", "kb-atomic"}) {
    const OitSettings oit{.method = method, .kAve = 2.0, .tail = Tail::Mean};
    Bench forward(scene, settingsOf(oit), {64, 48}, device());
    Bench backward(scene, settingsOf(oit), {64, 48}, device(), {.reversed = true});
    forward.draw();
    backward.draw();
    const auto there = tailWords(forward);
    EXPECT_GT(there.size(), 4000U) << "tails take part";
    EXPECT_EQ(there, tailWords(backward)) << method;
    note(std::string("sums of ") + method, static_cast<double>(there.size()));
  }
}

}  // namespace
}  // namespace macula::test
