// Small scenes on which resizing fails where it is done badly, and measures of that.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "engine/scene/scene.h"
#include "gl_fixture.h"

namespace macula::test {

/// A lit floor to the horizon, a ball in front of a wall, all with hard edges to each other.
[[nodiscard]] scene::Scene still();
/// The same behind a fence of wires, each about half a pixel wide at 128 x 128.
[[nodiscard]] scene::Scene wires();
/// A floor that is seen at three degrees, with stripes of shadow on it.
[[nodiscard]] scene::Scene grazing();

/// A card in the sun before a wall in the shade of a roof that is out of view: the light on each is
/// even, and ends at the card's silhouette.
[[nodiscard]] scene::Scene litCard();

/// Five swatches side by side in one plane, of a fine random texture of three greys: unlit; a black
/// surface that emits it; a dielectric; a metal; metal and dielectric in turn.
[[nodiscard]] scene::Scene swatches();

/// still() with veins, occlusion and a wide shadow filter.
[[nodiscard]] scene::Scene richStill();

/// Settings for linear output at a resize factor.
[[nodiscard]] passes::RenderSettings resized(double r, const std::string& what = "shading");

/// Opaque radiance before the tone curve, RGBA, rows from the bottom.
[[nodiscard]] std::vector<float> radiance(const Bench& bench);

/// Root mean square of the differences of the first three channels of four.
[[nodiscard]] double rootMeanSquare(const std::vector<float>& a, const std::vector<float>& b);

}  // namespace macula::test
