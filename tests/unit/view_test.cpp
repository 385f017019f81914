// Matrices of the camera, by hand.
#include "engine/scene/view.h"

#include <gtest/gtest.h>

#include <cmath>

namespace macula::scene {
namespace {

glm::vec3 project(const View& view, const glm::vec3& world) {
  const glm::vec4 clip = view.viewProjection * glm::vec4(world, 1.0F);
  return glm::vec3(clip) / clip.w;
}

TEST(View, DepthIsReversed) {
  Camera camera;  // at the origin, looking along -z
  camera.nearPlane = 0.5F;
  camera.farPlane = 50.0F;
  const View view = makeView(camera, 1.0F);
  EXPECT_NEAR(project(view, {0, 0, -0.5F}).z, 1.0F, 1e-6F);
  EXPECT_NEAR(project(view, {0, 0, -50.0F}).z, 0.0F, 1e-6F);
  // n f / range / d - n / range with n = 0.5, f = 50, d = 5: (25 / 5 - 0.5) / 49.5.
  EXPECT_NEAR(project(view, {0, 0, -5.0F}).z, 4.5F / 49.5F, 1e-6F);
}

TEST(View, FieldOfViewIsVertical) {
  Camera camera;
  camera.verticalFov = 1.5707963F;  // 90 degrees: the edge lies as far up as ahead
  const View view = makeView(camera, 2.0F);
  EXPECT_NEAR(project(view, {0, 3, -3}).y, 1.0F, 1e-5F);
  EXPECT_NEAR(project(view, {6, 0, -3}).x, 1.0F, 1e-5F) << "twice as wide";
}

TEST(View, InverseBringsAPointBack) {
  Camera camera;
  camera.position = {1, 2, 3};
  camera.target = {-4, 0, 1};
  const View view = makeView(camera, 1.5F);
  const glm::vec3 world(-2, 1, 0.5F);
  const glm::vec3 ndc = project(view, world);
  glm::vec4 back = view.inverseViewProjection * glm::vec4(ndc, 1.0F);
  back /= back.w;
  EXPECT_NEAR(glm::distance(glm::vec3(back), world), 0.0F, 1e-4F);
}

}  // namespace
}  // namespace macula::scene
