// Triangle lists, normals and tangents, against cases worked by hand.
#include "engine/scene/mesh_attributes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace macula::scene {
namespace {

using Indices = std::vector<std::uint32_t>;

Primitive triangle() {
  Primitive p;
  p.positions = {{0, 0, 0}, {2, 0, 0}, {0, 3, 0}};
  p.attributes.resize(3);
  p.indices = {0, 1, 2};
  return p;
}

TEST(TriangleList, FollowsTheWindingOfTheSpecification) {
  const Indices five = {10, 11, 12, 13, 14};
  EXPECT_EQ(triangleList(Topology::Triangles, five), (Indices{10, 11, 12}));
  EXPECT_EQ(triangleList(Topology::TriangleStrip, five),
            (Indices{10, 11, 12, 11, 13, 12, 12, 13, 14}));
  EXPECT_EQ(triangleList(Topology::TriangleFan, five),
            (Indices{11, 12, 10, 12, 13, 10, 13, 14, 10}));
  EXPECT_TRUE(triangleList(Topology::TriangleStrip, Indices{1, 2}).empty());
}

TEST(FlatNormals, SplitSharedVertices) {
  Primitive p = triangle();
  p.positions.push_back({0, 0, 1});
  p.attributes.resize(4);
  p.attributes[0].uv0 = {0.25F, 0.5F};
  p.indices = {0, 1, 2, 0, 1, 3};  // one in z = 0, one in y = 0, seen from its -y side
  splitWithFlatNormals(p);
  ASSERT_EQ(p.positions.size(), 6U);
  EXPECT_EQ(p.indices, (Indices{0, 1, 2, 3, 4, 5}));
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(p.attributes[i].normal, glm::vec3(0, 0, 1));
  // (2,0,0) x (0,0,1) = (0,-2,0)
  for (std::size_t i = 3; i < 6; ++i) EXPECT_EQ(p.attributes[i].normal, glm::vec3(0, -1, 0));
  EXPECT_EQ(p.attributes[3].uv0, glm::vec2(0.25F, 0.5F));
}

TEST(FlatNormals, DegenerateTrianglesStayFinite) {
  Primitive p = triangle();
  p.indices = {0, 0, 1};
  splitWithFlatNormals(p);
  EXPECT_EQ(p.attributes[0].normal, glm::vec3(0, 0, 1));
}

TEST(RepairNormals, ReplacesThoseWithoutDirection) {
  Primitive p = triangle();
  p.attributes[0].normal = {0, 0, 0};
  p.attributes[1].normal = {0, 4, 0};
  p.attributes[2].normal = {NAN, 0, 1};
  EXPECT_EQ(repairNormals(p), 2U);
  EXPECT_EQ(p.attributes[0].normal, glm::vec3(0, 0, 1));
  EXPECT_EQ(p.attributes[1].normal, glm::vec3(0, 1, 0));
  EXPECT_EQ(p.attributes[2].normal, glm::vec3(0, 0, 1));
}

TEST(Tangents, PointAlongUWithTheBitangentUpTheImage) {
  // u grows with x, v shrinks with y: the image upright, as glTF places its origin top left.
  Primitive p = triangle();
  p.attributes[0].uv0 = {0, 1};
  p.attributes[1].uv0 = {1, 1};
  p.attributes[2].uv0 = {0, 0};
  computeTangents(p, 0);
  for (const VertexAttributes& v : p.attributes) EXPECT_EQ(v.tangent, glm::vec4(1, 0, 0, 1));
  // Mirrored in u.
  for (VertexAttributes& v : p.attributes) v.uv0.x = -v.uv0.x;
  computeTangents(p, 0);
  for (const VertexAttributes& v : p.attributes) EXPECT_EQ(v.tangent, glm::vec4(-1, 0, 0, -1));
}

TEST(Tangents, TakeTheChosenUvSet) {
  Primitive p = triangle();
  p.attributes[1].uv1 = {0, 1};  // u grows with y
  p.attributes[2].uv1 = {1, 0};
  computeTangents(p, 1);
  EXPECT_EQ(glm::vec3(p.attributes[0].tangent), glm::vec3(0, 1, 0));
}

TEST(Tangents, ArePerpendicularWhereUvsSayNothing) {
  Primitive p = triangle();
  p.attributes[1].normal = {0, 0, -1};
  p.attributes[2].normal = glm::normalize(glm::vec3(1, 2, 3));
  computeTangents(p, 0);
  for (const VertexAttributes& v : p.attributes) {
    EXPECT_NEAR(glm::dot(glm::vec3(v.tangent), v.normal), 0.0F, 1e-6F);
    EXPECT_NEAR(glm::length(glm::vec3(v.tangent)), 1.0F, 1e-6F);
  }
}

TEST(Tangents, OfAFileAreMadeUnitAndOrthogonal) {
  Primitive p = triangle();
  p.attributes[0].tangent = {2, 0, 1, -0.5F};
  p.attributes[1].tangent = {0, 0, 0, 0};
  p.attributes[2].tangent = {0, 0, 7, 1};  // along the normal
  repairTangents(p);
  EXPECT_EQ(p.attributes[0].tangent, glm::vec4(1, 0, 0, -1));
  for (const VertexAttributes& v : p.attributes) {
    EXPECT_NEAR(glm::dot(glm::vec3(v.tangent), v.normal), 0.0F, 1e-6F);
    EXPECT_NEAR(glm::length(glm::vec3(v.tangent)), 1.0F, 1e-6F);
  }
}

}  // namespace
}  // namespace macula::scene
