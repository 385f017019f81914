// Boxes against views: what can be seen is never left out, and what is far outside is.
#include "engine/scene/visibility.h"

#include <gtest/gtest.h>

#include "engine/core/random.h"
#include "engine/scene/view.h"

namespace macula::scene {
namespace {

Bounds boxAround(const glm::vec3& center, float half) {
  Bounds box;
  box.add(center - half);
  box.add(center + half);
  return box;
}

Camera cameraFrom(Random& random) {
  Camera camera;
  for (int axis = 0; axis < 3; ++axis) {
    camera.position[axis] = random.range(-3.0F, 3.0F);
    camera.target[axis] = random.range(-1.0F, 1.0F);
  }
  camera.verticalFov = random.range(0.3F, 2.0F);
  return camera;
}

bool isInside(const glm::vec4& clip) {
  return glm::abs(clip.x) <= clip.w && glm::abs(clip.y) <= clip.w && clip.z >= 0.0F &&
         clip.z <= clip.w;
}

TEST(Visibility, ABoxWithAPointInTheViewIsNeverLeftOut) {
  Random random(5);
  int seen = 0;
  int leftOut = 0;
  for (int i = 0; i < 20000; ++i) {
    const View view = makeView(cameraFrom(random), random.range(0.3F, 3.0F));
    Bounds box;
    const glm::vec3 center(random.range(-6.0F, 6.0F), random.range(-6.0F, 6.0F),
                           random.range(-6.0F, 6.0F));
    box.add(center);
    box.add(center + glm::vec3(random.unit(), random.unit(), random.unit()) * 3.0F);
    const bool visible = mayBeSeen(box, view.viewProjection);
    leftOut += visible ? 0 : 1;
    for (int k = 0; k < 20; ++k) {
      const glm::vec3 part(random.unit(), random.unit(), random.unit());
      const glm::vec3 p = glm::mix(box.min, box.max, part);
      if (!isInside(view.viewProjection * glm::vec4(p, 1.0F))) continue;
      ++seen;
      ASSERT_TRUE(visible) << "box " << i;
    }
  }
  EXPECT_GT(seen, 1000);
  EXPECT_GT(leftOut, 1000);
}

TEST(Visibility, LeavesOutWhatIsBeyondOneSide) {
  const View view = makeView(Camera{}, 1.0F);  // from the origin along -z
  EXPECT_TRUE(mayBeSeen(boxAround({0.0F, 0.0F, -5.0F}, 0.5F), view.viewProjection));
  EXPECT_FALSE(mayBeSeen(boxAround({0.0F, 0.0F, 5.0F}, 0.5F), view.viewProjection)) << "behind";
  EXPECT_FALSE(mayBeSeen(boxAround({9.0F, 0.0F, -5.0F}, 0.5F), view.viewProjection)) << "right";
  EXPECT_FALSE(mayBeSeen(boxAround({0.0F, 0.0F, -200.0F}, 0.5F), view.viewProjection)) << "far";
  EXPECT_TRUE(mayBeSeen(boxAround({0.0F, 0.0F, 0.0F}, 50.0F), view.viewProjection)) << "around";
  EXPECT_FALSE(mayBeSeen(Bounds{}, view.viewProjection)) << "empty";
}

TEST(Visibility, ABoxIsTransformedWithItsCorners) {
  glm::mat4 quarterTurn(0.0F);  // about z
  quarterTurn[0][1] = 1.0F;
  quarterTurn[1][0] = -1.0F;
  quarterTurn[2][2] = quarterTurn[3][3] = 1.0F;
  Bounds box;
  box.add({1.0F, 2.0F, 3.0F});
  box.add({4.0F, 6.0F, 8.0F});
  const Bounds turned = transformed(box, quarterTurn);
  EXPECT_EQ(turned.min, glm::vec3(-6.0F, 1.0F, 3.0F));
  EXPECT_EQ(turned.max, glm::vec3(-2.0F, 4.0F, 8.0F));
  EXPECT_TRUE(transformed(Bounds{}, quarterTurn).empty());
}

}  // namespace
}  // namespace macula::scene
