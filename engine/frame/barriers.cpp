#include "engine/frame/barriers.h"

namespace macula::frame {
namespace {

constexpr GLbitfield kIncoherent =
    GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT;

constexpr GLbitfield kAllUses = kIncoherent | GL_TEXTURE_FETCH_BARRIER_BIT |
                                GL_COMMAND_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT |
                                GL_BUFFER_UPDATE_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT;

GLbitfield bitOf(const Binding& row) {
  switch (row.point) {
    case BindPoint::Texture:
      return GL_TEXTURE_FETCH_BARRIER_BIT;
    case BindPoint::Image:
      return GL_SHADER_IMAGE_ACCESS_BARRIER_BIT;
    case BindPoint::Storage:
      return GL_SHADER_STORAGE_BARRIER_BIT;
    case BindPoint::Indirect:
      return GL_COMMAND_BARRIER_BIT;
    case BindPoint::ColorTarget:
    case BindPoint::DepthTarget:
      return GL_FRAMEBUFFER_BARRIER_BIT;
    case BindPoint::Update:
      return row.resource->isBuffer() ? GL_BUFFER_UPDATE_BARRIER_BIT
                                      : GL_TEXTURE_UPDATE_BARRIER_BIT;
  }
  return 0;
}

bool isIncoherent(BindPoint point) {
  return point == BindPoint::Image || point == BindPoint::Storage;
}

}  // namespace

void BarrierTracker::setMemory(std::span<const MemoryRange> slots) {
  pending_.assign(slots.size(), {kAllUses, kAllUses});
  overlaps_.assign(slots.size(), {});
  for (std::uint32_t a = 0; a < slots.size(); ++a) {
    for (std::uint32_t b = 0; b < slots.size(); ++b) {
      if (a == b || slots[a].overlaps(slots[b])) overlaps_[a].push_back(b);
    }
  }
}

void BarrierTracker::beginFrame() {
  for (Pending& pending : pending_) pending.forWrites = kAllUses;
}

GLbitfield BarrierTracker::neededBy(const Binding& row, std::uint32_t slot) const {
  const Pending& pending = pending_[slot];
  return bitOf(row) & ((reads(row.access) ? pending.forReads : 0U) |
                       (writes(row.access) ? pending.forWrites : 0U));
}

/// A barrier covers all memory, so the issued bits are settled for every slot.
void BarrierTracker::settle(GLbitfield bits) {
  if (bits == 0) return;
  for (Pending& pending : pending_) {
    pending.forReads &= ~bits;
    pending.forWrites &= ~bits;
  }
}

void BarrierTracker::note(const Binding& row, std::uint32_t slot) {
  const bool incoherent = isIncoherent(row.point);
  for (const std::uint32_t s : overlaps_[slot]) {
    if (incoherent && writes(row.access)) pending_[s].forReads = kAllUses;
    pending_[s].forWrites |= incoherent ? kAllUses : kIncoherent;
  }
}

GLbitfield BarrierTracker::before(std::span<const Binding> rows,
                                  std::span<const std::uint32_t> slots, std::uint32_t step) {
  GLbitfield bits = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].active && rows[i].step == step) bits |= neededBy(rows[i], slots[i]);
  }
  settle(bits);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].active && rows[i].step == step) note(rows[i], slots[i]);
  }
  return bits;
}

GLbitfield BarrierTracker::beforeClear(const Resource& resource, std::uint32_t slot) {
  const Binding row{&resource, Access::Write, BindPoint::Update};
  const GLbitfield bits = neededBy(row, slot);
  settle(bits);
  note(row, slot);
  return bits;
}

}  // namespace macula::frame
