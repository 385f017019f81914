// Level of detail and foveation: the shaders against plain mirrors, counts, allocation, history.
#include <gmock/gmock.h>

#include <bit>
#include <cmath>
#include <set>

#include "allocation_count.h"
#include "gl_fixture.h"
#include "lod_mirror.h"
#include "lod_scenes.h"
#include "passes/lod/plan.h"
#include "shared/lod_totals.h"

namespace macula::test {
namespace {

constexpr glm::ivec2 kSize{150, 101};  // no multiple of tiles or groups
/// As in shaders/lib/lod.glsl.
constexpr double kLeastFit = 0.05;
/// Float against double: a pixel as near to the bound may fall on either side.
constexpr double kFitSlack = 2e-3;

/// Half floats hold 11 bits.
bool isUnlike(const float* rgb, const glm::dvec3& wanted) {
  for (int c = 0; c < 3; ++c) {
    if (std::abs(static_cast<double>(rgb[c]) - wanted[c]) > 2e-3 * wanted[c] + 1e-4) return true;
  }
  return false;
}

double unpackHalf(std::uint32_t bits) {
  const double sign = (bits & 0x8000U) != 0 ? -1.0 : 1.0;
  const int exponent = static_cast<int>((bits >> 10U) & 31U);
  const double mantissa = (bits & 1023U) / 1024.0;
  return sign *
         (exponent == 0 ? std::ldexp(mantissa, -14) : std::ldexp(1.0 + mantissa, exponent - 15));
}

double unpackSnorm(std::uint32_t byte) {
  return std::max(-1.0, static_cast<double>(static_cast<std::int8_t>(byte & 255U)) / 127.0);
}

MirrorSample unpack(const std::uint32_t* texel) {
  return {
      .value = {unpackHalf(texel[0] & 0xFFFFU), unpackHalf(texel[0] >> 16U),
                unpackHalf(texel[1] & 0xFFFFU)},
      .inverseDistance = static_cast<double>(std::bit_cast<float>(texel[2])),
      .normal = {unpackSnorm(texel[3]), unpackSnorm(texel[3] >> 8U), unpackSnorm(texel[3] >> 16U)}};
}

glm::dvec3 decodeOctahedral(float x, float y) {
  glm::dvec3 n(x, y, 1.0 - std::abs(x) - std::abs(y));
  const double t = std::max(-n.z, 0.0);
  n.x += n.x >= 0.0 ? -t : t;
  n.y += n.y >= 0.0 ? -t : t;
  return glm::normalize(n);
}

/// What the GPU reconstructed from, for the mirror.
ReconstructionMirror mirrorOf(const Bench& bench) {
  ReconstructionMirror mirror;
  const passes::LodPlan& plan = bench.renderer.lod();
  mirror.filter = plan.reconstruction;
  mirror.view = bench.renderer.inputs().view;
  mirror.size = plan.size;
  mirror.texels = plan.texels;
  mirror.resize = static_cast<float>(plan.resize);
  mirror.samplesPerRow = plan.size.x;
  const std::vector<std::uint32_t> texels = bench.words(passes::kLodSamples, 4);
  for (std::size_t i = 0; i < texels.size(); i += 4) mirror.samples.push_back(unpack(&texels[i]));
  mirror.depth = bench.depths(passes::kDepth);
  const std::vector<float> normals = bench.floats(passes::kNormal, 2);
  for (std::size_t i = 0; i < normals.size(); i += 2) {
    mirror.normal.push_back(decodeOctahedral(normals[i], normals[i + 1]));
  }
  if (plan.foveated) {
    const std::vector<std::uint32_t> all = bench.words(passes::kShadingRate, 1);
    const int row = (plan.size.x + LOD_TILE - 1) / LOD_TILE;
    for (int y = 0; y < plan.tiles.y; ++y) {
      for (int x = 0; x < plan.tiles.x; ++x) {
        mirror.levels.push_back(
            static_cast<int>(all[static_cast<std::size_t>(y * row + x)] >> 8U & 3U));
      }
    }
  }
  return mirror;
}

passes::RenderSettings foveatedSettings(double pixelsPerDegree) {
  passes::RenderSettings settings = resized(1.0);
  settings.foveation.enabled = true;
  settings.foveation.pixelsPerDegree = pixelsPerDegree;
  return settings;
}

TEST(LodMirror, AgreesWithTheHand) {
  // Pitch 2: the middle of cell 3 is pixel boundary 7, so its sample is pixel 7.
  EXPECT_EQ(samplePixel(3, 2.0F, 100), 7);
  EXPECT_EQ(samplePixel(3, 1.5F, 100), 5);  // 5.25
  EXPECT_EQ(samplePixel(3, 2.0F, 6), 5) << "never outside";
  // On the axis: MAR(0) = 1/48 degree is 0.9375 pixels at 45 a degree; two samples to it.
  RateMirror rates;
  rates.size = {1024, 1024};
  rates.gaze = {512, 512};
  rates.viewer = 45.0 * 57.29577951308232;
  rates.fovealMar = 1.0 / 48.0;
  EXPECT_NEAR(rates.allowedPitch({512, 512}), 0.46875, 1e-9);
  // 10 degrees off: 0.22 + 0.0208 degrees, 10.84 pixels, half of that.
  const double tenDegrees = 512.0 + rates.viewer * std::tan(10.0 / 57.29577951308232);
  EXPECT_NEAR(rates.allowedPitch({tenDegrees, 512}), 5.41875, 1e-6);
  EXPECT_EQ(rates.level({static_cast<int>(tenDegrees) / 16, 32}), 2);
  rates.widened = tenDegrees - 512.0;
  EXPECT_NEAR(rates.allowedPitch({tenDegrees, 512}), 0.46875, 1e-9) << "all of it is looked at";
}

TEST(LodMirror, WeighsByHand) {
  // Two samples in a row at pixels 1 and 3 (r = 2, image 4 x 1... of which one row is looked at).
  ReconstructionMirror mirror;
  scene::Camera camera;
  camera.nearPlane = 1.0F;
  camera.farPlane = 100.0F;
  mirror.view = scene::makeView(camera, 1.0F);
  mirror.size = {4, 4};
  mirror.texels = {2, 2};
  mirror.resize = 2.0F;
  mirror.samplesPerRow = 2;
  // All at distance 2 and facing the eye; the right ones lie 1 pixel's span behind the plane.
  const double span = 2.0 / static_cast<double>(mirror.view.projection[1][1]) / 4.0 * 2.0;
  const MirrorSample left{{1.0, 0.0, 0.0}, 0.5, {0, 0, 1}};
  const MirrorSample right{{0.0, 1.0, 0.0}, 1.0 / (2.0 + span), {0, 0, 1}};
  mirror.samples = {left, right, left, right};
  const auto depth = static_cast<float>((0.5 - 0.01) * 100.0 / 99.0);
  mirror.depth.assign(16, depth);
  mirror.normal.assign(16, {0, 0, 1});
  mirror.filter = passes::Reconstruction::Bilinear;
  EXPECT_NEAR(mirror.pixel({2, 2}).value.y, 0.5, 1e-6);
  // The right ones lie 0.4142 behind, 0.8284 of what a pixel spans there: plane = 0.8284 / 0.35,
  // miss = 1 + 5.602, fit = 0.02294.
  mirror.filter = passes::Reconstruction::Macula;
  EXPECT_NEAR(mirror.pixel({2, 2}).value.y, 0.02294 / 1.02294, 1e-5);
  EXPECT_NEAR(mirror.pixel({2, 2}).best, 1.0, 1e-6);
  // Yang: relative depth difference span / (2 + span)... over sigma, as a Gaussian.
  mirror.filter = passes::Reconstruction::Yang2008;
  mirror.sigmaDepth = 0.1;
  const double z = span / 2.0;
  const double gauss = std::exp(-0.5 * z * z / 0.01);
  EXPECT_NEAR(mirror.pixel({2, 2}).value.y, gauss / (1.0 + gauss), 1e-6);
}

TEST_F(GlTest, ReconstructionIsWhatTheMirrorSays) {
  const scene::Scene scene = wires();
  for (const auto filter : {passes::Reconstruction::Bilinear, passes::Reconstruction::Yang2008,
                            passes::Reconstruction::Macula}) {
    for (const double r : {1.3, 2.0, 3.7, 8.0}) {
      passes::RenderSettings settings = resized(r);
      settings.lod.reconstruction = filter;
      settings.lod.demodulate = false;
      Bench bench(scene, settings, kSize, device());
      const passes::FrameResult result = bench.draw();
      const ReconstructionMirror mirror = mirrorOf(bench);
      const std::vector<float> image = radiance(bench);
      std::uint64_t holes = 0;
      std::uint64_t doubtful = 0;
      int wrong = 0;
      for (int y = 0; y < kSize.y; ++y) {
        for (int x = 0; x < kSize.x; ++x) {
          const auto expected = mirror.pixel({x, y});
          const bool edge = std::abs(expected.best - kLeastFit) < kFitSlack;
          doubtful += edge ? 1 : 0;
          if (filter != passes::Reconstruction::Bilinear && expected.best < kLeastFit) {
            ++holes;
            continue;
          }
          const auto at = static_cast<std::size_t>(y * kSize.x + x) * 4;
          wrong += !edge && isUnlike(&image[at], expected.value) ? 1 : 0;
        }
      }
      EXPECT_EQ(wrong, 0) << "r " << r << " filter " << static_cast<int>(filter);
      EXPECT_LE(holes > result.shading.holes ? holes - result.shading.holes
                                             : result.shading.holes - holes,
                doubtful);
      if (filter != passes::Reconstruction::Bilinear) {
        EXPECT_GT(holes, 10U) << "wires leave holes";
      }
    }
  }
}

TEST_F(GlTest, FoveatedReconstructionIsWhatTheMirrorSays) {
  constexpr glm::ivec2 kWide{300, 200};
  for (const double r : {1.0, 1.6}) {
    passes::RenderSettings settings = foveatedSettings(14.0);
    settings.foveation.slope = 0.1;
    settings.lod.resize = r;
    settings.lod.demodulate = false;
    Bench bench(still(), settings, kWide, device());
    (void)bench.draw({0.3F, 0.6F});
    const ReconstructionMirror mirror = mirrorOf(bench);
    EXPECT_EQ(std::set<int>(mirror.levels.begin(), mirror.levels.end()).size(), r == 1.0 ? 4U : 3U)
        << "every rate occurs";
    const std::vector<float> image = radiance(bench);
    int wrong = 0;
    int compared = 0;
    for (int y = 0; y < kWide.y; ++y) {
      for (int x = 0; x < kWide.x; ++x) {
        const auto expected = mirror.pixel({x, y});
        if (expected.best < kLeastFit + kFitSlack) continue;  // a hole, or nearly
        ++compared;
        const auto at = static_cast<std::size_t>(y * kWide.x + x) * 4;
        wrong += isUnlike(&image[at], expected.value) ? 1 : 0;
      }
    }
    EXPECT_EQ(wrong, 0) << r;
    EXPECT_GT(compared, kWide.x * kWide.y * 8 / 10);
  }
}

TEST_F(GlTest, PixelsThatWereShadedKeepTheirValue) {
  Bench full(still(), resized(1.0), kSize, device());
  (void)full.draw();
  const std::vector<float> wanted = radiance(full);
  for (const double r : {2.0, 3.3}) {
    passes::RenderSettings settings = resized(r);
    settings.lod.demodulate = false;
    Bench bench(still(), settings, kSize, device());
    (void)bench.draw();
    const std::vector<float> got = radiance(bench);
    const auto pitch = static_cast<float>(r);
    const glm::ivec2 texels = passes::resizedTexels(kSize, r);
    int unlike = 0;
    for (int j = 0; j < texels.y; ++j) {
      for (int i = 0; i < texels.x; ++i) {
        const int x = samplePixel(i, pitch, kSize.x);
        const int y = samplePixel(j, pitch, kSize.y);
        const auto at = static_cast<std::size_t>(y * kSize.x + x) * 4;
        for (std::size_t c = 0; c < 3; ++c) {
          // Both are half floats, but need not be rounded alike.
          const float step = std::abs(wanted[at + c]) / 1024.0F;
          unlike += std::abs(got[at + c] - wanted[at + c]) > step ? 1 : 0;
        }
      }
    }
    EXPECT_EQ(unlike, 0) << r;
  }
}

TEST_F(GlTest, HolesHaveTheirFullRateValue) {
  Bench full(wires(), resized(1.0), kSize, device());
  (void)full.draw();
  const std::vector<float> wanted = radiance(full);
  passes::RenderSettings settings = resized(4.0);
  settings.readBack = true;
  Bench bench(wires(), settings, kSize, device());
  const passes::FrameResult result = bench.draw();
  ASSERT_GT(result.shading.holes, 50U);
  const std::vector<std::uint32_t> holes = bench.bufferWords(passes::kLodHoles);
  const std::vector<float> got = radiance(bench);
  std::set<std::uint32_t> places;
  for (std::uint64_t i = 0; i < result.shading.holes; ++i) {
    places.insert(holes[i]);
    const auto at =
        ((holes[i] >> 16U) * static_cast<std::size_t>(kSize.x) + (holes[i] & 0xFFFFU)) * 4;
    for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(got[at + c], wanted[at + c]);
  }
  EXPECT_EQ(places.size(), result.shading.holes) << "each is listed once";
}

TEST_F(GlTest, FullRateWithControlsReadyIsTheSameImage) {
  Bench plain(richStill(), resized(1.0), kSize, device());
  (void)plain.draw();
  Bench bench(richStill(), resized(1.0), kSize, device());
  bench.renderer.setControls({.resize = 2.0F});
  (void)bench.draw();
  EXPECT_GT(rootMeanSquare(radiance(plain), radiance(bench)), 0.0);
  bench.renderer.setControls({.resize = 1.0F});
  const passes::FrameResult result = bench.draw();
  EXPECT_EQ(radiance(plain), radiance(bench));
  EXPECT_EQ(result.resizeFactor, 1.0);
  EXPECT_EQ(result.shading.shaded, result.shading.pixels);
}

TEST_F(GlTest, PartsAtFullRateAreTheSameButForTheirBytes) {
  Bench plain(richStill(), resized(1.0), kSize, device());
  (void)plain.draw();
  for (const char* what : {"shadow", "ao", "noise", "shadow,ao,noise"}) {
    Bench bench(richStill(), resized(1.0, what), kSize, device());
    bench.renderer.setControls({.resize = 1.0001F});  // parts go through their texture
    (void)bench.draw();
    bench.renderer.setControls({.resize = 1.0F});
    (void)bench.draw();
    // Parts are bytes: half a step of 1/255 of the light at the most.
    EXPECT_LT(rootMeanSquare(radiance(plain), radiance(bench)), 2e-3) << what;
  }
}

TEST_F(GlTest, RestartForgetsThatAControlAsked) {
  const passes::RenderSettings settings = resized(1.0, "shadow,ao,noise");
  Bench plain(richStill(), settings, kSize, device());
  (void)plain.draw();
  Bench bench(richStill(), settings, kSize, device());
  bench.renderer.setControls({.resize = 2.0F});
  (void)bench.draw();
  EXPECT_TRUE(bench.renderer.lod().wanted);
  bench.renderer.setControls({.resize = 1.0F});
  bench.renderer.restart();
  (void)bench.draw();
  EXPECT_FALSE(bench.renderer.lod().wanted);
  EXPECT_EQ(radiance(plain), radiance(bench)) << "no part went through its texture of bytes";
  // A quality control away from its default asks again.
  bench.renderer.setControls({.resize = 2.0F});
  bench.renderer.restart();
  EXPECT_EQ(bench.draw().resizeFactor, 2.0);
}

TEST_F(GlTest, RatesAreWhatTheMirrorSays) {
  const glm::ivec2 size{1000, 600};
  for (const glm::vec2 gaze : {glm::vec2(0.5F), glm::vec2(0.0F, 1.0F), glm::vec2(0.83F, 0.2F)}) {
    for (const float radius : {gaze::kFoveaRadius, 0.25F}) {
      for (const double r : {1.0, 1.7}) {
        passes::RenderSettings settings = foveatedSettings(45.0);
        settings.lod.resize = r;
        Bench bench(still(), settings, size, device());
        gaze::PointOfInterest point = gaze::exactPoint(gaze);
        point.radius = radius;
        const passes::FrameResult result = bench.renderer.render(bench.camera, point);
        const passes::LodPlan& plan = bench.renderer.lod();
        RateMirror mirror;
        mirror.size = size;
        mirror.gaze = glm::dvec2(gaze.x, 1.0F - gaze.y) * mirror.size;
        mirror.widened = static_cast<double>(radius - gaze::kFoveaRadius) * size.y;
        mirror.viewer = 45.0 * 57.29577951308232;
        mirror.fovealMar = settings.foveation.fovealMar;
        mirror.resize = static_cast<double>(static_cast<float>(r));
        const std::vector<int> levels = mirrorOf(bench).levels;
        int unlike = 0;
        std::uint64_t shaded = 0;
        for (int y = 0; y < plan.tiles.y; ++y) {
          for (int x = 0; x < plan.tiles.x; ++x) {
            const int level = levels[static_cast<std::size_t>(y * plan.tiles.x + x)];
            unlike += level != mirror.level({x, y}) ? 1 : 0;
            const glm::ivec2 inside =
                glm::min(plan.texels - glm::ivec2(x, y) * LOD_TILE, glm::ivec2(LOD_TILE));
            const glm::ivec2 cells = (inside + (1 << level) - 1) / (1 << level);
            shaded += static_cast<std::uint64_t>(cells.x) * static_cast<std::uint64_t>(cells.y);
          }
        }
        // Float against double: a tile on the very border of a rate.
        EXPECT_LE(unlike, 1) << gaze.x << ' ' << radius << ' ' << r;
        EXPECT_EQ(result.shading.shaded - result.shading.holes, shaded);
      }
    }
  }
}

TEST_F(GlTest, EverySampleOfATileIsShaded) {
  // Texels that no sample is for keep the marker.
  Bench bench(still(), foveatedSettings(20.0), {200, 120}, device());
  (void)bench.draw();
  const std::uint32_t marker[4] = {7, 7, 7, 7};
  const gl::Texture& samples = bench.renderer.resources().texture(passes::kLodSamples);
  glClearTexImage(samples.id(), 0, GL_RGBA_INTEGER, GL_UNSIGNED_INT, marker);
  const passes::FrameResult result = bench.draw({0.2F, 0.2F});
  const std::vector<std::uint32_t> texels = bench.words(passes::kLodSamples, 4);
  const std::vector<int> levels = mirrorOf(bench).levels;
  const passes::LodPlan& plan = bench.renderer.lod();
  std::uint64_t written = 0;
  for (int y = 0; y < plan.texels.y; ++y) {
    for (int x = 0; x < plan.texels.x; ++x) {
      const int level =
          levels[static_cast<std::size_t>((y / LOD_TILE) * plan.tiles.x + x / LOD_TILE)];
      const int mask = (1 << level) - 1;
      const bool sampled = (x & mask) == 0 && (y & mask) == 0;
      const bool touched = texels[static_cast<std::size_t>(y * plan.size.x + x) * 4 + 3] != 7;
      EXPECT_EQ(sampled, touched) << x << ',' << y;
      written += touched ? 1 : 0;
    }
  }
  EXPECT_EQ(written, result.shading.shaded - result.shading.holes);
}

}  // namespace
}  // namespace macula::test
