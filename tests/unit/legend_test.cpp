// The legend that heat maps bear: colours, numbers, and what small pictures leave out.
#include "engine/image/legend.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace macula::image {
namespace {

const Legend kSlots{"k(p): slots of each sample", 12.0, true};

using Color = std::array<int, 3>;

Color at(const Image8& image, int x, int y) {
  const auto i = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                      static_cast<std::size_t>(x));
  return {image.pixels[i], image.pixels[i + 1], image.pixels[i + 2]};
}

bool close(const Color& a, const Color& b) {
  constexpr int kStep = 16;  // of the scale between two columns of a narrow bar
  return std::abs(a[0] - b[0]) < kStep && std::abs(a[1] - b[1]) < kStep &&
         std::abs(a[2] - b[2]) < kStep;
}

/// Whether a row holds the bar: from the coldest colour of viridis to the hottest.
bool isBar(const Image8& image, int y) {
  int first = 0;
  int last = image.width - 1;
  while (first < last && close(at(image, first, y), {16, 18, 22})) ++first;
  while (first < last && close(at(image, last, y), {16, 18, 22})) --last;
  return close(at(image, first, y), {68, 1, 84}) && close(at(image, last, y), {253, 231, 37});
}

int barRows(const Image8& image) {
  int rows = 0;
  for (int y = 0; y < image.height; ++y) rows += isBar(image, y) ? 1 : 0;
  return rows;
}

TEST(Legend, NamesTheEndsOfItsScale) {
  EXPECT_EQ(labelsOf(kSlots).low, "0");
  EXPECT_EQ(labelsOf(kSlots).middle, "6");
  EXPECT_EQ(labelsOf(kSlots).high, ">= 12");
  EXPECT_EQ(labelsOf({"importance", 1.0, false}).high, "1");
}

TEST(Legend, FitsIntoAnyPictureOrIsLeftOut) {
  bool drawn = true;
  for (int size = 2048; size >= 1; size -= size > 300 ? 37 : 1) {
    const Image8 image = drawLegend(kSlots, size, size);
    EXPECT_LE(image.width, size);
    EXPECT_LE(image.height, size / 2 + 1);
    EXPECT_EQ(image.pixels.size(), static_cast<std::size_t>(image.width * image.height * 3));
    EXPECT_TRUE(drawn || image.pixels.empty()) << "one that does not fit fits a smaller picture";
    drawn = !image.pixels.empty();
    EXPECT_GE(barRows(image), drawn ? 8 : 0) << size;
    EXPECT_TRUE(drawn || size < 64) << size;
  }
  EXPECT_FALSE(drawn);
}

TEST(Legend, OtherNumbersAndOtherQuantitiesLookDifferent) {
  const Image8 slots = drawLegend(kSlots, 320, 240);
  Legend other = kSlots;
  other.maximum = 13.0;
  EXPECT_NE(drawLegend(other, 320, 240).pixels, slots.pixels);
  other = kSlots;
  other.quantity = "k(p): slots of each pixel";
  EXPECT_NE(drawLegend(other, 320, 240).pixels, slots.pixels);
}

TEST(Legend, StandsInTheLowerLeftCornerAndLeavesTheRest) {
  Image8 picture{200, 150, 3, {}};
  picture.pixels.assign(3 * 200 * 150, 77);
  putLegend(picture, kSlots);
  const Image8 legend = drawLegend(kSlots, 200, 150);
  int changed = 0;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const bool inside = x >= 4 && x < 4 + legend.width && y < 146 && y >= 146 - legend.height;
      changed += inside ? 1 : 0;
      EXPECT_EQ(at(picture, x, y),
                inside ? at(legend, x - 4, y - 146 + legend.height) : (Color{77, 77, 77}));
    }
  }
  EXPECT_EQ(changed, legend.width * legend.height);
}

}  // namespace
}  // namespace macula::image
