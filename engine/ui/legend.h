// What the colours of a heat map mean.
#pragma once

#include <string>

namespace macula::ui {

/// A heat map as its legend shows it.
struct Legend {
  std::string quantity;    ///< "k(p), layers stored per sample"
  double maximum = 1.0;    ///< value of the hottest colour, > 0; larger ones share it
  bool mayExceed = false;  ///< whether larger values can occur
  std::string grey = "zero, or nothing transparent";  ///< what grey means
};

/// A bar of the heat maps' colours over the width of the panel, from 0 to the maximum, with the
/// quantity above it and numbers below.
void drawLegend(const Legend& legend);

}  // namespace macula::ui
