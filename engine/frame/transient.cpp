#include "engine/frame/transient.h"

#include <algorithm>
#include <numeric>

namespace macula::frame {
namespace {

std::size_t alignedUp(std::size_t offset, std::size_t alignment) {
  return (offset + alignment - 1) / alignment * alignment;
}

/// Places one buffer after another.
class Placement {
 public:
  Placement(std::span<const TransientBuffer> buffers, std::size_t alignment)
      : buffers_(buffers), alignment_(alignment) {
    plan_.places.resize(buffers.size());
  }

  void place(std::size_t index, std::size_t mostBytes) {
    const std::size_t bytes = buffers_[index].bytes;
    std::uint32_t block = 0;
    std::size_t offset = 0;
    for (; block < plan_.blockBytes.size(); ++block) {
      offset = lowestFree(index, block);
      if (offset + bytes <= mostBytes) break;
    }
    if (block == plan_.blockBytes.size()) {
      plan_.blockBytes.push_back(0);
      offset = 0;
    }
    plan_.blockBytes[block] = std::max(plan_.blockBytes[block], offset + bytes);
    plan_.places[index] = {block, offset};
    placed_.push_back(index);
  }

  TransientPlan finish() { return std::move(plan_); }

 private:
  /// Lowest offset in a block at which no buffer lies that lives at the same time.
  [[nodiscard]] std::size_t lowestFree(std::size_t index, std::uint32_t block) const {
    std::vector<std::size_t> others;
    for (const std::size_t i : placed_) {
      const bool meets = buffers_[i].life.meets(buffers_[index].life);
      if (plan_.places[i].block == block && meets) others.push_back(i);
    }
    std::sort(others.begin(), others.end(), [&](std::size_t a, std::size_t b) {
      return plan_.places[a].offset < plan_.places[b].offset;
    });
    std::size_t offset = 0;
    for (const std::size_t i : others) {
      const std::size_t begin = plan_.places[i].offset;
      if (offset + buffers_[index].bytes <= begin) break;
      offset = std::max(offset, alignedUp(begin + buffers_[i].bytes, alignment_));
    }
    return offset;
  }

  std::span<const TransientBuffer> buffers_;
  std::size_t alignment_;
  TransientPlan plan_;
  std::vector<std::size_t> placed_;
};

}  // namespace

TransientPlan placeTransients(std::span<const TransientBuffer> buffers, std::size_t alignment,
                              std::size_t mostBytes) {
  std::vector<std::size_t> order(buffers.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return buffers[a].bytes > buffers[b].bytes;
  });
  Placement placement(buffers, alignment);
  for (const std::size_t index : order) placement.place(index, mostBytes);
  return placement.finish();
}

std::size_t largestSumAlive(std::span<const TransientBuffer> buffers) {
  std::size_t largest = 0;
  // A sum only grows where a life begins.
  for (const TransientBuffer& at : buffers) {
    std::size_t sum = 0;
    for (const TransientBuffer& buffer : buffers) {
      if (buffer.life.meets({at.life.first, at.life.first})) sum += buffer.bytes;
    }
    largest = std::max(largest, sum);
  }
  return largest;
}

}  // namespace macula::frame
