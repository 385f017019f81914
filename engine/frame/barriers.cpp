#include "engine/frame/barriers.h"

namespace macula::frame {
namespace {

GLbitfield bitFor(Use use) {
  switch (use) {
    case Use::Texture:
      return GL_TEXTURE_FETCH_BARRIER_BIT;
    case Use::Image:
      return GL_SHADER_IMAGE_ACCESS_BARRIER_BIT;
    case Use::ImageOrTarget:
      return GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT;
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

constexpr GLbitfield kUpdates = GL_BUFFER_UPDATE_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT;

constexpr GLbitfield kAllUses = GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT |
                                GL_SHADER_STORAGE_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT |
                                GL_COMMAND_BARRIER_BIT | kUpdates;

/// Before a pass that overwrites what is stored by shaders, and so may clear it first, updates are
/// waited for, too.
GLbitfield bitsFor(const Touch& touch) {
  const bool mayClear = (touch.access == Access::Write || touch.access == Access::Scratch) &&
                        touch.use != Use::ColorTarget && touch.use != Use::DepthTarget;
  return bitFor(touch.use) | (mayClear ? kUpdates : 0);
}

bool writesIncoherently(const Touch& touch) {
  const bool writes = touch.access == Access::Write || touch.access == Access::Modify ||
                      touch.access == Access::Keep || touch.access == Access::Consume ||
                      touch.access == Access::Scratch || touch.access == Access::Carry;
  return writes &&
         (touch.use == Use::Image || touch.use == Use::ImageOrTarget || touch.use == Use::Storage);
}

}  // namespace

GLbitfield BarrierTracker::before(std::span<const Touch> touches) {
  GLbitfield bits = 0;
  for (const Touch& touch : touches) {
    bits |= pending_[static_cast<std::size_t>(touch.resource)] & bitsFor(touch);
  }
  settle(bits);
  for (const Touch& touch : touches) {
    if (writesIncoherently(touch)) pending_[static_cast<std::size_t>(touch.resource)] = kAllUses;
  }
  return bits;
}

GLbitfield BarrierTracker::beforeClear(Resource resource) {
  return settle(pending_[static_cast<std::size_t>(resource)] & kUpdates);
}

/// A barrier covers all memory, so the issued bits are settled for every resource.
GLbitfield BarrierTracker::settle(GLbitfield bits) {
  for (GLbitfield& pending : pending_) pending &= ~bits;
  return bits;
}

}  // namespace macula::frame
