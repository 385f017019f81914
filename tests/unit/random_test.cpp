#include "engine/core/random.h"

#include <gtest/gtest.h>

#include "engine/scene/procedural/in_ball.h"

namespace macula {
namespace {

TEST(Random, GivesThePublishedSequence) {
  Random random(42, 54);  // as O'Neill's pcg32-demo, whose first round these are
  for (const std::uint32_t expected :
       {0xa15c02b7U, 0x7b47f409U, 0xba1d3330U, 0x83d2f293U, 0xbfa4784bU, 0xcbed606eU}) {
    EXPECT_EQ(random.next(), expected);
  }
}

TEST(Random, StaysInItsRanges) {
  Random random(1);
  for (int i = 0; i < 10000; ++i) {
    const float u = random.unit();
    EXPECT_GE(u, 0.0F);
    EXPECT_LT(u, 1.0F);
    EXPECT_LT(random.below(7), 7U);
    EXPECT_LE(glm::length(scene::inBall(random)), 1.0F);
  }
}

TEST(Random, NumbersAreUniformAndGaussian) {
  Random random(1);
  double sum = 0.0;
  double squares = 0.0;
  const int n = 20000;
  for (int i = 0; i < n; ++i) {
    const double u = random.uniform();
    ASSERT_TRUE(u >= 0.0 && u < 1.0);
    sum += u;
  }
  EXPECT_NEAR(sum / n, 0.5, 0.01);  // five standard errors
  sum = 0.0;
  for (int i = 0; i < n; ++i) {
    const double g = random.gauss();
    sum += g;
    squares += g * g;
  }
  EXPECT_NEAR(sum / n, 0.0, 0.035);
  EXPECT_NEAR(squares / n, 1.0, 0.05);
}

}  // namespace
}  // namespace macula
