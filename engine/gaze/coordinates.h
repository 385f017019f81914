// From the coordinates of a file to 0..1 of what was looked at, from its top left.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "engine/gaze/log.h"
#include "engine/gaze/log_options.h"
#include "engine/gaze/media_map.h"

namespace macula::gaze {

/// What a format and a file say of their coordinates; File where they do not say.
struct Coordinates {
  GazeUnit unit = GazeUnit::File;
  GazeOrigin origin = GazeOrigin::File;
  std::optional<Rectangle> screen = {};  ///< of pixels
  std::string_view of = "screen";
  std::string_view unitBy = "format";
  std::string_view originBy = "format";
  RecordedDisplay display = {};  ///< that degrees are of
};

/// Maps places, once unit, origin and size are known: what a setting says holds, otherwise what the
/// file says.
class CoordinateMapper {
 public:
  /// @param where begins messages: file and line
  /// @throws InputError where unit or origin are unknown or contradict each other
  CoordinateMapper(const Coordinates& coordinates, const LogOptions& options, std::string where);

  /// Takes the size from the file, unless a setting gave one.
  void setScreen(const Rectangle& screen);
  /// Of what the pixels are, where only the rows tell. @param of a literal
  void setOf(std::string_view of) { coordinates_.of = of; }

  /// @returns why no place can be mapped yet, and the fix: pixels of something of unknown size
  [[nodiscard]] std::optional<std::string> lack() const;

  /// 0..1; nothing where the place is a code for no place: (0, 0) unless that is the middle, -1280
  /// pixels, not finite, or more than 100 screens away.
  [[nodiscard]] std::optional<glm::dvec2> place(const glm::dvec2& raw) const;

  /// Writes down unit, origin and size and who said them.
  void state(CoordinateStatement& statement) const;

 private:
  void update();

  Coordinates coordinates_;
  KnownDisplay display_;
  std::string screenBy_ = "file";
  glm::dvec2 scale_{1.0};
  glm::dvec2 offset_{0.0};
};

/// "1920x1080". @throws InputError naming gaze.screen
[[nodiscard]] std::optional<Rectangle> screenOf(const LogOptions& options);

}  // namespace macula::gaze
