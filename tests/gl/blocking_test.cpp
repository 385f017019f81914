// No stall: frames are drawn, timed and counted without the CPU waiting for the GPU, and what comes
// late is what would have come at once.
#include <gmock/gmock.h>

#include <stdexcept>

#include "allocation_count.h"
#include "engine/gl/blocking.h"
#include "engine/gl/readback.h"
#include "engine/gl/timer.h"
#include "oit_cases.h"

namespace macula::test {
namespace {

using gl::Blocking;
using gl::TimeSource;

/// Another clock for the renderers that are made while it lives. llvmpipe's own timer counts wrong,
/// but its calls are those of any other.
class ClockOf {
 public:
  ClockOf(passes::DeviceContext& device, TimeSource source)
      : device_(device), before_(device.time.source) {
    device.time.source = source;
  }
  ~ClockOf() { device_.time.source = before_; }
  ClockOf(const ClockOf&) = delete;
  ClockOf& operator=(const ClockOf&) = delete;

 private:
  passes::DeviceContext& device_;
  TimeSource before_;
};

/// Every method, each option that adds passes, and the level of detail.
std::vector<passes::RenderSettings> manySettings(passes::DeviceContext& device) {
  std::vector<passes::OitSettings> oit{
      {.method = "kb-plus", .fill = true, .tail = passes::Tail::Mean},
      {.method = "kb-variable", .fill = true, .tail = passes::Tail::Mean},
      {.method = "kb-variable", .fill = true, .importance = passes::Predictor::Error},
      {.method = "kb-variable", .fill = true, .count = passes::CountSource::Predicted},
      {.method = "kb-fixed", .cull = passes::Cull::Occupancy},
      learnedUtility(4.0)};
  for (const passes::Method& method : passes::methods()) {
    if (method.id == "kb-stencil" && device.capabilities.routableSamples.empty()) continue;
    oit.push_back({.method = std::string(method.id)});
  }
  std::vector<passes::RenderSettings> all;
  for (const passes::OitSettings& options : oit) all.push_back(settingsOf(options));
  passes::RenderSettings foveated = settingsOf({.method = "kb-variable"});
  foveated.foveation.enabled = true;
  foveated.lod.resize = 1.5;
  all.push_back(foveated);
  return all;
}

/// Draws as a walk does. @returns the last result that came
std::optional<passes::FrameResult> walk(Bench& bench, int frames) {
  std::optional<passes::FrameResult> newest;
  for (int i = 0; i < frames; ++i) {
    bench.camera.position.x += 0.01F;
    bench.camera.target.x += 0.01F;
    bench.renderer.draw(bench.camera, gaze::exactPoint({0.4F, 0.6F}));
    if (const auto result = bench.renderer.takeResult()) newest = result;
  }
  return newest;
}

/// The same until a result comes.
passes::FrameResult walkToResult(Bench& bench) {
  for (;;) {
    if (const auto result = walk(bench, 1)) return *result;
  }
}

class NoStall : public GlTest {};

TEST_F(NoStall, AFrameOfAWalkWaitsForNothingAndAllocatesNothing) {
  const ClockOf clock(device(), TimeSource::Query);
  const scene::Scene scene = tangle(100, 1);
  for (const passes::RenderSettings& settings : manySettings(device())) {
    for (const bool all : {true, false}) {
      Bench bench(scene, settings, {64, 64}, device());
      bench.renderer.want({.times = all, .statistics = all});
      bench.draw();
      // Each slot of the ring has been used once.
      walk(bench, 4 * static_cast<int>(passes::FrameNumbers::kSlots));
      walkToResult(bench);
      const gl::BlockingCount before = gl::blockingCount();
      const std::size_t allocated = allocationCount();
      walk(bench, 10);
      const std::size_t allocations = allocationCount() - allocated;
      const gl::BlockingCount& after = gl::blockingCount();
      const std::string what =
          describe(settings.oit) + (settings.foveation.enabled ? ", foveated" : "");
      for (std::size_t kind = 0; kind < gl::kBlockingKinds; ++kind) {
        EXPECT_EQ(after.calls[kind], before.calls[kind]) << what << ", kind " << kind;
      }
      EXPECT_EQ(allocations, 0U) << what;
    }
  }
}

TEST_F(NoStall, EveryWaitIsCounted) {
  const scene::Scene scene = tangle(30, 1);
  for (const TimeSource source : {TimeSource::Finish, TimeSource::Query}) {
    const ClockOf clock(device(), source);
    Bench bench(scene, settingsOf({.method = "kb-variable"}), {32, 32}, device());
    bench.draw();
    const gl::BlockingCount before = gl::blockingCount();
    const std::size_t passes = bench.draw().passes.size();
    const gl::BlockingCount after = gl::blockingCount();
    EXPECT_EQ(after.of(Blocking::Finish) - before.of(Blocking::Finish),
              source == TimeSource::Finish ? passes + 1 : 0);
    EXPECT_EQ(after.of(Blocking::FenceWait) - before.of(Blocking::FenceWait), 1U);
    EXPECT_GT(after.waitedMs, before.waitedMs);
    (void)bench.display();
    EXPECT_EQ(gl::blockingCount().of(Blocking::TextureRead), after.of(Blocking::TextureRead) + 1);
    (void)bench.bufferWords(passes::kOitTotals);
    EXPECT_EQ(gl::blockingCount().of(Blocking::BufferRead), after.of(Blocking::BufferRead) + 1);
  }
}

TEST_F(NoStall, FinishIsOnlyCalledForTimes) {
  const ClockOf clock(device(), TimeSource::Finish);
  const scene::Scene scene = tangle(30, 1);
  passes::RenderSettings settings = settingsOf({.method = "kb-variable"});
  for (const bool setting : {true, false}) {
    settings.timing = setting;
    Bench bench(scene, settings, {32, 32}, device());
    bench.renderer.want({.times = !setting, .statistics = true});  // one of both is off
    bench.draw();
    const std::uint64_t before = gl::blockingCount().of(Blocking::Finish);
    const passes::FrameResult result = bench.draw();
    EXPECT_FALSE(result.timed);
    EXPECT_TRUE(result.passes.empty());
    EXPECT_TRUE(result.fragments);
    walk(bench, 3);
    EXPECT_EQ(gl::blockingCount().of(Blocking::Finish), before);
  }
}

/// What a frame is told to be, without its times.
void expectAlike(const passes::FrameResult& a, const passes::FrameResult& b,
                 const std::string& what) {
  EXPECT_EQ(a.resizeFactor, b.resizeFactor) << what;
  EXPECT_EQ(a.shading.shaded, b.shading.shaded) << what;
  EXPECT_EQ(a.shading.holes, b.shading.holes) << what;
  EXPECT_EQ(a.passes.size(), b.passes.size()) << what;
  ASSERT_EQ(a.fragments.has_value(), b.fragments.has_value()) << what;
  if (a.fragments) {
    EXPECT_EQ(a.fragments->generated, b.fragments->generated) << what;
    EXPECT_EQ(a.fragments->stored, b.fragments->stored) << what;
    EXPECT_EQ(a.fragments->merged, b.fragments->merged) << what;
  }
  ASSERT_EQ(a.layers.has_value(), b.layers.has_value()) << what;
  if (a.layers) {
    EXPECT_EQ(a.layers->mean, b.layers->mean) << what;
  }
  EXPECT_EQ(a.deepest, b.deepest) << what;
  EXPECT_EQ(a.tailSlots, b.tailSlots) << what;
  EXPECT_EQ(a.exact, b.exact) << what;
}

TEST_F(NoStall, LateNumbersAreThoseOfTheirFrame) {
  const scene::Scene scene = tangle(100, 1);
  constexpr int kFrames = 12;
  for (const TimeSource source : {TimeSource::Finish, TimeSource::Query}) {
    const ClockOf clock(device(), source);
    for (passes::RenderSettings settings : manySettings(device())) {
      if (settings.oit.method == "kb-racy") continue;  // no two frames need to be alike
      settings.importance.layerLimit = 10.0;           // else it follows the numbers, and as late
      Bench late(scene, settings, {48, 40}, device());
      Bench now(scene, settings, {48, 40}, device());
      std::vector<passes::FrameResult> results;
      int compared = 0;
      late.draw();
      now.draw();
      for (int i = 1; i < kFrames; ++i) {
        for (Bench* bench : {&late, &now}) bench->camera.position.x += 0.02F;
        results.push_back(now.draw());
        late.renderer.draw(late.camera, gaze::exactPoint(glm::vec2(0.5F)));
        if (const auto result = late.renderer.takeResult()) {
          ASSERT_GE(result->frame, 1U);
          expectAlike(*result, results[result->frame - 1], describe(settings.oit));
          ++compared;
        }
        EXPECT_EQ(late.display(), now.display()) << describe(settings.oit);
      }
      EXPECT_GT(compared, 0) << describe(settings.oit);
      const passes::FrameResult last = late.renderer.waitForResult();
      EXPECT_EQ(last.frame, results.back().frame);
      expectAlike(last, results.back(), describe(settings.oit));
    }
  }
}

TEST_F(NoStall, MoreFramesThanTheRingHoldsStillHaveNumbers) {
  const ClockOf clock(device(), TimeSource::Query);
  const scene::Scene scene = tangle(60, 1);
  Bench bench(scene, settingsOf({.method = "kb-variable"}), {48, 40}, device());
  const passes::FrameResult first = bench.draw();
  const auto gaze = gaze::exactPoint(glm::vec2(0.5F));
  for (std::size_t i = 0; i < 3 * passes::FrameNumbers::kSlots; ++i) {
    bench.renderer.draw(bench.camera, gaze);
  }
  // The last one found no place in the ring, and is told all the same.
  const passes::FrameResult last = bench.renderer.waitForResult();
  EXPECT_EQ(last.frame, first.frame + 3 * passes::FrameNumbers::kSlots);
  EXPECT_FALSE(last.timed);
  EXPECT_EQ(last.fragments->generated, first.fragments->generated);
}

TEST_F(NoStall, APoolThatIsTooSmallGrowsForTheFramesAfterIt) {
  const ClockOf clock(device(), TimeSource::Query);
  const scene::Scene scene = tangle(300, 2);
  for (const char* method : {"ab-list", "ab-sbuffer"}) {
    Bench now(scene, settingsOf({.method = method}), {40, 32}, device());
    now.draw();
    Bench late(scene, settingsOf({.method = method}), {40, 32}, device());
    const scene::Camera there = late.camera;
    late.camera.target = there.position + (there.position - there.target);
    late.draw();  // looks away: the pool stays small
    late.camera = there;
    const auto gaze = gaze::exactPoint(glm::vec2(0.5F));
    std::optional<passes::FrameResult> incomplete;
    while (!incomplete) {
      late.renderer.draw(late.camera, gaze, true);
      incomplete = late.renderer.takeResult();
    }
    EXPECT_GT(incomplete->overflows, 0U) << method;
    EXPECT_FALSE(incomplete->exact) << method;
    late.renderer.draw(late.camera, gaze, true);
    EXPECT_EQ(late.linear(), now.linear()) << method;
    const passes::FrameResult next = late.renderer.waitForResult();
    EXPECT_TRUE(next.exact) << method;
    EXPECT_EQ(next.overflows, incomplete->overflows) << method << ": and no frame more";
    EXPECT_EQ(next.recaptures, 0) << method;
  }
}

/// Primitives that are drawn while it lives.
class Primitives {
 public:
  Primitives() {
    GLuint id = 0;
    glCreateQueries(GL_PRIMITIVES_GENERATED, 1, &id);
    query_ = gl::QueryId(id);
    glBeginQuery(GL_PRIMITIVES_GENERATED, id);
  }
  std::uint64_t end() {
    glEndQuery(GL_PRIMITIVES_GENERATED);
    return gl::queryResult(query_.id());
  }

 private:
  gl::QueryId query_;
};

TEST_F(NoStall, NoGeometryIsDrawnForNumbersThatNobodyAskedFor) {
  const scene::Scene scene = tangle(60, 1);
  // kb-fixed counts nothing while it draws, kb-variable counts in any case.
  for (const auto& [method, more] :
       {std::pair("kb-fixed", true), std::pair("kb-variable", false)}) {
    Bench bench(scene, settingsOf({.method = method}), {40, 32}, device());
    std::array<std::uint64_t, 2> drawn{};
    for (const bool wanted : {false, true}) {
      bench.renderer.want({.times = true, .statistics = wanted});
      bench.draw();
      Primitives primitives;
      const passes::FrameResult result = bench.draw();
      drawn[wanted ? 1 : 0] = primitives.end();
      EXPECT_EQ(result.counted, wanted) << method;
      EXPECT_EQ(result.fragments.has_value(), wanted) << method;
    }
    EXPECT_EQ(drawn[1] > drawn[0], more) << method;
    EXPECT_GT(drawn[0], 0U) << method;
  }
}

TEST_F(NoStall, NumbersThatAreAskedForChangeNoPicture) {
  const scene::Scene scene = tangle(100, 3);
  for (const passes::RenderSettings& settings : manySettings(device())) {
    if (settings.oit.method == "kb-racy") continue;
    // The deepest pixel is then known from the last frame's prediction alone.
    if (settings.oit.count == passes::CountSource::Predicted) continue;
    Bench all(scene, settings, {48, 40}, device());
    Bench none(scene, settings, {48, 40}, device());
    none.renderer.want({.times = false, .statistics = false});
    for (int frame = 0; frame < 4; ++frame) {
      for (Bench* bench : {&all, &none}) {
        bench->camera.position.z += 0.05F;
        bench->draw();
      }
      EXPECT_EQ(all.display(), none.display()) << describe(settings.oit) << ", frame " << frame;
    }
  }
}

TEST_F(NoStall, TimersRefuseMoreMarksThanTheyHold) {
  for (const TimeSource source : {TimeSource::Finish, TimeSource::Query}) {
    gl::FrameTimer timer(source);
    for (std::size_t slot = 0; slot < gl::FrameTimer::kSlots; ++slot) timer.begin(slot);
    for (std::size_t i = 1; i < gl::FrameTimer::kMaxMarks; ++i) timer.mark();
    EXPECT_THROW(timer.mark(), std::logic_error);
    for (std::size_t slot = 0; slot < gl::FrameTimer::kSlots; ++slot) timer.wait(slot);
    EXPECT_EQ(timer.intervals(gl::FrameTimer::kSlots - 1), gl::FrameTimer::kMaxMarks - 1);
    EXPECT_EQ(timer.intervals(0), 0U);
  }
}

TEST_F(NoStall, ReadbackHoldsWhatWasCopiedAndNothingElse) {
  const std::array<std::uint32_t, 4> words{3, 1, 4, 1};
  const gl::Buffer source = gl::Buffer::of("words", std::span<const std::uint32_t>(words));
  gl::Readback readback("copies", 2 * sizeof(std::uint32_t), 3);
  readback.begin();
  for (std::size_t slot = 0; slot < 3; ++slot) {
    readback.copy(slot, source.id(), slot * sizeof(std::uint32_t), sizeof(std::uint32_t),
                  sizeof(std::uint32_t));
    readback.fence(slot);
  }
  readback.wait(2);
  // What the GPU reached last it reached after the others.
  for (std::size_t slot = 0; slot < 3; ++slot) {
    EXPECT_TRUE(readback.ready(slot));
    EXPECT_EQ(readback.read<std::uint32_t>(slot, sizeof(std::uint32_t)), words[slot]);
  }
}

}  // namespace
}  // namespace macula::test
