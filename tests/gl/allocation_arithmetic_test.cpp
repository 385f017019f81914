// The integer arithmetic of the allocation (shaders/lib/budget.glsl, shaders/lib/cut.glsl) against
// plain arithmetic of 64 bits.
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <random>

#include "engine/core/file.h"
#include "oit_cases.h"
#include "shared/oit_constants.h"

namespace macula::test {
namespace {

namespace fs = std::filesystem;

class Arithmetic : public GlTest {};

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

constexpr int kRandomCases = 200000;

/// Numbers of all magnitudes below 2^bits.
std::uint64_t anyBelow(int bits, std::mt19937_64& random) {
  const int size = static_cast<int>(random() % static_cast<std::uint64_t>(bits + 1));
  return size == 0 ? 0 : random() >> (64 - size);
}

TEST_F(Arithmetic, AShareIsRoundedDownExactly) {
  std::mt19937_64 random(1);
  std::vector<Probe::Case> cases;
  const auto add = [&](std::uint64_t importance, std::uint64_t slots, std::uint64_t total) {
    cases.push_back({static_cast<std::uint32_t>(importance), static_cast<std::uint32_t>(slots),
                     static_cast<std::uint32_t>(total), static_cast<std::uint32_t>(total >> 32)});
  };
  for (int i = 0; i < kRandomCases; ++i) {
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

TEST_F(Arithmetic, WhatIsGrantedIsRoundedDownExactly) {
  std::mt19937_64 random(2);
  std::vector<Probe::Case> cases;
  for (int i = 0; i < kRandomCases; ++i) {
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

TEST_F(Arithmetic, TheBudgetIsCutAtTheLargestAmountWithinIt) {
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

}  // namespace
}  // namespace macula::test
