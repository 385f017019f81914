#include "engine/scene/procedural/mesh_builder.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <vector>

#include "engine/scene/procedural/circle.h"

namespace macula::scene {
namespace {

constexpr float kTau = glm::two_pi<float>();
constexpr float kSharpEdgeCosine = 0.7071F;  // of 45 degrees

void addTriangle(Primitive& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  mesh.indices.insert(mesh.indices.end(), {a, b, c});
}

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

std::uint32_t addVertex(Primitive& mesh, const glm::vec3& position, const glm::vec3& normal,
                        const glm::vec2& uv, const glm::vec4& color) {
  mesh.positions.push_back(position);
  VertexAttributes attributes;
  attributes.normal = normal;
  attributes.uv0 = uv;
  attributes.color = color;
  mesh.attributes.push_back(attributes);
  return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

void addQuad(Primitive& mesh, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c,
             const glm::vec3& d, const glm::vec2& uvMin, const glm::vec2& uvMax) {
  const glm::vec3 normal = glm::normalize(glm::cross(b - a, d - a));
  const std::uint32_t first = addVertex(mesh, a, normal, {uvMin.x, uvMax.y});
  addVertex(mesh, b, normal, {uvMax.x, uvMax.y});
  addVertex(mesh, c, normal, {uvMax.x, uvMin.y});
  addVertex(mesh, d, normal, {uvMin.x, uvMin.y});
  addTriangle(mesh, first, first + 1, first + 2);
  addTriangle(mesh, first, first + 2, first + 3);
}

void addBox(Primitive& mesh, const glm::vec3& low, const glm::vec3& high, float uvPerMetre) {
  const auto face = [&](const glm::vec3& a, const glm::vec3& b, const glm::vec3& c,
                        const glm::vec3& d) {
    const glm::vec2 size{glm::length(b - a), glm::length(d - a)};
    addQuad(mesh, a, b, c, d, glm::vec2(0.0F), size * uvPerMetre);
  };
  const glm::vec3& l = low;
  const glm::vec3& h = high;
  face({l.x, l.y, h.z}, {h.x, l.y, h.z}, {h.x, h.y, h.z}, {l.x, h.y, h.z});  // +z
  face({h.x, l.y, l.z}, {l.x, l.y, l.z}, {l.x, h.y, l.z}, {h.x, h.y, l.z});  // -z
  face({h.x, l.y, h.z}, {h.x, l.y, l.z}, {h.x, h.y, l.z}, {h.x, h.y, h.z});  // +x
  face({l.x, l.y, l.z}, {l.x, l.y, h.z}, {l.x, h.y, h.z}, {l.x, h.y, l.z});  // -x
  face({l.x, h.y, h.z}, {h.x, h.y, h.z}, {h.x, h.y, l.z}, {l.x, h.y, l.z});  // +y
  face({l.x, l.y, l.z}, {h.x, l.y, l.z}, {h.x, l.y, h.z}, {l.x, l.y, h.z});  // -y
}

void addBevelledBox(Primitive& mesh, const glm::vec3& low, const glm::vec3& high, float bevel,
                    float uvPerMetre) {
  // Six faces drawn in by the bevel, twelve chamfers and eight corner triangles.
  const glm::vec3 center = 0.5F * (low + high);
  const glm::vec3 half = 0.5F * (high - low);
  const auto corner = [&](int axis, const glm::vec3& sign) {
    glm::vec3 p = half - glm::vec3(bevel);
    p[axis] = half[axis];
    return center + sign * p;
  };
  const auto facing = [&](const glm::vec3& outwards, const glm::vec3& a, const glm::vec3& b,
                          const glm::vec3& c, const glm::vec3& d) {
    const glm::vec2 size{glm::length(b - a), glm::length(d - a)};
    if (glm::dot(glm::cross(b - a, c - a), outwards) > 0.0F) {
      addQuad(mesh, a, b, c, d, glm::vec2(0.0F), size * uvPerMetre);
    } else {
      addQuad(mesh, a, d, c, b, glm::vec2(0.0F), glm::vec2(size.y, size.x) * uvPerMetre);
    }
  };
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    for (const float side : {-1.0F, 1.0F}) {
      const auto at = [&](float su, float sv) {
        glm::vec3 sign(side);
        sign[u] = su;
        sign[v] = sv;
        return corner(axis, sign);
      };
      glm::vec3 outwards(0.0F);
      outwards[axis] = side;
      facing(outwards, at(-1, -1), at(1, -1), at(1, 1), at(-1, 1));
    }
    for (const float su : {-1.0F, 1.0F}) {
      for (const float sv : {-1.0F, 1.0F}) {
        glm::vec3 back(-1.0F);
        glm::vec3 front(1.0F);
        back[u] = front[u] = su;
        back[v] = front[v] = sv;
        glm::vec3 outwards(0.0F);
        outwards[u] = su;
        outwards[v] = sv;
        facing(outwards, corner(u, back), corner(u, front), corner(v, front), corner(v, back));
      }
    }
  }
  for (unsigned bits = 0; bits < 8; ++bits) {
    const glm::vec3 sign{(bits & 1U) != 0 ? 1.0F : -1.0F, (bits & 2U) != 0 ? 1.0F : -1.0F,
                         (bits & 4U) != 0 ? 1.0F : -1.0F};
    const glm::vec3 normal = glm::normalize(sign);
    std::uint32_t index[3];
    for (int axis = 0; axis < 3; ++axis) index[axis] = addVertex(mesh, corner(axis, sign), normal);
    const bool even = sign.x * sign.y * sign.z > 0.0F;
    addTriangle(mesh, index[0], index[even ? 1 : 2], index[even ? 2 : 1]);
  }
}

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

void append(Primitive& mesh, const Primitive& part, const glm::mat4& transform) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const glm::mat3 forNormals = glm::transpose(glm::inverse(glm::mat3(transform)));
  for (std::size_t i = 0; i < part.positions.size(); ++i) {
    mesh.positions.push_back(glm::vec3(transform * glm::vec4(part.positions[i], 1.0F)));
    mesh.attributes.push_back(part.attributes[i]);
    mesh.attributes.back().normal = glm::normalize(forNormals * part.attributes[i].normal);
  }
  for (const std::uint32_t index : part.indices) mesh.indices.push_back(first + index);
}

void paint(Primitive& mesh, const glm::vec4& color, std::size_t first) {
  for (std::size_t i = first; i < mesh.attributes.size(); ++i) mesh.attributes[i].color = color;
}

glm::mat4 place(const glm::vec3& position, float turns, float scale) {
  const glm::vec2 turned = scale * onCircle(turns);
  return {{turned.x, 0.0F, -turned.y, 0.0F},
          {0.0F, scale, 0.0F, 0.0F},
          {turned.y, 0.0F, turned.x, 0.0F},
          glm::vec4(position, 1.0F)};
}

}  // namespace macula::scene
