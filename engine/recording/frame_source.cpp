#include "engine/recording/frame_source.h"

#include <utility>

namespace macula::recording {

PathFrames::PathFrames(const scene::CameraPath& path, gaze::GazeSource& gaze, double fps,
                       std::size_t count, glm::ivec2 size)
    : player_(path), gaze_(gaze), fps_(fps), count_(count) {
  first_.size = size;
  first_.camera = player_.moveTo(0.0).camera;
  first_.gaze = gaze.at(0.0);
  frame_ = first_;
}

const Frame* PathFrames::next() {
  if (next_ == count_) return nullptr;
  frame_.index = next_++;
  frame_.timeSeconds = static_cast<double>(frame_.index) / fps_;
  const scene::PathPlayer::Moment moment = player_.moveTo(frame_.timeSeconds);
  frame_.camera = moment.camera;
  frame_.cut = moment.cut;
  frame_.gaze = gaze_.at(frame_.timeSeconds);
  return &frame_;
}

ListedFrames::ListedFrames(const std::vector<scene::Camera>& views, glm::ivec2 size) {
  for (const scene::Camera& view : views) {
    Frame& frame = frames_.emplace_back();
    frame.index = frames_.size() - 1;
    frame.size = size;
    frame.camera = view;
    frame.gaze = gaze::exactPoint(glm::dvec2(0.5));
  }
}

scene::CameraPath cameraPathOf(const Recording& recording) {
  std::vector<scene::CameraKey> keys;
  for (const Frame& frame : recording.frames) {
    if (!keys.empty() && frame.timeSeconds <= keys.back().time) continue;
    keys.push_back({.time = frame.timeSeconds,
                    .position = frame.camera.position,
                    .target = frame.camera.target,
                    .verticalFov = frame.camera.verticalFov,
                    .cut = frame.cut});
  }
  return scene::CameraPath(std::move(keys));
}

}  // namespace macula::recording
