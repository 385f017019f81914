// Memory that buffers share when their lives do not meet.
#include "engine/frame/transient.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

namespace macula::frame {
namespace {

constexpr std::size_t kAlignment = 256;
constexpr std::size_t kNoLimit = ~std::size_t{0} / 2;

std::size_t sumOf(const std::vector<std::size_t>& bytes) {
  return std::accumulate(bytes.begin(), bytes.end(), std::size_t{0});
}

TEST(Transient, BuffersWhoseLivesDoNotMeetShareMemory) {
  const std::vector<TransientBuffer> buffers{{1000, {0, 1}}, {2048, {2, 3}}, {512, {4, 4}}};
  const TransientPlan plan = placeTransients(buffers, kAlignment, kNoLimit);
  EXPECT_EQ(plan.blockBytes, std::vector<std::size_t>{2048});
  for (const TransientPlan::Place& place : plan.places) EXPECT_EQ(place.offset, 0U);
  EXPECT_EQ(largestSumAlive(buffers), 2048U);
}

TEST(Transient, BuffersThatLiveTogetherLieApart) {
  // The lives share one pass, which uses both.
  const std::vector<TransientBuffer> buffers{{1024, {0, 2}}, {512, {2, 3}}, {256, {3, 4}}};
  const TransientPlan plan = placeTransients(buffers, kAlignment, kNoLimit);
  EXPECT_EQ(plan.places[1].offset, 1024U);
  EXPECT_EQ(plan.places[2].offset, 0U) << "the first is dead by then";
  EXPECT_EQ(sumOf(plan.blockBytes), largestSumAlive(buffers));
}

TEST(Transient, ABlockEndsAtTheLimit) {
  const std::vector<TransientBuffer> buffers{{1024, {0, 1}}, {1024, {0, 1}}, {4096, {0, 1}}};
  const TransientPlan plan = placeTransients(buffers, kAlignment, 2048);
  EXPECT_EQ(plan.blockBytes, (std::vector<std::size_t>{4096, 2048}))
      << "the largest has a block of its own size";
}

TEST(Transient, NothingNeedsNothing) {
  EXPECT_EQ(placeTransients({}, kAlignment, kNoLimit), TransientPlan{});
  EXPECT_EQ(largestSumAlive({}), 0U);
}

TEST(Transient, RandomLivesNeverOverlapInMemory) {
  std::mt19937 random(1);
  const auto below = [&](std::uint32_t n) { return static_cast<std::uint32_t>(random() % n); };
  std::size_t pairs = 0;
  std::size_t placed = 0;
  std::size_t bound = 0;
  std::size_t unshared = 0;
  constexpr int kLists = 2000;
  for (int list = 0; list < kLists; ++list) {
    std::vector<TransientBuffer> buffers(1 + below(12));
    for (TransientBuffer& buffer : buffers) {
      buffer.bytes = 4 * (1 + below(3000));
      buffer.life.first = below(20);
      buffer.life.last = buffer.life.first + below(6);
    }
    const std::size_t limit = below(2) == 0 ? kNoLimit : 16384;
    const TransientPlan plan = placeTransients(buffers, kAlignment, limit);
    ASSERT_EQ(plan.places.size(), buffers.size());
    std::size_t sum = 0;
    for (std::size_t i = 0; i < buffers.size(); ++i) {
      const TransientPlan::Place& a = plan.places[i];
      ASSERT_EQ(a.offset % kAlignment, 0U);
      ASSERT_LE(a.offset + buffers[i].bytes, plan.blockBytes[a.block]);
      sum += (buffers[i].bytes + kAlignment - 1) / kAlignment * kAlignment;
      for (std::size_t j = i + 1; j < buffers.size(); ++j) {
        const TransientPlan::Place& b = plan.places[j];
        const bool together = buffers[i].life.meets(buffers[j].life);
        const bool overlap = a.block == b.block && a.offset < b.offset + buffers[j].bytes &&
                             b.offset < a.offset + buffers[i].bytes;
        ASSERT_FALSE(together && overlap) << "list " << list << ", buffers " << i << " and " << j;
        ++pairs;
      }
    }
    for (const std::size_t bytes : plan.blockBytes) ASSERT_LE(bytes, limit);
    ASSERT_LE(sumOf(plan.blockBytes), sum);
    ASSERT_GE(sumOf(plan.blockBytes), largestSumAlive(buffers));
    placed += sumOf(plan.blockBytes);
    bound += largestSumAlive(buffers);
    unshared += sum;
  }
  std::printf(
      "[   NOTE   ] %d lists, %zu pairs; %.3f of the bytes without sharing, %.3f of the "
      "lower bound\n",
      kLists, pairs, static_cast<double>(placed) / static_cast<double>(unshared),
      static_cast<double>(placed) / static_cast<double>(bound));
  EXPECT_LT(placed, unshared * 7 / 10) << "sharing is worth its while";
}

}  // namespace
}  // namespace macula::frame
