// Round shapes: declared in mesh_builder.h.
#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <vector>

#include "engine/scene/procedural/circle.h"
#include "engine/scene/procedural/mesh_builder.h"

namespace macula::scene {
namespace {

constexpr float kTau = glm::two_pi<float>();
constexpr float kSharpEdgeCosine = 0.7071F;  // of 45 degrees

/// A unit vector at right angles to `v`.
glm::vec3 anyPerpendicular(const glm::vec3& v) {
  const glm::vec3 other =
      std::abs(v.y) < 0.9F ? glm::vec3(0.0F, 1.0F, 0.0F) : glm::vec3(1.0F, 0.0F, 0.0F);
  return glm::normalize(glm::cross(v, other));
}

/// Normal of the profile edge from a to b: to the right of the way.
glm::vec2 edgeNormal(const glm::vec2& a, const glm::vec2& b) {
  const glm::vec2 along = b - a;
  const float length = glm::length(along);
  return length > 0.0F ? glm::vec2(along.y, -along.x) / length : glm::vec2(1.0F, 0.0F);
}

/// One band of the lathe between two profile points; a band that touches the axis is a fan.
void addBand(Primitive& mesh, const glm::vec2& a, const glm::vec2& b, const glm::vec2& normalA,
             const glm::vec2& normalB, float vA, float vB, int segments) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (int j = 0; j <= segments; ++j) {
    const float u = static_cast<float>(j) / static_cast<float>(segments);
    const glm::vec2 turned = onCircle(u);
    const float c = turned.x;
    const float s = -turned.y;  // counter-clockwise seen from above
    addVertex(mesh, {a.x * c, a.y, a.x * s}, {normalA.x * c, normalA.y, normalA.x * s}, {u, vA});
    addVertex(mesh, {b.x * c, b.y, b.x * s}, {normalB.x * c, normalB.y, normalB.x * s}, {u, vB});
  }
  for (int j = 0; j < segments; ++j) {
    const std::uint32_t low = first + 2 * static_cast<std::uint32_t>(j);
    if (a.x > 0.0F) addTriangle(mesh, low, low + 2, low + 3);
    if (b.x > 0.0F) addTriangle(mesh, low, low + 3, low + 1);
  }
}

/// Turns `frame` (a unit vector) by the least rotation that takes `from` to `to`.
glm::vec3 transport(const glm::vec3& frame, const glm::vec3& to) {
  return glm::normalize(frame - to * glm::dot(frame, to));
}

}  // namespace

void addLathe(Primitive& mesh, std::span<const glm::vec2> profile, int segments) {
  const std::size_t edges = profile.size() - 1;
  const auto joined = [&](std::size_t edge, std::size_t other) {
    const glm::vec2 own = edgeNormal(profile[edge], profile[edge + 1]);
    if (other >= edges) return own;  // also where edge - 1 wraps below 0
    const glm::vec2 neighbour = edgeNormal(profile[other], profile[other + 1]);
    return glm::dot(own, neighbour) > kSharpEdgeCosine ? glm::normalize(own + neighbour) : own;
  };
  float total = 0.0F;
  for (std::size_t i = 0; i < edges; ++i) total += glm::distance(profile[i], profile[i + 1]);
  float along = 0.0F;
  for (std::size_t i = 0; i < edges; ++i) {
    const float next = along + glm::distance(profile[i], profile[i + 1]);
    addBand(mesh, profile[i], profile[i + 1], joined(i, i - 1), joined(i, i + 1),
            1.0F - along / total, 1.0F - next / total, segments);
    along = next;
  }
}

void addVessel(Primitive& mesh, std::span<const glm::vec2> outer, float wall, float bottom,
               int segments) {
  const float innerFoot = outer.front().y + bottom;
  std::vector<glm::vec2> profile(outer.begin(), outer.end());
  for (std::size_t i = outer.size() - 1; i > 0 && outer[i].y > innerFoot; --i) {
    profile.emplace_back(outer[i].x - wall, outer[i].y);
  }
  // The inside is rounded where the wall meets the bottom, which rises a little in the middle.
  profile.emplace_back(0.6F * profile.back().x, innerFoot);
  profile.emplace_back(0.0F, innerFoot + 0.4F * bottom);
  addLathe(mesh, profile, segments);
}

void addSphere(Primitive& mesh, const glm::vec3& center, float radius, int segments) {
  const int rings = std::max(segments / 2, 2);
  std::vector<glm::vec2> profile;
  for (int i = 0; i <= rings; ++i) {
    const glm::vec2 turned = onCircle(0.5 * i / rings);
    const bool pole = i == 0 || i == rings;
    profile.emplace_back(pole ? 0.0F : radius * turned.y, -radius * turned.x);
  }
  const std::size_t first = mesh.positions.size();
  addLathe(mesh, profile, segments);
  for (std::size_t i = first; i < mesh.positions.size(); ++i) {
    mesh.attributes[i].normal = glm::normalize(mesh.positions[i]);  // exact, unlike the lathe's
    mesh.positions[i] += center;
  }
}

void addTube(Primitive& mesh, std::span<const glm::vec3> path, std::span<const float> radii,
             int segments, bool closed) {
  const std::size_t count = path.size();
  const std::size_t rings = closed ? count + 1 : count;
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const auto tangentAt = [&](std::size_t i) {
    const std::size_t before = i > 0 ? i - 1 : (closed ? count - 1 : 0);
    const std::size_t after = i + 1 < count ? i + 1 : (closed ? 0 : count - 1);
    return glm::normalize(path[after] - path[before]);
  };
  glm::vec3 side = anyPerpendicular(tangentAt(0));
  // Carried along a closed path, the frame comes back turned; that turn is spread over the rings.
  float twist = 0.0F;
  if (closed) {
    glm::vec3 carried = side;
    for (std::size_t i = 1; i <= count; ++i) carried = transport(carried, tangentAt(i % count));
    const glm::vec3 other = glm::cross(tangentAt(0), side);
    twist = -std::atan2(glm::dot(carried, other), glm::dot(carried, side)) / kTau;
  }
  for (std::size_t i = 0; i < rings; ++i) {
    const std::size_t at = i % count;
    const glm::vec3 tangent = tangentAt(at);
    side = transport(side, tangent);
    const glm::vec3 other = glm::cross(tangent, side);
    const float v = static_cast<float>(i) / static_cast<float>(rings - 1);
    for (int j = 0; j <= segments; ++j) {
      const float u = static_cast<float>(j) / static_cast<float>(segments);
      const glm::vec2 turned = onCircle(u + twist * v);
      const glm::vec3 normal = side * turned.x + other * turned.y;
      addVertex(mesh, path[at] + normal * radii[at], normal, {u, v});
    }
  }
  const auto stride = static_cast<std::uint32_t>(segments) + 1;
  for (std::uint32_t i = 0; i + 1 < rings; ++i) {
    for (std::uint32_t j = 0; j + 1 < stride; ++j) {
      const std::uint32_t a = first + i * stride + j;
      addTriangle(mesh, a, a + 1, a + 1 + stride);
      addTriangle(mesh, a, a + 1 + stride, a + stride);
    }
  }
}

void addTorusKnot(Primitive& mesh, int p, int q, float radius, float tubeRadius, int steps,
                  int segments) {
  std::vector<glm::vec3> path;
  for (int i = 0; i < steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    const glm::vec2 around = onCircle(p * t);
    const glm::vec2 through = onCircle(q * t);
    // The winding of the path lies on a torus whose tube is 40 % of its ring.
    const float ring = 1.0F + 0.4F * through.x;
    path.push_back(radius * glm::vec3(ring * around.x, 0.4F * through.y, ring * around.y));
  }
  addTube(mesh, path, std::vector<float>(path.size(), tubeRadius), segments, true);
}

void addFlutedShaft(Primitive& mesh, float radius, float height, int flutes, int rings) {
  constexpr int kPerFlute = 6;          // points across one flute
  constexpr float kFluteDepth = 0.07F;  // of the radius
  const int segments = flutes * kPerFlute;
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (int i = 0; i <= rings; ++i) {
    const float v = static_cast<float>(i) / static_cast<float>(rings);
    const float taper = 1.0F - 0.15F * v * v;  // entasis: the shaft narrows late
    for (int j = 0; j <= segments; ++j) {
      const float u = static_cast<float>(j) / static_cast<float>(segments);
      const float across = static_cast<float>(j % kPerFlute) / kPerFlute;
      const float hollow = 4.0F * across * (1.0F - across);
      const float slope = 4.0F * (1.0F - 2.0F * across) * static_cast<float>(flutes) / kTau;
      const float r = radius * taper * (1.0F - kFluteDepth * hollow);
      const float drdAngle = -radius * taper * kFluteDepth * (j % kPerFlute == 0 ? 0.0F : slope);
      const glm::vec2 turned = onCircle(u);
      const glm::vec3 out{turned.x, 0.0F, -turned.y};
      const glm::vec3 around{-turned.y, 0.0F, -turned.x};
      addVertex(mesh, out * r + glm::vec3(0.0F, height * v, 0.0F),
                glm::normalize(out * r - around * drdAngle), {u * 4.0F, v * 4.0F});
    }
  }
  const auto stride = static_cast<std::uint32_t>(segments) + 1;
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(rings); ++i) {
    for (std::uint32_t j = 0; j + 1 < stride; ++j) {
      const std::uint32_t a = first + i * stride + j;
      addTriangle(mesh, a, a + 1, a + 1 + stride);
      addTriangle(mesh, a, a + 1 + stride, a + stride);
    }
  }
}

void addPuff(Primitive& mesh, const glm::vec3& center, const glm::vec3& axis, float radius,
             const glm::vec3& color, float alpha) {
  constexpr std::uint32_t kSegments = 24;
  constexpr std::uint32_t kRings = 5;
  constexpr float kBend = 0.35F;  // height of the dish in radii
  const glm::vec3 u = anyPerpendicular(axis);
  const glm::vec3 v = glm::cross(axis, u);
  const auto at = [&](float r, float turns) {
    const glm::vec2 turned = onCircle(turns);
    const glm::vec3 flat = u * turned.x + v * turned.y;
    const glm::vec3 normal = glm::normalize(axis + flat * (2.0F * kBend * r));
    const float fade = (1.0F - r * r) * (1.0F - r * r);
    return addVertex(mesh, center + radius * (flat * r - axis * (kBend * r * r)), normal,
                     {0.5F, 0.5F}, glm::vec4(color, alpha * fade));
  };
  const std::uint32_t middle = at(0.0F, 0.0F);
  for (std::uint32_t i = 1; i <= kRings; ++i) {
    const float r = static_cast<float>(i) / static_cast<float>(kRings);
    for (std::uint32_t j = 0; j < kSegments; ++j) {
      const std::uint32_t index = at(r, static_cast<float>(j) / static_cast<float>(kSegments));
      const std::uint32_t ring = middle + 1 + (i - 1) * kSegments;
      const std::uint32_t next = ring + (j + 1) % kSegments;
      if (i == 1) {
        addTriangle(mesh, middle, index, next);
      } else {
        addTriangle(mesh, index - kSegments, index, next);
        addTriangle(mesh, index - kSegments, next, next - kSegments);
      }
    }
  }
}

}  // namespace macula::scene
