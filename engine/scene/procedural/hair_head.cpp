#include "engine/scene/procedural/hair_head.h"

#include <utility>

#include "engine/scene/procedural/mesh_builder.h"
#include "engine/scene/procedural/textures.h"

namespace macula::scene::head {
namespace {

void addEllipsoid(Primitive& mesh, const glm::vec3& center, const glm::vec3& radii, int segments) {
  Primitive sphere;
  addSphere(sphere, glm::vec3(0.0F), 1.0F, segments);
  append(mesh, sphere,
         {{radii.x, 0, 0, 0}, {0, radii.y, 0, 0}, {0, 0, radii.z, 0}, glm::vec4(center, 1.0F)});
}

}  // namespace

std::vector<std::uint32_t> addHead(SceneBuilder& builder, std::uint64_t seed) {
  std::vector<std::uint32_t> shapes;
  const auto keep = [&](Primitive mesh, const Material& material) {
    shapes.push_back(builder.shape(std::move(mesh), builder.material(material)));
    builder.add(shapes.back());
  };

  Primitive skin;
  addEllipsoid(skin, kCenter, kRadii, 72);
  addEllipsoid(skin, {0.0F, 1.36F, 0.05F}, {0.37F, 0.36F, 0.38F}, 64);  // cheeks and jaw
  addEllipsoid(skin, {0.0F, 1.45F, 0.47F}, {0.105F, 0.10F, 0.12F}, 40);
  for (const float side : {-1.0F, 1.0F}) {
    addEllipsoid(skin, {side * 0.075F, 1.415F, 0.43F}, {0.055F, 0.05F, 0.06F}, 28);   // nostrils
    addEllipsoid(skin, {side * 0.41F, 1.46F, -0.02F}, {0.05F, 0.12F, 0.09F}, 32);     // ears
    addEllipsoid(skin, {side * 0.155F, 1.635F, 0.335F}, {0.10F, 0.05F, 0.085F}, 32);  // lids
  }
  Primitive neck;
  addLathe(neck, std::vector<glm::vec2>{{0.26F, 0.8F}, {0.22F, 0.95F}, {0.22F, 1.25F}}, 48);
  append(skin, neck, glm::mat4(1.0F));
  keep(std::move(skin), plainMaterial("skin", {0.72F, 0.40F, 0.28F, 1.0F}, 0.55F));

  Primitive eyes;
  Primitive pupils;
  for (const float side : {-1.0F, 1.0F}) {
    const glm::vec3 eye{side * 0.155F, 1.595F, 0.345F};
    addSphere(eyes, eye, 0.082F, 40);
    addSphere(pupils, eye + glm::vec3(0.012F, 0.0F, 0.052F), 0.038F, 28);
  }
  keep(std::move(eyes), plainMaterial("eyes", {0.85F, 0.85F, 0.82F, 1.0F}, 0.2F));
  keep(std::move(pupils), plainMaterial("pupils", {0.02F, 0.03F, 0.05F, 1.0F}, 0.1F));

  Primitive tunic;
  addEllipsoid(tunic, {0.0F, 0.42F, -0.04F}, {0.80F, 0.55F, 0.40F}, 72);
  keep(std::move(tunic), plainMaterial("tunic", {0.07F, 0.20F, 0.17F, 1.0F}, 0.9F));

  Primitive gold;
  addTorusKnot(gold, 1, 0, 0.75F * kTieRadius, 0.012F, 48, 16);
  Primitive placed;
  append(placed, gold, place(kTie));
  append(placed, gold, place(kTie - glm::vec3(0.0F, 0.02F, 0.0F)));
  Primitive collar;
  addTorusKnot(collar, 1, 0, 0.2F, 0.045F, 72, 20);
  append(placed, collar, place({0.0F, 0.93F, 0.0F}));
  keep(std::move(placed), plainMaterial("gold", {0.95F, 0.68F, 0.25F, 1.0F}, 0.3F, 0.9F));

  constexpr float kHalf = 5.0F;  // of floor and wall, metres
  constexpr float kWall = 1.8F;  // behind the head
  Material boards = plainMaterial("floor", glm::vec4(1.0F), 0.6F);
  boards.baseColorTexture.image = builder.image(woodBoards(256, seed));
  Primitive floor;
  addQuad(floor, {-kHalf, 0.0F, kHalf}, {kHalf, 0.0F, kHalf}, {kHalf, 0.0F, -kHalf},
          {-kHalf, 0.0F, -kHalf}, glm::vec2(0.0F), glm::vec2(kHalf));
  keep(std::move(floor), boards);
  // One-sided, so that an orbit passing through it still sees the head.
  Material paint = plainMaterial("wall", {0.42F, 0.36F, 0.27F, 1.0F}, 0.95F);
  paint.baseColorTexture.image = builder.image(plaster(256, seed));
  Primitive wall;
  addQuad(wall, {-kHalf, 0.0F, -kWall}, {kHalf, 0.0F, -kWall}, {kHalf, kHalf, -kWall},
          {-kHalf, kHalf, -kWall}, glm::vec2(0.0F), glm::vec2(kHalf));
  keep(std::move(wall), paint);
  return shapes;
}

}  // namespace macula::scene::head
