#include "walk/report.h"

#include <algorithm>

#include "engine/gl/blocking.h"
#include "frame_record.h"

namespace macula::tools {

using nlohmann::ordered_json;

std::optional<double> meanK(const passes::FrameRenderer& renderer, glm::vec2 place,
                            int samplesPerAxis) {
  if (!renderer.resources().has(passes::kFragmentRange)) return {};
  constexpr int kHalfSide = 32;
  const gl::Texture& ranges =
      renderer.resources().textureFor(passes::kFragmentRange, GL_TEXTURE_UPDATE_BARRIER_BIT);
  const glm::ivec2 size(ranges.width(), ranges.height());
  // GL counts rows from the bottom.
  const glm::ivec2 center(glm::vec2(place.x, 1.0F - place.y) * glm::vec2(size));
  const int half = kHalfSide * samplesPerAxis;
  const glm::ivec2 low = glm::clamp(center - half, glm::ivec2(0), size - 1);
  const glm::ivec2 extent = glm::clamp(center + half, low + 1, size) - low;
  const std::size_t count = static_cast<std::size_t>(extent.x) * static_cast<std::size_t>(extent.y);
  std::vector<glm::uvec2> texels(count);  // first slot, k
  gl::readTexture(ranges.id(), low, extent, {GL_RG_INTEGER, GL_UNSIGNED_INT},
                  count * sizeof(glm::uvec2), texels.data());
  double sum = 0.0;
  for (const glm::uvec2& texel : texels) sum += texel.y;
  return sum / static_cast<double>(count);
}

namespace {

/// The metrics of a frame, each level of keys without any value null.
ordered_json metricsOf(const measure::FrameRecord& record) {
  ordered_json json = ordered_json::object();
  measure::addTo(json, record, measure::kWalk, measure::None::Group);
  return json;
}

ordered_json secondOf(const SecondView& second) {
  if (!second.shown()) return nullptr;
  ordered_json json{{"view", viewModeNames()[static_cast<std::size_t>(second.mode())]},
                    {"method", second.settings().oit.method},
                    {"difference_scale", second.differenceScale()}};
  const passes::FrameRenderer* renderer = second.renderer();
  json.update(metricsOf(renderer == nullptr ? measure::FrameRecord()
                                            : recordOf(*renderer, second.result())));
  if (renderer != nullptr) json["ms"]["median"] = second.time().medianMs();
  return json;
}

ordered_json errorOf(const ErrorCheck& errors) {
  if (!errors.result()) return nullptr;
  ordered_json json = measure::toJson(errors.result()->error);
  json["reference"] = errors.result()->referenceName;
  json["test"] = errors.result()->testName;
  // Of this frame, not of the report's.
  json["frame"] = errors.result()->frame;
  json["scene"] = errors.result()->scene;
  return json;
}

ordered_json controlOf(const WalkReport& report) {
  const control::Controller& controller = report.control.controller();
  const control::ControlValues& controls = controller.controls();
  ordered_json json{{"law", report.control.settings().law},
                    {"target_ms", report.control.settings().targetMs},
                    {"r", report.result.resizeFactor},
                    {"active", controller.active()},
                    {"notice", controller.notice()}};
  for (const control::ControlInfo& info : control::kControlOrder) {
    json["levers"][std::string(info.name)] = controls[info.control];
  }
  return json;
}

ordered_json placeOf(glm::vec3 place) {
  return ordered_json::array({place.x, place.y, place.z});
}

}  // namespace

ordered_json describeWalk(const WalkReport& report, const std::vector<glm::vec2>& probes) {
  const gaze::PointOfInterest& point = report.events.gaze;
  ordered_json json{{"schema", 1},
                    {"frames", report.frames},
                    {"loading_frames", report.loadingFrames},
                    {"first_image_ms", nullptr},
                    {"first_frame_ms", nullptr},
                    {"frame", report.events.index},
                    {"frames_per_second", nullptr},
                    {"blocking_calls", report.blockingCalls},
                    {"scene", report.events.scene},
                    {"width", report.events.windowSize.x},
                    {"height", report.events.windowSize.y},
                    {"method", report.settings.oit.method}};
  json["gaze"] = {{"x", point.position.x},
                  {"y", point.position.y},
                  {"state", gaze::stateName(point.state)},
                  {"source", report.gazeSource},
                  {"warnings", report.gazeWarnings}};
  json["camera"] = {{"position", placeOf(report.events.camera.position)},
                    {"target", placeOf(report.events.camera.target)},
                    {"playing", report.playing}};
  const measure::FrameRecord record = recordOf(report.renderer, report.result);
  json.update(metricsOf(record));
  for (const auto& [name, ms] : record.passMs) json["ms"][name] = ms;
  if (report.firstImageMs) json["first_image_ms"] = *report.firstImageMs;
  if (report.firstFrameMs) json["first_frame_ms"] = *report.firstFrameMs;
  if (report.framesPerSecond) json["frames_per_second"] = *report.framesPerSecond;
  json["control"] = controlOf(report);
  json["second"] = secondOf(report.second);
  json["error"] = errorOf(report.errors);
  json["tab"] = report.tab;
  json["search_hits"] = nullptr;
  if (report.searchHits) json["search_hits"] = *report.searchHits;
  json["message"] = report.message;
  json["command_line"] = report.commandLine;
  json["probes"] = ordered_json::array();
  for (const glm::vec2& probe : probes) {
    const std::optional<double> mean = meanK(report.renderer, probe, report.settings.tonemap.ssaa);
    json["probes"].push_back({{"x", probe.x}, {"y", probe.y}, {"k_mean", nullptr}});
    if (mean) json["probes"].back()["k_mean"] = *mean;
  }
  return json;
}

}  // namespace macula::tools
