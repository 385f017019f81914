#include "chart_path.h"

#include <new>
#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/experiment/path_error.h"

namespace macula::tools {

std::optional<bool> walkPath(recording::FrameSource& frames, double fps, Contender& exact,
                             std::span<const std::unique_ptr<Contender>> members,
                             std::span<experiment::Point> points, ProgressBar& progress) {
  std::vector<experiment::PathError> errors(members.size());
  std::vector<std::string> refusals(members.size());
  bool allExact = true;
  const auto draw = [&](const recording::Frame& frame) {
    exact.drawFrom(frame);
    allExact = allExact && exact.result().exact;
    const image::ImageF reference = exact.display();
    for (std::size_t i = 0; i < members.size(); ++i) {
      if (members[i] == nullptr || !refusals[i].empty()) continue;
      try {
        members[i]->drawFrom(frame);
        errors[i].add(reference, members[i]->display());
      } catch (const InputError& error) {
        refusals[i] = error.what();
      } catch (const std::bad_alloc&) {
        refusals[i] = "out of memory";
      }
    }
  };
  if (!playFrames(frames, progress, draw)) return std::nullopt;
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (members[i] == nullptr) continue;
    points[i]["path"] =
        refusals[i].empty() ? errors[i].toPoint(fps) : experiment::Point{{"reason", refusals[i]}};
  }
  return allExact;
}

}  // namespace macula::tools
