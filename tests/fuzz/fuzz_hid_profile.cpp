// Any bytes as a tracker profile: an InputError of one line, or numbers that lie within the report.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "engine/core/error.h"
#include "engine/gaze/hid/profile.h"
#include "engine/gaze/hid/report.h"

namespace {

using namespace macula::gaze::hid;

void require(bool holds) {
  if (!holds) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const TrackerProfile profile = parseProfile(text, "fuzz.toml");
    const GazeReportLayout& gaze = profile.layout.gaze;
    require(gaze.bytes <= kMaxReportBytes);
    require(gaze.x.endBit() <= gaze.bytes * 8 && gaze.y.endBit() <= gaze.bytes * 8);
    require(gaze.shares != profile.screenMm.has_value());
    ReportDecoder decoder(profile.layout);
    if (profile.screenMm) decoder.setScreen(*profile.screenMm);
    std::vector<std::uint8_t> report(gaze.bytes, 0x5A);
    if (profile.layout.numbered && !report.empty()) report.front() = gaze.reportId;
    HidGazeReport sample;
    const ReportClass kind = decoder.decode(report, sample);
    require(kind == (report.empty() ? ReportClass::Garbage : ReportClass::Gaze));
  } catch (const macula::InputError& error) {
    require(std::string_view(error.what()).find('\n') == std::string_view::npos);
  }
  return 0;
}
