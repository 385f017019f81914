#include "engine/scene/environment.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace macula::scene {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
/// Wide enough for a background that is looked at on a 1024-pixel window.
constexpr int kMaxWidth = 2048;
/// The roughest level; fewer texels would show the lobes' seams.
constexpr int kMinWidth = 16;
/// Enough that the roughest lobe of a pre-averaged level shows no noise.
constexpr std::uint32_t kLobeSamples = 64;
/// A sun of 1e5 in one texel would sparkle through every lobe.
constexpr float kMaxRadiance = 1.0e4F;

Panorama halved(const Panorama& in) {
  Panorama out{std::max(1, in.width / 2), std::max(1, in.height / 2), {}};
  out.pixels.reserve(static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height));
  for (int y = 0; y < out.height; ++y) {
    for (int x = 0; x < out.width; ++x) {
      const int x1 = std::min(2 * x + 1, in.width - 1);
      const int y1 = std::min(2 * y + 1, in.height - 1);
      out.pixels.push_back(
          0.25F * (in.at(2 * x, 2 * y) + in.at(x1, 2 * y) + in.at(2 * x, y1) + in.at(x1, y1)));
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

float radicalInverse(std::uint32_t bits) {  // van der Corput, base 2
  float value = 0.0F;
  for (float digit = 0.5F; bits != 0; bits >>= 1, digit *= 0.5F) {
    if ((bits & 1U) != 0) value += digit;
  }
  return value;
}

/// Blurs with the GGX lobe of `roughness` around each texel's own direction (Karis 2013, Eq. 48).
Panorama blurred(const Panorama& in, float roughness) {
  Panorama out{in.width, in.height, {}};
  out.pixels.resize(in.pixels.size());
  const float a = roughness * roughness;
  for (int y = 0; y < in.height; ++y) {
    for (int x = 0; x < in.width; ++x) {
      const glm::vec3 n =
          directionOf((static_cast<float>(x) + 0.5F) / static_cast<float>(in.width),
                      (static_cast<float>(y) + 0.5F) / static_cast<float>(in.height));
      const glm::vec3 up = std::abs(n.y) < 0.99F ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
      const glm::vec3 tangent = glm::normalize(glm::cross(up, n));
      const glm::vec3 bitangent = glm::cross(n, tangent);
      glm::vec3 sum(0.0F);
      float weight = 0.0F;
      for (std::uint32_t i = 0; i < kLobeSamples; ++i) {
        const float phi = 2.0F * kPi * (static_cast<float>(i) + 0.5F) / kLobeSamples;
        const float xi = radicalInverse(i);
        const float cosH = std::sqrt((1.0F - xi) / (1.0F + (a * a - 1.0F) * xi));
        const float sinH = std::sqrt(std::max(0.0F, 1.0F - cosH * cosH));
        const glm::vec3 h =
            tangent * (sinH * std::cos(phi)) + bitangent * (sinH * std::sin(phi)) + n * cosH;
        const glm::vec3 l = 2.0F * glm::dot(n, h) * h - n;
        const float cosL = glm::dot(n, l);
        if (cosL <= 0.0F) continue;
        sum += sampleBilinear(in, panoramaUv(l)) * cosL;
        weight += cosL;
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
  std::array<glm::vec3, 9> sum{};
  for (int y = 0; y < p.height; ++y) {
    // The exact area of a texel of this row on the unit sphere (Archimedes' bands).
    const float top = kPi * static_cast<float>(y) / static_cast<float>(p.height);
    const float bottom = kPi * static_cast<float>(y + 1) / static_cast<float>(p.height);
    const float solidAngle =
        2.0F * kPi / static_cast<float>(p.width) * (std::cos(top) - std::cos(bottom));
    const float v = (static_cast<float>(y) + 0.5F) / static_cast<float>(p.height);
    for (int x = 0; x < p.width; ++x) {
      const float u = (static_cast<float>(x) + 0.5F) / static_cast<float>(p.width);
      const std::array<float, 9> basis = harmonics(directionOf(u, v));
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += p.at(x, y) * (basis[i] * solidAngle);
    }
  }
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] *= kCosineLobe[i];
  return sum;
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
  for (glm::vec3& p : panorama.pixels) p = glm::clamp(p, glm::vec3(0.0F), glm::vec3(kMaxRadiance));
  while (panorama.width > kMaxWidth) panorama = halved(panorama);
  int count = 1;
  for (int w = panorama.width; w / 2 >= kMinWidth; w /= 2) ++count;
  Environment environment;
  environment.levels.push_back(std::move(panorama));
  Panorama averaged = environment.levels.front();
  for (int i = 1; i < count; ++i) {
    averaged = halved(averaged);
    environment.levels.push_back(
        blurred(averaged, static_cast<float>(i) / static_cast<float>(count - 1)));
  }
  environment.irradiance = irradianceOf(environment.levels.front());
  return environment;
}

}  // namespace macula::scene
