// Every order in which two or three invocations of a pixel can insert fragments, by the shaders'
// own text.
#include "insertion.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <iostream>

namespace macula::model {
namespace {

/// Pixels whose threads insert `each` fragments: every choice of so many depths, ties among them.
std::vector<Pixel> pixels(std::size_t threads, std::size_t each, std::uint32_t depthCount,
                          std::uint32_t slots) {
  std::vector<std::vector<std::uint32_t>> depths{{}};
  for (std::size_t i = 0; i < threads * each; ++i) {
    std::vector<std::vector<std::uint32_t>> longer;
    for (const auto& list : depths) {
      for (std::uint32_t depth = 1; depth <= depthCount; ++depth) {
        longer.push_back(list);
        longer.back().push_back(depth);
      }
    }
    depths = std::move(longer);
  }
  std::vector<Pixel> all;
  for (const auto& list : depths) {
    Pixel pixel{slots, std::vector<std::vector<Inserted>>(threads)};
    for (std::size_t i = 0; i < list.size(); ++i) {
      pixel.threads[i / each].push_back({list[i], static_cast<std::uint32_t>(i)});
    }
    all.push_back(std::move(pixel));
  }
  return all;
}

struct Covered {
  std::uint64_t pixels = 0;
  std::uint64_t states = 0;
  std::uint64_t outcomes = 0;
  std::uint64_t waits = 0;
  std::string fault;  ///< the first
};

Covered exploreAll(const Variant& variant, const std::vector<Pixel>& all) {
  Covered covered;
  for (const Pixel& pixel : all) {
    const Explorer::Result result = explore(variant, pixel);
    ++covered.pixels;
    covered.states += result.states;
    covered.outcomes += result.outcomes;
    covered.waits += result.waits;
    covered.fault = result.fault;
    if (!covered.fault.empty()) break;
  }
  return covered;
}

/// Two threads of one or two fragments, three of one; cores of one and two slots.
std::vector<Pixel> everyPixel(bool tail) {
  const std::uint32_t tailSlots = tail ? 1 : 0;
  std::vector<Pixel> all;
  for (std::uint32_t slots = 1; slots <= 2; ++slots) {
    for (auto& list : {pixels(2, 1, 3, slots + tailSlots), pixels(3, 1, 2, slots + tailSlots),
                       pixels(2, 2, 2, slots + tailSlots)}) {
      all.insert(all.end(), list.begin(), list.end());
    }
  }
  return all;
}

TEST(InsertionModel, NoOrderLosesAWantedFragment) {
  for (const Variant& variant : soundVariants()) {
    const Covered covered = exploreAll(variant, everyPixel(variant.tail));
    EXPECT_EQ(covered.fault, "") << variant.name;
    EXPECT_GT(covered.waits, 0U) << variant.name << ": no thread ever waited";
    std::cout << "[     NOTE ] InsertionModel, " << variant.name << ": " << covered.pixels
              << " pixels, " << covered.states << " states, " << covered.outcomes << " outcomes\n";
  }
}

TEST(InsertionModel, FindsWhatIsWrong) {
  for (const Variant& variant : faultyVariants()) {
    const Covered covered = exploreAll(variant, everyPixel(variant.tail));
    EXPECT_NE(covered.fault, "") << variant.name;
    std::cout << "[     NOTE ] InsertionModel, " << variant.name << ": " << covered.fault << "\n";
  }
}

// The model itself, on the textbook's examples.

TEST(MemoryModel, StoresToTwoPlacesBecomeVisibleInAnyOrder) {
  // Message passing: data in 0, a flag in 1.
  std::uint32_t flag = 0;
  std::uint32_t data = 0;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> seen;
  const auto look = [&](bool barriers) {
    seen.clear();
    const Explorer::Result result = Explorer::explore({0, 0},
                                                      {[&] {
                                                         Explorer::store(0, 7);
                                                         if (barriers) Explorer::barrier();
                                                         Explorer::store(1, 1);
                                                       },
                                                       [&] {
                                                         flag = Explorer::load(1);
                                                         if (barriers) Explorer::barrier();
                                                         data = Explorer::load(0);
                                                       }},
                                                      [&](const auto&) {
                                                        seen.emplace_back(flag, data);
                                                        return std::string();
                                                      });
    EXPECT_EQ(result.fault, "");
  };
  look(false);
  EXPECT_THAT(seen, testing::Contains(std::pair(1U, 0U))) << "the flag without its data";
  look(true);
  EXPECT_THAT(seen, testing::Not(testing::Contains(std::pair(1U, 0U))));
  EXPECT_THAT(seen, testing::Contains(std::pair(1U, 7U)));
  EXPECT_THAT(seen, testing::Contains(std::pair(0U, 0U)));
}

TEST(MemoryModel, APlaceIsNeverSeenToGoBack) {
  std::uint32_t first = 0;
  std::uint32_t second = 0;
  const Explorer::Result result =
      Explorer::explore({0},
                        {[] { Explorer::store(0, 1); },
                         [&] {
                           first = Explorer::load(0);
                           second = Explorer::load(0);
                         }},
                        [&](const auto&) { return first > second ? "went back" : ""; });
  EXPECT_EQ(result.fault, "");
}

TEST(MemoryModel, ALockWithoutItsEndIsFound) {
  const Explorer::Thread taker = [] { Explorer::exchangeLock(0, 1); };
  const Explorer::Result result =
      Explorer::explore({0}, {taker, taker}, [](const auto&) { return std::string(); });
  EXPECT_EQ(result.fault, "a thread waits for ever");
}

}  // namespace
}  // namespace macula::model
