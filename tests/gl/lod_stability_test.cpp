// Where resizing fails when it is done badly: thin geometry, silhouettes, grazing planes, factors
// and gaze that change from frame to frame.
#include <gmock/gmock.h>

#include <cmath>

#include "engine/measure/flicker.h"
#include "gl_fixture.h"
#include "lod_scenes.h"

namespace macula::test {
namespace {

constexpr glm::ivec2 kSize{128, 128};

std::vector<float> draw(const scene::Scene& scene, const passes::RenderSettings& settings,
                        passes::DeviceContext& device) {
  Bench bench(scene, settings, kSize, device);
  (void)bench.draw();
  return radiance(bench);
}

passes::RenderSettings by(passes::Reconstruction filter, double r,
                          const std::string& what = "shading") {
  passes::RenderSettings settings = resized(r, what);
  settings.lod.reconstruction = filter;
  return settings;
}

using enum passes::Reconstruction;

TEST_F(GlTest, ThinWiresLeaveNoNanAndNoWhite) {
  const std::vector<float> full = draw(wires(), resized(1.0), device());
  const float brightest = *std::max_element(full.begin(), full.end());
  for (const auto filter : {Yang2008, Macula}) {
    for (const auto holes : {passes::Holes::Shade, passes::Holes::Tap}) {
      for (const double r : {2.0, 5.5, 8.0}) {
        passes::RenderSettings settings = by(filter, r);
        settings.lod.holes = holes;
        // So small that even the same surface hardly fits.
        settings.lod.sigmaDepth = 1e-5;
        settings.lod.sigmaNormal = 1e-3;
        Bench bench(wires(), settings, kSize, device());
        const passes::FrameResult result = bench.draw();
        EXPECT_EQ(result.shading.holes > 0, holes == passes::Holes::Shade);
        for (const float value : radiance(bench)) {
          ASSERT_TRUE(std::isfinite(value));
          // Light apart from colour may come out a little brighter than any pixel was.
          ASSERT_LE(value, 1.5F * brightest);
        }
      }
    }
  }
}

TEST_F(GlTest, WiresAreAsDarkAsAtFullRate) {
  const std::vector<float> full = draw(wires(), resized(1.0), device());
  const double plain = rootMeanSquare(full, draw(wires(), by(Bilinear, 4.0), device()));
  const double fitted = rootMeanSquare(full, draw(wires(), by(Macula, 4.0), device()));
  EXPECT_LT(fitted, 0.4 * plain) << fitted << " against " << plain;
}

/// Error of the pixels that are next to a silhouette in the depth buffer, and of the others.
struct EdgeError {
  double edge = 0.0;
  double elsewhere = 0.0;
};

EdgeError edgeError(const scene::Scene& scene, const passes::RenderSettings& settings,
                    passes::DeviceContext& device) {
  Bench full(scene, resized(1.0), kSize, device);
  (void)full.draw();
  Bench bench(scene, settings, kSize, device);
  (void)bench.draw();
  const std::vector<float> depth = full.depths(passes::kDepth);
  const std::vector<float> wanted = radiance(full);
  const std::vector<float> got = radiance(bench);
  double sums[2] = {0.0, 0.0};
  int counts[2] = {0, 0};
  for (int y = 2; y < kSize.y - 2; ++y) {
    for (int x = 2; x < kSize.x - 2; ++x) {
      const auto depthAt = [&](int dx, int dy) {
        return depth[static_cast<std::size_t>((y + dy) * kSize.x + x + dx)];
      };
      float least = depthAt(0, 0);
      float most = least;
      for (int d = -2; d <= 2; ++d) {
        least = std::min({least, depthAt(d, 0), depthAt(0, d)});
        most = std::max({most, depthAt(d, 0), depthAt(0, d)});
      }
      const int kind = most > 1.3F * least ? 0 : 1;
      const auto at = static_cast<std::size_t>(y * kSize.x + x) * 4;
      for (std::size_t c = 0; c < 3; ++c) {
        const double d = static_cast<double>(wanted[at + c]) - static_cast<double>(got[at + c]);
        sums[kind] += d * d;
      }
      ++counts[kind];
    }
  }
  EXPECT_GT(counts[0], 200) << "there are silhouettes";
  return {std::sqrt(sums[0] / counts[0]), std::sqrt(sums[1] / counts[1])};
}

TEST_F(GlTest, SilhouettesHaveNoHalo) {
  // Yang 2008, Fig. 4: parts of the shading leak over depth edges when they are spread bilinearly.
  const EdgeError plain = edgeError(litCard(), by(Bilinear, 4.0, "shadow"), device());
  EXPECT_GT(plain.edge, 0.1) << "a halo";
  EXPECT_GT(plain.edge, 10.0 * plain.elsewhere);
  for (const auto filter : {Yang2008, Macula}) {
    const EdgeError fitted = edgeError(litCard(), by(filter, 4.0, "shadow"), device());
    EXPECT_LT(fitted.edge, 0.01 * plain.edge) << "none";
  }
  // The whole of the shading, colours apart.
  const EdgeError whole = edgeError(litCard(), by(Macula, 4.0), device());
  EXPECT_LT(whole.edge, 0.02 * edgeError(litCard(), by(Bilinear, 4.0), device()).edge);
}

TEST_F(GlTest, SurfaceColoursStayAtFullRate) {
  scene::Scene scene = still();
  for (scene::Primitive& primitive : scene.primitives) {
    std::uint32_t n = 0;
    for (scene::VertexAttributes& vertex : primitive.attributes) {
      vertex.color = glm::vec4(glm::vec3((n++ % 3) == 0 ? 0.1F : 1.0F), 1.0F);
    }
  }
  scene.lights.clear();
  scene.ambient = glm::vec3(0.7F);
  passes::RenderSettings settings = by(Macula, 4.0);
  const std::vector<float> full = draw(scene, resized(1.0), device());
  const double light = rootMeanSquare(full, draw(scene, settings, device()));
  settings.lod.demodulate = false;
  const double all = rootMeanSquare(full, draw(scene, settings, device()));
  EXPECT_GT(all, 5e-3);
  EXPECT_LT(light, 0.3 * all) << "even light carries nothing of the colours";
}

TEST_F(GlTest, ColoursOfEveryKindOfMaterialAreThoseOfFullRate) {
  const scene::Scene scene = swatches();
  const std::vector<float> full = draw(scene, resized(1.0), device());
  std::vector<passes::RenderSettings> all;
  for (const double r : {1.5, 2.0, 4.0, 7.0}) all.push_back(by(Macula, r));
  passes::RenderSettings foveated = resized(1.0);
  foveated.foveation.enabled = true;
  foveated.foveation.pixelsPerDegree = 6.0;
  foveated.foveation.slope = 0.1;
  all.push_back(foveated);
  for (const passes::RenderSettings& settings : all) {
    Bench bench(scene, settings, kSize, device());
    const passes::FrameResult result = bench.draw({0.1F, 0.1F});
    const std::vector<float> got = radiance(bench);
    float worst = 0.0F;
    for (std::size_t i = 0; i < full.size(); ++i) {
      worst = std::max(worst, std::abs(full[i] - got[i]));
    }
    EXPECT_LT(worst, 0.02F) << "r " << settings.lod.resize;
    EXPECT_LT(result.shading.shaded, result.shading.pixels * 3 / 4);
  }
  // Nor does the best sample bring the light of another kind.
  passes::RenderSettings taps = by(Macula, 2.0);
  taps.lod.holes = passes::Holes::Tap;
  EXPECT_LT(rootMeanSquare(full, draw(scene, taps, device())), 0.05);
}

TEST_F(GlTest, BrightSamplesStayFinite) {
  scene::Scene scene = still();
  scene.materials[0].emissive = glm::vec3(3000.0F);
  scene.materials[0].baseColor = glm::vec4(0.0F, 0.0F, 0.0F, 1.0F);
  for (const float value : draw(scene, resized(2.0), device())) ASSERT_TRUE(std::isfinite(value));
}

TEST_F(GlTest, GrazingPlanesNeedTheTangentPlane) {
  // Nothing but a plane: its own samples fit everywhere, although depth changes fast across it.
  Bench bench(grazing(), by(Macula, 4.0), kSize, device());
  const passes::FrameResult macula = bench.draw();
  EXPECT_EQ(macula.shading.holes, 0U);
  passes::RenderSettings settings = by(Yang2008, 4.0);
  Bench yang(grazing(), settings, kSize, device());
  EXPECT_GT(yang.draw().shading.holes, macula.shading.holes) << "differences of depth alone fail";
  settings.lod.holes = passes::Holes::Tap;
  const std::vector<float> full = draw(grazing(), resized(1.0), device());
  const double published = rootMeanSquare(full, draw(grazing(), settings, device()));
  EXPECT_LT(rootMeanSquare(full, radiance(bench)), published);
}

TEST_F(GlTest, FlickerOfAFactorThatChangesEveryFrame) {
  // The picture stands still; what changes is r. Mean absolute change against the reference's, 0.
  const auto flickerOf = [&](passes::Reconstruction filter) {
    Bench bench(still(), by(filter, 1.5), kSize, device());
    measure::FlickerMeter meter;
    double sum = 0.0;
    constexpr int kFrames = 12;
    const image::ImageF reference{
        .width = kSize.x,
        .height = kSize.y,
        .channels = 3,
        .pixels = std::vector<float>(static_cast<std::size_t>(kSize.x * kSize.y) * 3, 0.0F)};
    for (int i = 0; i < kFrames; ++i) {
      bench.renderer.setControls({.resize = 2.0F + 0.4F * std::sin(1.7F * static_cast<float>(i))});
      (void)bench.draw();
      image::ImageF image = reference;
      image.pixels = bench.linear();
      sum += meter.next(reference, image).value_or(0.0);
    }
    return sum / (kFrames - 1);
  };
  const double plain = flickerOf(Bilinear);
  const double fitted = flickerOf(Macula);
  RecordProperty("flicker_bilinear_1e6", static_cast<int>(plain * 1e6));
  RecordProperty("flicker_macula_1e6", static_cast<int>(fitted * 1e6));
  EXPECT_GT(plain, 0.0);
  EXPECT_LT(fitted, 0.5 * plain) << fitted << " against " << plain;
}

TEST_F(GlTest, GazeThatJumpsLeavesNothingBehind) {
  passes::RenderSettings settings = resized(1.0);
  settings.foveation.enabled = true;
  settings.foveation.pixelsPerDegree = 10.0;
  Bench jumping(richStill(), settings, kSize, device());
  for (const glm::vec2 gaze :
       {glm::vec2(0, 0), glm::vec2(1, 1), glm::vec2(0, 1), glm::vec2(1, 0)}) {
    (void)jumping.draw(gaze);
    Bench fresh(richStill(), settings, kSize, device());
    (void)fresh.draw(gaze);
    EXPECT_EQ(radiance(jumping), radiance(fresh)) << gaze.x << ',' << gaze.y;
  }
}

TEST_F(GlTest, TheWindowMayChangeUnderAnyFactor) {
  passes::RenderSettings settings = resized(2.5, "shadow,ao,noise");
  settings.foveation.enabled = true;
  Bench bench(richStill(), settings, kSize, device());
  (void)bench.draw();
  for (const glm::ivec2 size : {glm::ivec2(33, 70), glm::ivec2(1, 1), glm::ivec2(128, 17)}) {
    bench.renderer.resize(size);
    (void)bench.draw();
    Bench fresh(richStill(), settings, size, device());
    (void)fresh.draw();
    EXPECT_EQ(radiance(bench), radiance(fresh)) << size.x << 'x' << size.y;
  }
}

}  // namespace
}  // namespace macula::test
