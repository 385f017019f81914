#include "engine/frame/barriers.h"

namespace macula::frame {
namespace {

GLbitfield bitFor(Use use) {
  switch (use) {
    case Use::Texture:
      return GL_TEXTURE_FETCH_BARRIER_BIT;
    case Use::Image:
      return GL_SHADER_IMAGE_ACCESS_BARRIER_BIT;
    case Use::Storage:
      return GL_SHADER_STORAGE_BARRIER_BIT;
    case Use::Indirect:
      return GL_COMMAND_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT;
    case Use::ColorTarget:
    case Use::DepthTarget:
      return GL_FRAMEBUFFER_BARRIER_BIT;
  }
  return 0;
}

constexpr GLbitfield kAllUses = GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT |
                                GL_SHADER_STORAGE_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT |
                                GL_COMMAND_BARRIER_BIT;

bool writesIncoherently(const Touch& touch) {
  const bool writes = touch.access == Access::Write || touch.access == Access::Modify ||
                      touch.access == Access::Keep || touch.access == Access::Consume ||
                      touch.access == Access::Scratch || touch.access == Access::Carry;
  return writes && (touch.use == Use::Image || touch.use == Use::Storage);
}

}  // namespace

GLbitfield BarrierTracker::before(std::span<const Touch> touches) {
  GLbitfield bits = 0;
  for (const Touch& touch : touches) {
    bits |= pending_[static_cast<std::size_t>(touch.resource)] & bitFor(touch.use);
  }
  // A barrier covers all memory, so the issued bits are settled for every resource.
  for (GLbitfield& pending : pending_) pending &= ~bits;
  for (const Touch& touch : touches) {
    if (writesIncoherently(touch)) pending_[static_cast<std::size_t>(touch.resource)] = kAllUses;
  }
  return bits;
}

}  // namespace macula::frame
