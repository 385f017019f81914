// Wheels, lamps, grille, bumpers and the rest that is fixed to the body.
#include <span>
#include <utility>
#include <vector>

#include "engine/scene/procedural/car_parts.h"
#include "engine/scene/procedural/circle.h"
#include "engine/scene/procedural/mesh_builder.h"

namespace macula::scene::car {
namespace {

constexpr float kTrack = 0.735F;      // from the middle to a wheel's, metres
constexpr float kTyreHalf = 0.105F;   // half the width of a tyre
constexpr float kRimRadius = 0.225F;  // of the wheel inside the tyre
constexpr int kSpokes = 6;
constexpr int kWheelSegments = 40;

/// Turns y up into the direction of x (turns = 0 along +x for `sign` 1), to stand lathes on end.
glm::mat4 lyingAlongX(const glm::vec3& at, float sign) {
  return {{0.0F, -sign, 0.0F, 0.0F},
          {sign, 0.0F, 0.0F, 0.0F},
          {0.0F, 0.0F, 1.0F, 0.0F},
          glm::vec4(at, 1.0F)};
}

/// Turns y up into the direction of z.
glm::mat4 lyingAlongZ(const glm::vec3& at, float sign) {
  return {{sign, 0.0F, 0.0F, 0.0F},
          {0.0F, 0.0F, sign, 0.0F},
          {0.0F, -1.0F, 0.0F, 0.0F},
          glm::vec4(at, 1.0F)};
}

Primitive turned(std::span<const glm::vec2> profile, int segments) {
  Primitive mesh;
  addLathe(mesh, profile, segments);
  return mesh;
}

/// Tread blocks around the tyre, about the y axis.
void addTread(Primitive& mesh) {
  constexpr int kBlocks = 26;
  for (int i = 0; i < kBlocks; ++i) {
    for (const float row : {-0.058F, 0.0F, 0.058F}) {
      const float stagger = row * row < 0.001F ? 0.5F : 0.0F;
      Primitive block;
      addBox(block, {kWheelRadius - 0.012F, row - 0.024F, -0.024F},
             {kWheelRadius, row + 0.024F, 0.024F});
      append(mesh, block, place({0, 0, 0}, (static_cast<float>(i) + stagger) / kBlocks));
    }
  }
}

/// Rim and spokes about the y axis, the outside towards +y.
Primitive rim() {
  Primitive mesh = turned(std::vector<glm::vec2>{{kRimRadius - 0.03F, -0.08F},
                                                 {kRimRadius + 0.005F, -0.08F},
                                                 {kRimRadius + 0.012F, 0.088F},
                                                 {kRimRadius, 0.094F},
                                                 {kRimRadius - 0.022F, 0.086F},
                                                 {kRimRadius - 0.032F, 0.05F},
                                                 {kRimRadius - 0.034F, -0.08F}},
                          kWheelSegments);
  for (int i = 0; i < kSpokes; ++i) {
    Primitive spoke;
    addBevelledBox(spoke, {0.045F, 0.045F, -0.019F}, {kRimRadius - 0.02F, 0.075F, 0.019F}, 0.006F);
    append(mesh, spoke, place({0, 0, 0}, static_cast<float>(i) / kSpokes));
  }
  append(mesh,
         turned(std::vector<glm::vec2>{{0.06F, 0.03F},
                                       {0.066F, 0.08F},
                                       {0.056F, 0.09F},
                                       {0.030F, 0.094F},
                                       {0.027F, 0.108F},
                                       {0.0F, 0.112F}},
                24),
         glm::mat4(1.0F));
  for (int i = 0; i < 5; ++i) {
    const glm::vec2 c = 0.043F * onCircle(0.2 * i);
    Primitive nut;
    addSphere(nut, {c.x, 0.094F, c.y}, 0.009F, 6);
    append(mesh, nut, glm::mat4(1.0F));
  }
  return mesh;
}

}  // namespace

void addWheels(SceneBuilder& builder, const Palette& palette) {
  Primitive tyre = turned(std::vector<glm::vec2>{{kRimRadius, -0.085F},
                                                 {0.265F, -kTyreHalf},
                                                 {0.296F, -0.097F},
                                                 {0.308F, -0.080F},
                                                 {0.310F, 0.080F},
                                                 {0.296F, 0.097F},
                                                 {0.265F, kTyreHalf},
                                                 {kRimRadius, 0.085F}},
                          kWheelSegments);
  addTread(tyre);
  Primitive brake = turned(std::vector<glm::vec2>{{0.0F, 0.005F},
                                                  {0.15F, 0.005F},
                                                  {0.15F, 0.02F},
                                                  {0.07F, 0.02F},
                                                  {0.07F, 0.03F},
                                                  {0.0F, 0.03F}},
                           32);
  Primitive caliper;
  addBevelledBox(caliper, {0.09F, -0.02F, -0.06F}, {0.165F, 0.036F, 0.06F}, 0.012F);
  Primitive well;  // the dark inside of the wheel
  addLathe(
      well,
      std::vector<glm::vec2>{{kRimRadius, -0.07F}, {kRimRadius - 0.04F, -0.07F}, {0.0F, -0.07F}},
      24);
  for (auto& normal : well.attributes) normal.normal = {0.0F, 1.0F, 0.0F};
  const Model wheel{
      builder.shape(std::move(tyre), palette.rubber), builder.shape(rim(), palette.alloy),
      builder.shape(std::move(brake), palette.steel),
      builder.shape(std::move(caliper), palette.red), builder.shape(std::move(well), palette.dark)};
  for (const float x : {kFrontAxle, kRearAxle}) {
    for (const float side : {-1.0F, 1.0F}) {
      builder.add(wheel, lyingAlongZ({x, kWheelRadius, side * kTrack}, side));
    }
  }
}

namespace {

/// A lamp about the y axis: ring, bowl and glass.
void addLamp(SceneBuilder& builder, const Palette& palette, float radius, const glm::mat4& at) {
  Primitive ring = turned(std::vector<glm::vec2>{{1.02F * radius, -0.08F},
                                                 {1.10F * radius, -0.005F},
                                                 {1.10F * radius, 0.02F},
                                                 {1.02F * radius, 0.032F},
                                                 {0.94F * radius, 0.022F},
                                                 {0.92F * radius, 0.0F}},
                          32);
  Primitive lens = turned(std::vector<glm::vec2>{{0.93F * radius, 0.008F},
                                                 {0.70F * radius, 0.024F},
                                                 {0.40F * radius, 0.034F},
                                                 {0.0F, 0.038F}},
                          32);
  builder.addOnce(std::move(ring), palette.chrome, at);
  builder.addOnce(std::move(lens), palette.lamp, at);
}

void addFace(SceneBuilder& builder, const Palette& palette) {
  Primitive recess;
  addBox(recess, {2.08F, 0.43F, -0.30F}, {2.155F, 0.585F, 0.30F});
  builder.addOnce(std::move(recess), palette.dark);
  Primitive bars;
  for (int i = 0; i < 6; ++i) {
    const float y = 0.442F + 0.026F * static_cast<float>(i);
    addBevelledBox(bars, {2.14F, y - 0.005F, -0.29F}, {2.17F, y + 0.005F, 0.29F}, 0.003F);
  }
  for (const float z : {-0.29F, -0.10F, 0.10F, 0.29F}) {
    addBevelledBox(bars, {2.14F, 0.43F, z - 0.007F}, {2.175F, 0.585F, z + 0.007F}, 0.003F);
  }
  addBevelledBox(bars, {2.13F, 0.58F, -0.31F}, {2.175F, 0.60F, 0.31F}, 0.006F);
  addBevelledBox(bars, {2.13F, 0.415F, -0.31F}, {2.175F, 0.435F, 0.31F}, 0.006F);
  builder.addOnce(std::move(bars), palette.chrome);
  for (const float side : {-1.0F, 1.0F}) {
    addLamp(builder, palette, 0.095F, lyingAlongX({2.125F, 0.525F, side * 0.43F}, 1.0F));
    addLamp(builder, palette, 0.062F, lyingAlongX({2.215F, 0.40F, side * 0.20F}, 1.0F));
    Primitive flasher;
    addBevelledBox(flasher, {2.02F, 0.37F, -0.05F}, {2.13F, 0.405F, 0.05F}, 0.01F);
    builder.addOnce(std::move(flasher), palette.amber, place({0.0F, 0.0F, side * 0.50F}));
  }
}

void addBumpers(SceneBuilder& builder, const Palette& palette) {
  Primitive chrome;
  for (const float end : {-1.0F, 1.0F}) {
    // Around the corner and across, in one tube.
    std::vector<glm::vec3> path;
    for (const glm::vec2& p : {glm::vec2{1.80F, -0.87F},
                               {1.98F, -0.83F},
                               {2.12F, -0.72F},
                               {2.18F, -0.50F},
                               {2.20F, 0.0F},
                               {2.18F, 0.50F},
                               {2.12F, 0.72F},
                               {1.98F, 0.83F},
                               {1.80F, 0.87F}}) {
      path.emplace_back(end * p.x, 0.345F, end * p.y);
    }
    const std::vector<float> radii(path.size(), 0.032F);
    addTube(chrome, path, radii, 12, false);
  }
  addTube(chrome, std::vector<glm::vec3>{{-1.95F, 0.25F, 0.45F}, {-2.25F, 0.245F, 0.45F}},
          std::vector<float>{0.03F, 0.03F}, 14, false);
  builder.addOnce(std::move(chrome), palette.chrome);

  Primitive plates;
  addQuad(plates, {2.235F, 0.29F, 0.23F}, {2.235F, 0.29F, -0.23F}, {2.235F, 0.40F, -0.23F},
          {2.235F, 0.40F, 0.23F});
  addQuad(plates, {-2.20F, 0.47F, -0.25F}, {-2.20F, 0.47F, 0.25F}, {-2.20F, 0.59F, 0.25F},
          {-2.20F, 0.59F, -0.25F});
  builder.addOnce(std::move(plates), palette.plate);
  Primitive tail;
  for (const float side : {-1.0F, 1.0F}) {
    addBevelledBox(tail, {-2.155F, 0.50F, side * 0.50F - 0.10F},
                   {-2.08F, 0.62F, side * 0.50F + 0.10F}, 0.015F);
  }
  builder.addOnce(std::move(tail), palette.red);
}

}  // namespace

void addFittings(SceneBuilder& builder, const Palette& palette) {
  addFace(builder, palette);
  addBumpers(builder, palette);
  Primitive chrome;
  Primitive dark;
  Primitive mirrors;
  for (const float side : {-1.0F, 1.0F}) {
    const glm::vec3 handle = onBody(kDoorBack + 0.17F, side, 0.33F);
    addBevelledBox(chrome, handle - glm::vec3(0.08F, 0.011F, 0.018F),
                   handle + glm::vec3(0.08F, 0.011F, 0.018F), 0.006F);
    const glm::vec3 foot = onBody(0.50F, side, kWaistShare);
    const glm::vec3 head = foot + glm::vec3(0.02F, 0.09F, side * 0.15F);
    addTube(dark, std::vector<glm::vec3>{foot, head}, std::vector<float>{0.014F, 0.012F}, 8, false);
    Primitive shell;
    addSphere(shell, glm::vec3(0.0F), 1.0F, 20);
    append(
        mirrors, shell,
        glm::mat4({0.055F, 0, 0, 0}, {0, 0.062F, 0, 0}, {0, 0, 0.095F, 0}, glm::vec4(head, 1.0F)));
    // Rails along the waist and the gutter, and a wiper.
    std::vector<glm::vec3> rail;
    std::vector<glm::vec3> gutter;
    for (int i = 0; i <= 20; ++i) {
      const float x = glm::mix(-1.2F, 0.72F, static_cast<float>(i) / 20.0F);
      rail.push_back(onBody(x, side, kWaistShare));
      gutter.push_back(onBody(x, side, kRoofShare - 0.012F));
    }
    addTube(chrome, rail, std::vector<float>(rail.size(), 0.010F), 6, false);
    addTube(chrome, gutter, std::vector<float>(gutter.size(), 0.009F), 6, false);
  }
  for (const float z : {-0.42F, 0.06F}) {
    const glm::vec3 lift{0.012F, 0.016F, 0.0F};
    const auto share = [](float across) { return kRoofShare + (1.0F - kRoofShare) * across; };
    addTube(dark,
            std::vector<glm::vec3>{
                onBody(0.80F, z < 0.0F ? -1.0F : 1.0F, share(z < 0 ? 0.4F : 0.9F)),
                onBody(0.60F, z < 0.0F ? -1.0F : 1.0F, share(z < 0 ? 0.65F : 0.75F)) + lift,
                onBody(0.40F, z < 0.0F ? -1.0F : 1.0F, share(z < 0 ? 0.85F : 0.6F)) + lift},
            std::vector<float>{0.008F, 0.007F, 0.006F}, 6, false);
  }
  // An aerial on the wing.
  const glm::vec3 aerial = onBody(1.05F, -1.0F, 0.55F);
  addTube(chrome, std::vector<glm::vec3>{aerial, aerial + glm::vec3(-0.12F, 0.75F, -0.02F)},
          std::vector<float>{0.006F, 0.003F}, 6, false);
  builder.addOnce(std::move(chrome), palette.chrome);
  builder.addOnce(std::move(dark), palette.dark);
  builder.addOnce(std::move(mirrors), palette.chrome);
}

}  // namespace macula::scene::car
