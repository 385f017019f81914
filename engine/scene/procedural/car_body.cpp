// The body: sections across the car, swept from tail to nose.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "engine/scene/procedural/car_parts.h"
#include "engine/scene/procedural/circle.h"
#include "engine/scene/procedural/mesh_builder.h"
#include "engine/scene/procedural/patch.h"

namespace macula::scene::car {
namespace {

using Key = glm::vec2;  // (x, height or half-width), metres

// Lines along the body, from the sill to the ridge. Where there is no cabin, the edge of the roof
// is the crease of the lids.
constexpr std::array kSillZ{Key{-2.1F, 0.64F}, Key{-1.9F, 0.78F}, Key{-1.5F, 0.83F},
                            Key{0.0F, 0.82F},  Key{1.5F, 0.83F},  Key{1.9F, 0.78F},
                            Key{2.1F, 0.62F}};
constexpr std::array kShoulderY{Key{-2.1F, 0.62F}, Key{-1.9F, 0.70F}, Key{-1.4F, 0.76F},
                                Key{0.0F, 0.73F},  Key{1.3F, 0.74F},  Key{1.9F, 0.64F},
                                Key{2.1F, 0.55F}};
constexpr std::array kShoulderZ{Key{-2.1F, 0.68F}, Key{-1.9F, 0.81F}, Key{-1.4F, 0.875F},
                                Key{0.0F, 0.865F}, Key{1.4F, 0.875F}, Key{1.9F, 0.80F},
                                Key{2.1F, 0.66F}};
constexpr std::array kWaistY{Key{-2.1F, 0.74F}, Key{-1.9F, 0.84F}, Key{-1.3F, 0.89F},
                             Key{0.0F, 0.86F},  Key{0.85F, 0.86F}, Key{1.5F, 0.82F},
                             Key{1.95F, 0.73F}, Key{2.1F, 0.64F}};
constexpr std::array kWaistZ{Key{-2.1F, 0.64F}, Key{-1.9F, 0.75F}, Key{-1.3F, 0.82F},
                             Key{0.0F, 0.82F},  Key{1.0F, 0.82F},  Key{1.6F, 0.79F},
                             Key{1.95F, 0.72F}, Key{2.1F, 0.60F}};
constexpr std::array kEdgeY{Key{-2.1F, 0.78F}, Key{-1.95F, 0.86F}, Key{-1.62F, 0.915F},
                            Key{-1.0F, 1.20F}, Key{-0.65F, 1.27F}, Key{-0.3F, 1.285F},
                            Key{0.12F, 1.24F}, Key{0.82F, 0.89F},  Key{1.4F, 0.85F},
                            Key{1.95F, 0.75F}, Key{2.1F, 0.66F}};
constexpr std::array kEdgeZ{Key{-2.1F, 0.54F}, Key{-1.62F, 0.66F}, Key{-1.0F, 0.60F},
                            Key{-0.3F, 0.59F}, Key{0.12F, 0.60F},  Key{0.82F, 0.73F},
                            Key{1.4F, 0.69F},  Key{1.95F, 0.62F},  Key{2.1F, 0.50F}};
constexpr std::array kRidgeY{Key{-2.1F, 0.80F}, Key{-1.95F, 0.88F},  Key{-1.66F, 0.95F},
                             Key{-1.1F, 1.24F}, Key{-0.65F, 1.345F}, Key{-0.25F, 1.36F},
                             Key{0.16F, 1.32F}, Key{0.86F, 0.945F},  Key{1.4F, 0.90F},
                             Key{1.95F, 0.79F}, Key{2.1F, 0.69F}};

/// Shares of the livery at which the five lines lie, and where the steps between them are cut.
constexpr std::array<float, 6> kShares{0.0F, 0.15F, kFlankShare, kWaistShare, kRoofShare, 1.0F};
const std::vector<float>& steps(std::size_t segment) {
  static const std::array<std::vector<float>, 5> kSteps{
      {{0.0F, 0.33F, 0.67F},
       {0.0F, 0.33F, 0.67F},
       {0.0F, 0.5F},
       {0.0F, 0.10F, 0.32F, 0.60F, 0.92F},
       {0.0F, 0.08F, 0.2F, 0.4F, 0.6F, 0.8F, 1.0F}}};
  return kSteps[segment];
}

/// Height of the lower edge, with the openings for the wheels.
float sillY(float x) {
  const float rise = std::max(std::abs(x) - 1.75F, 0.0F);
  float y = kSill + 0.25F * rise;
  for (const float axle : {kFrontAxle, kRearAxle}) {
    const float d = (x - axle) / kArchRadius;
    if (std::abs(d) < 1.0F) {
      y = std::max(y, kWheelRadius + kArchRadius * std::sqrt(1.0F - d * d));
    }
  }
  return y;
}

/// The flank stands out around the wheels.
float flare(float x) {
  float out = 0.0F;
  for (const float axle : {kFrontAxle, kRearAxle}) {
    const float d = std::abs(x - axle) / (1.5F * kArchRadius);
    if (d < 1.0F) out = 0.035F * (1.0F - d * d) * (1.0F - d * d);
  }
  return out;
}

/// The six points of a section: sill, flank, shoulder, waist, edge of the roof, ridge.
std::array<glm::vec3, 6> sectionAt(float x) {
  const float low = sillY(x);
  const glm::vec2 shoulder{std::max(curveAt(kShoulderY, x), low + 0.03F),
                           curveAt(kShoulderZ, x) + flare(x)};
  const float sillZ = curveAt(kSillZ, x) + flare(x);
  // The flank bulges from the sill's line at its usual height, wherever an opening cuts it.
  const auto flankZ = [&](float y) {
    const float t = std::clamp((y - kSill) / (shoulder.x - kSill), 0.0F, 1.0F);
    return glm::mix(sillZ, shoulder.y, t * (2.0F - t));
  };
  const float middle = glm::mix(low, shoulder.x, 0.5F);
  return {glm::vec3(x, low, flankZ(low)),
          glm::vec3(x, middle, flankZ(middle)),
          glm::vec3(x, shoulder.x, shoulder.y),
          glm::vec3(x, std::max(curveAt(kWaistY, x), shoulder.x + 0.02F), curveAt(kWaistZ, x)),
          glm::vec3(x, curveAt(kEdgeY, x), curveAt(kEdgeZ, x)),
          glm::vec3(x, curveAt(kRidgeY, x), 0.0F)};
}

/// A point of the right half.
glm::vec3 alongSection(const std::array<glm::vec3, 6>& s, std::size_t segment, float t) {
  constexpr glm::vec3 kMirror{1.0F, 1.0F, -1.0F};
  const glm::vec3 before = segment == 0 ? 2.0F * s[0] - s[1] : s[segment - 1];
  const glm::vec3 after = segment == 4 ? s[4] * kMirror : s[segment + 2];
  return splineBetween(before, s[segment], s[segment + 1], after, t);
}

/// Where the stations stand along x: evenly, on the rims of the openings and of the windows.
std::vector<float> stations() {
  std::vector<float> xs{kDoorFront, kDoorBack, kDoorBack - 0.07F, 0.74F, 0.16F, -1.02F, -1.14F,
                        -1.56F,     0.08F};
  constexpr int kEven = 44;
  for (int i = 0; i <= kEven; ++i) {
    xs.push_back(glm::mix(kTail, kNose, static_cast<float>(i) / kEven));
  }
  constexpr int kArchSteps = 16;
  // Half the width of an opening at the height of the sill.
  const float dip = kWheelRadius - kSill;
  const float half = std::sqrt(kArchRadius * kArchRadius - dip * dip);
  for (const float axle : {kFrontAxle, kRearAxle}) {
    for (int i = 1; i < kArchSteps; ++i) {
      xs.push_back(axle + half * onCircle(0.5 * i / kArchSteps).x);
    }
    // Just outside and just inside: the edge goes up at once.
    for (const float side : {-1.0F, 1.0F}) {
      xs.push_back(axle + side * (half + 0.001F));
      xs.push_back(axle + side * (half - 0.001F));
    }
  }
  std::sort(xs.begin(), xs.end());
  xs.erase(
      std::unique(xs.begin(), xs.end(), [](float a, float b) { return std::abs(a - b) < 0.0015F; }),
      xs.end());
  return xs;
}

enum class Skin : std::uint8_t { Paint, Glass };

/// What a cell between two stations is made of.
Skin skinOf(float x, std::size_t segment, int step) {
  if (segment == 3 && step >= 1 && step <= 3) {
    const bool pillar = x < kDoorBack && x > kDoorBack - 0.07F;
    if (x > -1.02F && x < kDoorFront && !pillar) return Skin::Glass;
  }
  if (segment == 4 && step >= 1) {
    if (x > 0.16F && x < 0.74F) return Skin::Glass;
    if (x > -1.56F && x < -1.14F) return Skin::Glass;
  }
  return Skin::Paint;
}

/// One column of the right half: a segment of the section, the step in it, and the share.
struct Column {
  std::size_t segment;
  int step;
  float t;
  float share;
};

std::vector<Column> columns() {
  std::vector<Column> list;
  for (std::size_t s = 0; s < 5; ++s) {
    const std::vector<float>& cuts = steps(s);
    for (std::size_t k = 0; k < cuts.size(); ++k) {
      list.push_back(
          {s, static_cast<int>(k), cuts[k], glm::mix(kShares[s], kShares[s + 1], cuts[k])});
    }
  }
  return list;
}

/// Closes an end between both halves of its section, bulging outwards.
void addEnd(Primitive& mesh, float x, float sign, const std::vector<Column>& half) {
  constexpr int kAcross = 8;
  constexpr float kBulge = 0.05F;
  const auto section = sectionAt(x);
  // One row less than columns: the last one is the ridge itself.
  Patch patch(static_cast<int>(half.size()), kAcross + 1);
  for (int i = 0; i < patch.rows(); ++i) {
    const Column& column = half[static_cast<std::size_t>(i)];
    const glm::vec3 rim = alongSection(section, column.segment, column.t);
    for (int j = 0; j <= kAcross; ++j) {
      const float across = 2.0F * static_cast<float>(j) / kAcross - 1.0F;
      const float out = kBulge * (1.0F - across * across) * (1.0F - column.share * column.share);
      patch.at(i, j) = {{x + sign * out, rim.y, -sign * across * rim.z},
                        {0.5F + 0.5F * x / kNose, 0.02F + 0.96F * column.share}};
    }
  }
  addPatch(mesh, patch);
}

}  // namespace

glm::vec3 onBody(float x, float side, float share) {
  std::size_t segment = 0;
  while (segment < 4 && share > kShares[segment + 1]) ++segment;
  const float t = (share - kShares[segment]) / (kShares[segment + 1] - kShares[segment]);
  return alongSection(sectionAt(x), segment, t) * glm::vec3(1.0F, 1.0F, side);
}

void addBody(SceneBuilder& builder, const Palette& palette) {
  const std::vector<float> xs = stations();
  const std::vector<Column> half = columns();
  const auto halfCount = static_cast<int>(half.size());
  const auto rows = static_cast<int>(xs.size());
  // From the left sill over the ridge, which both halves share, to the right sill.
  Patch skin(rows, 2 * halfCount - 1);
  Patch lips[2] = {Patch(rows, 2), Patch(rows, 2)};
  for (int i = 0; i < rows; ++i) {
    const float x = xs[static_cast<std::size_t>(i)];
    const auto section = sectionAt(x);
    const float u = (x - kTail) / (kNose - kTail);
    for (int k = 0; k < halfCount; ++k) {
      const Column& column = half[static_cast<std::size_t>(k)];
      const glm::vec3 p = alongSection(section, column.segment, column.t);
      const glm::vec3 mirrored{p.x, p.y, -p.z};
      skin.at(i, k) = {mirrored, {u, 0.5F * column.share}};
      skin.at(i, 2 * halfCount - 2 - k) = {p, {u, 1.0F - 0.5F * column.share}};
    }
    // The lower edge is turned in, so that the body has thickness around the wheels.
    const glm::vec3 rim = section[0];
    const glm::vec3 inner{rim.x, rim.y + 0.005F, rim.z - 0.10F};
    constexpr glm::vec3 kMirror{1.0F, 1.0F, -1.0F};
    lips[0].at(i, 0) = {inner * kMirror, {u, 0.0F}};
    lips[0].at(i, 1) = {rim * kMirror, {u, 0.0F}};
    lips[1].at(i, 0) = {rim, {u, 1.0F}};
    lips[1].at(i, 1) = {inner, {u, 1.0F}};
  }
  const auto skinAt = [&](int row, int column) {
    const int fromSill = column < halfCount - 1 ? column : 2 * halfCount - 3 - column;
    const Column& c = half[static_cast<std::size_t>(fromSill)];
    const auto i = static_cast<std::size_t>(row);
    return skinOf(0.5F * (xs[i] + xs[i + 1]), c.segment, c.step);
  };
  Primitive paint;
  addPatch(paint, skin, [&](int i, int j) { return skinAt(i, j) == Skin::Paint; });
  addEnd(paint, kNose, 1.0F, half);
  addEnd(paint, kTail, -1.0F, half);
  Primitive glass;
  addPatch(glass, skin, [&](int i, int j) { return skinAt(i, j) == Skin::Glass; });
  Primitive under;
  addPatch(under, lips[0]);
  addPatch(under, lips[1]);
  addBox(under, {-1.95F, 0.20F, -0.58F}, {1.95F, 0.62F, 0.58F});
  builder.addOnce(std::move(paint), palette.paint);
  builder.addOnce(std::move(glass), palette.glass);
  builder.addOnce(std::move(under), palette.dark);
}

}  // namespace macula::scene::car
