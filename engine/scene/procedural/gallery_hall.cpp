#include <utility>
#include <vector>

#include "engine/scene/procedural/circle.h"
#include "engine/scene/procedural/gallery_parts.h"
#include "engine/scene/procedural/mesh_builder.h"
#include "engine/scene/procedural/textures.h"

namespace macula::scene::gallery {
namespace {

constexpr float kWall = 0.3F;  // thickness, metres
constexpr float kSill = 0.9F;
constexpr float kHead = 4.6F;        // upper edge of the windows
constexpr float kHalfWindow = 1.1F;  // half their width
constexpr int kWindows = 5;
constexpr float kFirstWindow = -8.0F;  // z of the first window's middle
constexpr float kFirstColumn = -10.0F;
constexpr int kColumnsInRow = 6;
constexpr float kEntablature = 5.2F;  // its lower edge, on the columns
constexpr float kBeam = 5.6F;         // lower edge of the ceiling's beams

float windowZ(int i) {
  return kFirstWindow + kBay * static_cast<float>(i);
}
float columnZ(int i) {
  return kFirstColumn + kBay * static_cast<float>(i);
}

void addShell(SceneBuilder& builder, const Palette& palette) {
  constexpr float w = kHalfWidth;
  constexpr float l = kHalfLength;
  Primitive floor;
  // One repeat of the image is two slabs by two: a slab is a metre.
  addQuad(floor, {-w, 0.0F, l}, {w, 0.0F, l}, {w, 0.0F, -l}, {-w, 0.0F, -l}, glm::vec2(0.0F),
          {w, l});
  builder.addOnce(std::move(floor), palette.marble);

  Primitive walls;
  constexpr float kRepeat = 0.5F;  // of the plaster, per metre
  addBox(walls, {-w - kWall, 0.0F, -l}, {-w, kHeight, l}, kRepeat);
  addBox(walls, {-w - kWall, 0.0F, -l - kWall}, {w + kWall, kHeight, -l}, kRepeat);
  addBox(walls, {-w - kWall, 0.0F, l}, {w + kWall, kHeight, l + kWall}, kRepeat);
  addBox(walls, {-w - kWall, kHeight, -l - kWall}, {w + kWall, kHeight + kWall, l + kWall},
         kRepeat);
  addBox(walls, {w, 0.0F, -l}, {w + kWall, kSill, l}, kRepeat);
  addBox(walls, {w, kHead, -l}, {w + kWall, kHeight, l}, kRepeat);
  float pier = -l;
  for (int i = 0; i < kWindows; ++i) {
    addBox(walls, {w, kSill, pier}, {w + kWall, kHead, windowZ(i) - kHalfWindow}, kRepeat);
    pier = windowZ(i) + kHalfWindow;
  }
  addBox(walls, {w, kSill, pier}, {w + kWall, kHead, l}, kRepeat);
  builder.addOnce(std::move(walls), palette.plaster);
}

void addWoodwork(SceneBuilder& builder, const Palette& palette) {
  // Panels along the walls, proud of the plaster, with a rail on top and a skirting below.
  constexpr float kDepth = 0.05F;
  constexpr float kPanel = 0.98F;  // width of one panel with its gap
  Primitive wood;
  const auto run = [&](const glm::vec3& from, const glm::vec3& along, const glm::vec3& inwards,
                       float length) {
    const auto slab = [&](float start, float end, float low, float high, float depth) {
      const glm::vec3 a = from + along * start + glm::vec3(0.0F, low, 0.0F);
      const glm::vec3 b = from + along * end + inwards * depth + glm::vec3(0.0F, high, 0.0F);
      addBevelledBox(wood, glm::min(a, b), glm::max(a, b), 0.008F, 1.2F);
    };
    slab(0.0F, length, 0.0F, 0.16F, kDepth + 0.02F);
    slab(0.0F, length, 0.80F, 0.88F, kDepth + 0.03F);
    slab(0.0F, length, 0.15F, 0.81F, 0.018F);
    const int panels = static_cast<int>(length / kPanel);
    const float step = length / static_cast<float>(panels);
    for (int i = 0; i < panels; ++i) {
      const float start = step * static_cast<float>(i);
      slab(start + 0.02F, start + step - 0.02F, 0.15F, 0.81F, 0.03F);
      slab(start + 0.14F, start + step - 0.14F, 0.25F, 0.71F, kDepth);
    }
  };
  run({-kHalfWidth, 0.0F, -kHalfLength}, {0.0F, 0.0F, 1.0F}, {1.0F, 0.0F, 0.0F},
      2.0F * kHalfLength);
  run({kHalfWidth, 0.0F, -kHalfLength}, {0.0F, 0.0F, 1.0F}, {-1.0F, 0.0F, 0.0F},
      2.0F * kHalfLength);
  run({-kHalfWidth + 0.09F, 0.0F, -kHalfLength}, {1.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 1.0F},
      2.0F * kHalfWidth - 0.18F);
  run({-kHalfWidth + 0.09F, 0.0F, kHalfLength}, {1.0F, 0.0F, 0.0F}, {0.0F, 0.0F, -1.0F},
      2.0F * kHalfWidth - 0.18F);
  builder.addOnce(std::move(wood), palette.wood);
}

/// A column of one bay with plinth, base, capital and abacus, standing at the origin.
Model columnModel(SceneBuilder& builder, const Palette& palette) {
  constexpr float kRadius = 0.28F;
  constexpr float kShaftFoot = 0.42F;
  constexpr float kShaftTop = 4.72F;
  Primitive shaft;
  addFlutedShaft(shaft, kRadius, kShaftTop - kShaftFoot, 20, 16);
  Primitive ends;
  addBevelledBox(ends, {-0.42F, 0.0F, -0.42F}, {0.42F, 0.18F, 0.42F}, 0.015F);
  const std::vector<glm::vec2> base{{0.40F, 0.18F},  {0.415F, 0.21F}, {0.415F, 0.25F},
                                    {0.39F, 0.285F}, {0.335F, 0.30F}, {0.335F, 0.32F},
                                    {0.355F, 0.34F}, {0.36F, 0.37F},  {0.345F, 0.40F},
                                    {0.30F, 0.42F},  {0.0F, 0.43F}};
  addLathe(ends, base, 48);
  const std::vector<glm::vec2> capital{
      {0.235F, 4.70F}, {0.265F, 4.72F}, {0.265F, 4.76F}, {0.24F, 4.78F}, {0.25F, 4.86F},
      {0.29F, 4.95F},  {0.36F, 5.02F},  {0.38F, 5.05F},  {0.36F, 5.08F}, {0.0F, 5.08F}};
  addLathe(ends, capital, 48);
  addBevelledBox(ends, {-0.42F, 5.07F, -0.42F}, {0.42F, kEntablature, 0.42F}, 0.015F);
  Primitive placedShaft;
  append(placedShaft, shaft, place({0.0F, kShaftFoot, 0.0F}));
  return {builder.shape(std::move(placedShaft), palette.stone),
          builder.shape(std::move(ends), palette.stone)};
}

void addColumnsAndCeiling(SceneBuilder& builder, const Palette& palette) {
  const Model column = columnModel(builder, palette);
  for (int i = 0; i < kColumnsInRow; ++i) {
    for (const float side : {-1.0F, 1.0F}) {
      builder.add(column, place({side * kColumnX, 0.0F, columnZ(i)}));
    }
  }
  Primitive stone;
  constexpr float kHalfBeam = 0.24F;
  constexpr float kDentil = 0.22F;  // distance from one to the next
  for (const float side : {-1.0F, 1.0F}) {
    const float x = side * kColumnX;
    addBox(stone, {x - kHalfBeam, kEntablature, -kHalfLength}, {x + kHalfBeam, kBeam, kHalfLength});
    addBevelledBox(stone, {x - 0.31F, kBeam - 0.08F, -kHalfLength},
                   {x + 0.31F, kBeam + 0.02F, kHalfLength}, 0.02F);
    const int dentils = static_cast<int>(2.0F * kHalfLength / kDentil);
    for (int i = 0; i < dentils; ++i) {
      const float z = -kHalfLength + kDentil * (static_cast<float>(i) + 0.5F);
      const float inner = x - side * kHalfBeam;
      const glm::vec3 a{inner + 0.01F * side, kBeam - 0.21F, z - 0.06F};
      const glm::vec3 b{inner - side * 0.055F, kBeam - 0.09F, z + 0.06F};
      addBevelledBox(stone, glm::min(a, b), glm::max(a, b), 0.006F);
    }
  }
  builder.addOnce(std::move(stone), palette.stone);

  Primitive beams;
  for (int i = 0; i < kColumnsInRow; ++i) {
    addBevelledBox(beams, {-kHalfWidth, kBeam, columnZ(i) - 0.18F},
                   {kHalfWidth, kHeight, columnZ(i) + 0.18F}, 0.03F, 1.2F);
  }
  for (const float x : {-1.4F, 1.4F}) {
    addBevelledBox(beams, {x - 0.1F, kBeam + 0.16F, -kHalfLength}, {x + 0.1F, kHeight, kHalfLength},
                   0.02F, 1.2F);
  }
  builder.addOnce(std::move(beams), palette.wood);
}

void addWindows(SceneBuilder& builder) {
  // Frosted panes that glow with the sky. They blend, so the sun still shines through them.
  Material pane;
  pane.name = "frosted pane";
  pane.baseColor = {0.62F, 0.80F, 1.0F, 0.88F};
  pane.alphaMode = AlphaMode::Blend;
  pane.unlit = true;
  Primitive frame;
  addBevelledBox(frame, {0.12F, kSill, -kHalfWindow}, {0.2F, kSill + 0.07F, kHalfWindow}, 0.008F);
  addBevelledBox(frame, {0.12F, kHead - 0.07F, -kHalfWindow}, {0.2F, kHead, kHalfWindow}, 0.008F);
  for (int i = 0; i <= 3; ++i) {
    const float z = (kHalfWindow - 0.03F) * (static_cast<float>(i) / 1.5F - 1.0F);
    addBevelledBox(frame, {0.13F, kSill, z - 0.025F}, {0.19F, kHead, z + 0.025F}, 0.006F);
  }
  for (int i = 1; i < 5; ++i) {
    const float y = kSill + (kHead - kSill) * static_cast<float>(i) / 5.0F;
    addBevelledBox(frame, {0.14F, y - 0.015F, -kHalfWindow}, {0.18F, y + 0.015F, kHalfWindow},
                   0.004F);
  }
  addBevelledBox(frame, {-0.12F, kSill - 0.02F, -kHalfWindow - 0.1F},
                 {0.12F, kSill + 0.03F, kHalfWindow + 0.1F}, 0.01F);
  Primitive glass;
  addQuad(glass, {0.16F, kSill, -kHalfWindow}, {0.16F, kSill, kHalfWindow},
          {0.16F, kHead, kHalfWindow}, {0.16F, kHead, -kHalfWindow});
  const std::int32_t iron =
      builder.material(plainMaterial("window iron", {0.05F, 0.055F, 0.06F, 1.0F}, 0.5F));
  const Model window{builder.shape(std::move(frame), iron),
                     builder.shape(std::move(glass), builder.material(pane))};
  for (int i = 0; i < kWindows; ++i) {
    builder.add(window, place({kHalfWidth, 0.0F, windowZ(i)}));
  }
}

void addCarpet(SceneBuilder& builder, std::uint64_t seed) {
  Material material = plainMaterial("carpet", glm::vec4(1.0F), 0.95F);
  material.baseColorTexture.image = builder.image(carpet(128, 512, seed));
  const std::int32_t index = builder.material(material);
  constexpr float kThickness = 0.012F;
  Primitive mesh;
  addQuad(mesh, {-1.3F, kThickness, 8.6F}, {1.3F, kThickness, 8.6F}, {1.3F, kThickness, 0.6F},
          {-1.3F, kThickness, 0.6F});
  builder.addOnce(std::move(mesh), index);
  // The cut edge, so that the carpet does not float.
  Primitive edge;
  addQuad(edge, {-1.3F, 0.0F, 8.6F}, {1.3F, 0.0F, 8.6F}, {1.3F, kThickness, 8.6F},
          {-1.3F, kThickness, 8.6F});
  addQuad(edge, {1.3F, 0.0F, 8.6F}, {1.3F, 0.0F, 0.6F}, {1.3F, kThickness, 0.6F},
          {1.3F, kThickness, 8.6F});
  addQuad(edge, {1.3F, 0.0F, 0.6F}, {-1.3F, 0.0F, 0.6F}, {-1.3F, kThickness, 0.6F},
          {1.3F, kThickness, 0.6F});
  addQuad(edge, {-1.3F, 0.0F, 0.6F}, {-1.3F, 0.0F, 8.6F}, {-1.3F, kThickness, 8.6F},
          {-1.3F, kThickness, 0.6F});
  builder.addOnce(std::move(edge),
                  builder.material(plainMaterial("carpet edge", {0.3F, 0.2F, 0.1F, 1.0F}, 0.95F)));
}

}  // namespace

void addHall(SceneBuilder& builder, const Palette& palette, std::uint64_t seed) {
  addShell(builder, palette);
  addWoodwork(builder, palette);
  addColumnsAndCeiling(builder, palette);
  addWindows(builder);
  addCarpet(builder, seed);
}

}  // namespace macula::scene::gallery
