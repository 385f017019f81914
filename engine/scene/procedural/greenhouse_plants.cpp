#include <array>
#include <utility>

#include "engine/core/random.h"
#include "engine/scene/procedural/greenhouse_parts.h"
#include "engine/scene/procedural/in_ball.h"
#include "engine/scene/procedural/leaf.h"

namespace macula::scene::greenhouse {
namespace {

constexpr float kGoldenTurn = 0.381966F;  // of successive leaves about a stem

/// A pointed oval on a short stalk. @param s 0 at the stem, 1 at the tip
float lens(float s) {
  if (s < 0.12F) return 0.08F;
  const float along = (s - 0.12F) / 0.88F;
  return 0.08F + 3.9F * along * (1.0F - along) * (1.1F - 0.35F * along) * (1.0F - s * s * s * s);
}

/// Broad at the tip, as petals are.
float petal(float s) {
  return (0.25F + 1.6F * s) * (1.0F - 0.75F * s * s * s * s);
}

/// A blade that narrows towards its tip.
float blade(float s) {
  return 1.0F - 0.92F * s * s;
}

glm::vec4 shade(const glm::vec3& color, float tone, float alpha) {
  return {glm::min(color * tone, glm::vec3(1.0F)), alpha};
}

/// Broad leaves around a stem.
Primitive broadLeaved(const glm::vec3& color, int leaves, float size, Random& random) {
  Primitive mesh;
  for (int i = 0; i < leaves; ++i) {
    const float t = static_cast<float>(i) / static_cast<float>(leaves);
    Leaf leaf{};
    leaf.turns = kGoldenTurn * static_cast<float>(i) + random.range(-0.04F, 0.04F);
    leaf.length = size * random.range(0.7F, 1.0F) * (1.1F - 0.4F * t);
    leaf.rise = 0.4F + 1.9F * t;
    leaf.droop = 0.9F + 0.4F * t;
    leaf.width = leaf.length * random.range(0.46F, 0.58F);
    leaf.foot = {0.0F, size * t, 0.0F};
    addLeaf(mesh, leaf, 4, shade(color, random.range(0.6F, 1.1F), random.range(0.3F, 0.55F)), lens);
  }
  return mesh;
}

/// A tuft of long blades.
Primitive grassy(const glm::vec3& color, int blades, float size, Random& random) {
  Primitive mesh;
  for (int i = 0; i < blades; ++i) {
    Leaf leaf{};
    leaf.turns = kGoldenTurn * static_cast<float>(i) + random.range(-0.1F, 0.1F);
    leaf.length = size * random.range(0.35F, 0.7F);
    leaf.rise = random.range(1.4F, 3.0F);
    leaf.droop = random.range(0.9F, 1.9F);
    leaf.width = random.range(0.036F, 0.056F);
    leaf.foot = inBall(random) * glm::vec3(0.05F, 0.0F, 0.05F);
    addLeaf(mesh, leaf, 5, shade(color, random.range(0.6F, 1.1F), random.range(0.3F, 0.55F)),
            blade);
  }
  return mesh;
}

/// Petals around one head. @param open slope of the petals; less is wider open
void addBloom(Primitive& mesh, const glm::vec3& head, float radius, float open,
              const glm::vec3& color, Random& random) {
  constexpr int kPetals = 7;
  const float turn = random.unit();
  for (int i = 0; i < kPetals; ++i) {
    Leaf leaf{};
    leaf.turns = turn + static_cast<float>(i) / kPetals;
    leaf.length = radius;
    leaf.rise = open;
    leaf.droop = 0.5F * open;
    leaf.width = 0.72F * radius;
    leaf.foot = head;
    addLeaf(mesh, leaf, 3, shade(color, random.range(0.85F, 1.1F), random.range(0.4F, 0.6F)),
            petal);
  }
}

/// Leaves below, blooms on stalks above.
Primitive flowering(const glm::vec3& green, const glm::vec3& color, int blooms, float size,
                    Random& random) {
  Primitive mesh = broadLeaved(green, 22, 0.8F * size, random);
  for (int i = 0; i < blooms; ++i) {
    Leaf stalk{};
    stalk.turns = kGoldenTurn * static_cast<float>(i);
    stalk.length = size * random.range(0.1F, 0.32F);
    stalk.rise = size * random.range(0.8F, 1.15F) / stalk.length;
    stalk.width = 0.008F;
    stalk.foot = glm::vec3(0.0F);
    addLeaf(mesh, stalk, 2, shade(green, 0.8F, 0.6F), [](float) { return 1.0F; });
    const glm::vec2 out = stalk.length * onCircle(stalk.turns);
    addBloom(mesh, {out.x, stalk.length * stalk.rise, -out.y}, size * random.range(0.14F, 0.20F),
             random.range(0.3F, 0.9F), color, random);
  }
  return mesh;
}

/// Long fronds that hang down all around, leafy on both sides.
Primitive trailing(const glm::vec3& color, Random& random) {
  constexpr int kVines = 14;
  constexpr int kLeaves = 9;
  Primitive mesh;
  for (int i = 0; i < kVines; ++i) {
    const float turns = kGoldenTurn * static_cast<float>(i);
    const glm::vec2 out = onCircle(turns);
    const float reach = random.range(0.12F, 0.3F);
    const float fall = random.range(0.35F, 0.95F);
    for (int j = 1; j <= kLeaves; ++j) {
      const float t = static_cast<float>(j) / kLeaves;
      const float spread = reach * t * (2.0F - t);
      Leaf leaf{};
      leaf.foot = {out.x * spread, 0.1F * t * (1.0F - t) - fall * t * t, -out.y * spread};
      leaf.turns = turns + (j % 2 == 0 ? 0.22F : -0.22F) + random.range(-0.08F, 0.08F);
      leaf.length = random.range(0.10F, 0.16F);
      leaf.rise = 0.2F;
      leaf.droop = random.range(0.5F, 1.1F);
      leaf.width = 0.6F * leaf.length;
      addLeaf(mesh, leaf, 3, shade(color, random.range(0.6F, 1.1F), random.range(0.35F, 0.6F)),
              lens);
    }
  }
  return mesh;
}

std::int32_t leafMaterial(SceneBuilder& builder, const char* name) {
  // The colour of each leaf is that of its vertices.
  Material material = plainMaterial(name, glm::vec4(1.0F), 0.45F);
  material.alphaMode = AlphaMode::Blend;
  material.doubleSided = true;
  return builder.material(material);
}

// Linear colours.
constexpr glm::vec3 kDeepGreen{0.06F, 0.30F, 0.07F};
constexpr glm::vec3 kFreshGreen{0.22F, 0.50F, 0.08F};
constexpr glm::vec3 kBlueGreen{0.08F, 0.34F, 0.24F};
constexpr glm::vec3 kPurpleLeaf{0.32F, 0.07F, 0.22F};

}  // namespace

std::vector<std::uint32_t> addPlantShapes(SceneBuilder& builder, std::uint64_t seed) {
  Random random(seed, 51);
  const std::int32_t leaves = leafMaterial(builder, "leaves");
  const std::int32_t flowers = leafMaterial(builder, "flowers");
  std::vector<std::uint32_t> shapes;
  const auto keep = [&](Primitive mesh, std::int32_t material) {
    shapes.push_back(builder.shape(std::move(mesh), material));
  };
  keep(broadLeaved(kDeepGreen, 34, 0.58F, random), leaves);
  keep(broadLeaved(kFreshGreen, 38, 0.5F, random), leaves);
  keep(broadLeaved(kPurpleLeaf, 34, 0.5F, random), leaves);
  keep(grassy(kFreshGreen, 44, 0.8F, random), leaves);
  keep(grassy(kBlueGreen, 44, 0.7F, random), leaves);
  keep(flowering(kDeepGreen, {0.85F, 0.10F, 0.12F}, 9, 0.6F, random), flowers);
  keep(flowering(kFreshGreen, {0.90F, 0.55F, 0.08F}, 10, 0.55F, random), flowers);
  keep(flowering(kBlueGreen, {0.45F, 0.22F, 0.80F}, 9, 0.62F, random), flowers);
  keep(flowering(kDeepGreen, {0.92F, 0.70F, 0.78F}, 11, 0.58F, random), flowers);
  return shapes;
}

std::vector<std::uint32_t> addHangingShapes(SceneBuilder& builder, std::uint64_t seed) {
  Random random(seed, 52);
  const std::int32_t vines = leafMaterial(builder, "vines");
  return {builder.shape(trailing(kFreshGreen, random), vines),
          builder.shape(trailing(kBlueGreen, random), vines)};
}

}  // namespace macula::scene::greenhouse
