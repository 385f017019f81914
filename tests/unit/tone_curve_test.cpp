// The tone curves, on values worked out by hand.
#include "engine/experiment/tone_curve.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace macula::experiment {
namespace {

void expectColour(const glm::vec3& found, const glm::vec3& wanted) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[i], wanted[i], 1e-5F) << "channel " << i;
}

TEST(ToneCurve, NoneChangesNothing) {
  expectColour(toneCurve("none", {0.1F, 2.0F, 9.0F}), {0.1F, 2.0F, 9.0F});
}

TEST(ToneCurve, NeutralTakesTheReflectionFromDarkAndMiddleColours) {
  // least 0.2: 0.04 is taken from each
  expectColour(toneCurve("neutral", {0.2F, 0.4F, 0.5F}), {0.16F, 0.36F, 0.46F});
  // least 0.04: 0.04 - 6.25 * 0.0016 = 0.03
  expectColour(toneCurve("neutral", {0.04F, 0.4F, 0.5F}), {0.01F, 0.37F, 0.47F});
}

TEST(ToneCurve, NeutralCompressesBrightOnes) {
  // grey 1.04 -> 1; newPeak 1 - 0.24^2 / (1 + 0.24 - 0.76) = 0.88; a grey stays grey
  expectColour(toneCurve("neutral", glm::vec3(1.04F)), glm::vec3(0.88F));
  // (2.04, 1.04, 0.04 + 0.04) -> (2, 1, 0.04); newPeak 1 - 0.0576 / 1.48 = 0.961081;
  // times 0.480541: (0.961081, 0.480541, 0.019222); grey 1 - 1 / (0.15 * 1.038919 + 1) = 0.134826
  expectColour(toneCurve("neutral", {2.04F, 1.04F, 0.08F}), {0.961081F, 0.545330F, 0.146210F});
}

TEST(ToneCurve, AcesOfOneHalf) {
  // 0.5 * (1.255 + 0.03) / (0.5 * (1.215 + 0.59) + 0.14) = 0.6425 / 1.0425
  expectColour(toneCurve("aces", glm::vec3(0.5F)), glm::vec3(0.616307F));
}

TEST(ToneCurve, AnUnknownOneIsAMistake) {
  EXPECT_THROW((void)toneCurve("filmic", glm::vec3(0.5F)), std::invalid_argument);
}

}  // namespace
}  // namespace macula::experiment
