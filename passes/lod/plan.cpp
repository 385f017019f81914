#include "passes/lod/plan.h"

#include <algorithm>
#include <cmath>

#include "engine/control/law.h"
#include "shared/lod_totals.h"

namespace macula::passes {
namespace {

constexpr double kDegreesPerRadian = 57.295779513082321;

}  // namespace

glm::ivec2 resizedTexels(glm::ivec2 size, double resize) {
  const auto along = [resize](int full) {
    // As floats, like the shaders' positions.
    return std::max(
        1, static_cast<int>(std::ceil(static_cast<float>(full) / static_cast<float>(resize))));
  };
  return {along(size.x), along(size.y)};
}

double viewerDistance(const FoveationSettings& settings, int imageWidth) {
  if (settings.pixelsPerDegree > 0.0) return settings.pixelsPerDegree * kDegreesPerRadian;
  const gaze::Display display = settings.display != nullptr ? *settings.display : gaze::Display{};
  return display.distanceMm / display.widthMm * imageWidth;
}

void planLod(LodPlan& plan, const LodSettings& settings, const FoveationSettings& foveation,
             const scene::SceneFacts& facts, bool mayResize) {
  plan.parts = parseLodParts(settings.what);
  plan.parts.shadow = plan.parts.shadow && facts.shadowLight && facts.opaqueTriangles > 0;
  plan.parts.occlusion = plan.parts.occlusion && facts.occlusion.any();
  plan.parts.noise = plan.parts.noise && facts.veins;
  const bool something =
      plan.parts.shading || plan.parts.shadow || plan.parts.occlusion || plan.parts.noise;
  plan.foveated = foveation.enabled;
  const bool resizes = settings.resize > control::kLeastResize || mayResize;
  plan.canResizeShading = facts.litOpaque && something;
  plan.canResizeTransparency = settings.transparency && facts.transparentTriangles > 0;
  plan.wanted = plan.canResizeShading && (resizes || foveation.enabled);
  plan.transparency = plan.canResizeTransparency && resizes;
  plan.reconstruction = settings.reconstruction;
  plan.holes = settings.holes;
  plan.demodulates = settings.demodulate && plan.parts.shading &&
                     settings.reconstruction == Reconstruction::Macula;
  plan.sigma = {settings.sigmaNormal, settings.sigmaDepth};
}

void planFrame(LodPlan& plan, const LodSettings& settings, const FoveationSettings& foveation,
               const frame::FrameInputs& inputs, int samplesPerAxis) {
  const frame::QualityControls& controls = inputs.controls;
  const double asked =
      controls.resize > 0.0F ? static_cast<double>(controls.resize) : settings.resize;
  plan.resize = plan.wanted || plan.transparency
                    ? std::clamp(asked, control::kLeastResize, control::kMostResize)
                    : 1.0;
  plan.size = inputs.displaySize;
  plan.texels = resizedTexels(inputs.displaySize, plan.resize);
  plan.tiles = (plan.texels + LOD_TILE - 1) / LOD_TILE;
  constexpr double kSamplesPerCycle = 2.0;  // Nyquist
  plan.acuity = {foveation.slope * static_cast<double>(controls.foveaSlope), foveation.fovealMar,
                 foveation.perCycle ? kSamplesPerCycle : 1.0, foveation.coarsest};
  plan.viewerSamples =
      static_cast<float>(viewerDistance(foveation, inputs.outputSize.x) * samplesPerAxis);
}

}  // namespace macula::passes
