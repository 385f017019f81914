// The points of one group of an experiment: one scene, light, size and seed, loaded once.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "chart_contender.h"
#include "chart_oracle.h"
#include "chart_run.h"
#include "engine/scene/camera_path.h"

namespace macula::tools {

/// A group whose scene is loaded and whose reference is drawn.
class LoadedGroup {
 public:
  /// @throws InputError where the scene cannot be loaded
  LoadedGroup(ChartRun& run, const experiment::Group& group, ProgressBar& progress);

  /// One batch from its settings to its lines in the points file. Ends early after SIGINT or
  /// SIGTERM, and writes nothing then.
  void measure(const experiment::Batch& batch);

 private:
  [[nodiscard]] LoadedScene load() const;
  [[nodiscard]] std::unique_ptr<VariantSettings> makeSettings() const;
  [[nodiscard]] std::unique_ptr<Contender> makeReference() const;
  [[nodiscard]] std::unique_ptr<Contender> makeContender(const experiment::PointPlan& plan) const;
  void drawReference();
  [[nodiscard]] double budgetBytes(const experiment::Budget& budget) const;
  [[nodiscard]] experiment::Point refusedPoint(const experiment::Batch& batch,
                                               const experiment::PointPlan& plan,
                                               const std::string& refusal) const;
  std::vector<experiment::Point> measureRounds(const experiment::Batch& batch);
  /// Along the camera's path, where the study asks for it.
  void walk(std::span<const std::unique_ptr<Contender>> contenders,
            std::span<experiment::Point> points);
  [[nodiscard]] experiment::Point finish(const experiment::Batch& batch,
                                         const experiment::PointPlan& plan,
                                         const Contender& contender) const;
  std::vector<experiment::Point> askOracles(const experiment::Batch& batch);
  void describeOracle(experiment::Point& point, const experiment::PointPlan& plan,
                      const Oracles& oracles) const;

  ChartRun& run_;
  const experiment::Group& group_;
  const experiment::Study& study_;
  ProgressBar& progress_;
  LoadedScene loaded_;
  scene::GpuScene gpu_;
  scene::CameraPath camera_;
  Stage stage_;
  Reference reference_;
};

}  // namespace macula::tools
