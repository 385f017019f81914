// FrameRenderer: the constants that the shaders of a frame read.
#include <algorithm>

#include "engine/scene/view.h"
#include "passes/frame_renderer.h"
#include "passes/oit/oit_pass.h"
#include "shared/frame_constants.h"

namespace macula::passes {

void FrameRenderer::uploadConstants() {
  const glm::ivec2 image = inputs_.displaySize;
  const shader::FrameConstants full = constantsFor(image);
  constants_.upload(&full, sizeof(full));
  if (plan_.resized()) {
    const shader::FrameConstants resized = constantsFor(plan_.size);
    resizedConstants_.upload(&resized, sizeof(resized));
  }
}

shader::FrameConstants FrameRenderer::constantsFor(glm::ivec2 samples) const {
  const glm::vec2 size(samples);
  shader::FrameConstants c{};
  c.viewProjection = inputs_.view.viewProjection;
  c.inverseViewProjection = inputs_.view.inverseViewProjection;
  c.eye = glm::vec4(inputs_.view.camera.position, 1.0F);
  c.size = glm::vec4(size, 1.0F / size);
  // GL counts rows from the bottom, gaze from the top.
  const gaze::PointOfInterest& gaze = inputs_.gaze;
  c.gaze = glm::vec4(gaze.position.x * size.x, (1.0F - gaze.position.y) * size.y,
                     std::max(gaze.radius - gaze::kFoveaRadius, 0.0F) * size.y, 0.0F);
  c.background = glm::vec4(settings_.background, 1.0F);
  c.frame = glm::uvec4(inputs_.frameIndex, plan_.historyValid ? 1U : 0U, settings_.seed, 0U);
  c.oit = glm::uvec4(plan_.layers, plan_.slots, priceStride(plan_.size), plan_.options.cullWords);
  c.slices = glm::vec4(inputs_.view.camera.nearPlane, inputs_.view.camera.farPlane,
                       plan_.importance.tile, 0.0F);
  describeLod(c);
  c.reprojection = lastViewProjection_ * inputs_.view.inverseViewProjection;
  return c;
}

void FrameRenderer::describeLod(shader::FrameConstants& c) const {
  const scene::View& view = inputs_.view;
  const glm::mat3 axes(glm::transpose(glm::mat3(view.view)));
  // The projection scales by the inverse of what the view spans at distance 1.
  c.right = glm::vec4(axes[0] / view.projection[0][0], 0.0F);
  c.up = glm::vec4(axes[1] / view.projection[1][1], 0.0F);
  c.ahead = glm::vec4(-axes[2], 0.0F);
  const float nearPlane = view.camera.nearPlane;
  const float farPlane = view.camera.farPlane;
  c.depth = glm::vec4((farPlane - nearPlane) / (nearPlane * farPlane), 1.0F / farPlane, 0.0F, 0.0F);
  const auto r = static_cast<float>(lod_.resize);
  c.resize = glm::vec4(r, 1.0F / r, lod_.viewerSamples, 0.0F);
  c.lodSize = glm::ivec4(lod_.texels, lod_.tiles);
  c.acuity = lod_.acuity;
}

}  // namespace macula::passes
