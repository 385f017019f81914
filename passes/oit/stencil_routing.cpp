#include "passes/oit/stencil_routing.h"

#include <array>

#include "engine/gl/objects.h"
#include "engine/gl/render_state.h"
#include "shared/bindings.h"

namespace macula::passes {
namespace {

bool dealsOut(RoutingMode mode, gl::ProgramCache& programs) {
  FullScreenDraw fullScreen;
  constexpr int kSamples = 2;
  constexpr glm::ivec2 kSide{4};
  const gl::Texture color = gl::Texture::multisample("routing check", GL_R32UI, kSide, kSamples);
  const gl::Texture stencil =
      gl::Texture::multisample("routing check stencil", GL_DEPTH32F_STENCIL8, kSide, kSamples);
  const gl::Texture depth("routing check depth", GL_R32F, kSide.x, kSide.y);
  const gl::Texture result("routing check result", GL_RG32UI, kSide.x, kSide.y);
  GLuint id = 0;
  glCreateFramebuffers(1, &id);
  const gl::FramebufferId framebuffer(id);
  glNamedFramebufferTexture(id, GL_COLOR_ATTACHMENT0, color.id(), 0);
  glNamedFramebufferTexture(id, GL_DEPTH_STENCIL_ATTACHMENT, stencil.id(), 0);
  glBindFramebuffer(GL_FRAMEBUFFER, id);
  glViewport(0, 0, kSide.x, kSide.y);
  glClearTexImage(depth.id(), 0, GL_RED, GL_FLOAT, nullptr);
  const GLuint none[4]{};
  glClearBufferuiv(GL_COLOR, 0, none);
  prepareRouting(routingProgram(programs), fullScreen, depth.id(), kSamples);
  beginRouting(mode);
  const GLuint layer = programs.get({{"oit/full_screen.vert", "oit/routing_check.frag"}, {}, {}});
  for (GLuint number = 1; number <= kSamples; ++number) {
    glProgramUniform1ui(layer, 0, number);
    fullScreen.draw(layer);
  }
  endRouting();
  glUseProgram(programs.get({{"oit/routing_check.comp"}, {}, {}}));
  glBindTextureUnit(TEX_INPUT0, color.id());
  glBindImageTexture(IMG_0, result.id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RG32UI);
  glDispatchCompute(1, 1, 1);
  glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
  std::array<GLuint, static_cast<std::size_t>(2 * kSide.x * kSide.y)> words{};
  glGetTextureImage(result.id(), 0, GL_RG_INTEGER, GL_UNSIGNED_INT, sizeof(words), words.data());
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] != i % 2 + 1) return false;  // the first layer in sample 0, the second in 1
  }
  return true;
}

}  // namespace

RoutingMode checkStencilRouting(gl::ProgramCache& programs) {
  if (dealsOut(RoutingMode::Single, programs)) return RoutingMode::Single;
  return dealsOut(RoutingMode::Multi, programs) ? RoutingMode::Multi : RoutingMode::None;
}

GLuint routingProgram(gl::ProgramCache& programs) {
  return programs.get({{"oit/full_screen.vert", "oit/routing_depth.frag"}, {}, {}});
}

void prepareRouting(GLuint program, FullScreenDraw& fullScreen, GLuint opaqueDepth,
                    std::uint32_t slots) {
  glBindTextureUnit(TEX_INPUT0, opaqueDepth);
  gl::apply({.depthTest = true, .depthFunc = GL_ALWAYS, .depthWrite = true});
  glEnable(GL_MULTISAMPLE);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glEnable(GL_STENCIL_TEST);
  glStencilMask(0xFF);
  glClearBufferfi(GL_DEPTH_STENCIL, 0, 0.0F, 0);
  glStencilOp(GL_REPLACE, GL_REPLACE, GL_REPLACE);
  glEnable(GL_SAMPLE_MASK);
  for (std::uint32_t i = 0; i < slots; ++i) {
    glSampleMaski(0, 1U << i);
    glStencilFunc(GL_ALWAYS, static_cast<GLint>(i + 1), 0xFF);
    fullScreen.draw(program);
  }
  glDisable(GL_SAMPLE_MASK);
  glSampleMaski(0, ~0U);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void beginRouting(RoutingMode mode) {
  mode == RoutingMode::Single ? glDisable(GL_MULTISAMPLE) : glEnable(GL_MULTISAMPLE);
  gl::apply({.depthTest = true});
  glEnable(GL_STENCIL_TEST);
  // A sample at 1 is next and takes the fragment; every fragment brings all samples one nearer.
  glStencilFunc(GL_EQUAL, 1, 0xFF);
  glStencilOp(GL_DECR, GL_KEEP, GL_DECR);
}

void endRouting() {
  glDisable(GL_STENCIL_TEST);
  glEnable(GL_MULTISAMPLE);
}

}  // namespace macula::passes
