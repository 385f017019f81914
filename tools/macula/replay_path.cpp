// The frames of `macula replay SCENE`: a camera path and a gaze.
#include <fmt/format.h>

#include <optional>

#include "engine/core/plural.h"
#include "engine/gaze/point_error.h"
#include "engine/gaze/source.h"
#include "gaze_report.h"
#include "provenance.h"
#include "replay_input.h"

namespace macula::tools {
namespace {

class PathInput final : public ReplayInput {
 public:
  PathInput(const ReplayOptions& options, glm::ivec2 size)
      : options_(options),
        gaze_(gaze::parseGazeSpec(options.gaze, options.gazeSettings)),
        trueGaze_(gaze::parseGazeSpec(options.gaze, gaze::undelayed(options.gazeSettings))),
        loaded_(loadForRendering(options.scene, options.settings)),
        followed_(*gaze_, options.gazeSettings) {
    followed_.printWarnings();
    frames_.emplace(parseCameraSpec(options.camera, loaded_->scene), *gaze_, options.fps,
                    static_cast<std::size_t>(options.frames), size);
    provenance_ = provenanceOfFrames(options);
  }

  recording::FrameSource& frames() override { return *frames_; }
  int warmup() const override { return options_.warmup; }
  recording::SceneSource scene() const override { return {options_.scene, {}, {}}; }
  LoadedScene load(const recording::SceneSource& /*source*/) override {
    LoadedScene loaded = std::move(loaded_.value());
    loaded_.reset();
    return loaded;
  }

  void judge(const DrawnFrame& drawn, measure::FrameRecord& record) override {
    if (!followed_.hasDegrees()) return;
    const recording::Frame& frame = drawn.source;
    record.set("fovea.error_deg",
               gaze::pointError(frame.gaze, trueGaze_->at(frame.timeSeconds), followed_.display()));
  }

  void describe(measure::RunRecord& run) override {
    run.provenance = provenance_;
    run.gazeLog = followed_.toJson();
    run.gazeErrorBasis = followed_.errorBasis();
    followed_.printEnd(options_.fps, options_.frames);
  }
  std::string summary(const nlohmann::ordered_json& report) const override {
    const auto& summary = report["summary"];
    std::string line =
        fmt::format("{} of {} by {}: {}", counted(report["frames"].size(), "frame"), options_.scene,
                    options_.settings.oit.method, medianText(summary));
    if (options_.reference) {
      line += fmt::format(", rmse {:.5f}", summary["error"]["rmse"].get<double>());
    }
    return line;
  }

 private:
  const ReplayOptions& options_;
  std::unique_ptr<gaze::GazeSource> gaze_;
  std::unique_ptr<gaze::GazeSource> trueGaze_;
  std::optional<LoadedScene> loaded_;  ///< until it is taken
  FollowedGaze followed_;
  std::optional<recording::PathFrames> frames_;
  nlohmann::ordered_json provenance_;
};

}  // namespace

std::unique_ptr<ReplayInput> openPath(const ReplayOptions& options, glm::ivec2 size) {
  return std::make_unique<PathInput>(options, size);
}

}  // namespace macula::tools
