// What depth slices sum, where that is more than their words first had room for.
#include <gmock/gmock.h>

#include "oit_cases.h"
#include "shared/oit_constants.h"

namespace macula::test {
namespace {

using passes::Predictor;

class Slices : public GlTest {};

/// Fragments and optical depth of all slices of a pixel or tile.
struct SliceSums {
  std::uint64_t fragments = 0;
  std::uint64_t depth = 0;  ///< in steps
  std::uint64_t red = 0;    ///< times optical depth, in steps
};

SliceSums sumsOf(const std::vector<std::uint32_t>& words, std::size_t place, int slices) {
  SliceSums sums;
  for (int i = 0; i < slices; ++i) {
    const std::size_t at =
        4 * (place * static_cast<std::size_t>(slices) + static_cast<std::size_t>(i));
    const std::uint64_t countsOver = words[at + 1] >> SLICE_CARRY_SHIFT;
    const std::uint64_t depthsOver = words[at + 2] >> SLICE_CARRY_SHIFT;
    // Both as one number of more bits.
    const std::uint64_t first = countsOver << 32 | words[at];
    const std::uint64_t depth =
        first % (1U << SLICE_COUNT_SHIFT) + (depthsOver << SLICE_COUNT_SHIFT);
    sums.depth += depth;
    sums.fragments += (first - depth) >> SLICE_COUNT_SHIFT;
    sums.red += words[at + 1] % (1U << SLICE_CARRY_SHIFT);
  }
  return sums;
}

TEST_F(Slices, HoldThousandsOfFragments) {
  constexpr glm::ivec2 kSize{8, 4};
  for (const int layers : {40, 600, 1500, 2600}) {
    // All but one in one slice, opaque, so that count and optical depth run over.
    std::vector<Sheet> list(static_cast<std::size_t>(layers - 1),
                            {1.0F, glm::vec4(0.5F, 0.25F, 0.125F, 1.0F)});
    list.push_back({9.0F, glm::vec4(0.5F, 0.25F, 0.125F, 1.0F)});
    const scene::Scene scene = sheets(list);
    for (const int tile : {1, 4}) {
      for (const char* sync : {"spinlock", "ordered"}) {
        if (std::string(sync) == "ordered" && !device().ordered.passed) continue;
        passes::RenderSettings settings = settingsOf(
            {.method = "kb-variable", .kAve = 4.0, .sync = sync, .importance = Predictor::Error});
        settings.importance.tile = tile;
        settings.readBack = true;
        Bench bench(scene, settings, kSize, device());
        bench.draw();
        const auto words = bench.bufferWords(passes::kSliceSums);
        const auto places = static_cast<std::size_t>(kSize.x * kSize.y / (tile * tile));
        const auto n = static_cast<std::uint64_t>(layers);
        for (std::size_t place = 0; place < places; ++place) {
          const SliceSums sums = sumsOf(words, place, settings.importance.slices);
          const std::string what =
              std::to_string(layers) + " layers, tile " + std::to_string(tile) + ", " + sync;
          // A tile sees each layer once: slices are drawn at the tiles' resolution.
          ASSERT_EQ(sums.fragments, n) << what;
          ASSERT_EQ(sums.depth, n * 8 * 1024) << what;
          ASSERT_EQ(sums.red, sums.depth / 2) << what;
        }
      }
    }
  }
}

}  // namespace
}  // namespace macula::test
