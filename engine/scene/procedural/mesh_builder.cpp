#include "engine/scene/procedural/mesh_builder.h"

#include "engine/scene/procedural/circle.h"

namespace macula::scene {

void addTriangle(Primitive& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  mesh.indices.insert(mesh.indices.end(), {a, b, c});
}

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
