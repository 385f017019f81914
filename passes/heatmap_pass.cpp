#include "passes/heatmap_pass.h"

#include <algorithm>
#include <array>

#include "passes/lod/resources.h"
#include "passes/resources.h"
#include "shared/bindings.h"
#include "shared/dispatch.h"
#include "shared/lod_totals.h"

namespace macula::passes {

namespace {

constexpr glm::ivec2 kGroup{FULLSCREEN_GROUP};

constexpr std::string_view kRateMap = "shading-rate";

struct Map {
  std::string_view name;
  const frame::Resource* source;
  std::string_view channel;  ///< SOURCE_CHANNEL of the shader
  const char* quantity;      ///< for the legend
};

constexpr std::array kMaps{
    Map{"k", &kFragmentRange, "g", "k(p): slots of each sample"},
    Map{"depth-complexity", &kFragmentCount, "r", "transparent fragments of each sample"},
    Map{"importance", &kImportanceFactors, "a", "importance, Eq. 6"},
    Map{"periphery", &kImportanceFactors, "r", "periphery factor, Eq. 4"},
    Map{"depth-factor", &kImportanceFactors, "g", "depth complexity factor, Eq. 3"},
    Map{"fresnel", &kImportanceFactors, "b", "Fresnel factor, Eq. 5"},
    Map{kRateMap, &kShadingRate, "r",
        "log2 of the texels a side that share a sample of the shading"},
};

const Map* find(const std::string& name) {
  const auto it =
      std::find_if(kMaps.begin(), kMaps.end(), [&](const Map& map) { return map.name == name; });
  return it == kMaps.end() ? nullptr : &*it;
}

/// Whether the plans make what the map shows.
bool isMade(const Map& map, const OitPlan& plan, const LodPlan& lod) {
  if (map.name == kRateMap) return lod.wanted && lod.foveated;
  if (*map.source == kFragmentRange) return plan.method->hasRanges();
  if (*map.source == kFragmentCount) return plan.method->counts();
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
  return map != nullptr && *map->source == kImportanceFactors;
}

double heatmapRange(const HeatmapPass::Settings& settings, const OitPlan& plan) {
  if (needsFactors(settings.map)) return 1.0;
  if (settings.map == kRateMap) return LOD_RATES - 1;
  if (settings.range > 0.0) return settings.range;
  constexpr double kLeast = 4.0;  // so that a picture of one layer is not all hot
  if (settings.map == "k") return std::max(kLeast, static_cast<double>(plan.largestLayers));
  return std::max(kLeast, static_cast<double>(plan.layerLimit));
}

bool rangeFollowsFrames(const HeatmapPass::Settings& settings) {
  if (settings.map == "none" || settings.map == kRateMap) return false;
  return settings.range <= 0.0 && !needsFactors(settings.map);
}

image::Legend legendOf(const HeatmapPass::Settings& settings, double range) {
  const Map& map = *find(settings.map);
  const bool counts = *map.source == kFragmentRange || *map.source == kFragmentCount;
  image::Legend legend{map.quantity, range, counts};
  if (map.name == kRateMap) legend.grey.clear();
  return legend;
}

void HeatmapPass::declare(frame::PassDeclaration& d, const frame::FrameInputs& /*in*/) const {
  d.texture(TEX_INPUT0, *find(settings_.map)->source);
  d.image(IMG_0, kDisplayColor, frame::Access::Read);
  d.image(IMG_1, kHeatmapColor, frame::Access::Write);
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
  if (*map.source == kFragmentRange) defines.emplace_back("SOURCE_INTEGER", "1");
  if (map.name == kRateMap) defines = {{"SOURCE_RATE", "1"}};
  program_ = programs.get({{"heatmap.comp"}, defines, {}});
}

void HeatmapPass::execute(frame::PassContext& context) {
  glUseProgram(program_);
  glUniform1f(0, static_cast<float>(heatmapRange(settings_, plan_)));
  glUniform1i(1, samplesPerAxis_);
  const frame::Resource& source = *find(settings_.map)->source;
  if (source == kFragmentRange) glUniform1ui(2, plan_.tailSlots());
  if (source == kShadingRate) {
    glUniform1f(3, static_cast<float>(static_cast<double>(samplesPerAxis_) / lod_.resize));
  } else {
    const glm::vec2 texels = glm::vec2(plan_.size) / glm::vec2(plan_.imageSize);
    glUniform2f(4, texels.x, texels.y);
  }
  context.dispatch(context.inputs().outputSize, kGroup);
}

}  // namespace macula::passes
