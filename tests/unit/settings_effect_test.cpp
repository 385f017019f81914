// What has to be done where a setting changes: the whole list, over all rooms that register some.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "engine/control/control_settings.h"
#include "engine/gaze/gaze_settings.h"
#include "passes/render_settings.h"

namespace macula {
namespace {

using settings::Effect;

TEST(SettingsEffect, EveryGroupSaysWhatAChangeNeeds) {
  passes::RenderSettings render;
  gaze::GazeSettings gaze;
  control::ControlSettings control;
  settings::Registry registry;
  passes::registerSettings(registry, render);
  gaze::registerSettings(registry, gaze);
  control::registerSettings(registry, control);
  std::vector<std::string> reloads;
  for (const settings::Entry& entry : registry.entries()) {
    const bool ofGaze = entry.group() == "gaze" || entry.group() == "display";
    EXPECT_EQ(entry.effect() == Effect::ReopensGaze, ofGaze) << entry.key();
    EXPECT_EQ(entry.effect() == Effect::Immediate, entry.group() == "control") << entry.key();
    if (entry.effect() == Effect::ReloadsScene) reloads.push_back(entry.key());
  }
  EXPECT_THAT(reloads,
              testing::UnorderedElementsAre("frame.seed", "scene.environment", "scene.lighting",
                                            "scene.opacity", "scene.order"));
}

}  // namespace
}  // namespace macula
