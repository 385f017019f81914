#include "engine/frame/pass_context.h"

#include <stdexcept>
#include <string>

#include "engine/frame/barriers.h"
#include "shared/bindings.h"

namespace macula::frame {
namespace {

GLenum imageAccess(Access access) {
  if (!writes(access)) return GL_READ_ONLY;
  return reads(access) ? GL_READ_WRITE : GL_WRITE_ONLY;
}

bool isTarget(const Binding& row) {
  return row.point == BindPoint::ColorTarget || row.point == BindPoint::DepthTarget;
}

}  // namespace

std::vector<std::uint32_t> slotsOf(const PassDeclaration& declaration,
                                   const FrameResources& resources) {
  std::vector<std::uint32_t> slots;
  for (const Binding& row : declaration.bindings())
    slots.push_back(resources.slotOf(*row.resource));
  return slots;
}

void PassContext::beginStep(std::uint32_t step) {
  const std::vector<Binding>& rows = declaration_->bindings();
  const GLbitfield bits = barriers_.before(rows, slots_, step);
  if (bits != 0) glMemoryBarrier(bits);
  bool draws = false;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!rows[i].active || rows[i].step != step) continue;
    bind(rows[i], slots_[i]);
    draws = draws || isTarget(rows[i]);
  }
  if (draws) bindTargets(step);
}

void PassContext::bind(const Binding& row, std::uint32_t slot) const {
  switch (row.point) {
    case BindPoint::Texture:
      glBindTextureUnit(row.unit, resources_.textureAt(slot).id());
      break;
    case BindPoint::Image: {
      const gl::Texture& texture = resources_.textureAt(slot);
      glBindImageTexture(row.unit, texture.id(), 0, GL_FALSE, 0, imageAccess(row.access),
                         texture.format());
      break;
    }
    case BindPoint::Storage: {
      const BufferRange range = resources_.bufferAt(slot);
      glBindBufferRange(GL_SHADER_STORAGE_BUFFER, row.unit, range.id(),
                        static_cast<GLintptr>(range.offset()),
                        static_cast<GLsizeiptr>(range.bytes()));
      break;
    }
    case BindPoint::Indirect:     // bound by dispatchIndirect()
    case BindPoint::ColorTarget:  // bound together, by bindTargets()
    case BindPoint::DepthTarget:
    case BindPoint::Update:
      break;
  }
}

void PassContext::bindTargets(std::uint32_t step) {
  std::array<std::uint32_t, FrameResources::kMostTargets> colors{};
  colors.fill(FrameResources::kNoSlot);
  std::uint32_t depth = FrameResources::kNoSlot;
  std::uint32_t sized = FrameResources::kNoSlot;
  const std::vector<Binding>& rows = declaration_->bindings();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!rows[i].active || rows[i].step != step || !isTarget(rows[i])) continue;
    (rows[i].point == BindPoint::DepthTarget ? depth : colors.at(rows[i].unit)) = slots_[i];
    sized = slots_[i];
  }
  glBindFramebuffer(GL_FRAMEBUFFER, resources_.framebuffer(colors, depth));
  glm::ivec2 size = declaration_->viewportOf(step);
  if (size == glm::ivec2(0)) {
    const gl::Texture& target = resources_.textureAt(sized);
    size = {target.width(), target.height()};
  }
  glViewport(0, 0, size.x, size.y);
}

void PassContext::bindConstants(Raster raster) const {
  glBindBufferBase(GL_UNIFORM_BUFFER, UBO_FRAME, constants_[static_cast<std::size_t>(raster)]);
}

void PassContext::dispatch(glm::ivec2 threads, glm::ivec2 group) const {
  const glm::ivec2 groups = (threads + group - 1) / group;
  glDispatchCompute(static_cast<GLuint>(groups.x), static_cast<GLuint>(groups.y), 1);
}

void PassContext::dispatchIndirect(const Resource& buffer, GLintptr offset) const {
  const BufferRange range = resources_.bufferAt(slotOf(buffer, BindPoint::Indirect));
  glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, range.id());
  glDispatchComputeIndirect(static_cast<GLintptr>(range.offset()) + offset);
}

void PassContext::fill(const Resource& r, std::uint32_t word) const {
  resources_.fill(slotOf(r, BindPoint::Update), word);
}

std::uint32_t PassContext::slotOf(const Resource& r, BindPoint point) const {
  const std::vector<Binding>& rows = declaration_->bindings();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (*rows[i].resource == r && rows[i].point == point) return slots_[i];
  }
  throw std::logic_error("a pass accesses " + std::string(r.name) +
                         " and does not declare that use of it");
}

}  // namespace macula::frame
