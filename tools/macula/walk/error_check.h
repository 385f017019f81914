// How far the picture is from a reference: numbers and maps, computed on a thread of their own.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/gl/objects.h"
#include "engine/image/image.h"
#include "engine/measure/image_error.h"
#include "walk/background_job.h"

namespace macula::tools {

/// Two pictures of one view.
struct PicturePair {
  std::string referenceName;  ///< of the method
  std::string testName;
  std::string scene;
  int frame = 0;            ///< FrameEvents::index of the view
  image::Image8 reference;  ///< 3 channels, display values
  image::Image8 test;
};

class ErrorCheck {
 public:
  enum class Map { None, Difference, Flip };

  struct Result {
    std::string referenceName;
    std::string testName;
    std::string scene;
    int frame = 0;  ///< that was measured; the walk goes on
    measure::ImageError error;
    image::Image8 difference;
    double differenceScale = 1.0;
    image::Image8 flip;
  };

  /// Must not be called while busy().
  void start(PicturePair pair);
  [[nodiscard]] bool busy() const { return job_.busy(); }
  /// To be called once a frame. @returns whether a result came
  bool poll();
  /// The newest; none before the first.
  [[nodiscard]] const std::optional<Result>& result() const { return result_; }

  /// What the newest figures and maps are of: "blend against ab-sbuffer, at frame 812".
  /// @param scene that is shown now: another one is named
  [[nodiscard]] std::string title(std::string_view scene) const;

  /// Shows a map of the result in place of the picture. The view it is of stays until then.
  void show(Map map);
  [[nodiscard]] Map map() const { return map_; }
  /// The map's picture; null where none is shown.
  [[nodiscard]] const gl::Texture* texture() const;

 private:
  BackgroundJob<Result> job_;
  std::optional<Result> result_;
  Map map_ = Map::None;
  gl::Texture texture_;
};

/// "none", "difference", "flip", in the order of ErrorCheck::Map.
[[nodiscard]] const std::vector<std::string>& mapNames();

}  // namespace macula::tools
