#include "engine/gaze/log_format.h"

#include <array>

namespace macula::gaze {
namespace {

constexpr std::array<LogFormat, 2> kFormats{{
    {"macula-csv", "CSV with the header time_s,x,y,valid[,confidence][,pupil_mm]", isMaculaCsv,
     openMaculaCsv},
    {"tobii-studio",
     "Tobii Studio text export with the columns GazePointX, GazePointY, ValidityLeft and "
     "ValidityRight",
     isTobiiStudio, openTobiiStudio},
}};

}  // namespace

std::span<const LogFormat> logFormats() {
  return kFormats;
}

std::vector<std::string> gazeFormatNames() {
  std::vector<std::string> names;
  for (const LogFormat& format : kFormats) names.emplace_back(format.name);
  return names;
}

}  // namespace macula::gaze
