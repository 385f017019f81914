#include "chart_path.h"

#include <new>
#include <string>

#include "engine/core/error.h"
#include "engine/experiment/path_error.h"

namespace macula::tools {

bool walkPath(const PathTrack& track, Contender& exact,
              std::span<const std::unique_ptr<Contender>> members,
              std::span<experiment::Point> points, const std::function<bool()>& goesOn) {
  std::vector<experiment::PathError> errors(members.size());
  std::vector<std::string> refusals(members.size());
  bool allExact = true;
  for (int frame = 0; frame < track.frames; ++frame) {
    const double time = frame / track.fps;
    const scene::Camera camera = track.camera.at(time);
    const auto gaze = glm::vec2(track.gaze.at(time).position);
    const bool cut = frame > 0 && track.camera.cutAt((frame - 1) / track.fps, time);
    exact.drawFrom(camera, gaze, cut);
    allExact = allExact && exact.result().exact;
    const image::ImageF reference = exact.display();
    for (std::size_t i = 0; i < members.size(); ++i) {
      if (members[i] == nullptr || !refusals[i].empty()) continue;
      try {
        members[i]->drawFrom(camera, gaze, cut);
        errors[i].add(reference, members[i]->display());
      } catch (const InputError& error) {
        refusals[i] = error.what();
      } catch (const std::bad_alloc&) {
        refusals[i] = "out of memory";
      }
    }
    if (!goesOn()) return allExact;
  }
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (members[i] == nullptr) continue;
    points[i]["path"] = refusals[i].empty() ? errors[i].toPoint(track.fps)
                                            : experiment::Point{{"reason", refusals[i]}};
  }
  return allExact;
}

}  // namespace macula::tools
