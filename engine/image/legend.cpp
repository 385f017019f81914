#include "engine/image/legend.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "engine/image/font.h"
#include "shared/viridis.h"

namespace macula::image {
namespace {

using Color = std::array<std::uint8_t, 3>;

constexpr Color kPaper{16, 18, 22};
constexpr Color kInk{236, 236, 236};
/// Letters grow with the picture: one pixel for so many rows.
constexpr int kRowsPerPixel = 480;
/// Lengths in pixels of letters.
constexpr int kAdvance = kGlyphWidth + 1;
constexpr int kLine = kGlyphHeight + 2;
constexpr int kBar = 8;
constexpr int kPad = 4;
constexpr int kMostLetters = 38;   ///< of a line; longer ones are wrapped
constexpr int kLeastLetters = 22;  ///< a narrower bar would show few colours

Color viridis(double t) {
  constexpr std::array<std::array<double, 3>, VIRIDIS_POINTS> kPoints{
      {{VIRIDIS_0}, {VIRIDIS_1}, {VIRIDIS_2}, {VIRIDIS_3}, {VIRIDIS_4}}};
  const double x = std::clamp(t, 0.0, 1.0) * (VIRIDIS_POINTS - 1);
  const auto i = std::min(static_cast<std::size_t>(x), kPoints.size() - 2);
  Color color{};
  for (std::size_t c = 0; c < color.size(); ++c) {
    const double value = std::lerp(kPoints[i][c], kPoints[i + 1][c], x - static_cast<double>(i));
    color[c] = static_cast<std::uint8_t>(std::lround(255.0 * value));
  }
  return color;
}

void setPixel(Image8& image, int x, int y, const Color& color) {
  const auto at = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                       static_cast<std::size_t>(x));
  std::copy(color.begin(), color.end(), image.pixels.begin() + static_cast<std::ptrdiff_t>(at));
}

void fill(Image8& image, int left, int top, int width, int height, const Color& color) {
  for (int y = top; y < top + height; ++y) {
    for (int x = left; x < left + width; ++x) setPixel(image, x, y, color);
  }
}

void drawText(Image8& image, int left, int top, int scale, std::string_view text) {
  for (const char letter : text) {
    const auto glyph = static_cast<std::size_t>(static_cast<unsigned char>(letter) - kFirstGlyph);
    for (int x = 0; glyph < kGlyphs.size() && x < kGlyphWidth; ++x) {
      for (int y = 0; y < kGlyphHeight; ++y) {
        if ((kGlyphs[glyph][static_cast<std::size_t>(x)] >> y & 1) == 0) continue;
        fill(image, left + x * scale, top + y * scale, scale, scale, kInk);
      }
    }
    left += kAdvance * scale;
  }
}

/// Breaks at spaces; a word that is longer than a line is cut.
std::vector<std::string> wrapped(std::string_view text, std::size_t letters) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    std::size_t end = std::min(letters, text.size());
    if (end < text.size()) {
      const std::size_t space = text.rfind(' ', end);
      if (space != std::string_view::npos && space > 0) end = space;
    }
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(end);
    while (text.starts_with(' ')) text.remove_prefix(1);
  }
  return lines;
}

int widthOf(std::string_view text) {
  return kAdvance * static_cast<int>(text.size());
}

}  // namespace

LegendLabels labelsOf(const Legend& legend) {
  return {"0", fmt::format("{:.4g}", 0.5 * legend.maximum),
          fmt::format("{}{:.4g}", legend.mayExceed ? ">= " : "", legend.maximum)};
}

Image8 drawLegend(const Legend& legend, int width, int height) {
  const int scale = std::max(1, height / kRowsPerPixel);
  // Half of the picture at the most, and a margin.
  const int mostLetters = std::min(kMostLetters, (width / scale - 4 * kPad) / kAdvance);
  const int mostRows = height / scale / 2;
  const LegendLabels labels = labelsOf(legend);
  const auto ends = static_cast<int>(labels.low.size() + labels.high.size()) + 1;
  constexpr int kLeastRows = kBar + 1 + kLine + 2 * kPad;
  if (mostLetters < ends || mostRows < kLeastRows) return {};
  std::vector<std::string> above = wrapped(legend.quantity, static_cast<std::size_t>(mostLetters));
  std::vector<std::string> below;
  if (!legend.grey.empty()) {
    below = wrapped("grey: " + legend.grey, static_cast<std::size_t>(mostLetters));
  }
  const auto rows = [&] {
    return kLeastRows + kLine * static_cast<int>(above.size() + below.size());
  };
  if (rows() > mostRows) below.clear();
  if (rows() > mostRows) above.clear();
  int letters = std::max(ends, std::min(kLeastLetters, mostLetters));
  for (const auto* lines : {&above, &below}) {
    for (const std::string& line : *lines)
      letters = std::max(letters, static_cast<int>(line.size()));
  }
  const int bar = kAdvance * letters;
  Image8 image{scale * (bar + 2 * kPad), scale * rows(), 3, {}};
  image.pixels.resize(3 * static_cast<std::size_t>(image.width) *
                      static_cast<std::size_t>(image.height));
  fill(image, 0, 0, image.width, image.height, kPaper);
  int y = kPad;
  const auto text = [&](int x, std::string_view line) {
    drawText(image, scale * (kPad + x), scale * y, scale, line);
  };
  for (const std::string& line : above) {
    text(0, line);
    y += kLine;
  }
  for (int x = 0; x < scale * bar; ++x) {
    fill(image, scale * kPad + x, scale * y, 1, scale * kBar,
         viridis((x + 0.5) / static_cast<double>(scale * bar)));
  }
  y += kBar + 2;
  text(0, labels.low);
  if (ends + static_cast<int>(labels.middle.size()) + 2 <= letters) {
    text((bar - widthOf(labels.middle)) / 2, labels.middle);
  }
  text(bar - widthOf(labels.high) + 1, labels.high);
  y += kLine;
  for (const std::string& line : below) {
    text(0, line);
    y += kLine;
  }
  return image;
}

void putLegend(Image8& picture, const Legend& legend) {
  const Image8 drawn = drawLegend(legend, picture.width, picture.height);
  if (drawn.pixels.empty()) return;
  const int margin = kPad * std::max(1, picture.height / kRowsPerPixel);
  const auto row = static_cast<std::ptrdiff_t>(drawn.width) * 3;
  for (std::ptrdiff_t y = 0; y < drawn.height; ++y) {
    const std::ptrdiff_t to = picture.height - margin - drawn.height + y;
    std::copy_n(drawn.pixels.begin() + y * row, row,
                picture.pixels.begin() + 3 * (to * picture.width + margin));
  }
}

}  // namespace macula::image
