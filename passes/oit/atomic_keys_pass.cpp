#include "passes/oit/atomic_keys_pass.h"

#include "engine/gl/render_state.h"
#include "shared/bindings.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

bool AtomicKeysPass::wanted() const {
  return plan_.method->insertion == Insertion::AtomicMin;
}

void AtomicKeysPass::declareWork(frame::PassDeclaration& d) const {
  readsTestedDepth(d, Use::DepthTarget);
  d.writes(Resource::FragmentKeys, Use::Storage);
}

void AtomicKeysPass::prepare(const frame::FrameInputs& in, gl::ProgramCache& programs) {
  const auto& runs = in.gpu->transparent().depthRuns;
  const gl::Defines vertex{{"POSITION_ONLY", "1"}, {"WITH_IDS", "1"}};
  gl::Defines ids = vertex;
  ids.emplace_back("STAGE_IDS", "1");
  depths_.prepare(runs, "oit/atomic_keys.frag", vertex, {}, programs);
  ids_.prepare(runs, "oit/atomic_keys.frag", ids, {}, programs);
}

void AtomicKeysPass::run(frame::PassContext& context) {
  const scene::GpuScene& gpu = *context.inputs().gpu;
  constexpr GLuint kEmpty = NO_KEY;
  glClearNamedBufferData(context.resources().buffer(Resource::FragmentKeys).id(), GL_R32UI,
                         GL_RED_INTEGER, GL_UNSIGNED_INT, &kEmpty);
  bindTargets(context, {}, plan_.testedDepth());
  gl::apply({.depthTest = true});
  context.bindStorage(SSBO_FRAGMENT_KEYS, Resource::FragmentKeys);
  depths_.draw(gpu, gpu.transparent(), gpu.transparent().depthRuns);
  // Both stages are one pass of the frame; the ids go to depths that are final.
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  ids_.draw(gpu, gpu.transparent(), gpu.transparent().depthRuns);
}

}  // namespace macula::passes
