#include <array>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "engine/scene/procedural/circle.h"
#include "engine/scene/procedural/gallery_parts.h"
#include "engine/scene/procedural/mesh_builder.h"

namespace macula::scene::gallery {
namespace {

using Profile = std::vector<glm::vec2>;

// Everything of glass that stands on wood or stone is lifted by this much, in metres, so that the
// two surfaces do not share a plane.
constexpr float kLift = 0.002F;

/// A smooth outline from few points: each edge is cut into `kCuts` along a Catmull-Rom spline.
Profile smoothed(const Profile& points) {
  constexpr int kCuts = 4;
  Profile out;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const glm::vec2 a = points[i > 0 ? i - 1 : 0];
    const glm::vec2 b = points[i];
    const glm::vec2 c = points[i + 1];
    const glm::vec2 d = points[i + 2 < points.size() ? i + 2 : i + 1];
    for (int k = 0; k < kCuts; ++k) {
      const float t = static_cast<float>(k) / kCuts;
      const glm::vec2 p =
          0.5F * (2.0F * b + (c - a) * t + (2.0F * a - 5.0F * b + 4.0F * c - d) * (t * t) +
                  (3.0F * (b - c) + d - a) * (t * t * t));
      out.emplace_back(std::max(p.x, 0.0F), p.y);
    }
  }
  out.push_back(points.back());
  out.front().x = 0.0F;
  return out;
}

/// The vases: one shape for each outline and tint.
std::vector<std::uint32_t> vaseShapes(SceneBuilder& builder) {
  const std::array<Profile, 4> outlines{Profile{{0.0F, 0.012F},
                                                {0.055F, 0.0F},
                                                {0.075F, 0.02F},
                                                {0.105F, 0.11F},
                                                {0.115F, 0.19F},
                                                {0.085F, 0.29F},
                                                {0.048F, 0.36F},
                                                {0.042F, 0.42F},
                                                {0.06F, 0.46F},
                                                {0.062F, 0.465F}},
                                        Profile{{0.0F, 0.012F},
                                                {0.05F, 0.0F},
                                                {0.056F, 0.03F},
                                                {0.05F, 0.16F},
                                                {0.055F, 0.30F},
                                                {0.075F, 0.42F},
                                                {0.10F, 0.50F},
                                                {0.102F, 0.505F}},
                                        Profile{{0.0F, 0.012F},
                                                {0.07F, 0.0F},
                                                {0.12F, 0.04F},
                                                {0.15F, 0.11F},
                                                {0.145F, 0.18F},
                                                {0.11F, 0.235F},
                                                {0.09F, 0.25F},
                                                {0.095F, 0.27F},
                                                {0.097F, 0.275F}},
                                        Profile{{0.0F, 0.012F},
                                                {0.045F, 0.0F},
                                                {0.06F, 0.015F},
                                                {0.03F, 0.06F},
                                                {0.026F, 0.14F},
                                                {0.05F, 0.20F},
                                                {0.11F, 0.27F},
                                                {0.17F, 0.31F},
                                                {0.174F, 0.315F}}};
  const std::array<glm::vec4, 5> tints{
      glm::vec4{0.05F, 0.36F, 0.62F, 0.36F}, glm::vec4{0.78F, 0.20F, 0.06F, 0.38F},
      glm::vec4{0.10F, 0.52F, 0.30F, 0.34F}, glm::vec4{0.86F, 0.92F, 0.95F, 0.20F},
      glm::vec4{0.82F, 0.50F, 0.08F, 0.36F}};
  std::vector<std::uint32_t> shapes;
  for (std::size_t t = 0; t < tints.size(); ++t) {
    const std::int32_t glass =
        builder.material(glassMaterial("vase glass " + std::to_string(t + 1), tints[t]));
    for (const Profile& outline : outlines) {
      Primitive mesh;
      addVessel(mesh, smoothed(outline), 0.006F, 0.014F, 48);
      shapes.push_back(builder.shape(std::move(mesh), glass));
    }
  }
  return shapes;
}

void addVaseTable(SceneBuilder& builder, const Palette& palette,
                  std::span<const std::uint32_t> vases, Random& random) {
  constexpr float kX = 2.65F;
  constexpr float kZ = 0.7F;
  constexpr float kHalf = 1.3F;  // of its length, along z
  constexpr float kTop = 0.86F;
  Primitive wood;
  addBevelledBox(wood, {kX - 0.45F, kTop - 0.05F, kZ - kHalf}, {kX + 0.45F, kTop, kZ + kHalf},
                 0.012F, 1.2F);
  addBevelledBox(wood, {kX - 0.38F, kTop - 0.16F, kZ - kHalf + 0.07F},
                 {kX + 0.38F, kTop - 0.04F, kZ + kHalf - 0.07F}, 0.008F, 1.2F);
  for (const float x : {-0.34F, 0.34F}) {
    for (const float z : {-1.18F, 0.0F, 1.18F}) {
      const Profile leg{{0.0F, 0.0F},   {0.03F, 0.0F},   {0.035F, 0.04F}, {0.025F, 0.08F},
                        {0.03F, 0.16F}, {0.045F, 0.32F}, {0.03F, 0.52F},  {0.045F, 0.58F},
                        {0.05F, 0.70F}, {0.0F, 0.70F}};
      Primitive turned;
      addLathe(turned, smoothed(leg), 24);
      append(wood, turned, place({kX + x, 0.0F, kZ + z}));
    }
  }
  builder.addOnce(std::move(wood), palette.wood);
  for (int i = 0; i < 10; ++i) {
    const float along = -1.1F + 2.2F * static_cast<float>(i) / 9.0F;
    const float across = (i % 2 == 0 ? -0.16F : 0.18F) + random.range(-0.03F, 0.03F);
    // The nth vase takes the tint and outline that the last one did not have.
    const std::size_t shape = (static_cast<std::size_t>(i) * 7 + 3) % vases.size();
    builder.add(vases[shape], place({kX + across, kTop + kLift, kZ + along}, random.unit(),
                                    random.range(0.85F, 1.15F)));
  }
}

/// A case of glass panes in brass edges on a wooden base, its middle at the origin.
Model caseModel(SceneBuilder& builder, const Palette& palette, std::int32_t glass) {
  constexpr float kX = 0.55F;  // half sizes
  constexpr float kZ = 0.42F;
  constexpr float kBase = 0.82F;
  constexpr float kTop = 1.62F;
  constexpr float kEdge = 0.012F;
  Primitive base;
  addBevelledBox(base, {-kX - 0.05F, 0.0F, -kZ - 0.05F}, {kX + 0.05F, 0.12F, kZ + 0.05F}, 0.012F);
  addBevelledBox(base, {-kX, 0.11F, -kZ}, {kX, kBase - 0.05F, kZ}, 0.012F);
  addBevelledBox(base, {-kX - 0.03F, kBase - 0.06F, -kZ - 0.03F}, {kX + 0.03F, kBase, kZ + 0.03F},
                 0.01F);
  Primitive felt;
  addBevelledBox(felt, {-kX + 0.04F, kBase - 0.01F, -kZ + 0.04F},
                 {kX - 0.04F, kBase + 0.012F, kZ - 0.04F}, 0.004F);
  Primitive edges;
  for (const float x : {-kX, kX}) {
    for (const float z : {-kZ, kZ}) {
      addBevelledBox(edges, {x - kEdge, kBase, z - kEdge}, {x + kEdge, kTop, z + kEdge}, 0.003F);
    }
    addBevelledBox(edges, {x - kEdge, kTop - kEdge, -kZ}, {x + kEdge, kTop + kEdge, kZ}, 0.003F);
  }
  for (const float z : {-kZ, kZ}) {
    addBevelledBox(edges, {-kX, kTop - kEdge, z - kEdge}, {kX, kTop + kEdge, z + kEdge}, 0.003F);
  }
  Primitive panes;
  const float low = kBase + 0.002F;
  addQuad(panes, {-kX, low, kZ}, {kX, low, kZ}, {kX, kTop, kZ}, {-kX, kTop, kZ});
  addQuad(panes, {kX, low, -kZ}, {-kX, low, -kZ}, {-kX, kTop, -kZ}, {kX, kTop, -kZ});
  addQuad(panes, {kX, low, kZ}, {kX, low, -kZ}, {kX, kTop, -kZ}, {kX, kTop, kZ});
  addQuad(panes, {-kX, low, -kZ}, {-kX, low, kZ}, {-kX, kTop, kZ}, {-kX, kTop, -kZ});
  addQuad(panes, {-kX, kTop, kZ}, {kX, kTop, kZ}, {kX, kTop, -kZ}, {-kX, kTop, -kZ});
  return {builder.shape(std::move(base), palette.wood),
          builder.shape(std::move(felt), palette.fabric),
          builder.shape(std::move(edges), palette.brass), builder.shape(std::move(panes), glass)};
}

void addCases(SceneBuilder& builder, const Palette& palette, std::span<const std::uint32_t> vases) {
  constexpr float kFelt = 0.832F;  // height of what the exhibits stand on
  constexpr float kSideways = 0.25F;
  const std::int32_t clear =
      builder.material(glassMaterial("case glass", {0.74F, 0.88F, 0.90F, 0.13F}));
  const Model model = caseModel(builder, palette, clear);
  Primitive knot;
  addTorusKnot(knot, 2, 5, 0.13F, 0.028F, 256, 20);
  const std::uint32_t gold = builder.shape(
      std::move(knot),
      builder.material(plainMaterial("gold", {0.95F, 0.62F, 0.22F, 1.0F}, 0.3F, 0.55F)));
  Primitive urnMesh;
  const Profile urn{{0.0F, 0.0F},    {0.07F, 0.0F},   {0.06F, 0.02F}, {0.035F, 0.06F},
                    {0.09F, 0.16F},  {0.125F, 0.27F}, {0.10F, 0.37F}, {0.05F, 0.42F},
                    {0.055F, 0.45F}, {0.075F, 0.47F}, {0.0F, 0.475F}};
  addLathe(urnMesh, smoothed(urn), 64);
  const std::uint32_t urnShape = builder.shape(std::move(urnMesh), palette.pottery);

  const std::array<glm::vec3, 3> places{
      glm::vec3(-2.55F, 0.0F, 1.3F), glm::vec3(-2.75F, 0.0F, -2.3F), glm::vec3(5.0F, 0.0F, -2.0F)};
  for (std::size_t i = 0; i < places.size(); ++i) {
    const glm::mat4 at = place(places[i], kSideways);
    builder.add(model, at);
    builder.add(urnShape, at * place({-0.28F, kFelt, 0.02F}));
    builder.add(gold, at * place({0.05F, kFelt + 0.085F, 0.0F}));
    builder.add(vases[(i * 5 + 12) % vases.size()], at * place({0.36F, kFelt + kLift, 0.0F}));
  }
}

/// Tinted panes between brass posts across the hall, open in the middle.
void addPartition(SceneBuilder& builder, const Palette& palette) {
  constexpr float kZ = -6.0F;
  constexpr float kInner = 1.25F;
  constexpr float kOuter = 3.86F;  // at the columns
  constexpr float kTop = 3.0F;
  constexpr int kPanes = 3;  // a side
  constexpr float kThick = 0.006F;
  Primitive posts;
  Primitive panes;
  for (const float side : {-1.0F, 1.0F}) {
    const auto bar = [&](float a, float b, float low, float high, float depth) {
      addBevelledBox(posts, {std::min(side * a, side * b), low, kZ - depth},
                     {std::max(side * a, side * b), high, kZ + depth}, 0.005F);
    };
    bar(kInner - 0.03F, kOuter + 0.03F, kTop, kTop + 0.06F, 0.03F);
    bar(kInner - 0.03F, kOuter + 0.03F, 0.0F, 0.06F, 0.03F);
    constexpr float kStep = (kOuter - kInner) / kPanes;
    for (int i = 0; i <= kPanes; ++i) {
      const float x = kInner + kStep * static_cast<float>(i);
      bar(x - 0.02F, x + 0.02F, 0.05F, kTop + 0.01F, 0.02F);
      if (i == kPanes) break;
      const float a = x + 0.02F;
      const float b = x + kStep - 0.02F;
      addBox(panes, {std::min(side * a, side * b), 0.06F, kZ - kThick},
             {std::max(side * a, side * b), kTop, kZ + kThick});
    }
  }
  builder.addOnce(std::move(posts), palette.brass);
  builder.addOnce(std::move(panes),
                  builder.material(glassMaterial("partition glass", {0.16F, 0.48F, 0.50F, 0.22F})));
}

/// A sheer curtain in the yz plane that faces -x, gathered in waves; z from 0 to `width`.
Primitive curtainMesh(float width, float height) {
  constexpr int kAcross = 56;
  constexpr int kDown = 16;
  constexpr float kWaves = 7.0F;
  constexpr float kAmplitude = 0.045F;
  constexpr float kTau = 6.2831853F;
  Primitive mesh;
  for (int i = 0; i <= kDown; ++i) {
    const float v = static_cast<float>(i) / kDown;
    const float fall = kAmplitude * (0.45F + 0.55F * v);  // the folds open downwards
    for (int j = 0; j <= kAcross; ++j) {
      const float u = static_cast<float>(j) / kAcross;
      const glm::vec2 wave = onCircle(u * kWaves);
      const float slope = fall * wave.x * kTau * kWaves / width;
      addVertex(mesh, {fall * wave.y, height * (1.0F - v), u * width},
                glm::normalize(glm::vec3(-1.0F, 0.0F, slope)), {u, v});
    }
  }
  constexpr std::uint32_t kStride = kAcross + 1;
  for (std::uint32_t i = 0; i < kDown; ++i) {
    for (std::uint32_t j = 0; j < kAcross; ++j) {
      const std::uint32_t a = i * kStride + j;
      mesh.indices.insert(mesh.indices.end(), {a, a + kStride, a + kStride + 1});
      mesh.indices.insert(mesh.indices.end(), {a, a + kStride + 1, a + 1});
    }
  }
  return mesh;
}

void addCurtains(SceneBuilder& builder, const Palette& palette) {
  constexpr float kWidth = 0.62F;
  constexpr float kRail = 4.78F;
  constexpr float kX = 5.78F;
  Material sheer = plainMaterial("sheer curtain", {0.93F, 0.86F, 0.74F, 0.42F}, 0.95F);
  sheer.doubleSided = true;
  const std::uint32_t curtain =
      builder.shape(curtainMesh(kWidth, kRail - 0.04F), builder.material(sheer));
  Primitive railMesh;
  const std::array<glm::vec3, 2> rod{glm::vec3(kX, kRail + 0.02F, -1.6F),
                                     glm::vec3(kX, kRail + 0.02F, 1.6F)};
  addTube(railMesh, rod, std::array{0.018F, 0.018F}, 12, false);
  for (const float z : {-1.6F, 1.6F}) addSphere(railMesh, {kX, kRail + 0.02F, z}, 0.04F, 16);
  const std::uint32_t rail = builder.shape(std::move(railMesh), palette.brass);
  for (int i = 0; i < 5; ++i) {
    const float z = -8.0F + kBay * static_cast<float>(i);
    builder.add(rail, place({0.0F, 0.0F, z}));
    builder.add(curtain, place({kX, 0.03F, z - 1.5F}));
    builder.add(curtain, place({kX, 0.03F, z + 1.5F - kWidth}));
  }
}

}  // namespace

void addGlass(SceneBuilder& builder, const Palette& palette, std::uint64_t seed) {
  Random random(seed, 11);
  const std::vector<std::uint32_t> vases = vaseShapes(builder);
  addVaseTable(builder, palette, vases, random);
  addCases(builder, palette, vases);
  addPartition(builder, palette);
  addCurtains(builder, palette);
}

}  // namespace macula::scene::gallery
