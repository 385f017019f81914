// The legend of a picture in false colours, as pixels.
#pragma once

#include <string>

#include "engine/image/image.h"

namespace macula::image {

/// The meaning of the colours of a heat map (viridis).
struct Legend {
  std::string quantity;    ///< "k(p): slots of each sample"
  double maximum = 1.0;    ///< value of the hottest colour, > 0; larger ones share it
  bool mayExceed = false;  ///< whether larger values can occur
  std::string grey = "zero, or nothing transparent";  ///< what grey means; empty: none is shown

  bool operator==(const Legend&) const = default;
};

/// The numbers under a legend's bar: at its beginning, its middle and its end.
struct LegendLabels {
  std::string low, middle, high;
};
[[nodiscard]] LegendLabels labelsOf(const Legend& legend);

/// A bar of colours with its quantity above and numbers below, 3 channels, in a size that suits a
/// picture. Small pictures have less: first no word on grey, then no quantity, then no legend (an
/// image without pixels).
/// @param width, height of the picture that it is for
[[nodiscard]] Image8 drawLegend(const Legend& legend, int width, int height);

/// Draws it into the lower left corner. @param picture 3 channels
void putLegend(Image8& picture, const Legend& legend);

}  // namespace macula::image
