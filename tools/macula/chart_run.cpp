#include "chart_run.h"

#include <algorithm>

#include "chart_group.h"
#include "engine/core/error.h"
#include "engine/core/interrupt.h"

namespace macula::tools {
namespace {

using experiment::Batch;
using experiment::Group;
using experiment::kWarmUpRounds;
using experiment::Point;
using experiment::PointPlan;

bool isFinished(const ChartRun& run, const Batch& batch) {
  for (const PointPlan& plan : batch.points) {
    const Point* point = run.file.find(plan.key);
    if (point == nullptr) return false;
    if (!point->contains("images")) continue;
    for (const auto& [role, name] : point->at("images").items()) {
      if (!std::filesystem::exists(run.folder / name.get<std::string>())) return false;
    }
  }
  return true;
}

int stepsOf(const ChartRun& run, const Group& group, const Batch& batch) {
  const experiment::Study& study = run.experiment.studies[group.study];
  const int each = batch.oracles ? 1 : kWarmUpRounds + study.frames + 1;  // and one for its images
  return each * static_cast<int>(batch.points.size()) + (batch.oracles ? 0 : study.pathFrames);
}

/// Notes why a group is left out. A missing optional file is noted once for all studies.
void skip(ChartRun& run, const Group& group, const std::string& reason) {
  std::error_code error;
  if (!group.optional || std::filesystem::exists(group.scene, error)) {
    run.skipped.push_back({group.label(), reason});
    return;
  }
  const bool known = std::any_of(run.skipped.begin(), run.skipped.end(),
                                 [&](const auto& other) { return other.what == group.scene; });
  if (!known) run.skipped.push_back({group.scene, "optional, and not here"});
}

void runGroup(ChartRun& run, const Group& group, ProgressBar& progress) {
  std::vector<const Batch*> pending;
  for (const Batch& batch : group.batches) {
    if (isFinished(run, batch)) {
      run.kept += batch.points.size();
    } else {
      pending.push_back(&batch);
    }
  }
  if (pending.empty()) return;
  try {
    LoadedGroup loaded(run, group, progress);
    for (const Batch* batch : pending) {
      if (!run.interrupted) loaded.measure(*batch);
    }
  } catch (const InputError& error) {
    run.skipped.push_back({group.label(), error.what()});
  }
}

}  // namespace

void runGroups(ChartRun& run, std::span<const Group> groups) {
  std::filesystem::create_directories(run.folder / "images");
  std::vector<const Group*> usable;
  int steps = 0;
  for (const Group& group : groups) {
    if (const auto reason = reasonToSkip(group)) {
      skip(run, group, *reason);
      continue;
    }
    usable.push_back(&group);
    for (const Batch& batch : group.batches) {
      if (!isFinished(run, batch)) steps += stepsOf(run, group, batch);
    }
  }
  if (steps == 0) {
    for (const Group* group : usable) {
      for (const Batch& batch : group->batches) run.kept += batch.points.size();
    }
    return;
  }
  ProgressBar progress("chart", steps);
  for (const Group* group : usable) {
    if (interruptAsked()) run.interrupted = true;
    if (run.interrupted) return;
    runGroup(run, *group, progress);
  }
}

}  // namespace macula::tools
