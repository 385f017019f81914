// Parts of a medley: colours, alphas, a stage, and the groups that stand on it.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string>

#include "engine/core/random.h"
#include "engine/scene/procedural/depth_counter.h"
#include "engine/scene/procedural/scene_builder.h"

namespace macula::scene::medley {

inline constexpr int kMostTriangles = 60'000;  ///< of a medley, opaque ones too

/// Colours that stand side by side: all saturated, all of one hue, greys, near-whites, near-blacks,
/// or two that differ so much that their order is seen at once.
class Palette {
 public:
  explicit Palette(Random& random);
  /// Linear RGB, 0..1.
  [[nodiscard]] glm::vec3 color(Random& random) const;

 private:
  std::uint32_t kind_;
  float hue_;  ///< turns
};

/// Alphas of a group: all equal, spread over a range, or mostly low with some high ones.
class Alphas {
 public:
  /// @param low,high 0..1
  Alphas(float low, float high, Random& random);
  [[nodiscard]] float pick(Random& random) const;

 private:
  float low_, high_, only_;
  std::uint32_t kind_;
};

/// A unit vector, evenly spread.
[[nodiscard]] glm::vec3 direction(Random& random);
/// A unit vector at right angles to `v` (unit length), evenly spread.
[[nodiscard]] glm::vec3 perpendicular(const glm::vec3& v, Random& random);

/// A scene that grows piece by piece within limits of depth and triangles.
class Stage {
 public:
  /// @param depthLimit layers that may lie behind one another, seen through the camera
  Stage(std::string name, const Camera& camera, float tanHalfFov, int depthLimit);

  [[nodiscard]] SceneBuilder& builder() { return builder_; }
  [[nodiscard]] const Camera& camera() const { return camera_; }

  /// Adds an opaque thing; surfaces behind it do not count as depth.
  void addOpaque(Primitive mesh, std::int32_t material);

  /// The share of the remaining triangles for the next of `groups` groups.
  void share(std::size_t groups);
  /// The number of pieces of this size for which the group has triangles left.
  [[nodiscard]] int room(std::size_t trianglesEach) const;
  /// Appends a transparent piece if triangles and depth allow. @return whether they did
  bool add(Primitive& group, const Primitive& piece);
  /// Share of the camera's square frame with something transparent, 0..1.
  [[nodiscard]] float coverage() const { return counter_.coverage(); }

 private:
  SceneBuilder builder_;
  Camera camera_;
  DepthCounter counter_;
  int depthLimit_;
  int left_ = kMostTriangles;  ///< triangles of the medley
  int ofGroup_ = 0;            ///< triangles of the present group
};

/// The parameters of one group.
struct Group {
  Stage& stage;
  Random random;
  Palette palette;
  glm::vec3 foot{0.0F};    ///< the middle of where it stands, metres
  float size = 1.0F;       ///< half its width, metres
  float layers = 10.0F;    ///< aimed at, behind one another in its middle
  float looseness = 0.0F;  ///< 0: as dense at the rim as in the middle; 1: thinning out towards it
  bool lit = true;

  /// A place in the unit ball, as loose as the group is.
  [[nodiscard]] glm::vec3 scatter();
  /// Alphas from a range. Deep groups mostly keep to its lower part, so that what lies far behind
  /// is still seen.
  [[nodiscard]] Alphas alphas(float low, float high);
  /// Its material: vertices give colour and alpha.
  [[nodiscard]] Material material(const char* name);
  /// Pieces of a projected area (metres squared) that give `layers` over the area `over`.
  [[nodiscard]] int pieces(float area, float over, std::size_t trianglesEach) const;
  /// Puts its pieces into the scene.
  void finish(Primitive mesh, const Material& material) const;
};

// Floor, walls and opaque things.
void addRoom(Stage& stage, Random& random, bool lit);

// The groups. Each takes what it needs at random from its Group.
void addPuffs(Group& group);     ///< soft, faint, unlit: clouds, plumes, fog
void addGlass(Group& group);     ///< vessels, boxes and balls in rows
void addStrands(Group& group);   ///< tufts, tassels, balls and streams of ribbons
void addLeaves(Group& group);    ///< cut-outs on small quads
void addSheets(Group& group);    ///< large panes, parallel, crossing or fanned out
void addShells(Group& group);    ///< spheres in spheres
void addConfetti(Group& group);  ///< triangles of any alpha

}  // namespace macula::scene::medley
