// The parsers of the log formats; README.md of engine/gaze has a table of what each reads.
#pragma once

#include "engine/gaze/log_format.h"

namespace macula::gaze {

[[nodiscard]] bool isMaculaCsv(std::string_view header, const LogContext& context);
[[nodiscard]] std::unique_ptr<LogParser> openMaculaCsv(std::string_view header,
                                                       const LogContext& context);

[[nodiscard]] bool isTobiiStudio(std::string_view header, const LogContext& context);
[[nodiscard]] std::unique_ptr<LogParser> openTobiiStudio(std::string_view header,
                                                         const LogContext& context);

[[nodiscard]] bool isTobiiProLab(std::string_view header, const LogContext& context);
[[nodiscard]] std::unique_ptr<LogParser> openTobiiProLab(std::string_view header,
                                                         const LogContext& context);

[[nodiscard]] bool isTobiiSdk(std::string_view header, const LogContext& context);
[[nodiscard]] std::unique_ptr<LogParser> openTobiiSdk(std::string_view header,
                                                      const LogContext& context);

[[nodiscard]] bool isPupilCore(std::string_view header, const LogContext& context);
[[nodiscard]] std::unique_ptr<LogParser> openPupilCore(std::string_view header,
                                                       const LogContext& context);

[[nodiscard]] bool isPupilNeon(std::string_view header, const LogContext& context);
[[nodiscard]] std::unique_ptr<LogParser> openPupilNeon(std::string_view header,
                                                       const LogContext& context);

[[nodiscard]] bool isEyeLink(std::string_view header, const LogContext& context);
[[nodiscard]] std::unique_ptr<LogParser> openEyeLink(std::string_view header,
                                                     const LogContext& context);

[[nodiscard]] bool isGazepoint(std::string_view header, const LogContext& context);
[[nodiscard]] std::unique_ptr<LogParser> openGazepoint(std::string_view header,
                                                       const LogContext& context);

[[nodiscard]] bool isGazeBase(std::string_view header, const LogContext& context);
[[nodiscard]] std::unique_ptr<LogParser> openGazeBase(std::string_view header,
                                                      const LogContext& context);

/// A recording without a header: its columns stand in LogContext::sidecar.
[[nodiscard]] bool isBids(std::string_view header, const LogContext& context);
[[nodiscard]] std::unique_ptr<LogParser> openBids(std::string_view header,
                                                  const LogContext& context);

}  // namespace macula::gaze
