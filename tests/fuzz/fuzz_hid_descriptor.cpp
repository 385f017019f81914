// Any bytes as a HID report descriptor: refused with an InputError of one line, or fields that lie
// within their reports and a layout that reads no further.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string_view>

#include "engine/core/error.h"
#include "engine/gaze/hid/layout.h"

namespace {

using namespace macula::gaze::hid;

void require(bool holds) {
  if (!holds) std::abort();
}

void requireWithin(const Scalar& scalar, std::size_t bytes) {
  require(scalar.bits > 0 && scalar.bits <= 64 && scalar.endBit() <= bytes * 8);
}

void requireWithin(const std::optional<ReportScalar>& scalar) {
  if (scalar) requireWithin(scalar->value, scalar->bytes);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const Descriptor descriptor = parseDescriptor({data, size}, "fuzz");
    require(descriptor.fields.size() <= kMaxFields);
    require(descriptor.collections.size() <= kMaxDescriptorBytes);
    const Field* last = nullptr;
    std::size_t bytes = 0;
    for (const Field& field : descriptor.fields) {
      if (last == nullptr || last->kind != field.kind || last->reportId != field.reportId) {
        bytes = descriptor.reportBytes(field.kind, field.reportId);
      }
      last = &field;
      const std::size_t end = std::size_t{field.bitOffset} + field.bitSize;
      require(field.bitSize > 0 && end + (descriptor.numbered ? 8 : 0) <= bytes * 8);
      require(bytes <= kMaxReportBytes + 1);
      require(field.collection < static_cast<std::int32_t>(descriptor.collections.size()));
    }
    for (std::size_t i = 0; i < descriptor.collections.size(); ++i) {
      require(descriptor.collections[i].parent < static_cast<std::int32_t>(i));
    }
    const TrackerLayout layout = layoutOf(descriptor, "fuzz");
    const std::size_t gazeBytes = layout.gaze.bytes;
    requireWithin(layout.gaze.x, gazeBytes);
    requireWithin(layout.gaze.y, gazeBytes);
    if (layout.gaze.timestamp) requireWithin(*layout.gaze.timestamp, gazeBytes);
    for (const auto& eye : {layout.gaze.leftEye, layout.gaze.rightEye}) {
      if (!eye) continue;
      for (const Scalar& axis : *eye) requireWithin(axis, gazeBytes);
    }
    requireWithin(layout.status);
    requireWithin(layout.samplingHz);
    requireWithin(layout.quality);
    requireWithin(layout.screenWidth);
    requireWithin(layout.screenHeight);
    requireWithin(layout.modeRequest);
  } catch (const macula::InputError& error) {
    require(std::string_view(error.what()).find('\n') == std::string_view::npos);
  }
  return 0;
}
