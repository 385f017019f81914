// The kernels of the allocation in both shapes of their work-groups, and their integer arithmetic
// against plain arithmetic of 128 bits.
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <random>

#include "engine/core/file.h"
#include "engine/scene/procedural/recipes.h"
#include "oit_cases.h"
#include "shared/oit_constants.h"

namespace macula::test {
namespace {

namespace fs = std::filesystem;
using passes::OitSettings;
using passes::Predictor;
using passes::Tail;

class Kernels : public GlTest {};

/// What the allocation of one frame gave and found.
struct Found {
  std::vector<std::uint32_t> slots;  ///< of each pixel, and whether with a tail
  std::vector<std::uint32_t> totals;
  std::vector<std::uint32_t> statistics;
  std::vector<std::uint32_t> importance;
  std::vector<float> image;
};

std::vector<Found> draw(const scene::Scene& scene, const OitSettings& oit, glm::ivec2 size,
                        passes::DeviceContext& device) {
  passes::RenderSettings settings = settingsOf(oit);
  settings.readBack = true;
  Bench bench(scene, settings, size, device);
  std::vector<Found> frames;
  for (int frame = 0; frame < 2; ++frame) {  // the second has history
    bench.draw({0.4F, 0.6F});
    Found found;
    if (bench.renderer.plan().method->hasRanges()) {
      const auto ranges = bench.words(passes::kFragmentRange, 2);
      for (std::size_t p = 0; 2 * p < ranges.size(); ++p) found.slots.push_back(ranges[2 * p + 1]);
    }
    found.totals = bench.bufferWords(passes::kOitTotals);
    found.statistics = bench.bufferWords(passes::kOitStatistics);
    if (bench.renderer.plan().mapsImportance()) {
      found.importance = bench.words(passes::kImportance, 1);
    }
    found.image = bench.linear();
    frames.push_back(std::move(found));
  }
  return frames;
}

TEST_F(Kernels, OfBothShapesFindTheSame) {
  std::vector<OitSettings> cases{{.method = "ab-sbuffer"}};
  for (const double kAve : {0.3, 2.5}) {  // fewer slots than covered pixels, and more
    for (const bool fill : {false, true}) {
      cases.push_back({.method = "kb-plus", .kAve = kAve, .fill = fill});
      cases.push_back({.method = "kb-variable", .kAve = kAve, .fill = fill});
    }
  }
  cases.push_back({.method = "kb-variable", .kAve = 2.5, .tail = Tail::Mean});
  cases.push_back({.method = "kb-variable", .kAve = 2.5, .fill = true, .tail = Tail::Mean});
  cases.push_back({.method = "kb-variable", .kAve = 2.5, .importance = Predictor::Error});
  cases.push_back({.method = "kb-learned", .kAve = 2.5});
  cases.push_back(learnedUtility(2.5));
  passes::DeviceContext alone;
  passes::DeviceContext together;
  alone.sumInGroups(false);
  together.sumInGroups(true);
  const scene::Scene scene = unlit(tangle(240, 7));
  // More than one chunk of a row's strips, no multiple of a strip or a tile; more rows than a group
  // that sums rows has threads; less than a strip.
  for (const glm::ivec2 size : {glm::ivec2(1061, 37), glm::ivec2(41, 301), glm::ivec2(19, 5)}) {
    for (const OitSettings& oit : cases) {
      const std::vector<Found> one = draw(scene, oit, size, alone);
      const std::vector<Found> other = draw(scene, oit, size, together);
      for (std::size_t frame = 0; frame < one.size(); ++frame) {
        const std::string what =
            describe(oit) + " frame " + std::to_string(frame) + " width " + std::to_string(size.x);
        EXPECT_EQ(one[frame].slots, other[frame].slots) << what;
        EXPECT_EQ(one[frame].totals, other[frame].totals) << what;
        EXPECT_EQ(one[frame].statistics, other[frame].statistics) << what;
        EXPECT_EQ(one[frame].importance, other[frame].importance) << what;
        EXPECT_EQ(countUnlike(one[frame].image, other[frame].image), 0U) << what;
      }
    }
  }
  note("cases in three sizes", static_cast<double>(cases.size()));
}

/// The largest k with sum min(n, k) <= slots, by trying one after another.
std::uint32_t largestCommon(const std::vector<float>& counts, std::uint64_t slots) {
  const auto needs = [&](std::uint32_t k) {
    std::uint64_t sum = 0;
    for (const float n : counts) sum += std::min(static_cast<std::uint32_t>(n), k);
    return sum;
  };
  std::uint32_t k = 0;
  while (needs(k + 1) <= slots && needs(k + 1) > needs(k)) ++k;
  return k;
}

TEST_F(Kernels, TheOneLayerCountIsTheLargestThatFits) {
  EXPECT_EQ(largestCommon({1.0F, 3.0F, 3.0F, 0.0F}, 6), 2U) << "1 + 2 + 2 <= 6 < 1 + 3 + 3";
  EXPECT_EQ(largestCommon({1.0F, 3.0F}, 99), 3U) << "no more than there are fragments";
  passes::DeviceContext own;
  for (const bool groups : {false, true}) {
    own.sumInGroups(groups);
    for (const scene::Scene& scene : {unlit(tangle(900, 4)), scene::makeLayers(300, 1)}) {
      for (const double kAve : {0.2, 1.0, 2.5, 4.0, 7.0, 299.0}) {
        Bench bench(scene, settingsOf({.method = "kb-plus", .kAve = kAve}), {53, 35}, own);
        bench.draw();
        const auto counts = bench.floats(passes::kFragmentCount, 1);
        const std::uint32_t k = largestCommon(counts, bench.renderer.plan().slots);
        const auto ranges = bench.words(passes::kFragmentRange, 2);
        for (std::size_t p = 0; p < counts.size(); ++p) {
          ASSERT_EQ(ranges[2 * p + 1], std::min(static_cast<std::uint32_t>(counts[p]), k))
              << "k " << kAve << " pixel " << p;
        }
      }
    }
  }
}

/// Runs functions of shaders/lib on lists of numbers.
class Probe {
 public:
  /// @param body sets `uvec4 result` from `uvec4 a`, `uvec4 b`
  explicit Probe(const std::string& body)
      : folder_(fs::temp_directory_path() /
                ("macula_probe_" + std::to_string(fs::hash_value(fs::current_path())) + "_" +
                 testing::UnitTest::GetInstance()->current_test_info()->name())) {
    fs::remove_all(folder_);
    fs::copy(dataFolder("shaders"), folder_, fs::copy_options::recursive);
    std::ofstream(folder_ / "probe.comp")
        << "#include \"shared/oit_constants.h\"\n"
           "#include \"lib/budget.glsl\"\n#include \"lib/cut.glsl\"\n"
           "layout(local_size_x = 64) in;\n"
           "layout(std430, binding = 0) readonly buffer In { uvec4 given[]; };\n"
           "layout(std430, binding = 1) writeonly buffer Out { uvec4 found[]; };\n"
           "void main() {\n  uint i = gl_GlobalInvocationID.x;\n"
           "  if (i >= uint(found.length())) return;\n"
           "  uvec4 a = given[2u * i];\n  uvec4 b = given[2u * i + 1u];\n  uvec4 result;\n"
        << body << "\n  found[i] = result;\n}\n";
  }
  ~Probe() { fs::remove_all(folder_); }
  Probe(const Probe&) = delete;
  Probe& operator=(const Probe&) = delete;

  using Case = std::array<std::uint32_t, 8>;
  std::vector<std::array<std::uint32_t, 4>> run(const std::vector<Case>& cases) const {
    gl::ProgramCache programs(folder_);
    std::vector<std::array<std::uint32_t, 4>> found(cases.size());
    const gl::Buffer in = gl::Buffer::of<Case>("given", cases);
    const gl::Buffer out("found", found.size() * sizeof(found.front()));
    glUseProgram(programs.get({{"probe.comp"}, {}, {}}));
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, in.id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, out.id());
    glDispatchCompute(static_cast<GLuint>((cases.size() + 63) / 64), 1, 1);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glGetNamedBufferSubData(
        out.id(), 0, static_cast<GLsizeiptr>(found.size() * sizeof(found.front())), found.data());
    return found;
  }

 private:
  fs::path folder_;
};

constexpr int kCases = 200000;

/// Numbers of all magnitudes below 2^bits.
std::uint64_t anyBelow(int bits, std::mt19937_64& random) {
  const int size = static_cast<int>(random() % static_cast<std::uint64_t>(bits + 1));
  return size == 0 ? 0 : random() >> (64 - size);
}

TEST_F(Kernels, AShareIsRoundedDownExactly) {
  std::mt19937_64 random(1);
  std::vector<Probe::Case> cases;
  const auto add = [&](std::uint64_t importance, std::uint64_t slots, std::uint64_t total) {
    cases.push_back({static_cast<std::uint32_t>(importance), static_cast<std::uint32_t>(slots),
                     static_cast<std::uint32_t>(total), static_cast<std::uint32_t>(total >> 32)});
  };
  for (int i = 0; i < kCases; ++i) {
    const std::uint64_t importance = anyBelow(18, random);
    const std::uint64_t slots = anyBelow(29, random);
    add(importance, slots, importance + anyBelow(44, random));
    // Quotients that are whole, or only just not.
    const std::uint64_t whole = 1 + anyBelow(16, random);
    const std::uint64_t total = importance * slots / whole;
    for (const int off : {-1, 0, 1}) {
      if (total > importance) add(importance, slots, total + static_cast<std::uint64_t>(off));
    }
  }
  const Probe probe(
      "  result = uvec4(share(a.x, budgetOf(a.y, a.zw)), hasNoShare(a.x, a.y, a.zw), 0u, 0u);");
  const auto found = probe.run(cases);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const std::uint64_t total = cases[i][2] | std::uint64_t{cases[i][3]} << 32;
    const std::uint64_t exact =
        total == 0 ? 0 : std::uint64_t{cases[i][0]} * cases[i][1] / total;  // below 2^47
    ASSERT_EQ(found[i][0], std::min<std::uint64_t>(exact, MAX_PIXEL_LAYERS))
        << cases[i][0] << " of " << total << ", " << cases[i][1] << " slots";
    ASSERT_EQ(found[i][1], exact == 0 ? 1U : 0U) << cases[i][0] << " of " << total;
  }
  note("shares compared", static_cast<double>(cases.size()));
}

TEST_F(Kernels, WhatIsGrantedIsRoundedDownExactly) {
  std::mt19937_64 random(2);
  std::vector<Probe::Case> cases;
  for (int i = 0; i < kCases; ++i) {
    const std::uint64_t extra = 1 + anyBelow(32, random) % 0xFFFFFFFFU;  // B - A
    const std::uint64_t part = random() % extra;                         // M - A
    std::uint64_t sum = random() % (extra + 1);
    if (part > 0 && i % 2 == 0) {  // about where the quotient is whole
      const std::uint64_t whole = random() % (part + 1);
      sum = std::min(extra, whole * extra / part + random() % 2);
    }
    cases.push_back({static_cast<std::uint32_t>(sum), static_cast<std::uint32_t>(part),
                     static_cast<std::uint32_t>(extra)});
  }
  const Probe probe("  result = uvec4(granted(a.x, ratioOf(a.y, a.z)), 0u, 0u, 0u);");
  const auto found = probe.run(cases);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const std::uint64_t exact = std::uint64_t{cases[i][0]} * cases[i][1] / cases[i][2];
    ASSERT_EQ(found[i][0], exact) << cases[i][0] << " times " << cases[i][1] << " / "
                                  << cases[i][2];
  }
  note("parts compared", static_cast<double>(cases.size()));
}

TEST_F(Kernels, TheBudgetIsCutAtTheLargestAmountWithinIt) {
  const std::vector<Probe::Case> cases{{5, 9, 9, 30, 4},  {5, 9, 9, 30, 5},  {5, 9, 9, 30, 8},
                                       {5, 9, 9, 30, 9},  {5, 9, 9, 30, 20}, {5, 9, 9, 30, 30},
                                       {5, 9, 9, 30, 31}, {0, 0, 0, 0, 3}};
  const Probe probe("  result = cutOf(a, b.x);");
  const auto found = probe.run(cases);
  const std::vector<std::uint32_t> numbers{0, 1, 1, 3, 3, 4, 4, 4};
  for (std::size_t i = 0; i < cases.size(); ++i) EXPECT_EQ(found[i][0], numbers[i]) << "case " << i;
  EXPECT_EQ(found[2][2], 0xC0000000U) << "(8 - 5) / (9 - 5)";
  EXPECT_EQ(found[2][1], 0U);
  EXPECT_EQ(found[0][2], 0xCCCCCCCCU) << "4 / 5";
  EXPECT_EQ(found[0][1], 0xCCCCCCCDU) << "rounded up";
}

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

TEST_F(Kernels, SlicesHoldThousandsOfFragments) {
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
