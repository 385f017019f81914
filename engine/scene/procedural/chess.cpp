#include <array>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/core/random.h"
#include "engine/scene/procedural/chess_parts.h"
#include "engine/scene/procedural/mesh_builder.h"
#include "engine/scene/procedural/pixels.h"
#include "engine/scene/procedural/recipes.h"
#include "engine/scene/procedural/textures.h"

namespace macula::scene {
namespace chess {
namespace {

constexpr float kHalfSquares = 4.0F * kSquare;
constexpr float kHalfBoard = kHalfSquares + kBorder;
constexpr float kThickness = 0.028F;  // of the board, metres
constexpr float kTable = 1.25F;       // half the side of the table, metres

// Anderssen against Kieseritzky, London 1851, after Black's twentieth move; rows from the eighth
// rank to the first, capitals for White.
constexpr std::array<std::string_view, 8> kPosition{"r.b.k.nr", "p..p.ppp", "n..B....", ".p.NPN.P",
                                                    "......P.", "...P.Q..", "P.P.K...", "q.....b."};
// Pieces that stand beside the board: taken by either side.
constexpr std::string_view kTakenFromBlack = "pp";
constexpr std::string_view kTakenFromWhite = "PPBRR";

Kind kindOf(char letter) {
  switch (letter | 0x20) {  // in small letters
    case 'p':
      return Kind::Pawn;
    case 'r':
      return Kind::Rook;
    case 'n':
      return Kind::Knight;
    case 'b':
      return Kind::Bishop;
    case 'q':
      return Kind::Queen;
    default:
      return Kind::King;
  }
}

class Pieces {
 public:
  Pieces(SceneBuilder& builder, std::uint64_t seed) : builder_(builder), random_(seed, 61) {
    Material ivory = plainMaterial("ivory", {0.68F, 0.58F, 0.41F, 1.0F}, 0.32F);
    Material ebony = plainMaterial("ebony", {0.085F, 0.038F, 0.022F, 1.0F}, 0.28F);
    const std::array<std::int32_t, 2> materials{builder.material(ivory), builder.material(ebony)};
    for (std::size_t side = 0; side < 2; ++side) {
      for (std::size_t kind = 0; kind < kKinds; ++kind) {
        Primitive mesh;
        addPiece(mesh, static_cast<Kind>(kind), seed);
        shapes_[side][kind] = builder.shape(std::move(mesh), materials[side]);
      }
    }
  }

  /// @param letter capital for White; at in metres, moved by up to `slack`, which no hand avoids
  void put(char letter, const glm::vec3& at, float slack) {
    const bool white = letter < 'a';
    const glm::vec3 aside{random_.range(-slack, slack), 0.0F, random_.range(-slack, slack)};
    const float turns = (white ? 0.0F : 0.5F) + random_.range(-0.04F, 0.04F);
    const auto kind = static_cast<std::size_t>(kindOf(letter));
    builder_.add(shapes_[white ? 0 : 1][kind], place(at + aside, turns));
  }

 private:
  SceneBuilder& builder_;
  Random random_;
  std::array<std::array<std::uint32_t, kKinds>, 2> shapes_{};
};

void addBoard(SceneBuilder& builder, std::uint64_t seed) {
  constexpr int kBoardImage = 1024;
  Material wood = plainMaterial("board", glm::vec4(1.0F), 0.34F);
  wood.baseColorTexture.image = builder.image(boardImage(kBoardImage, seed));
  Primitive top;
  const float h = kHalfBoard;
  addQuad(top, {-h, 0.0F, h}, {h, 0.0F, h}, {h, 0.0F, -h}, {-h, 0.0F, -h});
  builder.addOnce(std::move(top), builder.material(wood));
  // The frame stands a little over the squares, so that their rim is seen.
  const std::int32_t frame =
      builder.material(plainMaterial("frame", {0.14F, 0.060F, 0.030F, 1.0F}, 0.36F));
  Primitive edge;
  addBevelledBox(edge, {-h - 0.012F, -kThickness, -h - 0.012F}, {h + 0.012F, -0.0005F, h + 0.012F},
                 0.004F);
  for (int i = 0; i < 4; ++i) {
    Primitive bar;
    addBevelledBox(bar, {-h - 0.012F, -0.004F, h}, {h + 0.012F, 0.004F, h + 0.012F}, 0.002F);
    append(edge, bar, place({0, 0, 0}, 0.25F * static_cast<float>(i)));
  }
  for (const float x : {-1.0F, 1.0F}) {
    for (const float z : {-1.0F, 1.0F}) {
      addSphere(edge, {x * 0.8F * h, -kThickness - 0.002F, z * 0.8F * h}, 0.012F, 12);
    }
  }
  builder.addOnce(std::move(edge), frame);
}

/// A table of boards, a pile of books and a clock at the side.
void addTable(SceneBuilder& builder, std::uint64_t seed) {
  constexpr float kTop = -kThickness - 0.008F;
  Material wood = plainMaterial("table", glm::vec4(1.0F), 0.5F);
  wood.baseColorTexture.image = builder.image(woodBoards(512, seed));
  Primitive table;
  addQuad(table, {-kTable, kTop, kTable}, {kTable, kTop, kTable}, {kTable, kTop, -kTable},
          {-kTable, kTop, -kTable}, glm::vec2(0.0F), glm::vec2(3.0F));
  builder.addOnce(std::move(table), builder.material(wood));

  const std::int32_t paper =
      builder.material(plainMaterial("paper", {0.74F, 0.68F, 0.55F, 1.0F}, 0.9F));
  struct Book {
    glm::vec3 at, size;
    float turns;
    glm::vec3 color;
  };
  const std::array books{
      Book{{-0.44F, kTop, -0.27F}, {0.15F, 0.030F, 0.21F}, 0.03F, {0.30F, 0.05F, 0.04F}},
      Book{{-0.435F, kTop + 0.032F, -0.265F},
           {0.135F, 0.024F, 0.19F},
           -0.02F,
           {0.05F, 0.12F, 0.20F}},
      Book{
          {-0.445F, kTop + 0.058F, -0.275F}, {0.12F, 0.020F, 0.17F}, 0.06F, {0.08F, 0.17F, 0.08F}}};
  for (const Book& book : books) {
    const glm::vec3 half = 0.5F * book.size;
    constexpr float kCover = 0.003F;
    Primitive cover;
    addBevelledBox(cover, {-half.x, 0.0F, -half.z}, {half.x, kCover, half.z}, 0.001F);
    addBevelledBox(cover, {-half.x, book.size.y - kCover, -half.z}, {half.x, book.size.y, half.z},
                   0.001F);
    addBevelledBox(cover, {-half.x, 0.0F, -half.z}, {-half.x + kCover, book.size.y, half.z},
                   0.001F);
    Primitive pages;
    addBox(pages, {-half.x + kCover, kCover, -half.z + 0.004F},
           {half.x - 0.004F, book.size.y - kCover, half.z - 0.004F});
    const glm::mat4 at = place(book.at, book.turns);
    builder.addOnce(std::move(cover),
                    builder.material(plainMaterial("cover", glm::vec4(book.color, 1.0F), 0.6F)),
                    at);
    builder.addOnce(std::move(pages), paper, at);
  }

  // A clock with two dials.
  const std::int32_t box =
      builder.material(plainMaterial("clock", {0.20F, 0.09F, 0.045F, 1.0F}, 0.4F));
  const std::int32_t brass =
      builder.material(plainMaterial("brass", {0.70F, 0.48F, 0.18F, 1.0F}, 0.32F, 0.5F));
  const std::int32_t dark =
      builder.material(plainMaterial("hands", {0.02F, 0.02F, 0.025F, 1.0F}, 0.5F));
  const glm::mat4 clock = place({0.405F, kTop, 0.02F}, -0.25F);
  Primitive body;
  addBevelledBox(body, {-0.10F, 0.0F, -0.03F}, {0.10F, 0.10F, 0.03F}, 0.006F);
  Primitive rims;
  Primitive dials;
  Primitive hands;
  for (const float x : {-0.048F, 0.048F}) {
    // Lathes laid down to face +z.
    const glm::mat4 facing{{1, 0, 0, 0}, {0, 0, 1, 0}, {0, -1, 0, 0}, {x, 0.052F, 0.03F, 1}};
    Primitive rim;
    addLathe(rim,
             std::vector<glm::vec2>{
                 {0.042F, 0.0F}, {0.042F, 0.006F}, {0.038F, 0.008F}, {0.036F, 0.003F}},
             32);
    append(rims, rim, facing);
    Primitive dial;
    addLathe(dial, std::vector<glm::vec2>{{0.037F, 0.002F}, {0.0F, 0.002F}}, 32);
    append(dials, dial, facing);
    for (int hour = 0; hour < 12; ++hour) {
      Primitive mark;
      addBox(mark, {0.026F, 0.002F, -0.0012F}, {0.033F, 0.003F, 0.0012F});
      append(hands, mark, facing * place({0, 0, 0}, static_cast<float>(hour) / 12.0F));
    }
    for (const float length : {0.018F, 0.028F}) {
      Primitive hand;
      addBox(hand, {-0.004F, 0.004F, -0.0012F}, {length, 0.005F, 0.0012F});
      append(hands, hand, facing * place({0, 0, 0}, x + 20.0F * length));
    }
    Primitive button;
    addLathe(button,
             std::vector<glm::vec2>{{0.006F, 0.098F},
                                    {0.006F, x < 0.0F ? 0.115F : 0.106F},
                                    {0.009F, x < 0.0F ? 0.116F : 0.107F},
                                    {0.0F, x < 0.0F ? 0.120F : 0.111F}},
             16);
    append(rims, button, place({x, 0.0F, 0.0F}));
  }
  builder.addOnce(std::move(body), box, clock);
  builder.addOnce(std::move(rims), brass, clock);
  builder.addOnce(std::move(dials), paper, clock);
  builder.addOnce(std::move(hands), dark, clock);
}

}  // namespace

Image boardImage(int size, std::uint64_t seed) {
  const std::uint32_t key = foldSeed(seed) + 1009;
  return drawImage("board", size, size, [key](float u, float v) {
    const float x = (2.0F * u - 1.0F) * kHalfBoard / kSquare + 4.0F;  // 0..8 over the squares
    const float y = (2.0F * v - 1.0F) * kHalfBoard / kSquare + 4.0F;
    const bool inside = x >= 0.0F && x < 8.0F && y >= 0.0F && y < 8.0F;
    const auto column = static_cast<std::uint32_t>(std::max(x, 0.0F));
    const auto row = static_cast<std::uint32_t>(std::max(y, 0.0F));
    const bool dark = inside && (column + row) % 2 == 1;
    // Each square is cut from another place of the plank; the grain of dark ones runs across.
    const float offset = inside ? latticeValue(column, row, key) : 0.5F;
    const bool upright = inside ? dark : std::abs(x - 4.0F) > std::abs(y - 4.0F);
    const float along = upright ? v : u;
    const float across = upright ? u : v;
    const float bend = 0.05F * noise(along, offset, 6, key + 3);
    const float rings = triangleWave((across + bend + offset) * 46.0F);
    const float fibre = noise(across, along * 0.25F, 512, key + 7);
    const float grain = 0.55F * rings + 0.45F * fibre;
    const auto tone = [grain](const glm::vec3& low, const glm::vec3& high) {
      return glm::mix(low, high, grain);
    };
    if (!inside) {
      // A line of light wood in the border.
      const float out = std::max(std::abs(x - 4.0F), std::abs(y - 4.0F)) - 4.0F;
      const bool inlay = (out > 0.10F && out < 0.16F) || (out > 0.22F && out < 0.25F);
      return glm::vec4(inlay ? tone({0.74F, 0.56F, 0.34F}, {0.84F, 0.67F, 0.44F})
                             : tone({0.30F, 0.16F, 0.10F}, {0.42F, 0.24F, 0.15F}),
                       1.0F);
    }
    const float seam = std::min(triangleWave(x), triangleWave(y));
    const glm::vec3 color = dark ? tone({0.27F, 0.14F, 0.085F}, {0.44F, 0.26F, 0.16F})
                                 : tone({0.74F, 0.58F, 0.38F}, {0.88F, 0.75F, 0.54F});
    return glm::vec4(color * (seam < 0.02F ? 0.6F : 1.0F) * (0.92F + 0.16F * (offset - 0.5F)),
                     1.0F);
  });
}

}  // namespace chess

Scene makeChess(std::uint64_t seed) {
  using chess::kSquare;
  SceneBuilder builder("chess");
  chess::addBoard(builder, seed);
  chess::addTable(builder, seed);
  chess::Pieces pieces(builder, seed);
  for (std::size_t rank = 0; rank < 8; ++rank) {
    for (std::size_t file = 0; file < 8; ++file) {
      const char letter = chess::kPosition[rank][file];
      if (letter == '.') continue;
      const glm::vec3 at{(static_cast<float>(file) - 3.5F) * kSquare, 0.0F,
                         (static_cast<float>(rank) - 3.5F) * kSquare};
      pieces.put(letter, at, 0.004F);
    }
  }
  constexpr float kAside = 0.33F;
  constexpr float kTop = -chess::kThickness - 0.008F;
  for (std::size_t i = 0; i < chess::kTakenFromBlack.size(); ++i) {
    pieces.put(chess::kTakenFromBlack[i], {kAside, kTop, 0.16F + 0.045F * static_cast<float>(i)},
               0.012F);
  }
  for (std::size_t i = 0; i < chess::kTakenFromWhite.size(); ++i) {
    pieces.put(chess::kTakenFromWhite[i], {-kAside, kTop, -0.06F + 0.05F * static_cast<float>(i)},
               0.012F);
  }

  builder.light(sun({-0.55F, -0.72F, -0.42F}, {1.0F, 0.92F, 0.80F}, 1.5F));
  builder.light(pointLight({0.35F, 0.55F, 0.55F}, {1.0F, 0.78F, 0.52F}, 0.12F, 2.5F));
  // Most of the light comes from all around, so that the occlusion is seen.
  builder.ambient({0.62F, 0.64F, 0.68F});
  builder.occlusion({0.04F, 96});

  Camera camera;
  camera.name = "scene";
  camera.position = {0.30F, 0.34F, 0.50F};
  camera.target = {0.0F, -0.01F, 0.02F};
  camera.verticalFov = 0.66F;  // 38 degrees: the board fills a square frame
  camera.nearPlane = 0.02F;
  camera.farPlane = 6.0F;
  builder.camera(camera);
  camera.name = "orbit";
  builder.camera(camera);
  return std::move(builder).finish();
}

}  // namespace macula::scene
