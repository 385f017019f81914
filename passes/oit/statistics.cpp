#include "passes/oit/statistics.h"

#include "passes/oit/oit_pass.h"
#include "shared/bindings.h"

namespace macula::passes {

using frame::Resource;

void OitStatisticsCounter::prepare(const frame::FrameInputs& in,
                                   const frame::FrameResources& resources,
                                   gl::ProgramCache& programs) {
  const Method& method = *plan_.method;
  gl::Defines defines;
  if (method.hasRanges()) defines.emplace_back("SLOTS_RANGES", "1");
  if (method.fills()) defines.emplace_back("FILLS", "1");
  program_ = programs.get({{"oit/statistics.comp"}, defines, {}});
  if (!sums_) sums_ = gl::Buffer("transparency statistics", sizeof(shader::OitStatistics));
  if (method.counts() && !plan_.predictsCounts()) {
    counts_ = {};
    return;
  }
  count_.prepare(in, programs);
  if (counts_.width() != plan_.imageSize.x || counts_.height() != plan_.imageSize.y) {
    counts_ = {};
    counts_ = gl::Texture("statistics counts", GL_R32F, plan_.imageSize.x, plan_.imageSize.y);
  }
  const auto targetsWith = [&](Resource depth) {
    GLuint id = 0;
    glCreateFramebuffers(1, &id);
    glNamedFramebufferTexture(id, GL_COLOR_ATTACHMENT0, counts_.id(), 0);
    glNamedFramebufferTexture(id, GL_DEPTH_ATTACHMENT, resources.texture(depth).id(), 0);
    return gl::FramebufferId(id);
  };
  framebuffer_ = targetsWith(Resource::Depth);
  if (plan_.resizable) resizedFramebuffer_ = targetsWith(Resource::ResizedDepth);
}

shader::OitStatistics OitStatisticsCounter::measure(frame::PassContext& context) {
  if (plan_.resized()) context.bindConstants(frame::Raster::Resized);
  if (counts_) {
    glBindFramebuffer(GL_FRAMEBUFFER, (plan_.resized() ? resizedFramebuffer_ : framebuffer_).id());
    glViewport(0, 0, plan_.size.x, plan_.size.y);
    count_.draw(*context.inputs().gpu);
  }
  glMemoryBarrier(GL_ALL_BARRIER_BITS);
  glClearNamedBufferData(sums_.id(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
  glUseProgram(program_);
  glUniform1ui(0, plan_.hasTail() ? plan_.tailSlots() : 0U);
  if (counts_) {
    glBindTextureUnit(TEX_INPUT0, counts_.id());
  } else {
    context.bindTexture(TEX_INPUT0, Resource::FragmentCount);
  }
  if (plan_.method->hasRanges()) context.bindTexture(TEX_INPUT1, Resource::FragmentRange);
  if (plan_.method->fills()) context.bindTexture(TEX_INPUT2, Resource::FragmentFill);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SSBO_OIT_STATISTICS, sums_.id());
  dispatchStrips(context, plan_.size);
  if (plan_.resized()) context.bindConstants(frame::Raster::Image);
  shader::OitStatistics result{};
  sums_.download(&result, sizeof(result));
  return result;
}

}  // namespace macula::passes
