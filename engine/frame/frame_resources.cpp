#include "engine/frame/frame_resources.h"

#include <algorithm>
#include <cassert>
#include <glm/gtc/type_ptr.hpp>
#include <stdexcept>
#include <string>

#include "engine/core/error.h"
#include "engine/gl/blocking.h"

namespace macula::frame {
namespace {

bool isInteger(GLenum format) {
  return format == GL_R32UI || format == GL_RG32UI || format == GL_RGBA32UI;
}

void checkBytes(const Demand& demand, std::int64_t maxStorageBlockBytes) {
  if (static_cast<std::int64_t>(demand.bytes) <= maxStorageBlockBytes) return;
  failInput(
      "{} needs {} bytes, and this GPU takes {} in one buffer (GL_MAX_SHADER_STORAGE_BLOCK_SIZE); "
      "lower --k-ave or --oit-memory, or --size",
      demand.resource->name, demand.bytes, maxStorageBlockBytes);
}

std::size_t storageAlignment() {
  GLint bytes = 1;
  glGetIntegerv(GL_SHADER_STORAGE_BUFFER_OFFSET_ALIGNMENT, &bytes);
  return static_cast<std::size_t>(std::max(bytes, 4));  // clears go by words
}

void clearBytes(GLuint buffer, std::size_t offset, std::size_t bytes, std::uint32_t word) {
  glClearNamedBufferSubData(buffer, GL_R32UI, static_cast<GLintptr>(offset),
                            static_cast<GLsizeiptr>(bytes), GL_RED_INTEGER, GL_UNSIGNED_INT, &word);
}

}  // namespace

void BufferRange::download(void* values, std::size_t bytes) const {
  assert(bytes <= bytes_);
  buffer_->download(values, bytes, offset_);
}

bool FrameResources::makeTexture(Slot& slot, const Demand& demand) {
  gl::Texture& texture = slot.texture;
  if (texture.width() == demand.size.x && texture.height() == demand.size.y &&
      texture.samples() == demand.samples) {
    return false;
  }
  const Resource& r = *demand.resource;
  texture = {};
  texture = demand.samples > 0
                ? gl::Texture::multisample(r.name, r.format, demand.size, demand.samples)
                : gl::Texture(r.name, r.format, demand.size.x, demand.size.y);
  return true;
}

void FrameResources::makeBuffer(Slot& slot, const Demand& demand) {
  slot.bytes = demand.bytes;
  slot.transient = demand.transient;
  slot.life = demand.life;
  if (demand.transient) {
    slot.buffer = {};
  } else if (slot.buffer.bytes() != demand.bytes) {
    slot.buffer = {};
    slot.buffer = gl::Buffer(demand.resource->name, demand.bytes);
    clearBytes(slot.buffer.id(), 0, demand.bytes, 0);
  }
}

void FrameResources::placeTransients(std::span<const Demand> demands,
                                     std::int64_t maxStorageBlockBytes) {
  std::vector<TransientBuffer> buffers;
  std::vector<std::size_t> slots;
  for (std::size_t i = 0; i < demands.size(); ++i) {
    if (!demands[i].transient) continue;
    buffers.push_back({demands[i].bytes, demands[i].life});
    slots.push_back(i);
  }
  TransientPlan plan = frame::placeTransients(buffers, storageAlignment(),
                                              static_cast<std::size_t>(maxStorageBlockBytes));
  for (std::size_t i = 0; i < slots.size(); ++i) slots_[slots[i]].place = plan.places[i];
  if (plan.blockBytes == transients_.blockBytes) {
    transients_ = std::move(plan);
    return;
  }
  transients_ = {};
  blocks_.clear();
  for (const std::size_t bytes : plan.blockBytes) {
    blocks_.emplace_back("transient buffers", bytes);
    clearBytes(blocks_.back().id(), 0, bytes, 0);
  }
  transients_ = std::move(plan);
}

void FrameResources::allocate(std::span<const Demand> demands, std::int64_t maxStorageBlockBytes) {
  for (const Demand& demand : demands) {
    if (demand.resource->isBuffer()) checkBytes(demand, maxStorageBlockBytes);
  }
  framebuffers_.clear();
  // What stays keeps its memory; everything else is released before anything is made.
  std::vector<Slot> slots(demands.size());
  for (std::size_t i = 0; i < demands.size(); ++i) {
    const std::uint32_t old = slotOf(*demands[i].resource);
    if (old != kNoSlot) slots[i] = std::move(slots_[old]);
    slots[i].resource = demands[i].resource;
  }
  slots_ = std::move(slots);
  slotByResource_.clear();
  for (std::uint32_t i = 0; i < slots_.size(); ++i) slotByResource_[slots_[i].resource] = i;
  for (std::uint32_t i = 0; i < slots_.size(); ++i) {
    Slot& slot = slots_[i];
    if (slot.resource->isBuffer()) {
      makeBuffer(slot, demands[i]);
    } else if (makeTexture(slot, demands[i]) && slot.resource->initial != Initial::Undefined) {
      clear(i);
    }
  }
  placeTransients(demands, maxStorageBlockBytes);
  countBytes();
}

std::uint32_t FrameResources::slotOf(const Resource& r) const {
  const auto found = slotByResource_.find(&r);
  return found == slotByResource_.end() ? kNoSlot : found->second;
}

const gl::Texture& FrameResources::textureAt(std::uint32_t slot) const {
  if (slot >= slots_.size()) throw std::logic_error("a resource that no pass declares is used");
  return slots_[slot].texture;
}

BufferRange FrameResources::bufferAt(std::uint32_t slot) const {
  if (slot >= slots_.size()) throw std::logic_error("a resource that no pass declares is used");
  const Slot& s = slots_[slot];
  if (s.transient) return {blocks_[s.place.block], s.place.offset, s.bytes};
  return {s.buffer, 0, s.bytes};
}

std::vector<MemoryRange> FrameResources::memory() const {
  std::vector<MemoryRange> ranges;
  for (std::uint32_t i = 0; i < slots_.size(); ++i) {
    const Slot& s = slots_[i];
    // Blocks of transient buffers are numbered after the slots.
    ranges.push_back(
        s.transient ? MemoryRange{slots() + s.place.block, s.place.offset, s.place.offset + s.bytes}
                    : MemoryRange{i, 0, 1});
  }
  return ranges;
}

std::vector<const Resource*> FrameResources::list() const {
  std::vector<const Resource*> all;
  for (const Slot& slot : slots_) all.push_back(slot.resource);
  return all;
}

std::uint64_t FrameResources::bytesOf(const Resource& r) const {
  const std::uint32_t slot = slotOf(r);
  if (slot == kNoSlot) return 0;
  return r.isBuffer() ? slots_[slot].bytes : slots_[slot].texture.bytes();
}

void FrameResources::countBytes() {
  std::uint32_t passes = 1;
  for (const Slot& slot : slots_) passes = std::max(passes, slot.life.last + 1);
  const auto largest = [&](std::initializer_list<ByteClass> kinds) {
    std::uint64_t most = 0;
    for (std::uint32_t pass = 0; pass < passes; ++pass) {
      std::uint64_t sum = 0;
      for (const Slot& slot : slots_) {
        const bool alive = !slot.transient || slot.life.meets({pass, pass});
        const bool counts =
            std::find(kinds.begin(), kinds.end(), slot.resource->bytes) != kinds.end();
        if (counts && alive) sum += bytesOf(*slot.resource);
      }
      most = std::max(most, sum);
    }
    return most;
  };
  const std::uint64_t oit = largest({ByteClass::Oit});
  bytes_ = {.oit = oit,
            .overhead = largest({ByteClass::Oit, ByteClass::Overhead}) - oit,
            .gbuffer = largest({ByteClass::GBuffer}),
            .other = largest({ByteClass::Other})};
  for (const Slot& slot : slots_) bytes_.total += slot.texture.bytes() + slot.buffer.bytes();
  for (const gl::Buffer& block : blocks_) bytes_.total += block.bytes();
}

/// The formats of targets are GL's required ones, but which go together is for the driver to say.
void FrameResources::refuseTargets(const std::array<std::uint32_t, kMostTargets>& colors,
                                   std::uint32_t depth, GLenum status) const {
  std::string names;
  const auto add = [&](std::uint32_t slot) {
    if (slot == kNoSlot) return;
    names += (names.empty() ? "" : ", ") + std::string(resourceAt(slot).name);
  };
  for (const std::uint32_t slot : colors) add(slot);
  add(depth);
  failInput(
      "this GPU does not draw to these together: {} (framebuffer status 0x{:04X}); use "
      "another --method or driver",
      names, status);
}

GLuint FrameResources::framebuffer(const std::array<std::uint32_t, kMostTargets>& colors,
                                   std::uint32_t depth) {
  for (const Framebuffer& made : framebuffers_) {
    if (made.depth == depth && made.colors == colors) return made.id.id();
  }
  GLuint id = 0;
  glCreateFramebuffers(1, &id);
  gl::FramebufferId owner(id);
  std::array<GLenum, kMostTargets> outputs{};
  GLsizei used = 0;
  for (std::size_t i = 0; i < kMostTargets; ++i) {
    outputs[i] = GL_NONE;
    if (colors[i] == kNoSlot) continue;
    outputs[i] = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i);
    glNamedFramebufferTexture(id, outputs[i], textureAt(colors[i]).id(), 0);
    used = static_cast<GLsizei>(i) + 1;
  }
  glNamedFramebufferDrawBuffers(id, used, outputs.data());
  if (depth != kNoSlot) {
    const gl::Texture& texture = textureAt(depth);
    const bool stencil = texture.format() == GL_DEPTH32F_STENCIL8;
    glNamedFramebufferTexture(id, stencil ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT,
                              texture.id(), 0);
  }
  const GLenum status = glCheckNamedFramebufferStatus(id, GL_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE) refuseTargets(colors, depth, status);
  framebuffers_.push_back({colors, depth, std::move(owner)});
  return id;
}

void FrameResources::upload(const Resource& r, const void* values, std::size_t bytes) {
  Slot& slot = slots_.at(slotOf(r));
  assert(bytes <= slot.bytes);
  if (slot.transient) {
    blocks_[slot.place.block].upload(values, bytes, slot.place.offset);
  } else {
    slot.buffer.upload(values, bytes);
  }
}

void FrameResources::fill(std::uint32_t slot, std::uint32_t word) const {
  if (resourceAt(slot).isBuffer()) {
    const BufferRange range = bufferAt(slot);
    clearBytes(range.id(), range.offset(), range.bytes(), word);
  } else {
    glClearTexImage(textureAt(slot).id(), 0, GL_RED_INTEGER, GL_UNSIGNED_INT, &word);
  }
}

void FrameResources::clear(std::uint32_t slot) const {
  const Resource& r = resourceAt(slot);
  if (r.isBuffer()) {
    fill(slot, 0);
    return;
  }
  const GLuint id = textureAt(slot).id();
  if (r.initial == Initial::Background) {
    const glm::vec4 value(background_, 1.0F);
    glClearTexImage(id, 0, GL_RGBA, GL_FLOAT, glm::value_ptr(value));
  } else if (r.format == GL_DEPTH_COMPONENT32F) {
    glClearTexImage(id, 0, GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
  } else if (isInteger(r.format)) {
    const GLenum channels = r.format == GL_RGBA32UI ? GL_RGBA_INTEGER
                            : r.format == GL_RG32UI ? GL_RG_INTEGER
                                                    : GL_RED_INTEGER;
    glClearTexImage(id, 0, channels, GL_UNSIGNED_INT, nullptr);
  } else {
    glClearTexImage(id, 0, GL_RGBA, GL_FLOAT, nullptr);
  }
}

void FrameResources::read(const Resource& r, GLenum format, GLenum type, std::size_t bytes,
                          void* texels) const {
  gl::readTexture(textureFor(r, GL_TEXTURE_UPDATE_BARRIER_BIT).id(), {format, type}, bytes, texels);
}

const gl::Texture& FrameResources::textureFor(const Resource& r, GLbitfield use) const {
  glMemoryBarrier(use);
  return texture(r);
}

}  // namespace macula::frame
