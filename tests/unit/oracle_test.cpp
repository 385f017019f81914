// Oracles: composites and choices worked by hand, and against every choice there is.
#include "engine/measure/oracle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>
#include <set>
#include <stdexcept>

namespace macula::measure {
namespace {

using Pixel = std::vector<glm::vec4>;

/// One row of pixels over black.
FragmentImage imageOf(const std::vector<Pixel>& pixels, glm::vec3 behind = glm::vec3(0.0F)) {
  FragmentImage image;
  image.width = static_cast<int>(pixels.size());
  image.height = 1;
  image.offsets = {0};
  for (const Pixel& layers : pixels) {
    image.fragments.insert(image.fragments.end(), layers.begin(), layers.end());
    image.offsets.push_back(image.fragments.size());
    image.behind.push_back(behind);
  }
  return image;
}

/// A premultiplied grey layer.
glm::vec4 grey(float value, float alpha) {
  return {glm::vec3(value * alpha), alpha};
}

glm::vec3 asItIs(const glm::vec3& linear) {
  return linear;
}

FragmentImage randomImage(std::mt19937& random, int pixels, int deepest) {
  const auto unit = [&] { return static_cast<float>(random() >> 8) / 16777216.0F; };
  std::vector<Pixel> all(static_cast<std::size_t>(pixels));
  for (Pixel& layers : all) {
    layers.resize(random() % static_cast<unsigned>(deepest + 1));
    for (glm::vec4& layer : layers) {
      const float alpha = random() % 8 == 0 ? 1.0F : unit();
      layer = {alpha * unit(), alpha * unit(), alpha * unit(), alpha};
    }
  }
  return imageOf(all, glm::vec3(unit(), unit(), unit()));
}

// White, alpha 1/2, over grey 1/2, alpha 1/2, over black, alpha 1/2, over 0.8:
// k = 0: 0.8; 1: 0.5 + 0.4; 2: 0.5 + 0.125 + 0.25 * 0.8; 3: 0.625 + 0 + 0.125 * 0.8.
TEST(LayerSweep, FrontLayersOverTheOpaqueImage) {
  const FragmentImage image =
      imageOf({{grey(1, 0.5F), grey(0.5F, 0.5F), grey(0, 0.5F)}}, glm::vec3(0.8F));
  LayerSweep sweep(Tail::None);
  const auto colours = sweep.colours(image, 0);
  ASSERT_EQ(colours.size(), 4U);
  const float expected[] = {0.8F, 0.9F, 0.825F, 0.725F};
  for (std::size_t k = 0; k < 4; ++k) EXPECT_FLOAT_EQ(colours[k].g, expected[k]) << k;
}

// The same with a tail. k = 1: all three with tau 1 each, mean (1 + 0.5 + 0) / 3 = 0.5 over
// transmittance 1/8: 0.5 * 7/8 + 0.1 = 0.5375. k = 2: 0.5 + 0.5 * (0.25 * 3/4 + 0.8 / 4) = 0.69375.
TEST(LayerSweep, TailIsOneLayerOfTheMeanColour) {
  const FragmentImage image =
      imageOf({{grey(1, 0.5F), grey(0.5F, 0.5F), grey(0, 0.5F)}}, glm::vec3(0.8F));
  EXPECT_FLOAT_EQ(composite(image, 0, 0, Tail::Mean).r, 0.8F);
  EXPECT_FLOAT_EQ(composite(image, 0, 1, Tail::Mean).r, 0.5375F);
  EXPECT_FLOAT_EQ(composite(image, 0, 2, Tail::Mean).r, 0.69375F);
  EXPECT_FLOAT_EQ(composite(image, 0, 3, Tail::Mean).r, 0.725F);
  EXPECT_FLOAT_EQ(composite(image, 0, 9, Tail::Mean).r, 0.725F) << "more slots than layers";
}

// An opaque layer weighs 16, one of alpha 1/2 weighs 1; the opaque image is hidden.
TEST(LayerSweep, OpticalDepthIsClampedAndAlphaZeroWeighsNothing) {
  const FragmentImage image = imageOf({{grey(1, 0.5F), grey(1, 0.0F), grey(0, 1.0F)}}, {9, 9, 9});
  EXPECT_FLOAT_EQ(composite(image, 0, 1, Tail::Mean).r, 1.0F / 17.0F);
  EXPECT_FLOAT_EQ(composite(image, 0, 2, Tail::Mean).r, 0.5F);
}

// Equal layers of alpha 1/(N - i) weigh the same: the mean of all is exact.
TEST(LayerSweep, AllOfNLayers) {
  constexpr int kLayers = 64;
  Pixel layers;
  float sum = 0.0F;
  for (int i = 0; i < kLayers; ++i) {
    const float value = static_cast<float>(i % 7) / 7.0F;
    layers.push_back(grey(value, 1.0F / static_cast<float>(kLayers - i)));
    sum += value;
  }
  const FragmentImage image = imageOf({layers});
  EXPECT_NEAR(composite(image, 0, kLayers, Tail::None).r, sum / kLayers, 1e-5);
  EXPECT_EQ(composite(image, 0, kLayers, Tail::None), composite(image, 0, kLayers, Tail::Mean));
}

TEST(FragmentImage, MistakesAreNamed) {
  FragmentImage image = imageOf({{grey(1, 0.5F)}, {}});
  EXPECT_NO_THROW(requireConsistent(image));
  EXPECT_EQ(image.coveredPixels(), 1U);
  image.offsets.back() = 2;
  EXPECT_THROW(requireConsistent(image), std::invalid_argument);
  EXPECT_THROW(requireConsistent(FragmentImage{}), std::invalid_argument);
  EXPECT_THROW((void)evaluate(imageOf({{}}), {1, 2}, Tail::None), std::invalid_argument);
}

TEST(Evaluate, DisplayIsSrgbUnlessSaid) {
  const FragmentImage image = imageOf({{grey(0.5F, 1.0F)}, {}}, {2, 2, 2});
  const LayerChoice choice = evaluate(image, {7, 7}, Tail::None);
  EXPECT_EQ(choice.k, (std::vector<std::uint32_t>{1, 0}));
  EXPECT_EQ(choice.slots, 1U);
  EXPECT_NEAR(choice.image[0].r, 0.735357F, 1e-6);
  EXPECT_EQ(choice.image[1].r, 1.0F);
  EXPECT_EQ(choice.rmse, 0.0);
  // 1 and 0.735357 in one of two pixels.
  EXPECT_NEAR(evaluate(image, {0, 0}, Tail::None).rmse, (1.0 - 0.735357) / std::sqrt(2.0), 1e-6);
}

// Exact colours: pixel 0: 0.5 + 0.5 * 0.025 = 0.5125; pixel 1: 0.05 + 0.9 * 0.5 = 0.5.
// One layer fewer: pixel 0 errs by 0.0125, pixel 1 by 0.45. So pixel 0 loses its last.
TEST(OptimalK, RemovesWhatIsMissedLeast) {
  const FragmentImage image =
      imageOf({{grey(1, 0.5F), grey(0.05F, 0.5F)}, {grey(0.5F, 0.1F), grey(0.5F, 1.0F)}});
  EXPECT_EQ(optimalK(image, 4, asItIs).k, (std::vector<std::uint32_t>{2, 2}));
  const LayerChoice three = optimalK(image, 3, asItIs);
  EXPECT_EQ(three.k, (std::vector<std::uint32_t>{1, 2}));
  EXPECT_NEAR(three.rmse, 0.0125 / std::sqrt(2.0), 1e-6);
  EXPECT_EQ(optimalK(image, 2, asItIs).k, (std::vector<std::uint32_t>{1, 1}));
  EXPECT_EQ(optimalK(image, 0, asItIs).k, (std::vector<std::uint32_t>{1, 1})) << "each keeps one";
}

TEST(OptimalK, TiesGoToTheLowerPixel) {
  const Pixel pixel = {grey(1, 0.5F), grey(1, 0.5F), grey(1, 0.5F)};
  EXPECT_EQ(optimalK(imageOf({pixel, pixel, pixel}), 8).k, (std::vector<std::uint32_t>{2, 3, 3}));
  EXPECT_EQ(optimalK(imageOf({pixel, pixel, pixel}), 7).k, (std::vector<std::uint32_t>{2, 2, 3}));
}

// Pixel 0 shows 0, 0 and 0.99^2 with 1, 2 and 3 layers: the second alone wins nothing. Pixel 1
// shows 0 and 0.1.
TEST(LeastRmse, StepsOverLayersThatAloneWinNothing) {
  const FragmentImage image =
      imageOf({{grey(0, 0.01F), grey(0, 0.01F), grey(1, 1.0F)}, {grey(0, 0.5F), grey(0.2F, 1.0F)}});
  // Two slots are left after one each: the hull step of pixel 0 takes both.
  const LeastRmseChoice choice = leastRmse(image, 4, Tail::None, asItIs);
  EXPECT_EQ(choice.k, (std::vector<std::uint32_t>{3, 1}));
  EXPECT_NEAR(choice.rmse, std::sqrt(0.01 / 2.0), 1e-6);
  EXPECT_NEAR(choice.bound, choice.rmse, 1e-9);
  // One is left: the step of two does not fit, and pixel 1 has a use for it.
  EXPECT_EQ(leastRmse(image, 3, Tail::None, asItIs).k, (std::vector<std::uint32_t>{1, 2}));
}

// One pixel shows 0, 0.0099 and 0.9009: the hull has one step, from one layer to all three. With
// two slots it does not fit, and the second layer still helps.
TEST(LeastRmse, WhatIsLeftGoesInsideAStep) {
  const FragmentImage image = imageOf({{grey(0, 0.01F), grey(0.1F, 0.1F), grey(1, 1.0F)}});
  const LeastRmseChoice choice = leastRmse(image, 2, Tail::None, asItIs);
  EXPECT_EQ(choice.k, (std::vector<std::uint32_t>{2}));
  EXPECT_NEAR(choice.rmse, 0.891, 1e-5);
  // Half the step's squared error: 0.9009 / sqrt(2).
  EXPECT_NEAR(choice.bound, 0.637033, 1e-5);
}

// Over 0.8: 0.9, 0.95 and 0.75 with 1, 2 and 3 layers. The second alone makes it worse.
TEST(LeastRmse, SlotsThatWouldDoHarmStayUnused) {
  const FragmentImage bright =
      imageOf({{grey(1, 0.5F), grey(1, 0.5F), grey(0, 1.0F)}}, glm::vec3(0.8F));
  EXPECT_EQ(leastRmse(bright, 2, Tail::None, asItIs).slots, 1U);
  EXPECT_EQ(leastRmse(bright, 3, Tail::None, asItIs).slots, 3U);
}

TEST(LeastRmse, BudgetBelowOneEachGoesWhereItHelpsMost) {
  const FragmentImage image = imageOf({{grey(0.1F, 1)}, {grey(0.9F, 1)}, {grey(0.5F, 1)}});
  EXPECT_EQ(leastRmse(image, 2, Tail::None).k, (std::vector<std::uint32_t>{0, 1, 1}));
  EXPECT_EQ(leastRmse(image, 0, Tail::None).slots, 0U);
}

TEST(LeastRmse, NothingTransparent) {
  const LeastRmseChoice choice = leastRmse(imageOf({{}, {}}, {0.3F, 0.3F, 0.3F}), 5, Tail::Mean);
  EXPECT_EQ(choice.slots, 0U);
  EXPECT_EQ(choice.rmse, 0.0);
}

/// The least RMSE over every choice of k >= 1 with a sum of at most `budget`.
double bruteForce(const FragmentImage& image, std::uint64_t budget, Tail tail) {
  std::vector<std::uint32_t> k(image.pixels());
  for (std::size_t p = 0; p < k.size(); ++p) k[p] = std::min(1U, image.depth(p));
  double least = 1e9;
  while (true) {
    if (std::accumulate(k.begin(), k.end(), std::uint64_t{0}) <= budget) {
      least = std::min(least, evaluate(image, k, tail).rmse);
    }
    std::size_t p = 0;
    while (p < k.size() && k[p] == image.depth(p)) {
      k[p] = std::min(1U, image.depth(p));
      ++p;
    }
    if (p == k.size()) return least;
    ++k[p];
  }
}

class EveryChoice : public testing::TestWithParam<Tail> {};

TEST_P(EveryChoice, NoneIsBetterOnTheHullAndNoneIsBelowTheBound) {
  std::mt19937 random(5);
  constexpr double kRounding = 1e-9;
  int onHull = 0;
  int offHull = 0;
  for (int round = 0; round < 60; ++round) {
    const FragmentImage image = randomImage(random, 3 + round % 2, 4);
    const std::uint64_t all = image.fragments.size();
    for (std::uint64_t budget = image.coveredPixels(); budget <= all; ++budget) {
      const LeastRmseChoice choice = leastRmse(image, budget, GetParam());
      const double least = bruteForce(image, budget, GetParam());
      EXPECT_LE(choice.slots, budget);
      EXPECT_LE(choice.bound, least + kRounding);
      EXPECT_GE(choice.rmse, least - kRounding);
      if (choice.rmse <= choice.bound + kRounding) {
        ++onHull;
        EXPECT_NEAR(choice.rmse, least, kRounding) << "round " << round << " budget " << budget;
        if (GetParam() == Tail::None) {
          EXPECT_LE(choice.rmse, optimalK(image, budget).rmse + kRounding);
        }
      } else {
        ++offHull;
      }
    }
    EXPECT_EQ(leastRmse(image, all, GetParam()).rmse, 0.0);
  }
  EXPECT_GT(onHull, 100);
  EXPECT_GT(offHull, 10) << "else the parts of steps were never tried";
}

TEST_P(EveryChoice, TheBudgetIsUsedUpWhereMoreDoesNoHarm) {
  std::mt19937 random(11);
  for (int round = 0; round < 60; ++round) {
    // Few pixels, so that remainders find no short step elsewhere.
    const FragmentImage image = randomImage(random, 1 + round % 12, 12);
    for (std::uint64_t budget = 0; budget <= image.fragments.size() + 3; ++budget) {
      const LeastRmseChoice choice = leastRmse(image, budget, GetParam());
      const std::uint64_t wanted = std::min<std::uint64_t>(budget, image.fragments.size());
      ASSERT_LE(choice.slots, wanted);
      for (std::size_t p = 0; p < image.pixels(); ++p) {
        EXPECT_LE(choice.k[p], image.depth(p));
        const std::uint64_t most =
            std::min<std::uint64_t>(image.depth(p), choice.k[p] + wanted - choice.slots);
        for (std::uint32_t k = choice.k[p] + 1; k <= most; ++k) {
          std::vector<std::uint32_t> other = choice.k;
          other[p] = k;
          EXPECT_GT(evaluate(image, other, GetParam()).rmse, choice.rmse)
              << "slots that would help are left over";
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Tails, EveryChoice, testing::Values(Tail::None, Tail::Mean),
                         [](const auto& tail) {
                           return tail.param == Tail::None ? "None" : "Mean";
                         });

TEST(Oracles, LeastRmseIsNeverWorseThanOptimalK) {
  std::mt19937 random(23);
  for (int round = 0; round < 8; ++round) {
    const FragmentImage image = randomImage(random, 300, 16);
    const std::uint64_t covered = image.coveredPixels();
    const std::uint64_t all = image.fragments.size();
    for (std::uint64_t budget = covered; budget <= all; budget += (all - covered) / 40) {
      const LayerChoice published = optimalK(image, budget);
      const LeastRmseChoice choice = leastRmse(image, budget, Tail::None);
      EXPECT_EQ(published.slots, budget);
      EXPECT_LE(choice.rmse, published.rmse) << "budget " << budget << " of " << all;
      EXPECT_EQ(choice.slots, budget);
    }
  }
}

TEST(Oracles, RepeatToTheBit) {
  std::mt19937 random(3);
  const FragmentImage image = randomImage(random, 200, 10);
  const LeastRmseChoice a = leastRmse(image, 500, Tail::Mean);
  const LeastRmseChoice b = leastRmse(image, 500, Tail::Mean);
  EXPECT_EQ(a.k, b.k);
  EXPECT_EQ(a.rmse, b.rmse);
  EXPECT_EQ(optimalK(image, 500).k, optimalK(image, 500).k);
}

}  // namespace
}  // namespace macula::measure
