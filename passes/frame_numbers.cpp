#include "passes/frame_numbers.h"

#include <algorithm>

#include "passes/lod/resources.h"
#include "passes/oit/resources.h"

namespace macula::passes {
namespace {

// Places in a slot.
constexpr std::size_t kTotalsAt = 0;
constexpr std::size_t kLodAt = kTotalsAt + sizeof(shader::OitTotals);
constexpr std::size_t kStatisticsAt = kLodAt + sizeof(shader::LodTotals);
constexpr std::size_t kSlotBytes = kStatisticsAt + sizeof(shader::OitStatistics);

}  // namespace

FrameNumbers::FrameNumbers(gl::TimeSource source)
    : timer_(source), sums_("frame numbers", kSlotBytes, kSlots) {}

std::size_t FrameNumbers::take() {
  const auto* const free = std::ranges::find(taken_, false);
  if (free == taken_.end()) return kNoSlot;
  const auto slot = static_cast<std::size_t>(free - taken_.begin());
  taken_[slot] = true;
  return slot;
}

void FrameNumbers::drop() {
  taken_.fill(false);
}

void FrameNumbers::copy(std::size_t slot, const frame::FrameResources& resources) {
  const auto copy = [&](const frame::Resource& r, std::size_t bytes, std::size_t at) {
    if (!resources.has(r)) return false;
    const frame::BufferRange range = resources.buffer(r);
    sums_.copy(slot, range.id(), range.offset(), bytes, at);
    return true;
  };
  sums_.begin();
  copied_[slot] = {
      .totals = copy(kOitTotals, sizeof(shader::OitTotals), kTotalsAt),
      .lod = frames_[slot].countsHoles && copy(kLodTotals, sizeof(shader::LodTotals), kLodAt),
      .statistics = frames_[slot].statistics &&
                    copy(kOitStatistics, sizeof(shader::OitStatistics), kStatisticsAt)};
  sums_.fence(slot);
}

void FrameNumbers::wait(std::size_t slot) {
  sums_.wait(slot);
  if (frames_[slot].timed) timer_.wait(slot);
}

std::size_t FrameNumbers::ready() {
  std::size_t oldest = kNoSlot;
  for (std::size_t slot = 0; slot < kSlots; ++slot) {
    if (!taken_[slot]) continue;
    if (oldest == kNoSlot || frames_[slot].number < frames_[oldest].number) oldest = slot;
  }
  if (oldest == kNoSlot || !sums_.ready(oldest)) return kNoSlot;
  return !frames_[oldest].timed || timer_.ready(oldest) ? oldest : kNoSlot;
}

FrameSums FrameNumbers::sums(std::size_t slot) const {
  const Copied& copied = copied_[slot];
  FrameSums sums{};
  if (copied.totals) sums.totals = sums_.read<shader::OitTotals>(slot, kTotalsAt);
  if (copied.lod) sums.lod = sums_.read<shader::LodTotals>(slot, kLodAt);
  if (copied.statistics) sums.statistics = sums_.read<shader::OitStatistics>(slot, kStatisticsAt);
  return sums;
}

}  // namespace macula::passes
