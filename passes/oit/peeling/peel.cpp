// Depth peeling (Everitt 2001), exact at equal depths: each layer takes three geometry passes, for
// its depth, for the least id at that depth, and for the colour of the fragment with both.
#include <algorithm>
#include <array>
#include <optional>

#include "engine/gl/blocking.h"
#include "engine/gl/objects.h"
#include "engine/gl/render_state.h"
#include "passes/light_defines.h"
#include "passes/oit/oit_pass.h"
#include "passes/oit/passes.h"
#include "passes/scene_draw.h"
#include "shared/bindings.h"
#include "shared/oit_constants.h"

namespace macula::passes {
namespace {

using frame::Access;
using frame::ByteClass;
using frame::Initial;
using frame::SizeRule;

/// Depth of the layer being peeled.
constexpr frame::Resource kPeelDepth{"peel depth", GL_DEPTH_COMPONENT32F, SizeRule::Display,
                                     ByteClass::Overhead, Initial::Undefined};
/// Least id at that depth.
constexpr frame::Resource kPeelIds{"peel ids", GL_R32UI, SizeRule::Display, ByteClass::Overhead,
                                   Initial::Undefined};
/// Colour of the layer.
constexpr frame::Resource kPeelColor{"peel colour", GL_RGBA32F, SizeRule::Display, ByteClass::Oit,
                                     Initial::Undefined};
/// Key of the last layer.
constexpr frame::Resource kPeelLast{"peel last key", GL_RG32UI, SizeRule::Display, ByteClass::Oit,
                                    Initial::Undefined};
/// Layers so far: colour, transmittance.
constexpr frame::Resource kPeelSum{"peel sum", GL_RGBA32F, SizeRule::Display, ByteClass::Overhead,
                                   Initial::Undefined};

/// Steps of the pass. Those from Depths to Layer run once for each layer.
enum Step : std::uint32_t { Begin, Depths, Ids, Colors, Layer, Finish };

/// Layers whose occlusion queries may be on their way: what the GPU is behind by, and some more.
constexpr std::size_t kQueries = 16;

/// Commands while it lives have no effect where a query found nothing. The GPU decides, so that the
/// CPU need not wait.
class OnlyIfAny {
 public:
  explicit OnlyIfAny(const gl::QueryId& query) {
    glBeginConditionalRender(query.id(), GL_QUERY_WAIT);
  }
  ~OnlyIfAny() { glEndConditionalRender(); }
  OnlyIfAny(const OnlyIfAny&) = delete;
  OnlyIfAny& operator=(const OnlyIfAny&) = delete;
};

class PeelPass final : public OitPass {
 public:
  using OitPass::OitPass;
  [[nodiscard]] std::string_view name() const override { return "oit.peel"; }

  void declare(frame::PassDeclaration& d, const frame::FrameInputs& in) const override {
    d.update(kPeelSum);
    d.update(kPeelLast);
    d.update(kPeelIds);

    d.step();  // Depths
    d.scene();
    d.depth(kPeelDepth, Access::Write);
    d.viewport(plan_.size);
    depthTexture(d, TEX_INPUT0);
    d.image(IMG_0, kPeelLast, Access::Read);

    d.step();  // Ids
    d.scene();
    d.depth(kPeelDepth);
    d.viewport(plan_.size);
    depthTexture(d, TEX_INPUT0);
    d.image(IMG_0, kPeelLast, Access::Read);
    d.image(IMG_1, kPeelIds, Access::ReadWrite);

    d.step();  // Colors
    d.scene();
    d.color(0, kPeelColor, Access::Write);
    d.depth(kPeelDepth);
    d.viewport(plan_.size);
    d.image(IMG_1, kPeelIds, Access::Read);
    shadowMap(d, in);

    d.step();  // Layer
    d.texture(TEX_INPUT1, kPeelDepth);
    d.texture(TEX_INPUT2, kPeelColor);
    d.image(IMG_0, kPeelLast, Access::Scratch);   // for the next layer
    d.image(IMG_1, kPeelIds, Access::ReadWrite);  // emptied for the next layer
    d.image(IMG_2, kPeelSum, Access::ReadWrite);

    d.step();  // Finish
    d.image(IMG_2, kPeelSum, Access::Read);
    colorImage(d, IMG_3);
  }

  void prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) override {
    const auto& transparent = in.gpu->transparent();
    gl::Defines vertex{{"POSITION_ONLY", "1"}, {"WITH_IDS", "1"}};
    vertex.emplace_back("STAGE_DEPTH", "1");
    depths_.prepare(transparent.depthRuns, "oit/peel.frag", vertex, {}, programs);
    vertex.back() = {"STAGE_IDS", "1"};
    ids_.prepare(transparent.depthRuns, "oit/peel.frag", vertex, {}, programs);
    gl::Defines shading = lightingDefines(in);
    shading.emplace_back("STAGE_COLOR", "1");
    colors_.prepare(transparent.runs, "oit/peel.frag", shading, {}, programs);
    layerProgram_ = programs.get({{"oit/peel_layer.comp"}, {}, {}});
    finishProgram_ = programs.get({{"oit/peel_layer.comp"}, {{"FINISH", "1"}}, {}});
    for (gl::QueryId& query : queries_) {
      if (query) continue;
      GLuint id = 0;
      glCreateQueries(GL_ANY_SAMPLES_PASSED, 1, &id);
      query = gl::QueryId(id);
    }
  }

 private:
  [[nodiscard]] bool wanted() const override { return plan_.method->runs(name()); }

  void run(frame::PassContext& context) override {
    const frame::FrameResources& resources = context.resources();
    constexpr GLfloat kNoLayers[4]{0.0F, 0.0F, 0.0F, 1.0F};
    glClearTexImage(resources.texture(kPeelSum).id(), 0, GL_RGBA, GL_FLOAT, kNoLayers);
    glClearTexImage(resources.texture(kPeelLast).id(), 0, GL_RG_INTEGER, GL_UNSIGNED_INT, nullptr);
    constexpr GLuint kNoId = NO_KEY;
    glClearTexImage(resources.texture(kPeelIds).id(), 0, GL_RED_INTEGER, GL_UNSIGNED_INT, &kNoId);
    const auto layers = static_cast<std::size_t>(plan_.options.layers);
    std::size_t known = 0;  // layers that are known to hold a fragment
    for (std::size_t layer = 0; layer < layers && !foundEmpty(known, layer); ++layer) {
      drawDepths(context, layer);
      const OnlyIfAny any(queryOf(layer));
      drawIds(context);
      drawColors(context);
      context.beginStep(Layer);
      glUseProgram(layerProgram_);
      context.dispatch(plan_.size, kFullScreenGroup);
    }
    context.beginStep(Finish);
    glUseProgram(finishProgram_);
    context.dispatch(plan_.size, kFullScreenGroup);
  }

  [[nodiscard]] const gl::QueryId& queryOf(std::size_t layer) const {
    return queries_[layer % kQueries];
  }

  /// Whether a layer before `next` is known to be empty: then all behind it are. Asks for the
  /// results that are there, and never waits for one.
  /// @param known layers of which it is known that they are not; moves on
  bool foundEmpty(std::size_t& known, std::size_t next) const {
    if (next > kQueries) known = std::max(known, next - kQueries);  // asked about too late
    for (; known < next; ++known) {
      const std::optional<std::uint64_t> any = gl::resultIfThere(queryOf(known).id());
      if (!any) return false;
      if (*any == 0) return true;
    }
    return false;
  }

  /// Draws the depths of the next layer, where the one before it held anything.
  void drawDepths(frame::PassContext& context, std::size_t layer) {
    const scene::GpuScene& gpu = *context.inputs().gpu;
    context.beginStep(Depths);
    gl::apply({.depthTest = true, .depthFunc = GL_GREATER, .depthWrite = true});
    std::optional<OnlyIfAny> any;
    if (layer > 0) any.emplace(queryOf(layer - 1));
    constexpr GLfloat kFarthest = 0.0F;
    glClearBufferfv(GL_DEPTH, 0, &kFarthest);
    glBeginQuery(GL_ANY_SAMPLES_PASSED, queryOf(layer).id());
    depths_.draw(gpu, gpu.transparent(), gpu.transparent().depthRuns);
    glEndQuery(GL_ANY_SAMPLES_PASSED);
  }

  void drawIds(frame::PassContext& context) {
    const scene::GpuScene& gpu = *context.inputs().gpu;
    context.beginStep(Ids);
    gl::apply({.depthTest = true, .depthFunc = GL_EQUAL});
    ids_.draw(gpu, gpu.transparent(), gpu.transparent().depthRuns);
  }

  void drawColors(frame::PassContext& context) {
    const scene::GpuScene& gpu = *context.inputs().gpu;
    context.beginStep(Colors);
    gl::apply({.depthTest = true, .depthFunc = GL_EQUAL});
    constexpr GLfloat kNone[4]{};
    glClearBufferfv(GL_COLOR, 0, kNone);
    colors_.draw(gpu, gpu.transparent(), gpu.transparent().runs);
  }

  SceneVariants depths_;
  SceneVariants ids_;
  SceneVariants colors_;
  GLuint layerProgram_ = 0;
  GLuint finishProgram_ = 0;
  std::array<gl::QueryId, kQueries> queries_;
};

}  // namespace

OitPassPtr makePeelPass(const OitPlan& plan) {
  return std::make_unique<PeelPass>(plan);
}

}  // namespace macula::passes
