#include "passes/heatmap_pass.h"

#include <algorithm>

#include "shared/bindings.h"
#include "shared/dispatch.h"
#include "shared/lod_totals.h"

namespace macula::passes {

using frame::Resource;
using frame::Use;

namespace {

constexpr glm::ivec2 kGroup{FULLSCREEN_GROUP};

constexpr std::string_view kRateMap = "shading-rate";

struct Map {
  std::string_view name;
  Resource source;
  std::string_view channel;  ///< SOURCE_CHANNEL of the shader
};

constexpr std::array kMaps{
    Map{"k", Resource::FragmentRange, "g"},
    Map{"depth-complexity", Resource::FragmentCount, "r"},
    Map{"importance", Resource::ImportanceFactors, "a"},
    Map{"periphery", Resource::ImportanceFactors, "r"},
    Map{"depth-factor", Resource::ImportanceFactors, "g"},
    Map{"fresnel", Resource::ImportanceFactors, "b"},
    Map{kRateMap, Resource::ShadingRate, "r"},
};

const Map* find(const std::string& name) {
  const auto it =
      std::find_if(kMaps.begin(), kMaps.end(), [&](const Map& map) { return map.name == name; });
  return it == kMaps.end() ? nullptr : &*it;
}

/// Whether the plans make what the map shows.
bool isMade(const Map& map, const OitPlan& plan, const LodPlan& lod) {
  if (map.name == kRateMap) return lod.wanted && lod.foveated;
  if (map.source == Resource::FragmentRange) return plan.method->hasRanges();
  if (map.source == Resource::FragmentCount) return plan.method->counts();
  return plan.mapsImportance();
}

}  // namespace

std::vector<std::string> heatmapNames() {
  std::vector<std::string> names{"none"};
  for (const Map& map : kMaps) names.emplace_back(map.name);
  return names;
}

bool needsFactors(const std::string& name) {
  const Map* map = find(name);
  return map != nullptr && map->source == Resource::ImportanceFactors;
}

double heatmapRange(const HeatmapPass::Settings& settings, const OitPlan& plan) {
  if (needsFactors(settings.map)) return 1.0;
  if (settings.map == kRateMap) return LOD_RATES - 1;
  if (settings.range > 0.0) return settings.range;
  constexpr double kLeast = 4.0;  // so that a picture of one layer is not all hot
  if (settings.map == "k") return std::max(kLeast, static_cast<double>(plan.largestLayers));
  return std::max(kLeast, static_cast<double>(plan.layerLimit));
}

void HeatmapPass::declare(frame::PassDeclaration& d) const {
  const Map* map = find(settings_.map);
  if (map == nullptr || !isMade(*map, plan_, lod_)) return;
  d.reads(map->source, Use::Texture);
  d.modifies(Resource::DisplayColor, Use::Image);
}

bool HeatmapPass::hasWork(const frame::FrameInputs& in) const {
  const Map* map = find(settings_.map);
  if (map == nullptr || !isMade(*map, plan_, lod_)) return false;
  return map->name == kRateMap || in.facts.transparentTriangles > 0;
}

std::string HeatmapPass::reason(const frame::FrameInputs& in) const {
  const Map* map = find(settings_.map);
  if (map == nullptr) return "no heat map is shown";
  if (!isMade(*map, plan_, lod_)) {
    return map->name == kRateMap ? "shading is not foveated"
                                 : "the method does not make this quantity";
  }
  return hasWork(in) ? "a heat map is shown" : "nothing transparent";
}

void HeatmapPass::prepare(const frame::FrameInputs& /*in*/, gl::ProgramCache& programs) {
  const Map& map = *find(settings_.map);
  gl::Defines defines{{"SOURCE_CHANNEL", std::string(map.channel)}};
  if (map.source == Resource::FragmentRange) defines.emplace_back("SOURCE_INTEGER", "1");
  if (map.name == kRateMap) defines = {{"SOURCE_RATE", "1"}};
  program_ = programs.get({{"heatmap.comp"}, defines, {}});
}

void HeatmapPass::execute(frame::PassContext& context) {
  glUseProgram(program_);
  glUniform1f(0, static_cast<float>(heatmapRange(settings_, plan_)));
  glUniform1i(1, samplesPerAxis_);
  const Resource source = find(settings_.map)->source;
  if (source == Resource::FragmentRange) glUniform1ui(2, plan_.tailSlots());
  if (source != Resource::ShadingRate) {
    const glm::vec2 texels = glm::vec2(plan_.size) / glm::vec2(plan_.imageSize);
    glUniform2f(4, texels.x, texels.y);
  }
  if (source == Resource::ShadingRate) {
    glUniform1f(3, static_cast<float>(static_cast<double>(samplesPerAxis_) / lod_.resize));
  }
  context.bindTexture(TEX_INPUT0, source);
  context.bindImage(IMG_0, Resource::DisplayColor, GL_READ_WRITE);
  context.dispatch(context.inputs().outputSize, kGroup);
}

}  // namespace macula::passes
