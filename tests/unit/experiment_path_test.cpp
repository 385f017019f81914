// Errors along a camera path, by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/core/error.h"
#include "engine/experiment/path_error.h"

namespace macula::experiment {
namespace {

/// One grey pixel.
image::ImageF grey(float value) {
  return {1, 1, 3, {value, value, value}, false};
}

TEST(ExperimentPath, FlickerIsChangeThatTheExactFramesDoNotHave) {
  PathError path;
  // Errors of 0.1, 0.3 and 0.3 while the exact frames change themselves: |0.2| and |0|, mean 0.1.
  path.add(grey(0.0F), grey(0.1F));
  path.add(grey(0.5F), grey(0.8F));
  path.add(grey(0.2F), grey(0.5F));
  const Point point = path.toPoint(15.0);
  EXPECT_EQ(point["frames"], 3);
  EXPECT_EQ(point["fps"], 15.0);
  EXPECT_NEAR(point["flicker"].get<double>(), 0.1, 1e-6);
  // Root of (0.01 + 0.09 + 0.09) / 3, and not the mean of 0.1, 0.3 and 0.3.
  EXPECT_NEAR(point["rmse"].get<double>(), std::sqrt(0.19 / 3.0), 1e-6);
}

TEST(ExperimentPath, AnErrorThatStaysIsNoFlicker) {
  PathError path;
  for (const float exact : {0.1F, 0.4F, 0.2F}) path.add(grey(exact), grey(exact + 0.25F));
  EXPECT_NEAR(path.toPoint(30.0)["flicker"].get<double>(), 0.0, 1e-7);
  EXPECT_NEAR(path.toPoint(30.0)["rmse"].get<double>(), 0.25, 1e-6);
}

TEST(ExperimentPath, WithoutTwoFramesThereIsNoFlicker) {
  PathError path;
  EXPECT_TRUE(path.toPoint(15.0)["rmse"].is_null());
  path.add(grey(0.0F), grey(0.5F));
  EXPECT_TRUE(path.toPoint(15.0)["flicker"].is_null());
  EXPECT_NEAR(path.toPoint(15.0)["rmse"].get<double>(), 0.5, 1e-6);
}

TEST(ExperimentPath, FramesOfAnotherSizeAreRefused) {
  PathError path;
  path.add(grey(0.0F), grey(0.0F));
  const image::ImageF wide{2, 1, 3, {0, 0, 0, 0, 0, 0}, false};
  EXPECT_THROW(path.add(wide, wide), InputError);
}

TEST(ExperimentPath, MetricsOfAPoint) {
  const Point point{{"path", {{"flicker", 0.25}, {"rmse", nullptr}}}};
  EXPECT_EQ(metricOf(point, "flicker"), 0.25);
  EXPECT_EQ(metricOf(point, "path_rmse"), std::nullopt);
  const std::vector<std::string> names = metricNames();
  EXPECT_NE(std::find(names.begin(), names.end(), "path_rmse"), names.end());
}

}  // namespace
}  // namespace macula::experiment
