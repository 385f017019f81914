// Reports from any bytes. The first byte chooses the descriptor; then come reports, each behind a
// byte that says its length. Each is garbage, or a sample that keeps its promises.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "engine/gaze/hid/session.h"
#include "tests/hid/tracker_descriptor.h"

namespace {

using namespace macula::gaze::hid;

void require(bool holds) {
  if (!holds) std::abort();
}

TrackerLayout layoutFor(const testing::TrackerVariant& variant) {
  return layoutOf(parseDescriptor(testing::trackerDescriptor(variant), "fuzz"), "fuzz");
}

const std::array<TrackerLayout, 5>& layouts() {
  static const std::array all{
      layoutFor({}), layoutFor({.wideTimestamp = true, .padBytes = 7}),
      layoutFor({.flags = testing::kDataVariable, .gazeMax = 500'000}),
      layoutFor({.configuration = false}),
      readProfile(MACULA_SOURCE_DIR "/assets/trackers/example.toml").layout};
  return all;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::span<const std::uint8_t> rest(data, size);
  if (rest.empty()) return 0;
  Session session(layouts()[rest.front() % layouts().size()], TrackerChoice{});
  rest = rest.subspan(1);
  if (session.layout().screenWidth) {
    session.learn(screenSize(session.layout(), rest), "");  // any bytes as the configuration too
  }
  double time = 0.0;
  while (!rest.empty()) {
    const std::size_t length = std::min<std::size_t>(rest.front(), rest.size() - 1);
    time += 0.004;
    const Session::Taken taken = session.take(rest.subspan(1, length), time);
    if (taken.kind == ReportClass::Gaze) {
      const HidSample& sample = taken.sample;
      require(length >= session.layout().gaze.bytes);
      require(!sample.valid ||
              (std::isfinite(sample.position.x) && std::isfinite(sample.position.y)));
      require(!sample.deviceSeconds || std::isfinite(*sample.deviceSeconds));
    }
    rest = rest.subspan(1 + length);
  }
  require(session.note("").find('\n') == std::string::npos);
  return 0;
}
