#include "engine/gaze/coordinates.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "engine/core/error.h"
#include "engine/gaze/cells.h"
#include "engine/gaze/tracker.h"

namespace macula::gaze {
namespace {

// What Tobii Studio writes for an eye that was not found, in pixels.
constexpr double kEyeSentinel = -1280.0;
// A line of sight along the display never meets it.
constexpr double kWidestDegrees = 89.0;
// No screen is that wide; larger sizes are codes or rubbish.
constexpr std::int64_t kWidestScreen = 1'000'000;

bool isCentred(GazeOrigin origin) {
  return origin == GazeOrigin::Centre || origin == GazeOrigin::CentreUp;
}

bool pointsUp(GazeOrigin origin) {
  return origin == GazeOrigin::BottomLeft || origin == GazeOrigin::CentreUp;
}

std::string_view nameOf(GazeOrigin origin) {
  switch (origin) {
    case GazeOrigin::BottomLeft:
      return "bottom left";
    case GazeOrigin::Centre:
      return "centre";
    case GazeOrigin::CentreUp:
      return "centre, y up";
    default:
      return "top left";
  }
}

std::string_view nameOf(GazeUnit unit) {
  switch (unit) {
    case GazeUnit::Pixels:
      return "px";
    case GazeUnit::Degrees:
      return "deg";
    default:
      return "0..1";
  }
}

}  // namespace

bool isOfSceneCamera(const CoordinateStatement& coordinates) {
  return coordinates.of == kSceneCamera;
}

std::string describe(const CoordinateStatement& c) {
  std::string text = fmt::format("{} ({}), origin {} ({}), of the {}", c.unit, c.unitBy, c.origin,
                                 c.originBy, c.of);
  if (c.screenPixels) {
    text += fmt::format(" {:.0f}x{:.0f} ({})", c.screenPixels->x, c.screenPixels->y, c.screenBy);
  }
  if (!c.mapping.empty()) text += "; " + c.mapping;
  return text;
}

std::optional<Rectangle> screenOf(const LogOptions& options) {
  const std::string_view text = options.screen;
  if (text.empty()) return std::nullopt;
  const std::size_t cross = text.find('x');
  // 0 stands for what is no number, and is refused like it.
  const auto side = [](std::string_view digits) { return parseInteger(digits).value_or(0); };
  const std::int64_t width = side(text.substr(0, cross));
  const std::int64_t height = cross == std::string_view::npos ? 0 : side(text.substr(cross + 1));
  if (width < 1 || height < 1 || width > kWidestScreen || height > kWidestScreen) {
    failInput("gaze.screen '{}': write WIDTHxHEIGHT in pixels, for example 1920x1080",
              oneLine(text));
  }
  return Rectangle{{0.0, 0.0}, {static_cast<double>(width), static_cast<double>(height)}};
}

CoordinateMapper::CoordinateMapper(const Coordinates& coordinates, const LogOptions& options,
                                   std::string where)
    : coordinates_(coordinates), display_(knownDisplay(options.display, coordinates.display)) {
  if (options.unit != GazeUnit::File) {
    coordinates_.unit = options.unit;
    coordinates_.unitBy = "setting";
  }
  if (options.origin != GazeOrigin::File) {
    coordinates_.origin = options.origin;
    coordinates_.originBy = "setting";
  }
  if (const std::optional<Rectangle> screen = screenOf(options)) {
    coordinates_.screen = screen;
    screenBy_ = "setting";
  }
  if (coordinates_.unit == GazeUnit::File) {
    failInput("{}: the unit of the coordinates is not said; give --gaze.unit px, 0..1 or deg",
              where);
  }
  if (coordinates_.origin == GazeOrigin::File) {
    failInput(
        "{}: the origin of the coordinates is not said; give --gaze.origin top-left, bottom-left, "
        "centre or centre-up",
        where);
  }
  // A format that counts no pixels brings no size for the pixels that a setting speaks of.
  const bool bringsNoSize =
      coordinates.unit == GazeUnit::Normalised || coordinates.unit == GazeUnit::Degrees;
  if (bringsNoSize && lack()) failInput("{}: {}", where, *lack());
  if (coordinates_.unit == GazeUnit::Degrees && !isCentred(coordinates_.origin)) {
    failInput("{}: degrees begin at the centre; give --gaze.origin centre or centre-up", where);
  }
  update();
}

void CoordinateMapper::setScreen(const Rectangle& screen) {
  if (screenBy_ == "setting") return;
  coordinates_.screen = screen;
  update();
}

std::optional<std::string> CoordinateMapper::lack() const {
  if (coordinates_.unit != GazeUnit::Pixels || coordinates_.screen) return std::nullopt;
  return fmt::format("pixels of a {} whose size is not said; give --gaze.screen WIDTHxHEIGHT",
                     coordinates_.of);
}

void CoordinateMapper::update() {
  // place = raw * scale + offset; degrees are bent instead.
  Rectangle frame{{0.0, 0.0}, {1.0, 1.0}};
  if (coordinates_.unit == GazeUnit::Pixels && coordinates_.screen) frame = *coordinates_.screen;
  scale_ = glm::dvec2(1.0);
  if (pointsUp(coordinates_.origin)) scale_.y = -1.0;
  scale_ /= frame.size;
  offset_ = isCentred(coordinates_.origin) ? glm::dvec2(0.5) : glm::dvec2(0.0);
  if (coordinates_.origin == GazeOrigin::BottomLeft) offset_.y = 1.0;
  if (!isCentred(coordinates_.origin)) offset_ -= frame.origin * scale_;
}

std::optional<glm::dvec2> CoordinateMapper::place(const glm::dvec2& raw) const {
  const bool centred = isCentred(coordinates_.origin);
  if (!centred && raw == glm::dvec2(0.0)) return std::nullopt;
  if (coordinates_.unit == GazeUnit::Pixels && (raw.x == kEyeSentinel || raw.y == kEyeSentinel)) {
    return std::nullopt;
  }
  glm::dvec2 place;
  if (coordinates_.unit == GazeUnit::Degrees) {
    if (!(std::abs(raw.x) < kWidestDegrees && std::abs(raw.y) < kWidestDegrees)) {
      return std::nullopt;
    }
    place =
        placeOfAngles({raw.x, pointsUp(coordinates_.origin) ? -raw.y : raw.y}, display_.display);
  } else if (!centred && !pointsUp(coordinates_.origin) && coordinates_.screen &&
             coordinates_.unit == GazeUnit::Pixels) {
    // Divided, not multiplied by the inverse: pixel w of w is 1 and so off the screen.
    place = (raw - coordinates_.screen->origin) / coordinates_.screen->size;
  } else {
    place = raw * scale_ + offset_;
  }
  if (!(std::abs(place.x) <= kFarthestPlace && std::abs(place.y) <= kFarthestPlace)) {
    return std::nullopt;
  }
  return place;
}

void CoordinateMapper::state(CoordinateStatement& statement) const {
  statement.unit = nameOf(coordinates_.unit);
  statement.origin = nameOf(coordinates_.origin);
  statement.of = coordinates_.of;
  statement.unitBy = coordinates_.unitBy;
  statement.originBy = coordinates_.originBy;
  statement.screenBy = screenBy_;
  statement.screenPixels.reset();
  if (coordinates_.unit == GazeUnit::Pixels && coordinates_.screen) {
    statement.screenPixels = coordinates_.screen->size;
  }
  statement.mapping.clear();
  if (coordinates_.unit == GazeUnit::Degrees) {
    statement.mapping = "degrees mapped by a display of " + describe(display_);
  }
}

}  // namespace macula::gaze
