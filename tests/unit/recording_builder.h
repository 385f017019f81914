// Recordings to test with, and what makes two frames the same.
#pragma once

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>

#include "engine/recording/recording.h"

namespace macula::recording {

inline Frame someFrame(std::uint64_t index) {
  Frame frame;
  frame.index = index;
  frame.timeSeconds = 0.016 * static_cast<double>(index);
  frame.size = {640, 480};
  frame.reset = index == 0 ? Reset::Restart : Reset::None;
  frame.camera.position = {0.1F, 1.7F, -3.0F};
  frame.gaze = gaze::exactPoint({0.3, 0.7});
  return frame;
}

inline Session someSession() {
  Session session;
  session.commit = "300cf30ad6fe";
  session.started = "2026-11-22T10:50:16Z";
  session.scene.name = "a scene.glb";
  session.scene.file = "/scenes/a scene.glb";
  session.scene.sha256 = std::string(64, '7');
  session.environmentSha256 = std::string(64, 'e');
  session.renderer = "llvmpipe";
  session.version = "4.5";
  session.contentScale = {1.25F, 1.1F};
  session.settings = {{"frame.seed", std::int64_t{7}},
                      {"oit.fill", false},
                      {"oit.kAve", 0.1},
                      {"oit.method", std::string("kb-plus")},
                      {"scene.background", glm::vec3(0.1F, 0.2F, 1e-3F)}};
  session.options = {{"gaze", "mouse"}, {"size", "640x480"}};
  return session;
}

/// Bits, so that NaN is like itself and -0 unlike 0.
template <typename Value>
void expectSameBits(const Value& a, const Value& b, const char* what) {
  EXPECT_EQ(std::memcmp(&a, &b, sizeof(Value)), 0) << what;
}

inline void expectSame(const Frame& a, const Frame& b) {
  EXPECT_EQ(a.index, b.index);
  expectSameBits(a.timeSeconds, b.timeSeconds, "time");
  EXPECT_EQ(a.size, b.size);
  EXPECT_EQ(a.reset, b.reset);
  EXPECT_EQ(a.cut, b.cut);
  EXPECT_EQ(a.scene, b.scene);
  ASSERT_EQ(a.settings.size(), b.settings.size());
  for (std::size_t i = 0; i < a.settings.size(); ++i) {
    EXPECT_EQ(a.settings[i], b.settings[i]) << a.settings[i].first;
  }
  expectSameBits(a.camera.position, b.camera.position, "position");
  expectSameBits(a.camera.target, b.camera.target, "target");
  expectSameBits(a.camera.up, b.camera.up, "up");
  expectSameBits(a.camera.verticalFov, b.camera.verticalFov, "field of view");
  expectSameBits(a.camera.nearPlane, b.camera.nearPlane, "near plane");
  expectSameBits(a.camera.farPlane, b.camera.farPlane, "far plane");
  expectSameBits(a.gaze.position, b.gaze.position, "gaze");
  expectSameBits(a.gaze.raw, b.gaze.raw, "raw gaze");
  EXPECT_EQ(a.gaze.state, b.gaze.state);
  expectSameBits(a.gaze.ageSeconds, b.gaze.ageSeconds, "age");
  expectSameBits(a.gaze.radius, b.gaze.radius, "radius");
  EXPECT_EQ(a.gaze.saccade, b.gaze.saccade);
  expectSameBits(a.r, b.r, "r");
  EXPECT_EQ(a.controls, b.controls);
  EXPECT_EQ(a.unrecorded, b.unrecorded);
  EXPECT_EQ(a.imageSha256, b.imageSha256);
}

}  // namespace macula::recording
