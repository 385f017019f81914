// What the frames of a run come to, metric by metric.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>

#include "engine/measure/frame_record.h"

namespace macula::measure {

/// Every metric of some places that has a Summary, under its key in a summary. Null where there is
/// no value.
/// @param places a sum of Place
[[nodiscard]] nlohmann::ordered_json summaryOf(std::span<const FrameRecord> frames,
                                               unsigned places);

}  // namespace macula::measure
