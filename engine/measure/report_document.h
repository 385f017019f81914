// docs/report.md: what every number means, made from the table of metrics and the keys of the
// report.
#pragma once

#include <string>

namespace macula::measure {

/// Markdown, ending with a newline.
[[nodiscard]] std::string reportDocument();

}  // namespace macula::measure
