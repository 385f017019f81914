// Stencil-routed k-buffer (Bavoil and Myers 2008): the first k fragments drawn go to the samples of
// a multisample target. The stencil of sample i starts at i + 1; every fragment decrements all
// stencils of its pixel and is stored in the sample whose stencil was 1.
#include <array>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/gl/blocking.h"
#include "engine/gl/objects.h"
#include "engine/gl/render_state.h"
#include "passes/full_screen.h"
#include "passes/light_defines.h"
#include "passes/oit/oit_pass.h"
#include "passes/oit/passes.h"
#include "passes/scene_draw.h"
#include "shared/bindings.h"
#include "shared/oit_constants.h"

namespace macula::passes {
namespace {

using frame::Access;

/// Opaque depth, and the stencil that routes.
constexpr frame::Resource kRoutedStencil{"routing stencil", GL_DEPTH32F_STENCIL8,
                                         frame::SizeRule::DisplaySamples,
                                         frame::ByteClass::Overhead, frame::Initial::Undefined};

/// How multisample slots are to be drawn to.
enum class RoutingMode : std::uint8_t {
  Single,  ///< GL_MULTISAMPLE off: one fragment for all samples, each with its own stencil
  Multi,   ///< GL_MULTISAMPLE on, for rasterisers that then test all samples by the first one's
           ///< stencil; at edges some samples are not covered, and slots stay empty
  None,    ///< neither routes fragments to samples
};

GLuint routingProgram(gl::ProgramCache& programs) {
  return programs.get({{"oit/full_screen.vert", "oit/routing_depth.frag"}, {}, {}});
}

/// Sets the stencil of sample i to i + 1 and its depth to the bound opaque depth, in the bound
/// framebuffer. @param program routingProgram() · @param slots samples that take a fragment; the
/// others get 0
void prepareRouting(GLuint program, FullScreenDraw& fullScreen, std::uint32_t slots) {
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

/// Stencil state under which each fragment goes to the next free sample; endRouting() ends it.
void beginRouting(RoutingMode mode) {
  mode == RoutingMode::Single ? glDisable(GL_MULTISAMPLE) : glEnable(GL_MULTISAMPLE);
  gl::apply({.depthTest = true});
  glEnable(GL_STENCIL_TEST);
  glStencilFunc(GL_EQUAL, 1, 0xFF);
  glStencilOp(GL_DECR, GL_KEEP, GL_DECR);
}

void endRouting() {
  glDisable(GL_STENCIL_TEST);
  glEnable(GL_MULTISAMPLE);
}

/// Draws two layers over pixels of two samples, and compares which sample got which.
bool routes(RoutingMode mode, gl::ProgramCache& programs) {
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
  glBindTextureUnit(TEX_INPUT0, depth.id());
  prepareRouting(routingProgram(programs), fullScreen, kSamples);
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
  gl::readTexture(result.id(), {GL_RG_INTEGER, GL_UNSIGNED_INT}, sizeof(words), words.data());
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] != i % 2 + 1) return false;  // the first layer in sample 0, the second in 1
  }
  return true;
}

RoutingMode checkRouting() {
  gl::ProgramCache programs(dataFolder("shaders"));  // of the check alone
  if (routes(RoutingMode::Single, programs)) return RoutingMode::Single;
  return routes(RoutingMode::Multi, programs) ? RoutingMode::Multi : RoutingMode::None;
}

class RoutedPass final : public OitPass {
 public:
  using OitPass::OitPass;
  [[nodiscard]] std::string_view name() const override { return "oit.route"; }

  void declare(frame::PassDeclaration& d, const frame::FrameInputs& in) const override {
    const int samples = static_cast<int>(plan_.layers);
    for (const frame::Resource* r : {&kRoutedKeys, &kRoutedColors, &kRoutedStencil}) {
      d.samples(*r, samples);
    }
    d.scene();
    d.color(0, kRoutedKeys, Access::Write);
    d.color(1, kRoutedColors, Access::Write);
    d.depth(kRoutedStencil, Access::Scratch);
    d.viewport(plan_.size);
    testedDepthTexture(d, TEX_INPUT0);
    shadowMap(d, in);
  }

  void prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) override {
    routing_ = routingProgram(programs);
    variants_.prepare(in.gpu->transparentInOrder().runs, "oit/routed.frag", lightingDefines(in), {},
                      programs);
    if (mode_ == RoutingMode::None) mode_ = checkRouting();
    if (mode_ == RoutingMode::None) {
      failInput(
          "oit.method: this GPU's stencil test does not route fragments to samples; use "
          "kb-fixed");
    }
  }

 private:
  [[nodiscard]] bool wanted() const override { return plan_.method->runs(name()); }

  void run(frame::PassContext& context) override {
    const scene::GpuScene& gpu = *context.inputs().gpu;
    constexpr GLuint kEmpty[4]{NO_KEY, NO_KEY, NO_KEY, NO_KEY};
    glClearBufferuiv(GL_COLOR, 0, kEmpty);
    prepareRouting(routing_, fullScreen_, plan_.layers);
    beginRouting(mode_);
    variants_.draw(gpu, gpu.transparentInOrder(), gpu.transparentInOrder().runs);
    endRouting();
  }

  SceneVariants variants_;
  FullScreenDraw fullScreen_;
  RoutingMode mode_ = RoutingMode::None;
  GLuint routing_ = 0;
};

}  // namespace

OitPassPtr makeRoutedPass(const OitPlan& plan) {
  return std::make_unique<RoutedPass>(plan);
}

}  // namespace macula::passes
