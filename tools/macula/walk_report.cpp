#include "walk_report.h"

#include <algorithm>

namespace macula::tools {

using frame::Resource;
using nlohmann::ordered_json;

std::optional<double> meanK(const passes::FrameRenderer& renderer, glm::vec2 place,
                            int samplesPerAxis) {
  if (!renderer.resources().has(Resource::FragmentRange)) return {};
  constexpr int kHalfSide = 32;
  const gl::Texture& ranges = renderer.resources().texture(Resource::FragmentRange);
  const glm::ivec2 size(ranges.width(), ranges.height());
  // GL counts rows from the bottom.
  const glm::ivec2 center(glm::vec2(place.x, 1.0F - place.y) * glm::vec2(size));
  const int half = kHalfSide * samplesPerAxis;
  const glm::ivec2 low = glm::clamp(center - half, glm::ivec2(0), size - 1);
  const glm::ivec2 extent = glm::clamp(center + half, low + 1, size) - low;
  const std::size_t count = static_cast<std::size_t>(extent.x) * static_cast<std::size_t>(extent.y);
  std::vector<glm::uvec2> texels(count);  // first slot, k
  glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glGetTextureSubImage(ranges.id(), 0, low.x, low.y, 0, extent.x, extent.y, 1, GL_RG_INTEGER,
                       GL_UNSIGNED_INT, static_cast<GLsizei>(count * sizeof(glm::uvec2)),
                       texels.data());
  double sum = 0.0;
  for (const glm::uvec2& texel : texels) sum += texel.y;
  return sum / static_cast<double>(count);
}

ordered_json describeWalk(const passes::FrameRenderer& renderer,
                          const passes::RenderSettings& settings, const passes::FrameResult& result,
                          const gaze::PointOfInterest& point, const std::vector<glm::vec2>& probes,
                          int frames) {
  ordered_json json{{"schema", 1},
                    {"frames", frames},
                    {"width", renderer.outputSize().x},
                    {"height", renderer.outputSize().y},
                    {"method", settings.oit.method}};
  json["gaze"] = {
      {"x", point.position.x}, {"y", point.position.y}, {"state", gaze::stateName(point.state)}};
  json["ms"] = {{"total", result.totalMs}};
  for (const frame::PassTime& pass : result.passes) json["ms"][std::string(pass.name)] = pass.ms;
  json["fragments"] = nullptr;
  if (result.fragments) {
    json["fragments"] = {{"generated", result.fragments->generated},
                         {"stored", result.fragments->stored},
                         {"merged", result.fragments->merged},
                         {"lost", result.fragments->lost}};
  }
  json["k"] = nullptr;
  if (result.layers) {
    json["k"] = {
        {"min", result.layers->min}, {"max", result.layers->max}, {"mean", result.layers->mean}};
  }
  json["probes"] = ordered_json::array();
  for (const glm::vec2& probe : probes) {
    const std::optional<double> mean = meanK(renderer, probe, settings.tonemap.ssaa);
    json["probes"].push_back({{"x", probe.x}, {"y", probe.y}, {"k_mean", nullptr}});
    if (mean) json["probes"].back()["k_mean"] = *mean;
  }
  return json;
}

}  // namespace macula::tools
