#include "chart_group.h"

#include <exception>
#include <new>

#include "chart_path.h"
#include "engine/core/error.h"
#include "engine/core/interrupt.h"
#include "engine/gaze/source.h"
#include "replay_painter.h"

namespace macula::tools {
namespace {

using experiment::Batch;
using experiment::Group;
using experiment::kWarmUpRounds;
using experiment::Point;
using experiment::PointPlan;

/// Calls `work`; where the machine refuses, says why in `refusal` and returns false.
template <typename Work>
bool attempt(std::string& refusal, Work&& work) {
  if (!refusal.empty()) return false;
  try {
    work();
    return true;
  } catch (const InputError& error) {
    refusal = error.what();
  } catch (const std::bad_alloc&) {
    refusal = "out of memory";
  }
  return false;
}

}  // namespace

LoadedGroup::LoadedGroup(ChartRun& run, const Group& group, ProgressBar& progress)
    : run_(run),
      group_(group),
      study_(run.experiment.studies[group.study]),
      progress_(progress),
      loaded_(load()),
      gpu_(loaded_.scene, loaded_.environment ? &*loaded_.environment : nullptr),
      camera_(parseCameraSpec(study_.camera, loaded_.scene)),
      stage_{run.device, gpu_, camera_.at(0.0),
             glm::vec2(gaze::parseGazeSpec(study_.gaze)->at(0.0).position),
             glm::ivec2(group.size.width, group.size.height)} {
  loaded_ = {};  // it is in GPU memory now
  drawReference();
}

void LoadedGroup::measure(const Batch& batch) {
  std::vector<Point> points = batch.oracles ? askOracles(batch) : measureRounds(batch);
  if (run_.interrupted) return;
  run_.measured += points.size();
  run_.file.append(points);
}

LoadedScene LoadedGroup::load() const {
  VariantSettings shared;
  shared.applyGroup(run_.experiment, group_);
  return loadForRendering(group_.scene, shared.render);
}

std::unique_ptr<VariantSettings> LoadedGroup::makeSettings() const {
  auto settings = std::make_unique<VariantSettings>();
  settings->applyGroup(run_.experiment, group_);
  return settings;
}

std::unique_ptr<Contender> LoadedGroup::makeReference() const {
  auto settings = makeSettings();
  settings->render = passes::referenceOf(settings->render);
  auto contender = std::make_unique<Contender>(std::move(settings), stage_);
  contender->draw(false);
  return contender;
}

void LoadedGroup::drawReference() {
  try {
    const auto contender = makeReference();
    reference_.shown = contender->shown();
    reference_.display = contender->display();
    reference_.file = "images/" + group_.stem + "_reference.png";
    reference_.gaze = stage_.gaze;
    reference_.pixelsPerDegree = study_.pixelsPerDegree;
    reference_.flipMaps = study_.flipMaps;
    if (const auto& fragments = contender->result().fragments) {
      reference_.generated = fragments->generated;
    }
    image::writePng(run_.folder / reference_.file, reference_.shown);
    if (!contender->result().exact) {
      run_.skipped.push_back({group_.label() + ", reference", "ab-sbuffer was not exact here"});
    }
  } catch (const InputError& error) {
    reference_ = {};
    run_.skipped.push_back({group_.label() + ", reference and all errors", error.what()});
  }
}

double LoadedGroup::budgetBytes(const experiment::Budget& budget) const {
  if (budget.kind == experiment::Budget::Kind::Share && reference_.generated == 0) {
    failInput("{}: the number of fragments is not known without the reference", budget.label());
  }
  const auto samples = static_cast<std::uint64_t>(group_.size.width) *
                       static_cast<std::uint64_t>(group_.size.height);
  return budget.bytes(samples, reference_.generated);
}

std::unique_ptr<Contender> LoadedGroup::makeContender(const PointPlan& plan) const {
  auto settings = makeSettings();
  const experiment::Variant& variant = run_.experiment.variants[plan.variant];
  settings->applyVariant(run_.experiment, variant);
  if (plan.value) settings->applySweep(variant.sweep.value(), *plan.value);
  if (plan.budget) settings->applyBudget(*plan.budget, budgetBytes(*plan.budget));
  return std::make_unique<Contender>(std::move(settings), stage_);
}

Point LoadedGroup::refusedPoint(const Batch& batch, const PointPlan& plan,
                                const std::string& refusal) const {
  Point point = startPoint(run_.experiment, group_, batch, plan, experiment::kRefused);
  point["reason"] = refusal;
  return point;
}

std::vector<Point> LoadedGroup::measureRounds(const Batch& batch) {
  const std::size_t count = batch.points.size();
  std::vector<std::unique_ptr<Contender>> contenders(count);
  std::vector<std::string> refusals(count);
  for (std::size_t i = 0; i < count; ++i) {
    attempt(refusals[i], [&] { contenders[i] = makeContender(batch.points[i]); });
  }
  for (int round = 0; round < kWarmUpRounds + study_.frames; ++round) {
    for (std::size_t i = 0; i < count; ++i) {
      if (!attempt(refusals[i], [&] { contenders[i]->draw(round >= kWarmUpRounds); })) {
        contenders[i].reset();  // its memory is for the others
      }
      progress_.advance();
    }
    if (interruptAsked()) {
      run_.interrupted = true;
      return {};
    }
  }
  std::vector<Point> points;
  for (std::size_t i = 0; i < count; ++i) {
    const PointPlan& plan = batch.points[i];
    points.push_back(contenders[i] ? finish(batch, plan, *contenders[i])
                                   : refusedPoint(batch, plan, refusals[i]));
    progress_.advance();
  }
  walk(contenders, points);
  return points;
}

void LoadedGroup::walk(std::span<const std::unique_ptr<Contender>> contenders,
                       std::span<Point> points) {
  if (study_.pathFrames == 0 || reference_.file.empty()) return;
  const auto gaze = gaze::parseGazeSpec(study_.gaze);
  recording::PathFrames frames(camera_, *gaze, study_.pathFps,
                               static_cast<std::size_t>(study_.pathFrames), stage_.size);
  std::string refusal;
  attempt(refusal, [&] {
    const auto reference = makeReference();
    const auto exact = walkPath(frames, study_.pathFps, *reference, contenders, points, progress_);
    if (!exact.has_value()) run_.interrupted = true;
    if (exact == false) refusal = "ab-sbuffer was not exact here";
  });
  if (!refusal.empty()) run_.skipped.push_back({group_.label() + ", path", refusal});
}

Point LoadedGroup::finish(const Batch& batch, const PointPlan& plan,
                          const Contender& contender) const {
  Point point = startPoint(run_.experiment, group_, batch, plan, experiment::kMeasured);
  contender.describe(point);
  describeImage(point, shownPicture(contender.renderer(), contender.shown()), contender.display(),
                reference_, run_.experiment.differenceScale, run_.folder, plan.stem);
  return point;
}

std::vector<Point> LoadedGroup::askOracles(const Batch& batch) {
  std::unique_ptr<Contender> exact;
  std::unique_ptr<Oracles> oracles;
  std::string unusable;
  attempt(unusable, [&] {
    exact = makeReference();
    oracles = std::make_unique<Oracles>(*exact, stage_);
  });
  std::vector<Point> points;
  for (const PointPlan& plan : batch.points) {
    std::string refusal = unusable;
    Point point = startPoint(run_.experiment, group_, batch, plan, experiment::kOracle);
    attempt(refusal, [&] { describeOracle(point, plan, *oracles); });
    points.push_back(refusal.empty() ? std::move(point) : refusedPoint(batch, plan, refusal));
    progress_.advance();
    if (interruptAsked()) {
      run_.interrupted = true;
      return {};
    }
  }
  return points;
}

void LoadedGroup::describeOracle(Point& point, const PointPlan& plan,
                                 const Oracles& oracles) const {
  const auto bytes = static_cast<std::uint64_t>(budgetBytes(plan.budget.value()));
  const auto slots = bytes / static_cast<std::uint64_t>(experiment::kBytesPerFragment);
  const OracleAnswer answer = oracles.ask(run_.experiment.variants[plan.variant].oracle, slots);
  measure::addTo(point, recordOf(answer, bytes), measure::kPoint, measure::None::Omit);
  describeImage(point, image::toImage8(answer.display), answer.display, reference_,
                run_.experiment.differenceScale, run_.folder, plan.stem);
}

}  // namespace macula::tools
