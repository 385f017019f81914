// What the colours of a heat map mean.
#pragma once

#include "engine/image/legend.h"

namespace macula::ui {

using image::Legend;

/// A bar of the heat maps' colours over the width of the panel, from 0 to the maximum, with the
/// quantity above it and numbers below.
void drawLegend(const Legend& legend);

}  // namespace macula::ui
