#include "engine/scene/view.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace macula::scene {

View makeView(const Camera& camera, float aspect) {
  View v;
  v.camera = camera;
  v.view = glm::lookAt(camera.position, camera.target, camera.up);
  const float f = 1.0F / std::tan(0.5F * camera.verticalFov);
  const float n = camera.nearPlane;
  const float range = camera.farPlane - camera.nearPlane;
  v.projection = glm::mat4(0.0F);
  v.projection[0][0] = f / aspect;
  v.projection[1][1] = f;
  v.projection[2][2] = n / range;
  v.projection[2][3] = -1.0F;
  v.projection[3][2] = n * camera.farPlane / range;
  v.viewProjection = v.projection * v.view;
  v.inverseViewProjection = glm::inverse(v.viewProjection);
  return v;
}

}  // namespace macula::scene
