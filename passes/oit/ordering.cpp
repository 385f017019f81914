#include "passes/oit/ordering.h"

#include <algorithm>
#include <array>
#include <vector>

#include "engine/core/error.h"
#include "engine/gl/blocking.h"
#include "engine/gl/objects.h"

namespace macula::passes {
namespace {

constexpr int kSize = 128;  // several tiles of any rasteriser
constexpr std::uint32_t kTriangles = 96;

/// The sequence that shaders/oit/sync_check.frag runs at every pixel: it depends on the order.
std::uint32_t expectedWord() {
  std::uint32_t word = 0;
  for (std::uint32_t i = 0; i < kTriangles; ++i) word = word * 1664525U + i + 1U;
  return word;
}

bool drawMatches(gl::ProgramCache& programs) {
  const gl::Texture words("synchronisation check", GL_R32UI, kSize, kSize);
  glClearTexImage(words.id(), 0, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
  GLuint vao = 0;
  GLuint fbo = 0;
  glCreateVertexArrays(1, &vao);
  glCreateFramebuffers(1, &fbo);
  const gl::VertexArrayId vaoOwner(vao);
  const gl::FramebufferId fboOwner(fbo);
  glNamedFramebufferParameteri(fbo, GL_FRAMEBUFFER_DEFAULT_WIDTH, kSize);
  glNamedFramebufferParameteri(fbo, GL_FRAMEBUFFER_DEFAULT_HEIGHT, kSize);
  glBindFramebuffer(GL_FRAMEBUFFER, fbo);
  glViewport(0, 0, kSize, kSize);
  glDisable(GL_CULL_FACE);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  glBindVertexArray(vao);
  glUseProgram(programs.get({{"oit/sync_check.vert", "oit/sync_check.frag"}, {}, {}}));
  glBindImageTexture(0, words.id(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_R32UI);
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(3 * kTriangles));
  glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
  std::vector<std::uint32_t> read(static_cast<std::size_t>(kSize) * kSize);
  gl::readTexture(words.id(), {GL_RED_INTEGER, GL_UNSIGNED_INT},
                  read.size() * sizeof(std::uint32_t), read.data());
  const std::uint32_t expected = expectedWord();
  return std::all_of(read.begin(), read.end(), [&](std::uint32_t w) { return w == expected; });
}

}  // namespace

std::string_view nameOf(SyncMode mode) {
  switch (mode) {
    case SyncMode::Auto:
      return "auto";
    case SyncMode::Interlock:
      return "interlock";
    case SyncMode::Spinlock:
      return "spinlock";
    case SyncMode::Ordered:
      return "ordered";
    case SyncMode::None:
      return "none";
  }
  return "?";
}

SyncMode syncByName(std::string_view name) {
  for (const SyncMode mode :
       {SyncMode::Interlock, SyncMode::Spinlock, SyncMode::Ordered, SyncMode::None}) {
    if (name == nameOf(mode)) return mode;
  }
  return SyncMode::Auto;
}

OrderedCheck checkOrdered(const gl::Capabilities& capabilities, gl::ProgramCache& programs) {
  OrderedCheck check;
  check.allowed = capabilities.ordersFragmentsPerPixel;
  if (!check.allowed) {
    check.reason = "this renderer is not known to draw a pixel's fragments in order on one thread";
    return check;
  }
  constexpr int kRounds = 4;  // finds a race that shows in every second round, 15 times of 16
  check.passed = true;
  for (int i = 0; i < kRounds && check.passed; ++i) check.passed = drawMatches(programs);
  check.reason = check.passed ? "known renderer, and the self-test found every pixel in order"
                              : "known renderer, but the self-test found a pixel out of order";
  return check;
}

SyncMode chooseSync(SyncMode asked, const gl::Capabilities& capabilities,
                    const OrderedCheck& ordered) {
  if (asked == SyncMode::Auto) {
    if (capabilities.fragmentShaderInterlock) return SyncMode::Interlock;
    return ordered.passed ? SyncMode::Ordered : SyncMode::Spinlock;
  }
  if (asked == SyncMode::Interlock && !capabilities.fragmentShaderInterlock) {
    failInput("oit.sync: {} has no GL_ARB_fragment_shader_interlock; use auto or spinlock",
              capabilities.renderer);
  }
  if (asked == SyncMode::Ordered && !ordered.passed) {
    failInput("oit.sync: ordered cannot be used ({}); use auto or spinlock", ordered.reason);
  }
  return asked;
}

}  // namespace macula::passes
