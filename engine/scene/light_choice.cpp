#include "engine/scene/light_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace macula::scene {
namespace {

/// Lines of sight along each side of the part of the image that a light reaches, and sample points
/// on each line. More samples change the order only of lights that look alike.
constexpr int kLines = 6;
constexpr int kPlaces = 4;
/// Growth of the bounds, and the least distance to a light, in radii of the scene.
constexpr double kLeastRadii = 1e-3;

struct Range {
  double low;
  double high;
};

/// A camera as axes; x and y of a line of sight are those where it meets distance 1.
struct Sight {
  glm::dvec3 eye, right, up, ahead;
  double halfWidth, halfHeight;
};

Sight sightOf(const Camera& camera, float aspect) {
  Sight s{};
  s.eye = glm::dvec3(camera.position);
  s.ahead = glm::normalize(glm::dvec3(camera.target) - s.eye);
  s.right = glm::normalize(glm::cross(s.ahead, glm::dvec3(camera.up)));
  s.up = glm::cross(s.right, s.ahead);
  s.halfHeight = std::tan(0.5 * static_cast<double>(camera.verticalFov));
  s.halfWidth = s.halfHeight * static_cast<double>(aspect);
  return s;
}

/// The part of a line from the eye that lies inside a box.
std::optional<Range> inside(const Bounds& box, const glm::dvec3& eye, const glm::dvec3& line) {
  Range r{0.0, 1e300};
  for (int axis = 0; axis < 3; ++axis) {
    const double low = static_cast<double>(box.min[axis]) - eye[axis];
    const double high = static_cast<double>(box.max[axis]) - eye[axis];
    if (line[axis] == 0.0) {
      if (low > 0.0 || high < 0.0) return std::nullopt;
      continue;
    }
    const double a = low / line[axis];
    const double b = high / line[axis];
    r.low = std::max(r.low, std::min(a, b));
    r.high = std::min(r.high, std::max(a, b));
  }
  if (!(r.low < r.high)) return std::nullopt;
  return r;
}

/// Sides of the rectangle of the image that a ball can be seen in; all of it where it reaches the
/// eye. @param across of the ball's middle along an axis @param half of the image, at distance 1
Range sidesOf(double across, double ahead, double radius, double half) {
  const double nearest = ahead - radius;
  const double farthest = ahead + radius;
  if (nearest <= 0.0) return {-half, half};
  const auto least = [&](double v) { return v < 0.0 ? v / nearest : v / farthest; };
  const auto most = [&](double v) { return v > 0.0 ? v / nearest : v / farthest; };
  return {std::max(-half, least(across - radius)), std::min(half, most(across + radius))};
}

double strengthOf(const Light& light) {
  const glm::dvec3 weights(0.2126, 0.7152, 0.0722);  // luminance, Rec. 709
  return glm::dot(weights, glm::dvec3(light.color)) * static_cast<double>(light.intensity);
}

/// Attenuation by range and cone at a point, by KHR_lights_punctual, as shaders/lib/lighting.glsl.
double windowAt(const Light& light, const glm::dvec3& fromLight, double squared) {
  double window = 1.0;
  if (light.range > 0.0F) {
    const double q =
        squared / (static_cast<double>(light.range) * static_cast<double>(light.range));
    window = std::clamp(1.0 - q * q, 0.0, 1.0);
  }
  if (light.type != LightType::Spot) return window;
  constexpr double kLeastCone = 0.001;  // equal angles
  const double outer = std::cos(static_cast<double>(light.outerConeAngle));
  const double inner = std::cos(static_cast<double>(light.innerConeAngle));
  const double cosine = glm::dot(glm::dvec3(light.direction), fromLight) / std::sqrt(squared);
  const double a = std::clamp((cosine - outer) / std::max(kLeastCone, inner - outer), 0.0, 1.0);
  return window * a * a;
}

/// The integral of the illuminance of a light of one candela along a line: places at equal angles
/// as seen from the light, which makes the square of the distance cancel out (Kulla and Fajardo
/// 2012, "Importance Sampling Techniques for Path Tracing in Participating Media", section 4.1).
/// @param line unit length @param least distance to the light
double alongLine(const Light& light, const Sight& sight, const glm::dvec3& line, Range r,
                 double least) {
  const glm::dvec3 toLight = glm::dvec3(light.position) - sight.eye;
  const double middle = glm::dot(toLight, line);
  const double apart =
      std::max(least, std::sqrt(std::max(0.0, glm::dot(toLight, toLight) - middle * middle)));
  if (light.range > 0.0F) {
    const auto range = static_cast<double>(light.range);
    if (apart >= range) return 0.0;
    const double half = std::sqrt(range * range - apart * apart);
    r = {std::max(r.low, middle - half), std::min(r.high, middle + half)};
    if (!(r.low < r.high)) return 0.0;
  }
  const double from = std::atan((r.low - middle) / apart);
  const double turn = std::atan((r.high - middle) / apart) - from;
  double sum = 0.0;
  for (int i = 0; i < kPlaces; ++i) {
    const double along = middle + apart * std::tan(from + turn * (i + 0.5) / kPlaces);
    const glm::dvec3 fromLight = line * along - toLight;
    const double squared = std::max(glm::dot(fromLight, fromLight), least * least);
    sum += windowAt(light, fromLight, squared);
  }
  return sum / kPlaces * turn / apart;
}

}  // namespace

LightChoice::LightChoice(const std::vector<Light>& lights, const Bounds& bounds)
    : lights_(lights), bounds_(bounds), shares_(lights.size()), order_(lights.size()) {
  const auto more = static_cast<float>(kLeastRadii) * bounds.radius();
  bounds_.min -= more;
  bounds_.max += more;
}

double LightChoice::share(const Light& light, const Camera& camera, float aspect) const {
  const double strength = strengthOf(light);
  if (!(strength > 0.0) || bounds_.empty()) return 0.0;
  const Sight sight = sightOf(camera, aspect);
  const bool everywhere = light.type == LightType::Directional;
  Range x{-sight.halfWidth, sight.halfWidth};
  Range y{-sight.halfHeight, sight.halfHeight};
  if (!everywhere && light.range > 0.0F) {
    // Only the part in its reach is sampled, so that small lights do not fall between the lines.
    const glm::dvec3 d = glm::dvec3(light.position) - sight.eye;
    const double ahead = glm::dot(d, sight.ahead);
    const auto range = static_cast<double>(light.range);
    if (ahead + range <= 0.0) return 0.0;
    x = sidesOf(glm::dot(d, sight.right), ahead, range, sight.halfWidth);
    y = sidesOf(glm::dot(d, sight.up), ahead, range, sight.halfHeight);
    if (!(x.low < x.high) || !(y.low < y.high)) return 0.0;
  }
  const double stepX = (x.high - x.low) / kLines;
  const double stepY = (y.high - y.low) / kLines;
  const double radius = static_cast<double>(bounds_.radius());
  double sum = 0.0;
  for (int row = 0; row < kLines; ++row) {
    for (int column = 0; column < kLines; ++column) {
      const glm::dvec3 line =
          glm::normalize(sight.ahead + sight.right * (x.low + stepX * (column + 0.5)) +
                         sight.up * (y.low + stepY * (row + 0.5)));
      const std::optional<Range> r = inside(bounds_, sight.eye, line);
      if (!r) continue;
      if (everywhere) {
        sum += 1.0;
        continue;
      }
      // A line represents all within half a step of it: nearer distances are averaged out.
      const double far = std::max(0.0, glm::dot(glm::dvec3(light.position) - sight.eye, line));
      const double least = std::max(kLeastRadii * radius, 0.5 * std::max(stepX, stepY) * far);
      sum += alongLine(light, sight, line, *r, least) / (r->high - r->low);
    }
  }
  const double ofImage = stepX * stepY / (4.0 * sight.halfWidth * sight.halfHeight);
  return strength * ofImage * sum;
}

std::span<const std::uint32_t> LightChoice::choose(const Camera& camera, float aspect) {
  std::iota(order_.begin(), order_.end(), 0U);
  if (!needed()) return order_;
  for (std::size_t i = 0; i < lights_.size(); ++i) shares_[i] = share(lights_[i], camera, aspect);
  const auto end = order_.begin() + kMostLights;
  std::nth_element(order_.begin(), end, order_.end(), [&](std::uint32_t a, std::uint32_t b) {
    return shares_[a] != shares_[b] ? shares_[a] > shares_[b] : a < b;
  });
  std::sort(order_.begin(), end);
  return std::span(order_).first(kMostLights);
}

std::string lightsLeftOut(const Scene& scene, const Camera& camera, float aspect,
                          const std::string& from) {
  LightChoice choice(scene.lights, boundsOf(scene));
  if (!choice.needed()) return {};
  const std::span<const std::uint32_t> chosen = choice.choose(camera, aspect);
  constexpr std::size_t kMostNames = 12;  // in one line of text
  std::string names;
  const std::size_t left = scene.lights.size() - chosen.size();
  std::size_t named = 0;
  for (std::uint32_t i = 0; i < scene.lights.size() && named < kMostNames; ++i) {
    if (std::binary_search(chosen.begin(), chosen.end(), i)) continue;
    const std::string& name = scene.lights[i].name;
    names += (named++ > 0 ? ", " : "") + (name.empty() ? fmt::format("light {}", i) : name);
  }
  if (left > named) names += fmt::format(" and {} more", left - named);
  return fmt::format(
      "{} lights, and a frame is lit by {}: those that add most to what is in view; from {} "
      "without "
      "{}; remove or merge lights that add little",
      scene.lights.size(), kMostLights, from, names);
}

}  // namespace macula::scene
