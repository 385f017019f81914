// Memory barriers that follow from binding tables.
#include "engine/frame/barriers.h"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <vector>

namespace macula::frame {
namespace {

constexpr Resource kImage{"image", GL_R32UI, SizeRule::Display, ByteClass::Other, Initial::Zero};
constexpr Resource kBuffer{"buffer", 0, SizeRule::Declared, ByteClass::Other, Initial::Zero};

/// Two resources in memory of their own, without anything pending.
class Barriers : public testing::Test {
 protected:
  Barriers() {
    tracker_.setMemory(std::vector<MemoryRange>{{0, 0, 1}, {1, 0, 1}});
    // Whatever came before is settled by an access of each kind.
    for (const BindPoint point :
         {BindPoint::Texture, BindPoint::Image, BindPoint::ColorTarget, BindPoint::Update}) {
      before(point, Access::Read);
    }
    for (const BindPoint point : {BindPoint::Storage, BindPoint::Indirect, BindPoint::Update}) {
      beforeBuffer(point, Access::Read);
    }
  }
  GLbitfield before(BindPoint point, Access access) { return before(kImage, 0, point, access); }
  GLbitfield beforeBuffer(BindPoint point, Access access) {
    return before(kBuffer, 1, point, access);
  }
  GLbitfield before(const Resource& r, std::uint32_t slot, BindPoint point, Access access) {
    const Binding row{&r, access, point};
    return tracker_.before({&row, 1}, {&slot, 1}, 0);
  }
  BarrierTracker tracker_;
};

TEST_F(Barriers, StandBetweenAStoreAndItsReader) {
  before(BindPoint::Image, Access::Write);
  EXPECT_EQ(before(BindPoint::Texture, Access::Read), GLbitfield{GL_TEXTURE_FETCH_BARRIER_BIT});
  EXPECT_EQ(before(BindPoint::Texture, Access::Read), 0U) << "one barrier settles the write";
  EXPECT_EQ(before(BindPoint::ColorTarget, Access::ReadWrite),
            GLbitfield{GL_FRAMEBUFFER_BARRIER_BIT});
}

TEST_F(Barriers, AreNotNeededBetweenWhatTheDriverOrders) {
  before(BindPoint::ColorTarget, Access::Write);
  EXPECT_EQ(before(BindPoint::Texture, Access::Read), 0U);
  EXPECT_EQ(before(BindPoint::Update, Access::Write), 0U);
  EXPECT_EQ(before(BindPoint::Image, Access::Read), 0U) << "a target is no incoherent write";
}

TEST_F(Barriers, StandBeforeAStoreThatFollowsARead) {
  before(BindPoint::Texture, Access::Read);
  EXPECT_EQ(before(BindPoint::Image, Access::Write),
            GLbitfield{GL_SHADER_IMAGE_ACCESS_BARRIER_BIT});
  beforeBuffer(BindPoint::Indirect, Access::Read);
  EXPECT_EQ(beforeBuffer(BindPoint::Storage, Access::Write),
            GLbitfield{GL_SHADER_STORAGE_BARRIER_BIT});
}

TEST_F(Barriers, StandBeforeCommandsThatFollowAShader) {
  beforeBuffer(BindPoint::Storage, Access::Read);
  EXPECT_EQ(beforeBuffer(BindPoint::Update, Access::Write),
            GLbitfield{GL_BUFFER_UPDATE_BARRIER_BIT});
  before(BindPoint::Image, Access::ReadWrite);
  EXPECT_EQ(tracker_.beforeClear(kImage, 0), GLbitfield{GL_TEXTURE_UPDATE_BARRIER_BIT});
  beforeBuffer(BindPoint::Storage, Access::Write);
  EXPECT_EQ(beforeBuffer(BindPoint::Indirect, Access::Read), GLbitfield{GL_COMMAND_BARRIER_BIT});
}

TEST_F(Barriers, ReachFromOneFrameIntoTheNext) {
  before(BindPoint::Image, Access::ReadWrite);
  tracker_.beginFrame();
  EXPECT_EQ(before(BindPoint::Texture, Access::ReadHistory),
            GLbitfield{GL_TEXTURE_FETCH_BARRIER_BIT});
}

TEST_F(Barriers, AllowForReadersBetweenFrames) {
  before(BindPoint::ColorTarget, Access::Write);
  tracker_.beginFrame();
  EXPECT_EQ(before(BindPoint::Texture, Access::Read), 0U);
  EXPECT_EQ(before(BindPoint::Image, Access::Write),
            GLbitfield{GL_SHADER_IMAGE_ACCESS_BARRIER_BIT});
}

// The property: a plain model remembers every access and every barrier, and looks for each pair of
// accesses whether what the specification asks for stands between them.

/// One access as the model remembers it.
struct Event {
  MemoryRange memory;
  BindPoint point;
  bool buffer;
  bool reads;
  bool writes;
  int time;
};

struct Issued {
  GLbitfield bits;
  int time;  ///< before the accesses of this time
};

bool byShader(BindPoint p) {
  return p == BindPoint::Image || p == BindPoint::Storage;
}

/// Whether the order of two accesses of the same memory has to be enforced (OpenGL 4.5, 7.12.2).
bool isHazard(const Event& first, const Event& second) {
  if (!first.writes && !second.writes) return false;  // reads have no order
  const bool storedThenUsed = byShader(first.point) && first.writes;
  const bool usedThenStored = byShader(second.point) && second.writes;
  const bool loadedThenOverwritten = byShader(first.point) && second.writes;
  return storedThenUsed || usedThenStored || loadedThenOverwritten;
}

GLbitfield bitFor(const Event& access) {
  static constexpr std::array kBits{std::pair{BindPoint::Texture, GL_TEXTURE_FETCH_BARRIER_BIT},
                                    std::pair{BindPoint::Image, GL_SHADER_IMAGE_ACCESS_BARRIER_BIT},
                                    std::pair{BindPoint::Storage, GL_SHADER_STORAGE_BARRIER_BIT},
                                    std::pair{BindPoint::Indirect, GL_COMMAND_BARRIER_BIT},
                                    std::pair{BindPoint::ColorTarget, GL_FRAMEBUFFER_BARRIER_BIT},
                                    std::pair{BindPoint::DepthTarget, GL_FRAMEBUFFER_BARRIER_BIT}};
  for (const auto& [point, bit] : kBits) {
    if (point == access.point) return static_cast<GLbitfield>(bit);
  }
  return access.buffer ? GL_BUFFER_UPDATE_BARRIER_BIT : GL_TEXTURE_UPDATE_BARRIER_BIT;
}

class Model {
 public:
  std::size_t pairs = 0;
  std::size_t hazards = 0;

  void barrier(GLbitfield bits) { issued_.push_back({bits, time_}); }

  /// Accesses that happen together, after the barrier of the same time.
  /// @returns bits without which one of them is not ordered after an earlier access
  GLbitfield missing(const std::vector<Event>& accesses) {
    GLbitfield bits = 0;
    for (const Event& second : accesses) {
      for (const Event& first : events_) {
        ++pairs;
        if (!first.memory.overlaps(second.memory) || !isHazard(first, second)) continue;
        ++hazards;
        const GLbitfield bit = bitFor(second);
        bool stands = false;
        for (const Issued& i : issued_)
          stands = stands || ((i.bits & bit) != 0 && i.time > first.time);
        if (!stands) bits |= bit;
      }
    }
    return bits;
  }
  void happen(std::vector<Event> accesses) {
    for (Event& access : accesses) {
      access.time = time_;
      events_.push_back(access);
    }
    ++time_;
  }

 private:
  std::vector<Event> events_;
  std::vector<Issued> issued_;
  int time_ = 0;
};

class Drawn {
 public:
  explicit Drawn(std::uint32_t seed) : random_(seed) {}
  std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(random_() % n); }

 private:
  std::mt19937 random_;
};

TEST(BarrierProperty, EveryPairOfAccessesIsOrderedByTheBarriersThatItNeeds) {
  static constexpr std::array kResources{&kImage, &kBuffer, &kImage, &kBuffer, &kBuffer, &kBuffer};
  static constexpr std::array kImagePoints{BindPoint::Texture, BindPoint::Image,
                                           BindPoint::ColorTarget, BindPoint::DepthTarget,
                                           BindPoint::Update};
  static constexpr std::array kBufferPoints{BindPoint::Storage, BindPoint::Storage,
                                            BindPoint::Indirect, BindPoint::Update};
  static constexpr std::array kAccesses{Access::Read,
                                        Access::ReadHistory,
                                        Access::Write,
                                        Access::ReadWrite,
                                        Access::ReadInvalidate,
                                        Access::WritePersistent,
                                        Access::ReadWriteHistory,
                                        Access::Scratch};
  constexpr int kLists = 2000;
  constexpr int kFrames = 3;
  std::size_t pairs = 0;
  std::size_t hazards = 0;
  std::size_t steps = 0;
  std::size_t barriers = 0;
  for (int list = 0; list < kLists; ++list) {
    Drawn drawn(static_cast<std::uint32_t>(list) + 1);
    // Textures in memory of their own; buffers in one block, some over others.
    std::vector<MemoryRange> memory;
    for (std::uint32_t i = 0; i < kResources.size(); ++i) {
      const std::size_t begin = 16 * drawn.below(6);
      memory.push_back(kResources[i]->isBuffer()
                           ? MemoryRange{100, begin, begin + 16 * (1 + drawn.below(3))}
                           : MemoryRange{i, 0, 1});
    }
    BarrierTracker tracker;
    tracker.setMemory(memory);
    Model model;
    const auto everything = [&](bool writes) {
      std::vector<Event> all;
      for (std::size_t i = 0; i < memory.size(); ++i) {
        const bool buffer = kResources[i]->isBuffer();
        const BindPoint point = buffer ? BindPoint::Storage : BindPoint::Image;
        all.push_back({memory[i], point, buffer, true, writes, 0});
      }
      return all;
    };
    model.happen(everything(true));  // nothing is known of what came before
    // The same passes in each frame, as tables with steps of which some rest.
    std::vector<PassDeclaration> passes(1 + drawn.below(6));
    std::vector<std::vector<std::uint32_t>> slots(passes.size());
    for (std::size_t p = 0; p < passes.size(); ++p) {
      const std::uint32_t count = 1 + drawn.below(3);
      for (std::uint32_t step = 0; step < count; ++step) {
        if (step > 0) passes[p].step();
        const std::uint32_t rows = drawn.below(4);
        for (std::uint32_t row = 0; row < rows; ++row) {
          const std::uint32_t slot = drawn.below(kResources.size());
          const Resource& r = *kResources[slot];
          const Access access = kAccesses[drawn.below(kAccesses.size())];
          const BindPoint point = r.isBuffer() ? kBufferPoints[drawn.below(kBufferPoints.size())]
                                               : kImagePoints[drawn.below(kImagePoints.size())];
          const bool active = drawn.below(5) > 0;
          switch (point) {
            case BindPoint::Texture:
              passes[p].texture(row, r, Access::Read).when(active);
              break;
            case BindPoint::Image:
              passes[p].image(row, r, access).when(active);
              break;
            case BindPoint::Storage:
              passes[p].storage(row, r, access).when(active);
              break;
            case BindPoint::Indirect:
              passes[p].indirect(r).when(active);
              break;
            case BindPoint::ColorTarget:
              passes[p].color(row, r, access).when(active);
              break;
            case BindPoint::DepthTarget:
              passes[p].depth(r, access).when(active);
              break;
            case BindPoint::Update:
              passes[p].update(r, access).when(active);
              break;
          }
          slots[p].push_back(slot);
        }
      }
    }
    for (int frame = 0; frame < kFrames; ++frame) {
      tracker.beginFrame();
      model.happen(everything(false));  // anyone may read between frames
      for (std::size_t p = 0; p < passes.size(); ++p) {
        for (std::uint32_t step = 0; step < passes[p].steps(); ++step) {
          std::vector<Event> accesses;
          for (std::size_t i = 0; i < passes[p].bindings().size(); ++i) {
            const Binding& row = passes[p].bindings()[i];
            if (!row.active || row.step != step) continue;
            accesses.push_back({memory[slots[p][i]], row.point, row.resource->isBuffer(),
                                reads(row.access), writes(row.access), 0});
          }
          const GLbitfield bits = tracker.before(passes[p].bindings(), slots[p], step);
          ASSERT_EQ(bits, model.missing(accesses))
              << "list " << list << ", frame " << frame << ", pass " << p << ", step " << step;
          model.barrier(bits);
          ASSERT_EQ(model.missing(accesses), 0U);
          model.happen(accesses);
          ++steps;
          barriers += bits != 0 ? 1U : 0U;
        }
      }
    }
    pairs += model.pairs;
    hazards += model.hazards;
  }
  std::printf(
      "[   NOTE   ] %d lists of %d frames, %zu steps with %zu barriers; %zu pairs of "
      "accesses, of which %zu need an order\n",
      kLists, kFrames, steps, barriers, pairs / 2, hazards / 2);
  EXPECT_GT(hazards / 2, 100000U);
}

}  // namespace
}  // namespace macula::frame
