#include "engine/frame/pass_context.h"

#include "shared/bindings.h"

namespace macula::frame {

void PassContext::bindTexture(GLuint unit, Resource r) const {
  glBindTextureUnit(unit, resources_.has(r) ? resources_.texture(r).id() : 0);
}

void PassContext::bindImage(GLuint unit, Resource r, GLenum access) const {
  const gl::Texture& texture = resources_.texture(r);
  glBindImageTexture(unit, texture.id(), 0, GL_FALSE, 0, access, texture.format());
}

void PassContext::bindStorage(GLuint binding, Resource r) const {
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, resources_.buffer(r).id());
}

void PassContext::bindConstants(Raster raster) const {
  glBindBufferBase(GL_UNIFORM_BUFFER, UBO_FRAME, constants_[static_cast<std::size_t>(raster)]);
}

void PassContext::bindTargets(std::initializer_list<Resource> colors, Resource depth) const {
  const gl::Texture& sized = resources_.texture(colors.size() > 0 ? *colors.begin() : depth);
  bindTargets(colors, depth, {sized.width(), sized.height()});
}

void PassContext::bindTargets(std::initializer_list<Resource> colors, Resource depth,
                              glm::ivec2 viewport) const {
  glBindFramebuffer(GL_FRAMEBUFFER, resources_.framebuffer(colors, depth));
  glViewport(0, 0, viewport.x, viewport.y);
}

void PassContext::dispatch(glm::ivec2 threads, glm::ivec2 group) const {
  const glm::ivec2 groups = (threads + group - 1) / group;
  glDispatchCompute(static_cast<GLuint>(groups.x), static_cast<GLuint>(groups.y), 1);
}

void PassContext::dispatchIndirect(Resource buffer, GLintptr offset) const {
  glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, resources_.buffer(buffer).id());
  glDispatchComputeIndirect(offset);
}

}  // namespace macula::frame
