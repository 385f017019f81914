// The JSON Schema of report.json, made from the table of metrics and the keys of the report.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace macula::measure {

/// Draft 2020-12. Every object is closed, but for maps of settings, buffers and passes, and every
/// key is required, but for those that say when they are absent.
[[nodiscard]] nlohmann::ordered_json reportSchema();

}  // namespace macula::measure
