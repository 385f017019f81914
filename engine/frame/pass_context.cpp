#include "engine/frame/pass_context.h"

#include <algorithm>
#include <string>

#include "engine/gl/block_check.h"
#include "shared/bindings.h"

namespace macula::frame {

void PassContext::expectDeclared(Resource r, std::initializer_list<Use> uses) const {
  if (!gl::BlockCheck::enabled() || declared_.empty()) return;
  const auto matches = [&](const Touch& touch) {
    // A pass orders the uses of its scratch itself.
    return touch.resource == r && (touch.access == Access::Scratch ||
                                   std::find(uses.begin(), uses.end(), touch.use) != uses.end());
  };
  if (std::any_of(declared_.begin(), declared_.end(), matches)) return;
  gl::BlockCheck::report("a pass binds " + std::string(nameOf(r)) +
                         " and does not declare that use of it");
}

void PassContext::bindTexture(GLuint unit, Resource r) const {
  if (resources_.has(r)) expectDeclared(r, {Use::Texture});
  glBindTextureUnit(unit, resources_.has(r) ? resources_.texture(r).id() : 0);
}

void PassContext::bindImage(GLuint unit, Resource r, GLenum access) const {
  expectDeclared(r, {Use::Image, Use::ImageOrTarget});
  const gl::Texture& texture = resources_.texture(r);
  glBindImageTexture(unit, texture.id(), 0, GL_FALSE, 0, access, texture.format());
}

void PassContext::bindStorage(GLuint binding, Resource r) const {
  expectDeclared(r, {Use::Storage, Use::Indirect});
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
  for (const Resource color : colors) {
    expectDeclared(color, {Use::ColorTarget, Use::ImageOrTarget});
  }
  // No shader stores depth, so nothing needs to be waited for between these two uses of it.
  if (depth != Resource::Count) expectDeclared(depth, {Use::DepthTarget, Use::Texture});
  glBindFramebuffer(GL_FRAMEBUFFER, resources_.framebuffer(colors, depth));
  glViewport(0, 0, viewport.x, viewport.y);
}

void PassContext::dispatch(glm::ivec2 threads, glm::ivec2 group) const {
  const glm::ivec2 groups = (threads + group - 1) / group;
  gl::BlockCheck::beforeUse();
  glDispatchCompute(static_cast<GLuint>(groups.x), static_cast<GLuint>(groups.y), 1);
}

void PassContext::dispatchIndirect(Resource buffer, GLintptr offset) const {
  expectDeclared(buffer, {Use::Indirect});
  glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, resources_.buffer(buffer).id());
  gl::BlockCheck::beforeUse();
  glDispatchComputeIndirect(offset);
}

}  // namespace macula::frame
