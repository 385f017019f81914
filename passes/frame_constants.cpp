#include "passes/frame_constants.h"

#include <algorithm>

#include "engine/scene/view.h"
#include "passes/oit/utility/covered.h"
#include "shared/frame_constants.h"

namespace macula::passes {
namespace {

void setView(shader::FrameConstants& c, const scene::View& view) {
  c.viewProjection = view.viewProjection;
  c.inverseViewProjection = view.inverseViewProjection;
  c.eye = glm::vec4(view.camera.position, 1.0F);
  const glm::mat3 axes(glm::transpose(glm::mat3(view.view)));
  // The projection scales by the inverse of what the view spans at distance 1.
  c.right = glm::vec4(axes[0] / view.projection[0][0], 0.0F);
  c.up = glm::vec4(axes[1] / view.projection[1][1], 0.0F);
  c.ahead = glm::vec4(-axes[2], 0.0F);
  const float nearPlane = view.camera.nearPlane;
  const float farPlane = view.camera.farPlane;
  c.nearPlane = nearPlane;
  c.farPlane = farPlane;
  c.depthScale = (farPlane - nearPlane) / (nearPlane * farPlane);
  c.depthOffset = 1.0F / farPlane;
}

void setGaze(shader::FrameConstants& c, const gaze::PointOfInterest& gaze, glm::vec2 size) {
  // GL counts rows from the bottom, gaze from the top.
  c.gaze = {gaze.position.x * size.x, (1.0F - gaze.position.y) * size.y};
  c.gazeSpread = std::max(gaze.radius - gaze::kFoveaRadius, 0.0F) * size.y;
}

void setTransparency(shader::FrameConstants& c, const OitPlan& plan) {
  c.historyValid = plan.historyValid ? 1U : 0U;
  c.seed = plan.seed;
  c.pixelSlots = plan.layers;
  c.slots = plan.slots;
  c.sampledCellSide = static_cast<std::uint32_t>(sampledCellSide(plan.size));
  c.occupancyWords = static_cast<std::uint32_t>(plan.options.cullWords);
  c.sliceTile = static_cast<float>(plan.importance.tile);
}

void setLod(shader::FrameConstants& c, const LodPlan& lod) {
  c.pitch = static_cast<float>(lod.resize);
  c.inversePitch = 1.0F / c.pitch;
  c.viewerDistance = lod.viewerSamples;
  c.lodTexels = lod.texels;
  c.lodTiles = lod.tiles;
  c.acuitySlope = lod.acuity.x;
  c.fovealMar = lod.acuity.y;
  c.samplesPerMar = lod.acuity.z;
  c.coarsestRate = lod.acuity.w;
}

shader::FrameConstants constantsOf(const ConstantSources& s, glm::ivec2 samples) {
  shader::FrameConstants c{};
  c.size = glm::vec2(samples);
  c.inverseSize = 1.0F / c.size;
  c.background = glm::vec4(s.background, 1.0F);
  c.frameIndex = s.inputs.frameIndex;
  setView(c, s.inputs.view);
  setGaze(c, s.inputs.gaze, c.size);
  setTransparency(c, s.plan);
  setLod(c, s.lod);
  c.reprojection = s.lastViewProjection * s.inputs.view.inverseViewProjection;
  return c;
}

}  // namespace

FrameConstantBuffers::FrameConstantBuffers()
    : image_("frame constants", sizeof(shader::FrameConstants)),
      reduced_("frame constants of reduced-rate transparency", sizeof(shader::FrameConstants)) {}

void FrameConstantBuffers::upload(const ConstantSources& sources) {
  const shader::FrameConstants image = constantsOf(sources, sources.inputs.displaySize);
  image_.upload(&image, sizeof(image));
  if (!sources.plan.reduced()) return;
  const shader::FrameConstants reduced = constantsOf(sources, sources.plan.size);
  reduced_.upload(&reduced, sizeof(reduced));
}

}  // namespace macula::passes
