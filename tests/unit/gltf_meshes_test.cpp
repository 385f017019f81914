// Meshes and accessors of glTF files made by hand.
#include <gtest/gtest.h>

#include <limits>

#include "tests/unit/gltf_builder.h"

namespace macula::scene {
namespace {

using nlohmann::json;
using test::GltfBuilder;
using test::kF32;
using test::kI8;
using test::kU16;
using test::kU32;
using test::kU8;
using test::messageOf;
using test::Square;
using test::warns;
using Indices = std::vector<std::uint32_t>;

TEST(GltfMeshes, EveryIndexTypeAndNone) {
  const auto indicesWith = [](int accessor, Square& square) {
    json primitive{{"attributes", square.attributes}};
    if (accessor >= 0) primitive["indices"] = accessor;
    square.draw(primitive);
    return square.load().primitives.at(0).indices;
  };
  Square u8;
  EXPECT_EQ(indicesWith(u8.attribute<std::uint8_t>({2, 1, 3}, kU8, "SCALAR", 3), u8),
            (Indices{2, 1, 3}));
  Square u16;
  EXPECT_EQ(indicesWith(u16.attribute<std::uint16_t>({2, 1, 3}, kU16, "SCALAR", 3), u16),
            (Indices{2, 1, 3}));
  Square u32;
  EXPECT_EQ(indicesWith(u32.attribute<std::uint32_t>({2, 1, 3}, kU32, "SCALAR", 3), u32),
            (Indices{2, 1, 3}));
  Square none;
  EXPECT_EQ(indicesWith(-1, none), (Indices{0, 1, 2}));  // the fourth makes no triangle
}

TEST(GltfMeshes, ModesBecomeTriangles) {
  Square square;
  for (const int mode : {0, 1, 2, 3, 5, 6})
    square.draw({{"attributes", square.attributes}, {"mode", mode}});
  const Scene scene = square.load();
  ASSERT_EQ(scene.primitives.size(), 2U);
  EXPECT_EQ(scene.primitives[0].indices, (Indices{0, 1, 2, 1, 3, 2}));
  EXPECT_EQ(scene.primitives[1].indices, (Indices{1, 2, 0, 2, 3, 0}));
  EXPECT_TRUE(warns(scene, "mesh 0 primitive 0: points are not drawn"));
  EXPECT_TRUE(warns(scene, "lines are not drawn"));
  square.draw({{"attributes", square.attributes}, {"mode", 7}});
  EXPECT_SAYS(messageOf(square), "unknown mode 7");
}

TEST(GltfMeshes, BadIndicesAreRefused) {
  Square beyond;
  beyond.draw({{"attributes", beyond.attributes},
               {"indices", beyond.attribute<std::uint16_t>({0, 1, 4}, kU16, "SCALAR", 3)}});
  EXPECT_SAYS(messageOf(beyond), "test: mesh 0 primitive 0: index 4 has no vertex among 4");
  Square restart;
  restart.draw({{"attributes", restart.attributes},
                {"indices", restart.attribute<std::uint8_t>({0, 1, 255}, kU8, "SCALAR", 3)}});
  EXPECT_SAYS(messageOf(restart), "primitive restart value 255");
}

TEST(GltfMeshes, MeshesThatCannotBeReadWholeAreRefused) {
  Square square;
  square.draw({{"attributes", square.attributes}});
  EXPECT_EQ(messageOf(square), "");
  json& primitives = square.root["meshes"][0]["primitives"];
  primitives.push_back({{"indices", 0}});  // would be left out in silence
  EXPECT_EQ(messageOf(square),
            "test: mesh 0: 'attributes' property is missing in Primitive; correct the file or "
            "export it again");
  primitives = json::array();
  EXPECT_SAYS(messageOf(square), "test: mesh 0: has no primitives;");
  square.root["meshes"][0] = 7;
  EXPECT_SAYS(messageOf(square), "test: mesh 0: is no JSON object;");
  square.root["meshes"] = 7;
  EXPECT_SAYS(messageOf(square), "test: 'meshes' is not an array;");
}

TEST(GltfMeshes, CompressionByDracoIsNamed) {
  Square square;
  json primitive{{"attributes", square.attributes}};
  primitive["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", 0}};
  square.draw(primitive);
  EXPECT_EQ(messageOf(square), "") << "the same vertices stand in the file uncompressed";
  square.root["accessors"][square.attributes["POSITION"].get<int>()].erase("bufferView");
  EXPECT_SAYS(messageOf(square),
              "test: mesh 0 primitive 0: is compressed with KHR_draco_mesh_compression");
}

TEST(GltfMeshes, IndicesOfMeshesThatAreNotDrawnAreChecked) {
  Square square;
  square.draw({{"attributes", square.attributes}, {"indices", 7}});
  square.root.erase("nodes");
  EXPECT_SAYS(messageOf(square), "test: mesh 0 primitive 0: names accessor 7 of 2");
}

TEST(GltfMeshes, MalformedReferencesAreRefused) {
  Square square;
  square.attributes["COLOR_0"] = square.attribute<float>({1, 1, 1}, kF32, "VEC3", 1);
  square.draw({{"attributes", square.attributes}});
  EXPECT_SAYS(messageOf(square), "COLOR_0 has 1 element for 4 positions");
  Square accessor;
  accessor.attributes["TEXCOORD_0"] = 99;
  accessor.draw({{"attributes", accessor.attributes}});
  EXPECT_SAYS(messageOf(accessor), "names accessor 99 of 2");
  Square material;
  material.draw({{"attributes", material.attributes}, {"material", 0}});
  EXPECT_SAYS(messageOf(material), "names material 0 of 0");
  Square type;
  type.attributes["TANGENT"] = type.attributes["NORMAL"];
  type.draw({{"attributes", type.attributes}});
  EXPECT_SAYS(messageOf(type), "TANGENT: has 3 components where 4");
  Square node;
  node.root["nodes"] = {{{"mesh", 3}}};
  EXPECT_SAYS(messageOf(node), "names mesh 3 of 0");
  Square view;
  view.draw({{"attributes", view.attributes}});
  view.root["bufferViews"][0]["byteLength"] = 47;
  EXPECT_SAYS(messageOf(view), "4 elements asked for, and buffer view 0 holds 3");
  view.root["bufferViews"][0]["byteLength"] = 1000;
  EXPECT_SAYS(messageOf(view), "reaches beyond the");
  view.root["bufferViews"][0]["byteOffset"] = std::numeric_limits<std::uint64_t>::max() - 20;
  EXPECT_SAYS(messageOf(view), "reaches beyond the");
  Square count;
  count.root["accessors"][0]["count"] = std::uint64_t{1} << 62U;
  count.draw({{"attributes", {{"POSITION", 0}}}});
  EXPECT_SAYS(messageOf(count), "more than");
}

TEST(GltfAccessors, NormalizedAndQuantizedIntegers) {
  GltfBuilder builder;
  // KHR_mesh_quantization: positions as bytes, padded to 4.
  const int positions = builder.accessor(
      {{"bufferView", builder.view<std::int8_t>({0, 0, 0, 9, 127, -128, 64, 9, 0, 127, 0, 9}, 4)},
       {"componentType", kI8},
       {"type", "VEC3"},
       {"count", 3},
       {"normalized", true}});
  const int uv0 =
      builder.attribute<std::uint16_t>({0, 65535, 13107, 0, 0, 0}, kU16, "VEC2", 3, true);
  const int uv1 = builder.attribute<std::uint16_t>({0, 7, 2, 0, 0, 0}, kU16, "VEC2", 3);
  const int color = builder.attribute<std::uint8_t>({255, 51, 0, 255, 0, 0, 0, 0, 0, 0, 0, 102},
                                                    kU8, "VEC4", 3, true);
  builder.draw(
      {{"attributes",
        {{"POSITION", positions}, {"TEXCOORD_0", uv0}, {"TEXCOORD_1", uv1}, {"COLOR_0", color}}}});
  const Primitive p = builder.load().primitives.at(0);
  EXPECT_EQ(p.positions[1], glm::vec3(1.0F, -1.0F, 64.0F / 127.0F));  // -128 clamps to -1
  EXPECT_EQ(p.attributes[0].uv0, glm::vec2(0, 1));
  EXPECT_FLOAT_EQ(p.attributes[1].uv0.x, 0.2F);
  EXPECT_EQ(p.attributes[0].uv1, glm::vec2(0, 7));
  EXPECT_FLOAT_EQ(p.attributes[0].color.g, 0.2F);
  EXPECT_FLOAT_EQ(p.attributes[2].color.a, 0.4F);
}

TEST(GltfAccessors, InterleavedStrides) {
  GltfBuilder builder;
  const int view = builder.view<float>({0, 0, 0, 5, 1, 0, 0, 6, 0, 1, 0, 7}, 16);
  const int positions = builder.accessor(
      {{"bufferView", view}, {"componentType", kF32}, {"type", "VEC3"}, {"count", 3}});
  builder.draw({{"attributes", {{"POSITION", positions}}}});
  const Primitive p = builder.load().primitives.at(0);
  EXPECT_EQ(p.positions, (std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
}

TEST(GltfAccessors, SparseReplacesElementsOfDataOrOfZeros) {
  GltfBuilder builder;
  const int base = builder.trianglePositions();
  const int indices = builder.view<std::uint8_t>({0, 2});
  const int values = builder.view<float>({9, 8, 7, 6, 5, 4});
  json sparse{{"count", 2},
              {"indices", {{"bufferView", indices}, {"componentType", kU8}}},
              {"values", {{"bufferView", values}}}};
  builder.root["accessors"][static_cast<std::size_t>(base)]["sparse"] = sparse;
  const int zeros = builder.accessor(
      {{"componentType", kF32}, {"type", "VEC3"}, {"count", 3}, {"sparse", sparse}});
  builder.draw({{"attributes", {{"POSITION", base}}}});
  builder.draw({{"attributes", {{"POSITION", zeros}}}});
  const Scene scene = builder.load();
  using Points = std::vector<glm::vec3>;
  EXPECT_EQ(scene.primitives.at(0).positions, (Points{{9, 8, 7}, {1, 0, 0}, {6, 5, 4}}));
  EXPECT_EQ(scene.primitives.at(1).positions, (Points{{9, 8, 7}, {0, 0, 0}, {6, 5, 4}}));
  builder.root["accessors"][static_cast<std::size_t>(zeros)]["count"] = 2;
  EXPECT_SAYS(messageOf(builder), "replaces element 2 of 2");
}

TEST(GltfMeshes, MissingNormalsAreFlat) {
  GltfBuilder builder;
  const int positions =
      builder.attribute<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, kF32, "VEC3", 4);
  const int indices = builder.attribute<std::uint8_t>({0, 1, 2, 0, 1, 3}, kU8, "SCALAR", 6);
  builder.draw({{"attributes", {{"POSITION", positions}}}, {"indices", indices}});
  const Primitive p = builder.load().primitives.at(0);
  ASSERT_EQ(p.positions.size(), 6U);
  EXPECT_EQ(p.attributes[0].normal, glm::vec3(0, 0, 1));
  EXPECT_EQ(p.attributes[5].normal, glm::vec3(0, -1, 0));
}

TEST(GltfMeshes, TrianglesThatAreNotFiniteAreDropped) {
  Square square;
  const float infinity = std::numeric_limits<float>::infinity();
  square.attributes["POSITION"] =
      square.attribute<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, infinity, 1, 0}, kF32, "VEC3", 4);
  square.draw({{"attributes", square.attributes}, {"mode", 5}});
  const Scene scene = square.load();
  EXPECT_EQ(scene.primitives.at(0).indices, (Indices{0, 1, 2}));
  EXPECT_TRUE(warns(scene, "1 triangle with coordinates that are not finite"));
  EXPECT_EQ(boundsOf(scene).max, glm::vec3(1, 1, 0));
}

TEST(GltfMeshes, AMeshOfManyNodesIsOnePrimitive) {
  GltfBuilder builder;
  builder.draw({{"attributes", {{"POSITION", builder.trianglePositions()}}}});
  for (int i = 0; i < 9; ++i) builder.root["nodes"].push_back({{"mesh", 0}});
  const Scene scene = builder.load();
  EXPECT_EQ(scene.primitives.size(), 1U);
  EXPECT_EQ(scene.instances.size(), 10U);
}

TEST(GltfLimitsTest, AreErrors) {
  GltfBuilder builder;
  builder.draw({{"attributes", {{"POSITION", builder.trianglePositions()}}}});
  builder.root["nodes"].push_back({{"mesh", 0}});
  EXPECT_EQ(messageOf(builder), "");
  GltfLimits vertices;
  vertices.vertices = 5;  // three read, three more split
  EXPECT_SAYS(messageOf(builder, vertices), "more than 5 vertices");
  GltfLimits indices;
  indices.indices = 2;
  EXPECT_SAYS(messageOf(builder, indices), "more than 2 indices");
  GltfLimits instances;
  instances.instances = 1;
  EXPECT_SAYS(messageOf(builder, instances), "more than 1 draws");
}

}  // namespace
}  // namespace macula::scene
