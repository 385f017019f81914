// Staunton pieces: lathes with carved tops.
#include <algorithm>
#include <array>
#include <initializer_list>
#include <vector>

#include "engine/core/random.h"
#include "engine/scene/procedural/chess_parts.h"
#include "engine/scene/procedural/circle.h"
#include "engine/scene/procedural/mesh_builder.h"
#include "engine/scene/procedural/patch.h"

namespace macula::scene::chess {
namespace {

constexpr int kSegments = 24;

using Profile = std::vector<glm::vec2>;  // (radius, y), metres

/// The foot that all pieces share, scaled to a radius; ends at the beginning of the stem.
Profile foot(float radius) {
  Profile profile{{0.0F, 0.0F}};
  for (const glm::vec2& p : {glm::vec2{0.98F, 0.0F},
                             {1.0F, 0.04F},
                             {1.0F, 0.19F},
                             {0.90F, 0.25F},
                             {0.92F, 0.34F},
                             {0.84F, 0.44F},
                             {0.62F, 0.56F}}) {
    profile.push_back(radius * p);
  }
  return profile;
}

void lathe(Primitive& mesh, Profile profile, std::initializer_list<glm::vec2> rest) {
  profile.insert(profile.end(), rest);
  addLathe(mesh, profile, kSegments);
}

void addPawn(Primitive& mesh) {
  lathe(mesh, foot(0.0155F),
        {{0.0068F, 0.0145F},
         {0.0050F, 0.0240F},
         {0.0048F, 0.0275F},
         {0.0092F, 0.0288F},
         {0.0092F, 0.0302F},
         {0.0055F, 0.0312F},
         {0.0072F, 0.0330F},
         {0.0088F, 0.0368F},
         {0.0086F, 0.0402F},
         {0.0064F, 0.0434F},
         {0.0030F, 0.0450F},
         {0.0F, 0.0454F}});
}

void addRook(Primitive& mesh) {
  lathe(mesh, foot(0.0180F),
        {{0.0100F, 0.0170F},
         {0.0084F, 0.0300F},
         {0.0082F, 0.0360F},
         {0.0118F, 0.0375F},
         {0.0118F, 0.0390F},
         {0.0104F, 0.0400F},
         {0.0112F, 0.0440F},
         {0.0112F, 0.0455F},
         {0.0078F, 0.0455F},
         {0.0078F, 0.0430F},
         {0.0F, 0.0430F}});
  constexpr int kMerlons = 6;
  for (int i = 0; i < kMerlons; ++i) {
    Primitive merlon;
    addBevelledBox(merlon, {0.0074F, 0.0445F, -0.0036F}, {0.0112F, 0.0505F, 0.0036F}, 0.0006F);
    append(mesh, merlon, place({0, 0, 0}, static_cast<float>(i) / kMerlons));
  }
}

void addBishop(Primitive& mesh) {
  lathe(mesh, foot(0.0175F),
        {{0.0076F, 0.0165F},
         {0.0054F, 0.0300F},
         {0.0052F, 0.0370F},
         {0.0102F, 0.0385F},
         {0.0102F, 0.0400F},
         {0.0060F, 0.0412F},
         {0.0082F, 0.0425F},
         {0.0060F, 0.0440F},
         {0.0082F, 0.0480F},
         {0.0086F, 0.0520F},
         {0.0070F, 0.0570F},
         {0.0036F, 0.0620F},
         {0.0022F, 0.0636F},
         {0.0032F, 0.0652F},
         {0.0030F, 0.0676F},
         {0.0F, 0.0690F}});
}

void addQueen(Primitive& mesh) {
  lathe(mesh, foot(0.0190F),
        {{0.0086F, 0.0180F},
         {0.0062F, 0.0340F},
         {0.0060F, 0.0480F},
         {0.0112F, 0.0496F},
         {0.0112F, 0.0512F},
         {0.0072F, 0.0526F},
         {0.0094F, 0.0540F},
         {0.0068F, 0.0556F},
         {0.0074F, 0.0620F},
         {0.0108F, 0.0700F},
         {0.0110F, 0.0712F},
         {0.0086F, 0.0706F},
         {0.0070F, 0.0740F},
         {0.0036F, 0.0760F},
         {0.0F, 0.0764F}});
  addSphere(mesh, {0.0F, 0.0785F, 0.0F}, 0.0032F, 10);
  constexpr int kPoints = 9;
  for (int i = 0; i < kPoints; ++i) {
    const glm::vec2 c = 0.0100F * onCircle(static_cast<double>(i) / kPoints);
    addSphere(mesh, {c.x, 0.0716F, c.y}, 0.0019F, 6);
  }
}

void addKing(Primitive& mesh) {
  lathe(mesh, foot(0.0195F),
        {{0.0090F, 0.0185F},
         {0.0066F, 0.0360F},
         {0.0064F, 0.0530F},
         {0.0118F, 0.0548F},
         {0.0118F, 0.0566F},
         {0.0076F, 0.0582F},
         {0.0098F, 0.0596F},
         {0.0072F, 0.0612F},
         {0.0080F, 0.0680F},
         {0.0106F, 0.0770F},
         {0.0098F, 0.0786F},
         {0.0070F, 0.0800F},
         {0.0030F, 0.0822F},
         {0.0F, 0.0826F}});
  addBevelledBox(mesh, {-0.0018F, 0.0815F, -0.0016F}, {0.0018F, 0.0950F, 0.0016F}, 0.0005F);
  addBevelledBox(mesh, {-0.0052F, 0.0872F, -0.0016F}, {0.0052F, 0.0906F, 0.0016F}, 0.0005F);
}

/// A section of the horse's neck and head: its middle in the upright plane, half the width and
/// half the depth, and the way it leans.
struct Section {
  glm::vec3 at;  ///< millimetres
  float wide, deep;
  glm::vec3 across;  ///< towards the mane, at right angles to the neck
};

void addKnight(Primitive& mesh, std::uint64_t seed) {
  lathe(mesh, foot(0.0180F),
        {{0.0118F, 0.0128F}, {0.0128F, 0.0150F}, {0.0118F, 0.0172F}, {0.0F, 0.0176F}});
  const std::array<Section, 10> sections{Section{{0, 15.5F, 1.5F}, 8.6F, 9.6F, {0, 0, 1}},
                                         Section{{0, 22.0F, 2.6F}, 8.2F, 9.4F, {0, 0.05F, 1}},
                                         Section{{0, 29.0F, 3.6F}, 7.2F, 8.8F, {0, 0.15F, 1}},
                                         Section{{0, 36.0F, 3.2F}, 6.2F, 8.4F, {0, 0.35F, 1}},
                                         Section{{0, 42.5F, 1.0F}, 5.8F, 8.4F, {0, 0.8F, 1}},
                                         Section{{0, 45.0F, -3.5F}, 5.9F, 8.0F, {0, 1, 0.45F}},
                                         Section{{0, 42.8F, -8.5F}, 5.2F, 6.6F, {0, 1, -0.05F}},
                                         Section{{0, 38.6F, -13.0F}, 4.2F, 5.0F, {0, 1, -0.35F}},
                                         Section{{0, 35.2F, -16.5F}, 4.0F, 4.4F, {0, 1, -0.5F}},
                                         Section{{0, 33.6F, -18.4F}, 2.4F, 2.6F, {0, 1, -0.5F}}};
  constexpr float kMillimetre = 0.001F;
  constexpr int kAround = 20;
  constexpr int kBetween = 3;
  const int spans = static_cast<int>(sections.size()) - 1;
  // One more row closes the muzzle.
  Patch patch(spans * kBetween + 2, kAround + 1);
  for (int i = 0; i < patch.rows(); ++i) {
    const auto k = static_cast<std::size_t>(std::min(i / kBetween, spans - 1));
    const float t =
        std::min(static_cast<float>(i - static_cast<int>(k) * kBetween) / kBetween, 1.0F);
    const Section& a = sections[k];
    const Section& b = sections[k + 1];
    const glm::vec3 at = glm::mix(a.at, b.at, t);
    const glm::vec3 across = glm::normalize(glm::mix(a.across, b.across, t));
    const float closing = i + 1 == patch.rows() ? 0.0F : 1.0F;
    for (int j = 0; j <= kAround; ++j) {
      const glm::vec2 c = onCircle(static_cast<double>(j) / kAround);
      // Narrower towards the mane than towards the throat.
      const float wide = glm::mix(a.wide, b.wide, t) * (1.0F - 0.35F * std::max(c.x, 0.0F));
      const glm::vec3 p = at + closing * (across * (c.x * glm::mix(a.deep, b.deep, t)) +
                                          glm::vec3(c.y * wide, 0, 0));
      patch.at(i, j).position = p * kMillimetre;
    }
  }
  addPatch(mesh, patch);

  Random random(seed, 53);
  const auto millimetres = [](float x, float y, float z) {
    return kMillimetre * glm::vec3(x, y, z);
  };
  for (int i = 0; i < 8; ++i) {  // the mane
    const float t = static_cast<float>(i) / 7.0F;
    const glm::vec3 root =
        millimetres(0.0F, glm::mix(20.0F, 48.0F, t), glm::mix(11.4F, 7.4F, t * t));
    const float size = random.range(0.0024F, 0.0032F);
    addSphere(mesh, root, size, 8);
  }
  for (const float side : {-1.0F, 1.0F}) {
    addTube(mesh,
            std::vector<glm::vec3>{millimetres(side * 3.2F, 47.0F, -0.5F),
                                   millimetres(side * 3.8F, 53.0F, 0.0F),
                                   millimetres(side * 3.2F, 57.5F, -1.2F)},
            std::vector<float>{0.0024F, 0.0020F, 0.0003F}, 8, false);
    addSphere(mesh, millimetres(side * 4.8F, 45.0F, -7.5F), 0.0015F, 8);
    addSphere(mesh, millimetres(side * 3.0F, 36.4F, -17.2F), 0.0011F, 6);
  }
}

}  // namespace

void addPiece(Primitive& mesh, Kind kind, std::uint64_t seed) {
  switch (kind) {
    case Kind::Pawn:
      return addPawn(mesh);
    case Kind::Rook:
      return addRook(mesh);
    case Kind::Knight:
      return addKnight(mesh, seed);
    case Kind::Bishop:
      return addBishop(mesh);
    case Kind::Queen:
      return addQueen(mesh);
    case Kind::King:
      return addKing(mesh);
  }
}

}  // namespace macula::scene::chess
