// Insertion where invocations of a pixel meet: by compute shaders, which run on several threads
// even where a rasteriser draws a pixel's fragments on one, against a sort on the CPU.
// MACULA_CONTENTION: how many fragments each variant inserts at the least (default 100,000).
#include <gmock/gmock.h>

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <functional>
#include <numeric>
#include <thread>

#include "gl_fixture.h"
#include "shader_copy.h"
#include "shared/bindings.h"
#include "shared/oit_constants.h"
#include "shared/oit_totals.h"

namespace macula::test {
namespace {

constexpr std::uint32_t kWidth = 64;
constexpr std::uint32_t kHeight = 32;
constexpr std::uint32_t kPixels = kWidth * kHeight;
constexpr std::uint32_t kFragments =
    24;  // of a pixel: few, so that its slots are often just being filled
constexpr std::uint32_t kSlotsEach = 5;

/// Threads of a software device: those of the machine, as far as they divide a pixel's fragments.
std::uint32_t runCount() {
  std::uint32_t runs = 2;
  for (const std::uint32_t more : {3U, 4U, 6U, 8U}) {
    if (more <= std::thread::hardware_concurrency()) runs = more;
  }
  return runs;
}

struct Variant {
  const char* name;
  bool packed;
  bool tail;
  bool dynamicTail;
};
constexpr Variant kVariants[]{
    {"16 bytes", false, false, false},
    {"16 bytes, tail", false, true, false},
    {"16 bytes, dynamic tail", false, true, true},
    {"8 bytes", true, false, false},
    {"8 bytes, tail", true, true, false},
    {"8 bytes, dynamic tail", true, true, true},
};

std::uint32_t hashPcg(std::uint32_t x) {  // shaders/lib/hash.glsl
  const std::uint32_t state = x * 747796405U + 2891336453U;
  const std::uint32_t word = ((state >> ((state >> 28U) + 4U)) ^ state) * 277803737U;
  return (word >> 22U) ^ word;
}

/// A fragment as it is stored.
struct Stored {
  glm::uvec2 key;
  glm::uvec2 color;  ///< zero where the key holds it
  std::uint32_t number;
};

Stored storedBy(const Variant& variant, std::uint32_t pixel, std::uint32_t number,
                std::uint32_t seed) {
  const std::uint32_t random = hashPcg(seed ^ (pixel * 128U) ^ number);
  const float depth = static_cast<float>(1U + random % 64U) / 64.0F;
  const std::uint32_t bits = std::bit_cast<std::uint32_t>(depth);
  if (!variant.packed) {
    const auto half = [](float value) { return glm::packHalf2x16(glm::vec2(value, 0.0F)); };
    const float red = static_cast<float>(number) / 512.0F;
    return {{~bits, number}, {half(red), half(0.5F) * 0x10001U}, number};
  }
  const std::uint32_t rank = (0x3F800000U - bits) >> 6U;
  // Alpha in 8 bits, rounded; the largest channel, 0.5, is 256 steps of exponent 15.
  return {{(rank << 8U) | 128U, number | (256U << 18U) | (15U << 27U)}, glm::uvec2(0), number};
}

bool isNearer(const Stored& a, const Stored& b) {
  return a.key.x != b.key.x ? a.key.x < b.key.x : a.key.y < b.key.y;
}

/// GPU memory of kPixels pixels, and the program that fills it.
class Contention {
 public:
  Contention(const Variant& variant, const ShaderCopy& shaders, const gl::Defines& more)
      : variant_(variant), programs_(shaders.folder()) {
    gl::Defines defines{{"INSERTION_SORTED", "1"}, {"SYNC_SPINLOCK", "1"}};
    if (variant.packed) defines.emplace_back("PACKED", "1");
    if (variant.tail) defines.emplace_back("TAIL_IN_SLOT", "1");
    if (variant.dynamicTail) defines.emplace_back("TAIL_DYNAMIC", "1");
    defines.insert(defines.end(), more.begin(), more.end());
    program_ = programs_.get({{"contention.comp"}, defines, {}});
  }

  /// Inserts kFragments into each pixel, and compares.
  /// @returns pixels that are not as the sort says
  std::uint32_t round(std::uint32_t seed) {
    clear();
    glUseProgram(program_);
    glUniform2ui(0, kWidth, kHeight);
    glUniform1ui(1, kFragments);
    glUniform1ui(2, kSlotsEach);
    glUniform1ui(3, seed);
    glUniform1ui(4, seed % 2 == 0 ? 1 : runCount());
    glDispatchCompute(kPixels * kFragments, 1, 1);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT);
    inserted_ += std::uint64_t{kPixels} * kFragments;
    return compare(seed);
  }
  [[nodiscard]] std::uint64_t inserted() const { return inserted_; }
  [[nodiscard]] std::uint64_t waits() const { return waits_; }
  [[nodiscard]] std::uint64_t givenUp() const { return givenUp_; }

 private:
  void clear() {
    const GLuint zero = 0;
    for (const gl::Texture* image : {&fill_, &lock_}) {
      glClearTexImage(image->id(), 0, GL_RED_INTEGER, GL_UNSIGNED_INT, &zero);
    }
    glClearTexImage(normal_.id(), 0, GL_RGBA, GL_BYTE, nullptr);
    // What an unwritten slot must not be taken for: the nearest depth, which zero is in 8 bytes. A
    // tail begins with zero.
    for (const gl::Buffer* buffer : {&keys_, &colors_, &totals_, &waitCount_, &arrivals_}) {
      glClearNamedBufferData(buffer->id(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &zero);
    }
    if (!variant_.tail && !variant_.packed) {
      const GLuint nearest = ~std::bit_cast<std::uint32_t>(1.0F);
      glClearNamedBufferData(keys_.id(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &nearest);
    }
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    glBindImageTexture(IMG_1, fill_.id(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_R32UI);
    glBindImageTexture(IMG_2, normal_.id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA8_SNORM);
    glBindImageTexture(IMG_3, lock_.id(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_R32UI);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SSBO_FRAGMENT_KEYS, keys_.id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SSBO_FRAGMENT_COLORS, colors_.id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SSBO_OIT_TOTALS, totals_.id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SSBO_COVERED, waitCount_.id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SSBO_SLICES, arrivals_.id());
  }

  std::uint32_t compare(std::uint32_t seed) {
    std::uint32_t waits = 0;
    waitCount_.download(&waits, sizeof(waits));
    waits_ += waits;
    shader::OitTotals totals{};
    totals_.download(&totals, sizeof(totals));
    givenUp_ += totals.lockFailures;
    keys_.download(keyWords_.data(), keyWords_.size() * sizeof(glm::uvec2));
    colors_.download(colorWords_.data(), colorWords_.size() * sizeof(glm::uvec2));
    glGetTextureImage(fill_.id(), 0, GL_RED_INTEGER, GL_UNSIGNED_INT,
                      static_cast<GLsizei>(fillWords_.size() * sizeof(std::uint32_t)),
                      fillWords_.data());
    glGetTextureImage(normal_.id(), 0, GL_RGBA, GL_BYTE,
                      static_cast<GLsizei>(normals_.size() * sizeof(normals_[0])), normals_.data());
    std::uint32_t unlike = 0;
    for (std::uint32_t pixel = 0; pixel < kPixels; ++pixel) {
      if (!isAsSorted(pixel, seed)) ++unlike;
    }
    return unlike;
  }

  [[nodiscard]] bool isAsSorted(std::uint32_t pixel, std::uint32_t seed) const {
    std::vector<Stored> all;
    for (std::uint32_t i = 0; i < kFragments; ++i)
      all.push_back(storedBy(variant_, pixel, i, seed));
    std::ranges::sort(all, isNearer);
    const std::uint32_t tailSlots = !variant_.tail ? 0 : variant_.packed ? 2 : 1;
    const std::uint32_t core = kSlotsEach - tailSlots;
    const std::size_t first = std::size_t{pixel} * kSlotsEach;
    if (std::min(fillWords_[pixel] & ~RANGE_TAIL, core) != core) return false;
    for (std::uint32_t i = 0; i < core; ++i) {
      if (keyWords_[first + i] != all[i].key) return false;
      if (!variant_.packed && colorWords_[first + i] != all[i].color) return false;
    }
    if (normals_[pixel].x != static_cast<std::int8_t>(all[0].number)) return false;
    return !variant_.tail || isTailOf(first + core, std::span(all).subspan(core));
  }

  /// Whether the tail holds all of the others: each has more than an optical depth of 0.9, so that
  /// one too few or too many shows behind what logarithms may differ by.
  [[nodiscard]] bool isTailOf(std::size_t slot, std::span<const Stored> others) const {
    const glm::uvec2 high = variant_.packed ? keyWords_[slot + 1] : colorWords_[slot];
    const float depth = std::bit_cast<float>(high.y);
    const float red = std::bit_cast<float>(keyWords_[slot].x);
    const float each = variant_.packed ? -std::log2(1.0F - 128.0F / 255.0F) : 1.0F;
    double numbers = 0.0;
    for (const Stored& other : others) numbers += other.number;
    const auto count = static_cast<double>(others.size());
    constexpr double kStep = 1.0 / 16384.0;  // TAIL_STEPS, by which a fragment's part is rounded
    const double expectedRed =
        numbers / 256.0 * each * (variant_.packed ? 0.5 * 255.0 / 128.0 : 1.0);
    return std::abs(depth - count * each) <= count * kStep &&
           std::abs(red - expectedRed) <= count * kStep;
  }

  static constexpr std::size_t kSlots = std::size_t{kPixels} * kSlotsEach;
  Variant variant_;
  gl::ProgramCache programs_;
  GLuint program_ = 0;
  gl::Texture fill_{"fill", GL_R32UI, kWidth, kHeight};
  gl::Texture lock_{"lock", GL_R32UI, kWidth, kHeight};
  gl::Texture normal_{"normal", GL_RGBA8_SNORM, kWidth, kHeight};
  gl::Buffer keys_{"keys", kSlots * sizeof(glm::uvec2)};
  gl::Buffer colors_{"colors", kSlots * sizeof(glm::uvec2)};
  gl::Buffer totals_{"totals", sizeof(shader::OitTotals)};
  gl::Buffer arrivals_{"arrivals", kPixels * sizeof(std::uint32_t)};
  gl::Buffer waitCount_{"waits", sizeof(std::uint32_t)};
  std::vector<glm::uvec2> keyWords_ = std::vector<glm::uvec2>(kSlots);
  std::vector<glm::uvec2> colorWords_ = std::vector<glm::uvec2>(kSlots);
  std::vector<std::uint32_t> fillWords_ = std::vector<std::uint32_t>(kPixels);
  std::vector<glm::i8vec4> normals_ = std::vector<glm::i8vec4>(kPixels);
  std::uint64_t inserted_ = 0;
  std::uint64_t waits_ = 0;
  std::uint64_t givenUp_ = 0;
};

std::uint64_t wantedInsertions() {
  const char* wanted = std::getenv("MACULA_CONTENTION");
  return wanted != nullptr ? std::strtoull(wanted, nullptr, 10) : 100'000;
}
constexpr std::uint32_t kMostRounds = 200;  // until locks were waited for, or a fault was found

class InsertionUnderContention : public GlTest {};

TEST_F(InsertionUnderContention, LosesNothing) {
  const ShaderCopy shaders;
  shaders.add("contention.comp");
  for (const Variant& variant : kVariants) {
    Contention contention(variant, shaders, {});
    std::uint64_t givenUp = 0;
    std::uint64_t met = 0;  // insertions of rounds in which locks were waited for and none given up
    for (std::uint32_t seed = 1; met < wantedInsertions(); ++seed) {
      // A lock is given up where the system suspends the thread that holds it for too long. That is
      // counted, spoils no other pixel, and is rare.
      ASSERT_LE(seed, kMostRounds + 2 * wantedInsertions() / (kPixels * kFragments))
          << variant.name << ": " << givenUp << " locks given up, " << contention.waits()
          << " waits";
      const std::uint64_t waits = contention.waits();
      const std::uint32_t unlike = contention.round(seed);
      const std::uint64_t now = contention.givenUp() - givenUp;
      ASSERT_LE(unlike, now) << variant.name;
      givenUp += now;
      if (now == 0 && contention.waits() > waits) met += std::uint64_t{kPixels} * kFragments;
    }
    std::cout << "[     NOTE ] Contention, " << variant.name << ": " << contention.inserted()
              << " insertions, " << contention.waits() << " waits for a lock, " << givenUp
              << " given up\n";
  }
}

TEST_F(InsertionUnderContention, FindsAnUnsafeTestBeforeTheLock) {
  const ShaderCopy shaders;
  shaders.add("contention.comp");
  for (const Variant& variant : kVariants) {
    if (variant.tail) continue;  // nothing is tested before the lock
    Contention contention(variant, shaders, {{"UNSAFE_PRETEST", "1"}});
    std::uint32_t unlike = 0;
    for (std::uint32_t seed = 1; seed <= kMostRounds && unlike == 0; ++seed) {
      unlike = contention.round(seed);
    }
    EXPECT_GT(unlike, 0U) << variant.name;
    std::cout << "[     NOTE ] Contention, " << variant.name << ", unsafe test: " << unlike
              << " pixels wrong after " << contention.inserted() << " insertions\n";
  }
}

}  // namespace
}  // namespace macula::test
