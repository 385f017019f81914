#include "passes/oit/peel_pass.h"

#include "engine/gl/render_state.h"
#include "shared/bindings.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

bool PeelPass::wanted() const {
  return plan_.method->insertion == Insertion::Peeled;
}

void PeelPass::declareWork(frame::PassDeclaration& d) const {
  d.reads(Resource::ShadowMap, Use::Texture);
  readsDepth(d, Use::Texture);
  d.uses(Resource::PeelDepth, Use::DepthTarget);
  d.uses(Resource::PeelIds, Use::Image);
  d.uses(Resource::PeelColor, Use::ColorTarget);
  d.uses(Resource::PeelLast, Use::Image);
  d.uses(Resource::PeelSum, Use::Image);
  modifiesColor(d, Use::Image);
}

void PeelPass::prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) {
  const auto& transparent = in.gpu->transparent();
  gl::Defines vertex{{"POSITION_ONLY", "1"}, {"WITH_IDS", "1"}};
  vertex.emplace_back("STAGE_DEPTH", "1");
  depths_.prepare(transparent.depthRuns, "oit/peel.frag", vertex, {}, programs);
  vertex.back() = {"STAGE_IDS", "1"};
  ids_.prepare(transparent.depthRuns, "oit/peel.frag", vertex, {}, programs);
  gl::Defines shading = lightingDefines(in.facts);
  shading.emplace_back("STAGE_COLOR", "1");
  colors_.prepare(transparent.runs, "oit/peel.frag", shading, {}, programs);
  layerProgram_ = programs.get({{"oit/peel_layer.comp"}, {}, {}});
  finishProgram_ = programs.get({{"oit/peel_layer.comp"}, {{"FINISH", "1"}}, {}});
  if (!query_) {
    GLuint id = 0;
    glCreateQueries(GL_ANY_SAMPLES_PASSED, 1, &id);
    query_ = gl::QueryId(id);
  }
}

bool PeelPass::drawDepths(frame::PassContext& context) {
  const scene::GpuScene& gpu = *context.inputs().gpu;
  bindTargets(context, {}, Resource::PeelDepth);
  gl::apply({.depthTest = true, .depthFunc = GL_GREATER, .depthWrite = true});
  constexpr GLfloat kFarthest = 0.0F;
  glClearBufferfv(GL_DEPTH, 0, &kFarthest);
  glBeginQuery(GL_ANY_SAMPLES_PASSED, query_.id());
  depths_.draw(gpu, gpu.transparent(), gpu.transparent().depthRuns);
  glEndQuery(GL_ANY_SAMPLES_PASSED);
  GLuint any = 0;
  glGetQueryObjectuiv(query_.id(), GL_QUERY_RESULT, &any);
  return any != 0;
}

void PeelPass::drawIds(frame::PassContext& context) {
  const scene::GpuScene& gpu = *context.inputs().gpu;
  constexpr GLuint kNobody = NO_KEY;
  glClearTexSubImage(context.resources().texture(Resource::PeelIds).id(), 0, 0, 0, 0, plan_.size.x,
                     plan_.size.y, 1, GL_RED_INTEGER, GL_UNSIGNED_INT, &kNobody);
  gl::apply({.depthTest = true, .depthFunc = GL_EQUAL});
  ids_.draw(gpu, gpu.transparent(), gpu.transparent().depthRuns);
  // For the colours of this layer, and for the clear before the ids of the next.
  glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT);
}

void PeelPass::drawColors(frame::PassContext& context) {
  const scene::GpuScene& gpu = *context.inputs().gpu;
  bindTargets(context, {Resource::PeelColor}, Resource::PeelDepth);
  constexpr GLfloat kNone[4]{};
  glClearBufferfv(GL_COLOR, 0, kNone);
  gpu.bindLights();
  context.bindTexture(TEX_SHADOW_MAP, Resource::ShadowMap);
  colors_.draw(gpu, gpu.transparent(), gpu.transparent().runs);
}

void PeelPass::composite(frame::PassContext& context, GLuint program) {
  glUseProgram(program);
  context.bindTexture(TEX_INPUT1, Resource::PeelDepth);
  context.bindTexture(TEX_INPUT2, Resource::PeelColor);
  context.bindImage(IMG_2, Resource::PeelSum, GL_READ_WRITE);
  context.bindImage(IMG_3, plan_.color(), GL_READ_WRITE);
  context.dispatch(plan_.size, kFullScreenGroup);
  glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

// The barriers in here order the steps of one layer; those around the pass follow from what it
// declares.
void PeelPass::run(frame::PassContext& context) {
  const frame::FrameResources& resources = context.resources();
  constexpr GLfloat kClear[4]{0.0F, 0.0F, 0.0F, 1.0F};
  glClearTexImage(resources.texture(Resource::PeelSum).id(), 0, GL_RGBA, GL_FLOAT, kClear);
  glClearTexImage(resources.texture(Resource::PeelLast).id(), 0, GL_RG_INTEGER, GL_UNSIGNED_INT,
                  nullptr);
  context.bindTexture(TEX_INPUT0, plan_.depth());
  context.bindImage(IMG_0, Resource::PeelLast, GL_READ_WRITE);
  context.bindImage(IMG_1, Resource::PeelIds, GL_READ_WRITE);
  for (int layer = 0; layer < plan_.options.layers; ++layer) {
    if (!drawDepths(context)) break;
    drawIds(context);
    drawColors(context);
    composite(context, layerProgram_);
  }
  composite(context, finishProgram_);
}

}  // namespace macula::passes
