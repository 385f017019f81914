#include "engine/scene/environment_limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <string_view>
#include <vector>

namespace macula::scene {
namespace {

/// Brighter than anything; the sum over a panorama, times a lobe, still fits into a float.
constexpr float kMostRadiance = 1e30F;
/// How far light is spread around a texel that is too bright: ten times the sun's diameter.
constexpr double kSpreadDegrees = 5.0;
/// Of the texels: where more are too bright, the picture as a whole has the wrong scale, and
/// spreading would only blur it (and take long).
constexpr double kMostSpreadShare = 0.01;

float brightest(const glm::vec3& c) {
  return std::max(c.r, std::max(c.g, c.b));
}

/// Counts texels of one kind and remembers the first.
struct Found {
  std::size_t count = 0;
  int x = 0;
  int y = 0;
  void add(int column, int row) {
    if (count++ > 0) return;
    x = column;
    y = row;
  }
  [[nodiscard]] std::string text(std::string_view what) const {
    return count == 0 ? std::string()
                      : fmt::format("{} {} {} (the first in column {}, row {} from the top)", count,
                                    count == 1 ? "texel is" : "texels are", what, x, y);
  }
};

/// Solid angle of a texel of a row, up to a factor that is the same for all.
double areaOf(int row, int height) {
  return std::sin(std::numbers::pi * (row + 0.5) / height);
}

/// Light of one texel that looks for room.
class Spreader {
 public:
  explicit Spreader(Panorama& panorama) : panorama_(panorama), taken_(panorama.pixels.size()) {}

  /// @param excess colour that the texel has too much @returns the share that found no room
  double spread(int x, int y, const glm::vec3& excess) {
    const int height = panorama_.height;
    const int reach =
        std::max(1, static_cast<int>(std::ceil(panorama_.width * kSpreadDegrees / 360.0)));
    double left = areaOf(y, height);
    const double whole = left;
    for (int ring = 1; ring <= reach && 2 * ring < panorama_.width && left > 0.0; ++ring) {
      collect(x, y, ring, excess);
      double room = 0.0;
      for (const Place& place : places_) room += place.room;
      if (room <= 0.0) continue;
      const double given = std::min(left, room);
      for (const Place& place : places_) {
        if (place.room <= 0.0) continue;
        const double share = place.room / room * given / place.area;
        panorama_.pixels[place.index] += static_cast<float>(share) * excess;
        taken_[place.index] = true;
      }
      left -= given;
    }
    return std::max(0.0, left) / whole;
  }
  [[nodiscard]] std::size_t touched() const {
    return static_cast<std::size_t>(std::count(taken_.begin(), taken_.end(), true));
  }

 private:
  struct Place {
    std::size_t index;
    double area;
    double room;  ///< multiples of the excess, times the area
  };

  void collect(int x, int y, int ring, const glm::vec3& excess) {
    places_.clear();
    for (int dy = -ring; dy <= ring; ++dy) {
      const int row = y + dy;
      if (row < 0 || row >= panorama_.height) continue;
      const int step = std::abs(dy) == ring ? 1 : 2 * ring;
      for (int dx = -ring; dx <= ring; dx += step) {
        const int column = (x + dx + panorama_.width) % panorama_.width;
        const std::size_t index =
            static_cast<std::size_t>(row) * static_cast<std::size_t>(panorama_.width) +
            static_cast<std::size_t>(column);
        double room = std::numeric_limits<double>::max();
        for (int c = 0; c < 3; ++c) {
          if (excess[c] <= 0.0F) continue;
          const double free = kMostStored - panorama_.pixels[index][c];
          room = std::min(room, free / static_cast<double>(excess[c]));
        }
        const double area = areaOf(row, panorama_.height);
        places_.push_back({index, area, std::max(0.0, room) * area});
      }
    }
  }

  Panorama& panorama_;
  std::vector<bool> taken_;
  std::vector<Place> places_;
};

}  // namespace

std::string makeUsable(Panorama& panorama) {
  Found nan;
  Found infinite;
  Found negative;
  for (int y = 0; y < panorama.height; ++y) {
    for (int x = 0; x < panorama.width; ++x) {
      glm::vec3& p =
          panorama.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(panorama.width) +
                          static_cast<std::size_t>(x)];
      const glm::vec3 given = p;
      for (int c = 0; c < 3; ++c) {
        if (!(given[c] >= 0.0F)) p[c] = 0.0F;
        // Most often half floats that were too large for their file.
        if (given[c] > kMostRadiance) p[c] = kMostStored;
      }
      if (glm::any(glm::isnan(given))) nan.add(x, y);
      if (glm::any(glm::greaterThan(given, glm::vec3(kMostRadiance)))) infinite.add(x, y);
      if (glm::any(glm::lessThan(given, glm::vec3(0.0F)))) negative.add(x, y);
    }
  }
  std::string line;
  for (const std::string& part : {nan.text("not a number and black"),
                                  infinite.text(fmt::format("infinite and {}", kMostStored)),
                                  negative.text("negative and black")}) {
    if (!part.empty()) line += (line.empty() ? "" : "; ") + part;
  }
  return line.empty() ? line : line + "; write the picture again without them";
}

RadianceLimit limitRadiance(Panorama& panorama) {
  RadianceLimit limit;
  limit.all = panorama.pixels.size();
  struct Bright {
    int x, y;
    glm::vec3 excess;
  };
  std::vector<Bright> bright;
  for (int y = 0; y < panorama.height; ++y) {
    for (int x = 0; x < panorama.width; ++x) {
      glm::vec3& p =
          panorama.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(panorama.width) +
                          static_cast<std::size_t>(x)];
      const float most = brightest(p);
      if (most <= kMostStored) continue;
      if (most > limit.largest) {
        limit.largest = most;
        limit.x = x;
        limit.y = y;
      }
      const glm::vec3 kept = p * (kMostStored / most);  // the colour stays
      bright.push_back({x, y, p - kept});
      p = glm::min(kept, glm::vec3(kMostStored));
    }
  }
  if (bright.empty()) return limit;
  limit.texels = bright.size();
  Spreader spreader(panorama);
  const bool few = static_cast<double>(bright.size()) <=
                   std::max(1.0, kMostSpreadShare * static_cast<double>(limit.all));
  double whole = 0.0;
  double lost = 0.0;
  for (const Bright& b : bright) {
    const double light = areaOf(b.y, panorama.height) * static_cast<double>(brightest(b.excess));
    whole += light;
    lost += light * (few ? spreader.spread(b.x, b.y, b.excess) : 1.0);
  }
  for (glm::vec3& p : panorama.pixels) p = glm::min(p, glm::vec3(kMostStored));  // but for rounding
  limit.touched = spreader.touched();
  limit.lostShare = whole > 0.0 ? lost / whole : 0.0;
  return limit;
}

std::string describe(const RadianceLimit& limit) {
  if (limit.texels == 0) return {};
  constexpr double kPercent = 100.0;
  const double times = static_cast<double>(limit.largest) / static_cast<double>(kMostStored);
  const int stops = static_cast<int>(std::ceil(std::log2(times)));
  const std::string rest =
      limit.lostShare > 0.0
          ? fmt::format(", but for {:.3g} % of what is above that", kPercent * limit.lostShare)
          : std::string();
  return fmt::format(
      "{} of {} texels {} brighter than {}, the most that reflections and background hold ({:.4g} "
      "in column {}, row {} from the top): there {} light is spread over {} texels around{}; "
      "diffuse light is exact; to keep it in place, divide picture and lights by {} and use "
      "--exposure {}",
      limit.texels, limit.all, limit.texels == 1 ? "is" : "are", kMostStored, limit.largest,
      limit.x, limit.y, limit.texels == 1 ? "its" : "their", limit.touched, rest,
      1ULL << std::min(stops, 62), stops);
}

}  // namespace macula::scene
