#include "engine/scene/environment.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/scene/environment_limits.h"

namespace macula::scene {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
/// Wide enough for a background that is looked at on a 1024-pixel window.
constexpr int kMaxSide = 2048;
/// The roughest level; fewer texels would show the lobes' seams.
constexpr int kMinWidth = 16;
/// Samples of a lobe, by its density and evenly over the hemisphere: a sun is so bright that the
/// lobe's skirts count, where few samples of the first kind are. With their footprints (see
/// blurred()) enough that no lobe shows single samples.
constexpr int kLobeSamples = 48;
constexpr int kEvenSamples = 48;
/// Small levels, whose lobes are wide in texels, have more, up to so many times; it costs little.
constexpr int kMostTimes = 16;
constexpr int kTexelsOfTimes = 8192;  ///< over the level's texels: how many times
/// From one sample to the next around the axis; no two then stand in a line (Vogel 1979).
constexpr float kGoldenAngle = 2.3999632F;

/// Share of the sphere's area, times 2, above a row's upper edge (Archimedes): between two rows it
/// differs by the area between them.
double bandTop(double row, int height) {
  return -std::cos(std::numbers::pi * row / height);
}

/// Half as many texels a side, rounded down: each the mean of the area that it covers, weighted by
/// solid angle, so that no light is lost or gained on the way.
Panorama halved(const Panorama& in) {
  Panorama out{std::max(1, in.width / 2), std::max(1, in.height / 2), {}};
  out.pixels.reserve(static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height));
  const auto edge = [](int i, int from, int to) {
    return static_cast<double>(i) * static_cast<double>(from) / static_cast<double>(to);
  };
  for (int y = 0; y < out.height; ++y) {
    const double top = edge(y, in.height, out.height);
    const double bottom = edge(y + 1, in.height, out.height);
    for (int x = 0; x < out.width; ++x) {
      const double left = edge(x, in.width, out.width);
      const double right = edge(x + 1, in.width, out.width);
      glm::dvec3 sum(0.0);
      double weight = 0.0;
      for (int sy = static_cast<int>(top); sy < bottom; ++sy) {
        const double band = bandTop(std::min(bottom, sy + 1.0), in.height) -
                            bandTop(std::max(top, static_cast<double>(sy)), in.height);
        for (int sx = static_cast<int>(left); sx < right; ++sx) {
          const double area =
              band * (std::min(right, sx + 1.0) - std::max(left, static_cast<double>(sx)));
          sum += area * glm::dvec3(in.at(sx, sy));
          weight += area;
        }
      }
      out.pixels.emplace_back(sum / weight);
    }
  }
  return out;
}

glm::vec3 sampleBilinear(const Panorama& p, glm::vec2 uv) {
  const float fx = uv.x * static_cast<float>(p.width) - 0.5F;
  const float fy = uv.y * static_cast<float>(p.height) - 0.5F;
  const float x0 = std::floor(fx);
  const float y0 = std::floor(fy);
  const auto column = [&](float x) {
    const int i = static_cast<int>(x) % p.width;
    return i < 0 ? i + p.width : i;
  };
  const auto row = [&](float y) { return std::clamp(static_cast<int>(y), 0, p.height - 1); };
  const glm::vec3 top =
      glm::mix(p.at(column(x0), row(y0)), p.at(column(x0 + 1.0F), row(y0)), fx - x0);
  const glm::vec3 low =
      glm::mix(p.at(column(x0), row(y0 + 1.0F)), p.at(column(x0 + 1.0F), row(y0 + 1.0F)), fx - x0);
  return glm::mix(top, low, fy - y0);
}

/// A sample of the GGX lobe around +z, for a view along it.
struct LobeSample {
  glm::vec3 direction;
  float weight;       ///< of its radiance; they do not add up to 1
  double solidAngle;  ///< that it stands for
};

/// @param times as many samples as the least
std::vector<LobeSample> lobeOf(float roughness, int times) {
  std::vector<LobeSample> lobe;
  const int byLobe = times * kLobeSamples;
  const int even = times * kEvenSamples;
  const float a2 = roughness * roughness * roughness * roughness;
  const auto add = [&](int i, float cosH) {
    const float cosine = 2.0F * cosH * cosH - 1.0F;
    if (cosine <= 0.0F) return;
    const float sine = std::sqrt(std::max(0.0F, 1.0F - cosine * cosine));
    const float phi = kGoldenAngle * static_cast<float>(i);
    // With V = N the density of directions is D / 4 (Karis 2013, Eq. 48); both kinds of samples
    // share the hemisphere by the balance heuristic (Veach and Guibas 1995, Eq. 14).
    const double spread = (static_cast<double>(a2) - 1.0) * cosH * cosH + 1.0;
    const double density = static_cast<double>(a2) / (4.0 * std::numbers::pi * spread * spread);
    const double solidAngle = 1.0 / (byLobe * density + even / (2.0 * std::numbers::pi));
    lobe.push_back({{sine * std::cos(phi), sine * std::sin(phi), cosine},
                    static_cast<float>(density * solidAngle) * cosine,
                    solidAngle});
  };
  for (int i = 0; i < byLobe; ++i) {
    const float xi = (static_cast<float>(i) + 0.5F) / static_cast<float>(byLobe);
    add(i, std::sqrt((1.0F - xi) / (1.0F + (a2 - 1.0F) * xi)));
  }
  for (int i = 0; i < even; ++i) {
    const float cosine = (static_cast<float>(i) + 0.5F) / static_cast<float>(even);
    add(i, std::sqrt(0.5F * (1.0F + cosine)));
  }
  return lobe;
}

/// Blurs with the GGX lobe of `roughness` around each texel's own direction. Each sample is taken
/// from the average whose texels are as large as what the sample stands for (Colbert and Krivanek
/// 2007, "GPU-Based Importance Sampling", Eq. 13), or else a sun would fall between the samples.
/// @param averages the panorama, halved from one to the next @param level of the result's size
Panorama blurred(const std::vector<Panorama>& averages, std::size_t level, float roughness) {
  const Panorama& in = averages[level];
  Panorama out{in.width, in.height, {}};
  out.pixels.resize(in.pixels.size());
  const int times = std::clamp(kTexelsOfTimes / (in.width * in.height), 1, kMostTimes);
  const std::vector<LobeSample> lobe = lobeOf(roughness, times);
  std::vector<std::size_t> levels;
  const double texel = 4.0 * kPi / static_cast<double>(in.pixels.size());
  for (const LobeSample& sample : lobe) {
    // Rounded up: too smooth is better than single samples. Finer than the result where samples are
    // many, or else a sun would stand in the middle of a wide texel; not so fine that a lobe could
    // fall between two texels of the result.
    constexpr double kFinest = -2.0;
    const double steps = std::max(kFinest, std::ceil(0.5 * std::log2(sample.solidAngle / texel)));
    const double index = std::clamp(static_cast<double>(level) + steps, 0.0,
                                    static_cast<double>(averages.size() - 1));
    levels.push_back(static_cast<std::size_t>(index));
  }
  for (int y = 0; y < in.height; ++y) {
    for (int x = 0; x < in.width; ++x) {
      const glm::vec3 n =
          directionOf((static_cast<float>(x) + 0.5F) / static_cast<float>(in.width),
                      (static_cast<float>(y) + 0.5F) / static_cast<float>(in.height));
      // No texel's middle is a pole.
      const glm::vec3 tangent = glm::normalize(glm::cross(glm::vec3(0, 1, 0), n));
      const glm::vec3 bitangent = glm::cross(n, tangent);
      glm::vec3 sum(0.0F);
      float weight = 0.0F;
      for (std::size_t i = 0; i < lobe.size(); ++i) {
        const glm::vec3& d = lobe[i].direction;
        const glm::vec3 l = tangent * d.x + bitangent * d.y + n * d.z;
        sum += sampleBilinear(averages[levels[i]], panoramaUv(l)) * lobe[i].weight;
        weight += lobe[i].weight;
      }
      out.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(in.width) +
                 static_cast<std::size_t>(x)] = weight > 0.0F ? sum / weight : glm::vec3(0.0F);
    }
  }
  return out;
}

/// Real spherical harmonics up to l = 2 in the order (0,0) (1,-1) (1,0) (1,1) (2,-2) .. (2,2).
std::array<float, 9> harmonics(const glm::vec3& d) {
  return {0.282095F,
          0.488603F * d.y,
          0.488603F * d.z,
          0.488603F * d.x,
          1.092548F * d.x * d.y,
          1.092548F * d.y * d.z,
          0.315392F * (3.0F * d.z * d.z - 1.0F),
          1.092548F * d.x * d.z,
          0.546274F * (d.x * d.x - d.y * d.y)};
}

/// Convolution with the clamped cosine over pi: A_l / pi of Ramamoorthi and Hanrahan 2001, Eq. 8.
constexpr std::array<float, 9> kCosineLobe{1.0F,  2.0F / 3.0F, 2.0F / 3.0F, 2.0F / 3.0F, 0.25F,
                                           0.25F, 0.25F,       0.25F,       0.25F};

std::array<glm::vec3, 9> irradianceOf(const Panorama& p) {
  std::array<glm::dvec3, 9> sum{};
  for (int y = 0; y < p.height; ++y) {
    const double solidAngle =
        2.0 * std::numbers::pi / p.width * (bandTop(y + 1.0, p.height) - bandTop(y, p.height));
    const float v = (static_cast<float>(y) + 0.5F) / static_cast<float>(p.height);
    for (int x = 0; x < p.width; ++x) {
      const float u = (static_cast<float>(x) + 0.5F) / static_cast<float>(p.width);
      const std::array<float, 9> basis = harmonics(directionOf(u, v));
      for (std::size_t i = 0; i < sum.size(); ++i) {
        sum[i] += glm::dvec3(p.at(x, y)) * (static_cast<double>(basis[i]) * solidAngle);
      }
    }
  }
  std::array<glm::vec3, 9> irradiance{};
  for (std::size_t i = 0; i < sum.size(); ++i) {
    irradiance[i] = glm::vec3(sum[i] * static_cast<double>(kCosineLobe[i]));
  }
  return irradiance;
}

}  // namespace

glm::vec3 directionOf(float u, float v) {
  const float phi = (u - 0.5F) * 2.0F * kPi;
  const float theta = v * kPi;
  return {std::sin(theta) * std::sin(phi), std::cos(theta), -std::sin(theta) * std::cos(phi)};
}

glm::vec2 panoramaUv(const glm::vec3& d) {
  return {std::atan2(d.x, -d.z) / (2.0F * kPi) + 0.5F,
          std::acos(std::clamp(d.y, -1.0F, 1.0F)) / kPi};
}

Environment makeEnvironment(Panorama panorama) {
  Environment environment;
  const std::string unusable = makeUsable(panorama);
  if (!unusable.empty()) environment.warnings.push_back(unusable);
  while (std::max(panorama.width, panorama.height) > kMaxSide) panorama = halved(panorama);
  environment.irradiance = irradianceOf(panorama);
  std::size_t count = 1;
  for (int w = panorama.width; w / 2 >= kMinWidth; w /= 2) ++count;
  std::vector<Panorama> averages{std::move(panorama)};
  while (averages.back().width > 1) averages.push_back(halved(averages.back()));
  for (std::size_t i = 1; i < count; ++i) {
    environment.levels.push_back(
        blurred(averages, i, static_cast<float>(i) / static_cast<float>(count - 1)));
    (void)limitRadiance(environment.levels.back());
  }
  environment.levels.insert(environment.levels.begin(), std::move(averages.front()));
  const std::string limited = describe(limitRadiance(environment.levels.front()));
  if (!limited.empty()) environment.warnings.push_back(limited);
  return environment;
}

}  // namespace macula::scene
