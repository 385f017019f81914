#include "engine/scene/camera_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/scene/procedural/mesh_builder.h"
#include "engine/scene/procedural/recipes.h"
#include "tests/unit/plain_raster.h"

namespace macula::scene {
namespace {

constexpr double kDegree = M_PI / 180.0;

CameraKey keyAt(double time, float x, bool cut = false) {
  CameraKey key;
  key.time = time;
  key.position = {x, 1.0F, 0.0F};
  key.target = {x, 1.0F, -5.0F};
  key.verticalFov = 1.0F + 0.1F * static_cast<float>(time);
  key.cut = cut;
  return key;
}

std::string messageOf(const std::string& text) {
  try {
    (void)parseCameraPath(text, "path.csv");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

Scene cubeScene(const glm::vec3& low, const glm::vec3& high) {
  Scene scene;
  Primitive box;
  addBox(box, low, high);
  scene.primitives.push_back(box);
  scene.instances.push_back({0, glm::mat4(1.0F)});
  return scene;
}

TEST(CameraPath, PassesThroughItsKeysAndHoldsAtBothEnds) {
  const CameraPath path({keyAt(1, 0), keyAt(2, 3), keyAt(4, -2)});
  EXPECT_FLOAT_EQ(path.at(-5).position.x, 0.0F);
  EXPECT_FLOAT_EQ(path.at(1).position.x, 0.0F);
  EXPECT_FLOAT_EQ(path.at(2).position.x, 3.0F);
  EXPECT_FLOAT_EQ(path.at(4).position.x, -2.0F);
  EXPECT_FLOAT_EQ(path.at(99).position.x, -2.0F);
  EXPECT_DOUBLE_EQ(path.duration(), 4.0);
  EXPECT_FLOAT_EQ(path.at(3).verticalFov, 1.3F);
}

TEST(CameraPath, IsTheCatmullRomSplineWhereTimesAreEven) {
  // Half way, Catmull-Rom weighs the four keys -1/16, 9/16, 9/16, -1/16.
  const CameraPath path({keyAt(0, 1), keyAt(1, 4), keyAt(2, 2), keyAt(3, 8)});
  EXPECT_FLOAT_EQ(path.at(1.5).position.x, (-1.0F + 9.0F * 4.0F + 9.0F * 2.0F - 8.0F) / 16.0F);
  EXPECT_FLOAT_EQ(path.at(1.5).target.x, path.at(1.5).position.x);
  EXPECT_FLOAT_EQ(path.at(1.5).position.y, 1.0F);
}

TEST(CameraPath, StraightMotionStaysEvenWhateverTheTimes) {
  const CameraPath path({keyAt(0, 0), keyAt(1, 2), keyAt(4, 8), keyAt(4.5, 9)});
  for (double t = 0.0; t <= 4.5; t += 0.125) EXPECT_NEAR(path.at(t).position.x, 2.0 * t, 1e-5);
}

TEST(CameraPath, JumpsAtCutsAndDoesNotLookAcrossThem) {
  const CameraPath path({keyAt(0, 0), keyAt(1, 1), keyAt(2, 50, true), keyAt(3, 51)});
  EXPECT_FLOAT_EQ(path.at(1.999).position.x, 1.0F);
  EXPECT_FLOAT_EQ(path.at(2.0).position.x, 50.0F);
  EXPECT_FLOAT_EQ(path.at(0.5).position.x, 0.5F);
  EXPECT_FLOAT_EQ(path.at(2.5).position.x, 50.5F);
  EXPECT_TRUE(path.cutAt(1.99, 2.0));
  EXPECT_FALSE(path.cutAt(2.0, 2.01));
  EXPECT_FALSE(path.cutAt(0.5, 1.5));
  EXPECT_TRUE(path.cutAt(2.5, 2.4)) << "time ran back";
}

TEST(CameraPath, FixedCameraNeverMoves) {
  Camera camera;
  camera.position = {1, 2, 3};
  camera.farPlane = 7.0F;
  const CameraPath path = fixedCamera(camera);
  EXPECT_EQ(path.at(5).position, camera.position);
  EXPECT_EQ(path.at(5).farPlane, 7.0F);
  EXPECT_FALSE(path.cutAt(5, 0));
  EXPECT_EQ(path.duration(), 0.0);
}

TEST(CameraPath, FitsItsPlanesAroundTheScene) {
  CameraPath path({keyAt(0, 0), keyAt(1, 30)});
  Bounds bounds;
  bounds.add({-10, 0, -10});
  bounds.add({10, 6, 10});
  path.fitPlanes(bounds);
  EXPECT_GT(path.at(0).farPlane, glm::distance(glm::vec3(30, 1, 0), glm::vec3(-10, 6, -10)));
  EXPECT_LT(path.at(0).nearPlane, 0.1F);
  EXPECT_GT(path.at(0).nearPlane, 0.0F);
}

TEST(AutoOrbit, KeepsEveryVertexInASquareFrameAndFillsIt) {
  const Scene scenes[] = {cubeScene({-1, -1, -1}, {1, 1, 1}), cubeScene({4, 0, -3}, {5, 9, -1}),
                          cubeScene({-300, -1, -200}, {300, 1, 200})};
  for (const Scene& scene : scenes) {
    const CameraPath path = autoOrbit(scene);
    EXPECT_DOUBLE_EQ(path.duration(), 24.0);
    double widest = 0.0;
    for (double t = 0.0; t < 24.0; t += 0.37) {
      const Camera camera = path.at(t);
      const plain::PlainView view(camera, 100, 100);
      for (const glm::vec3& p : scene.primitives[0].positions) {
        const glm::dvec3 v = view.toView(glm::dvec3(p));
        EXPECT_GT(v.z, camera.nearPlane);
        EXPECT_LT(v.z, camera.farPlane);
        const double reach = std::max(std::abs(v.x), std::abs(v.y)) / (v.z * view.tanHalf);
        EXPECT_LT(reach, 1.0);
        widest = std::max(widest, reach);
      }
    }
    EXPECT_GT(widest, 0.88);
  }
}

TEST(AutoOrbit, FramesAModelOfAnyScaleAlike) {
  const auto scaled = [](float scale) {
    Scene scene = cubeScene({-1, -1, -1}, {1, 2, 1});
    scene.instances[0].transform = glm::mat4(scale);
    scene.instances[0].transform[3][3] = 1.0F;
    return scene;
  };
  const Camera metre = autoOrbit(scaled(1.0F)).at(5.0);
  for (const float scale : {1e-12F, 1e-6F, 1e-4F, 1e-2F, 1e5F, 1e12F}) {
    const Camera camera = autoOrbit(scaled(scale)).at(5.0);
    EXPECT_LT(glm::distance(camera.position / scale, metre.position), 1e-4F) << scale;
    EXPECT_LT(glm::distance(camera.target / scale, metre.target), 1e-4F) << scale;
    EXPECT_NEAR(camera.nearPlane / scale, metre.nearPlane, 1e-4F) << scale;
    EXPECT_NEAR(camera.farPlane / scale, metre.farPlane, 1e-4F) << scale;
  }
}

TEST(AutoOrbit, TurnsOnceIn24SecondsAndStartsInFront) {
  const CameraPath path = autoOrbit(cubeScene({-1, -1, -1}, {1, 1, 1}));
  const glm::vec3 start = path.at(0).position;
  EXPECT_GT(start.z, 0.0F);
  EXPECT_GT(start.y, 0.0F);
  EXPECT_NEAR(glm::distance(start, path.at(24).position), 0.0F, 1e-5F);
  const glm::vec3 half = path.at(12).position;
  EXPECT_NEAR(half.x, -start.x, 1e-4F);
  EXPECT_NEAR(half.z, -start.z, 1e-4F);
  EXPECT_FLOAT_EQ(half.y, start.y);
  // Counter-clockwise seen from above: from +z towards +x.
  EXPECT_GT(path.at(1).position.x, start.x);
}

TEST(AutoOrbit, SurvivesAnEmptyScene) {
  const Camera camera = autoOrbit(Scene{}).at(3);
  EXPECT_GT(camera.nearPlane, 0.0F);
  EXPECT_GT(camera.farPlane, camera.nearPlane);
  EXPECT_NE(camera.position, camera.target);
}

TEST(AutoOrbit, FollowsTheCameraNamedOrbit) {
  Scene scene = cubeScene({-9, -9, -9}, {9, 9, 9});
  Camera camera;
  camera.name = "orbit";
  camera.target = {1, 2, 3};
  camera.position = camera.target + glm::vec3(3, 0.5F, 0);
  camera.verticalFov = 1.1F;
  scene.cameras = {Camera{}, camera};
  const CameraPath path = autoOrbit(scene);
  EXPECT_NEAR(glm::distance(path.at(0).position, camera.position), 0.0F, 1e-5F);
  const Camera quarter = path.at(6);  // +x has turned to -z
  EXPECT_NEAR(glm::distance(quarter.position, camera.target + glm::vec3(0, 0.5F, -3)), 0.0F, 1e-5F);
  EXPECT_EQ(quarter.target, camera.target);
  EXPECT_EQ(quarter.verticalFov, 1.1F);
}

TEST(AutoOrbit, StaysInFrontOfLayers) {
  const Scene scene = makeLayers(4, 1);
  const CameraPath path = autoOrbit(scene);
  EXPECT_EQ(path.at(0).position, path.at(11).position);
  EXPECT_EQ(path.at(7).target, scene.cameras[0].target);
}

TEST(CameraPathFile, ReadsWhatItWrites) {
  std::vector<CameraKey> keys{keyAt(0, 0.1F), keyAt(1.0 / 3.0, -2.7F), keyAt(9, 1e-7F, true)};
  const std::string text = cameraPathCsv(keys);
  const std::vector<CameraKey> read = parseCameraPath(text, "path.csv");
  ASSERT_EQ(read.size(), keys.size());
  for (std::size_t i = 0; i < keys.size(); ++i) {
    EXPECT_EQ(read[i].time, keys[i].time);
    EXPECT_EQ(read[i].position, keys[i].position);
    EXPECT_EQ(read[i].target, keys[i].target);
    EXPECT_FLOAT_EQ(read[i].verticalFov, keys[i].verticalFov);
    EXPECT_EQ(read[i].cut, keys[i].cut);
  }
}

TEST(CameraPathFile, TakesCommentsAndAMissingCutColumn) {
  const auto keys = parseCameraPath(
      "\xEF\xBB\xBF# a walk\r\ntime_s, x,y,z,target_x,target_y,target_z,vfov_deg\r\n\r\n"
      "0, 1,2,3, 4,5,6, 90\r\n# later\n2,1,2,4,4,5,6,60",
      "path.csv");
  ASSERT_EQ(keys.size(), 2U);
  EXPECT_EQ(keys[0].position, glm::vec3(1, 2, 3));
  EXPECT_NEAR(keys[0].verticalFov, 90.0 * kDegree, 1e-6);
  EXPECT_FALSE(keys[0].cut);
  EXPECT_EQ(keys[1].time, 2.0);
}

TEST(CameraPathFile, NamesTheLineOfEveryMistake) {
  const std::string header = "time_s,x,y,z,target_x,target_y,target_z,vfov_deg,cut\n";
  const auto row = [&](const std::string& text) { return messageOf(header + text); };
  const auto has = [](const std::string& message, const std::string& part) {
    EXPECT_NE(message.find(part), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  };
  has(messageOf(""), "path.csv: holds no camera path");
  has(messageOf(header), "path.csv: holds no keys");
  has(messageOf("t,x,y\n0,0,0\n"), "path.csv, line 1: the header is 't,x,y'");
  has(row("0,0,0,0,0,0,-1,45"), "line 2: 8 fields");
  has(row("0,0,0,0,0,0,-1,45,0,7"), "line 2: 10 fields");
  has(row("0,0,zero,0,0,0,-1,45,0"), "line 2: y is 'zero'");
  has(row("0,0,,0,0,0,-1,45,0"), "line 2: y is ''");
  has(row("0,0,nan,0,0,0,-1,45,0"), "line 2: y is 'nan'");
  has(row("0,0,1e300,0,0,0,-1,45,0"), "line 2: y is 1e300");
  has(row("0,0,1e999,0,0,0,-1,45,0"), "line 2: y is '1e999'");
  has(row("0,0,0,5,0,0,5,45,0"), "line 2: the target is the position");
  has(row("0,0,0,0,0,5,0,45,0"), "line 2: the camera looks straight up");
  has(row("0,0,0,0,0,0,-1,180,0"), "line 2: vfov_deg is 180");
  has(row("0,0,0,0,0,0,-1,0,0"), "line 2: vfov_deg is 0");
  has(row("0,0,0,0,0,0,-1,45,2"), "line 2: cut is 2");
  has(row("0,0,0,0,0,0,-1,45,true"), "line 2: cut is 'true'; write 0 or 1");
  has(row("-1,0,0,0,0,0,-1,45,0"), "line 2: time_s is -1");
  has(row("0,0,0,0,0,0,-1,45,0\n# note\n0,0,0,0,0,0,-1,45,0"), "line 4: time_s is 0 after 0");
}

TEST(CameraPathFile, MissingFileIsNamed) {
  try {
    (void)readCameraPath("/nowhere/path.csv");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("/nowhere/path.csv"), std::string::npos);
  }
}

TEST(CameraPathFile, TheGalleryWalkStaysInItsHallAndOutOfItsFurniture) {
  const CameraPath path =
      readCameraPath(std::filesystem::path(MACULA_SOURCE_DIR) / "assets" / "gallery_walk.csv");
  EXPECT_DOUBLE_EQ(path.duration(), 20.0);
  const Scene scene = makeGallery(0);
  const Bounds hall = boundsOf(scene);
  // A walker takes 20 cm to each side; whatever is opaque or glass keeps out of that at eye level.
  std::vector<glm::vec3> solid;
  for (const Instance& instance : scene.instances) {
    const Primitive& mesh = scene.primitives[instance.primitive];
    if (scene.materialOf(mesh).unlit) continue;  // smoke can be walked through
    for (const glm::vec3& p : mesh.positions) {
      const glm::vec3 world = glm::vec3(instance.transform * glm::vec4(p, 1.0F));
      if (world.y > 0.3F && world.y < 1.9F) solid.push_back(world);
    }
  }
  for (double t = 0.0; t <= 20.0; t += 0.1) {
    const glm::vec3 eye = path.at(t).position;
    EXPECT_TRUE(glm::all(glm::greaterThan(eye, hall.min)) &&
                glm::all(glm::lessThan(eye, hall.max)));
    EXPECT_GT(eye.y, 1.2F);
    EXPECT_LT(eye.y, 2.2F);
    float nearest = 10.0F;
    for (const glm::vec3& p : solid) {
      nearest = std::min(nearest, glm::length(glm::vec2(p.x - eye.x, p.z - eye.z)));
    }
    EXPECT_GT(nearest, 0.2F) << "at " << t << " s";
  }
  for (double t = 1.0 / 60.0; t <= 20.0; t += 1.0 / 60.0) {
    EXPECT_FALSE(isCameraCut(path.at(t - 1.0 / 60.0), path.at(t), hall.radius())) << t;
  }
}

TEST(CameraCut, IsATurnOf20DegreesOrAJumpOf5Percent) {
  Camera a;
  Camera b = a;
  EXPECT_FALSE(isCameraCut(a, b, 10.0F));
  b.position.x = 0.49F;
  b.target.x = 0.49F;
  EXPECT_FALSE(isCameraCut(a, b, 10.0F));
  b.position.x = 0.51F;
  b.target.x = 0.51F;
  EXPECT_TRUE(isCameraCut(a, b, 10.0F));
  const auto turned = [&](double degrees) {
    Camera c = a;
    c.target = {std::sin(degrees * kDegree), 0.0, -std::cos(degrees * kDegree)};
    return c;
  };
  EXPECT_FALSE(isCameraCut(a, turned(19.9), 10.0F));
  EXPECT_TRUE(isCameraCut(a, turned(20.1), 10.0F));
  EXPECT_TRUE(isCameraCut(a, turned(-170), 10.0F));
  Camera rolled = a;
  rolled.up = {std::sin(25 * kDegree), std::cos(25 * kDegree), 0.0};
  EXPECT_TRUE(isCameraCut(a, rolled, 10.0F));
}

}  // namespace
}  // namespace macula::scene
