// The procedural scenes, one function each. Equal seeds give equal scenes.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "engine/scene/scene.h"

namespace macula::scene {

/// The largest N of `layers-N`.
inline constexpr int kMaxLayers = 4096;

/// N unlit quads that fill the view, for checking compositing exactly. Layer i (1 = nearest) has
/// alpha 1 / (N - i + 1), so that each weighs 1 / N in the result, and the colour
/// layerColor(i, N). The quads stand in one primitive, in an order shuffled by the seed, parallel
/// to the image plane, from 1 to 10 metres in equal steps, and fill frames from 1:4 to 4:1.
/// Its camera named "still" keeps `--camera auto` in front of them.
/// @param n 1 .. kMaxLayers
[[nodiscard]] Scene makeLayers(int n, std::uint64_t seed);

/// Linear RGB of layer i (1 .. n) of makeLayers:
/// (37 i mod 101) / 100, (53 i mod 103) / 102, (71 i mod 107) / 106.
[[nodiscard]] glm::vec3 layerColor(int i, int n);

/// Alpha of layer i (1 .. n): 1 / (n - i + 1).
[[nodiscard]] float layerAlpha(int i, int n);

/// The exact image of makeLayers(n, any seed) over any background: the mean of all layer colours,
/// because sum over i of a_i c_i prod_{j<i} (1 - a_j) has the weights 1 / n and the last layer is
/// opaque. Linear RGB.
[[nodiscard]] glm::vec3 layersComposite(int n);

/// The largest N of `medley-N`.
inline constexpr int kMaxMedley = 9999;

/// A still life of transparent things, another one for each n: two to five groups out of puffs,
/// glass, strands, leaves, sheets, shells and confetti, between opaque things, with colours,
/// alphas, lights and depth drawn at random. For training, so that
/// the scenes below stay unseen. At most 60,000 triangles; between about 6 and 150 surfaces
/// behind one another from its camera.
/// @param n 0 .. kMaxMedley; the only seed
[[nodiscard]] Scene makeMedley(int n);

/// A plume of unlit smoke over a brazier on an opaque floor. From its camera at 1024 x 1024 at most
/// 16 puffs lie behind one another.
[[nodiscard]] Scene makeSmoke(std::uint64_t seed);

/// 64 unlit, untextured, double-sided spheres of alpha 0.3 in a cube: what peers draw, for
/// comparing the price of a fragment with theirs. 4.7 million fragments from its camera at 1024 x
/// 1024.
[[nodiscard]] Scene makeSpheres(std::uint64_t seed);

/// Rows of lit glass bottles on a table under a sun that casts shadows, two lamps and a spot. From
/// its camera at 1024 x 1024 at most 22 glass surfaces lie behind one another.
[[nodiscard]] Scene makeBottles(std::uint64_t seed);

/// A comic head whose lit hair and beard are thin semi-transparent strands. From its camera at
/// 1024 x 1024 at most 92 strands lie behind one another.
[[nodiscard]] Scene makeHair(std::uint64_t seed);

/// A greenhouse: panes, benches in tiers, pots and plants whose leaves let light through, all lit.
/// From its camera at 1024 x 1024 at most 106 transparent surfaces lie behind one another.
[[nodiscard]] Scene makeGreenhouse(std::uint64_t seed);

/// A ball of thin lit strands, semi-transparent, wound loosely around its centre. From its camera
/// at 1024 x 1024 at most 180 strands lie behind one another.
[[nodiscard]] Scene makeHairball(std::uint64_t seed);

/// A furnished hall of several hundred thousand triangles to walk in, with glass, smoke and
/// plants: the default scene.
[[nodiscard]] Scene makeGallery(std::uint64_t seed);

/// A car with a camouflage livery in a paved yard, under a sun whose shadow filter has 9 x 9 taps:
/// for the Car of Yang 2008, section 4. Opaque, at most 40,000 triangles, like the next two.
[[nodiscard]] Scene makeCar(std::uint64_t seed);

/// A dragon of veined, polished stone on a veined plinth: for the Dragon of Yang 2008, section 4,
/// whose surface is procedural noise under a specular layer.
[[nodiscard]] Scene makeMarble(std::uint64_t seed);

/// A game of chess on a wooden board, darkened by ambient occlusion of 96 samples: for the Chess of
/// Yang 2008, section 4.
[[nodiscard]] Scene makeChess(std::uint64_t seed);

}  // namespace macula::scene
