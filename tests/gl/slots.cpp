#include "slots.h"

#include "shared/oit_constants.h"

namespace macula::test {

std::vector<Given> givenBy(const Bench& bench) {
  const auto ranges = bench.words(passes::kFragmentRange, 2);
  const auto counts = bench.floats(passes::kFragmentCount, 1);
  std::vector<Given> all(counts.size());
  for (std::size_t p = 0; p < counts.size(); ++p) {
    const bool tail = (ranges[2 * p + 1] & RANGE_TAIL) != 0;
    all[p] = {ranges[2 * p],
              (ranges[2 * p + 1] & ~RANGE_TAIL) + (tail ? bench.renderer.plan().tailSlots() : 0U),
              static_cast<std::uint32_t>(counts[p])};
  }
  return all;
}

std::uint64_t expectDisjoint(const std::vector<Given>& given, std::uint64_t slots,
                             const std::string& what) {
  std::vector<bool> taken(slots, false);
  std::uint64_t sum = 0;
  std::size_t overlaps = 0;
  std::size_t outside = 0;
  for (const Given& g : given) {
    sum += g.slots;
    for (std::uint64_t s = g.first; s < std::uint64_t{g.first} + g.slots; ++s) {
      if (s >= slots) {
        ++outside;
      } else {
        if (taken[s]) ++overlaps;
        taken[s] = true;
      }
    }
  }
  EXPECT_EQ(overlaps, 0U) << what;
  EXPECT_EQ(outside, 0U) << what;
  return sum;
}

}  // namespace macula::test
