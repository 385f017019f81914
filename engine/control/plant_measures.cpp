#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/control/plant.h"

namespace macula::control {
namespace {

constexpr double kLate = 1.02;
constexpr double kVeryLate = 1.1;
constexpr double kSettled = 0.05;
constexpr double kCycle = 0.03;  ///< of r, peak to peak
constexpr int kCycleFrames = 120;
constexpr double kFramesPerSecond = 60.0;

double quantile(std::vector<double> values, double share) {
  std::ranges::sort(values);
  const auto index = static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5);
  return values[index];
}

std::optional<int> settling(const PlantRun& run, const PlantCase& c) {
  const auto begin = run.frames.begin() + c.steadyFrom;
  const double mean =
      std::accumulate(begin, run.frames.end(), 0.0,
                      [](double sum, const PlantFrame& f) { return sum + f.trueMs; }) /
      static_cast<double>(run.frames.end() - begin);
  int last = c.stepFrame - 1;  // last frame that is not settled
  for (int i = c.stepFrame; i < c.frames; ++i) {
    if (std::abs(run.frames[static_cast<std::size_t>(i)].trueMs / mean - 1.0) > kSettled) last = i;
  }
  if (last >= c.steadyFrom) return std::nullopt;
  return last + 1 - c.stepFrame;
}

bool cycles(const std::string& name, const PlantCase& plantCase, const LawOptions& options) {
  PlantCase calm = plantCase;
  calm.noise = calm.spikeShare = calm.lostShare = calm.zeroShare = calm.staleShare = 0.0;
  calm.jitterMs = 0.0;
  calm.hitchMs = 0.0;
  // Loads that never rest say nothing about rest.
  const Load last = plantCase.load(plantCase.frames - 1);
  calm.load = [&](int frame) {
    return frame < plantCase.steadyFrom ? plantCase.load(frame) : last;
  };
  const auto law = makeLaw(name, options);
  const PlantRun run = runPlant(*law, calm, options.targetMs, 1);
  double low = kMostResize;
  double high = kLeastResize;
  for (auto i = run.frames.size() - kCycleFrames; i < run.frames.size(); ++i) {
    low = std::min(low, run.frames[i].resize);
    high = std::max(high, run.frames[i].resize);
  }
  return high / low - 1.0 > kCycle;
}

PlantMeasures measureRun(const PlantRun& run, const PlantCase& c, double targetMs) {
  PlantMeasures m;
  m.settleFrames = settling(run, c);
  std::vector<double> times;
  double pixels = 0.0;
  double idealPixels = 0.0;
  int over = 0;
  int direction = 0;
  for (int i = 0; i < c.frames; ++i) {
    const PlantFrame& f = run.frames[static_cast<std::size_t>(i)];
    over = f.spentMs > kLate * targetMs ? over + 1 : 0;
    m.longestOver = std::max(m.longestOver, over);
    if (i < c.steadyFrom) continue;
    times.push_back(f.spentMs);
    pixels += 1.0 / (f.resize * f.resize);
    idealPixels += 1.0 / (f.idealResize * f.idealResize);
    m.overShare += f.spentMs > kLate * targetMs ? 1.0 : 0.0;
    m.over110Share += f.spentMs > kVeryLate * targetMs ? 1.0 : 0.0;
    const double change = f.resize - run.frames[static_cast<std::size_t>(i - 1)].resize;
    if (change == 0.0) continue;
    m.changesPerSecond += 1.0;
    const int way = change > 0.0 ? 1 : -1;
    if (direction == -way) m.reversalsPerSecond += 1.0;
    direction = way;
  }
  const auto count = static_cast<double>(times.size());
  const double mean = std::accumulate(times.begin(), times.end(), 0.0) / count;
  for (const double t : times) m.sigmaMs += (t - mean) * (t - mean) / count;
  m.sigmaMs = std::sqrt(m.sigmaMs);
  m.biasMs = mean - targetMs;
  m.overShare /= count;
  m.over110Share /= count;
  m.usedPixels = pixels / idealPixels;
  m.changesPerSecond *= kFramesPerSecond / count;
  m.reversalsPerSecond *= kFramesPerSecond / count;
  m.p50Ms = quantile(times, 0.5);
  m.p95Ms = quantile(times, 0.95);
  m.p99Ms = quantile(times, 0.99);
  return m;
}

}  // namespace

std::pair<PlantCase, LawOptions> withStep(PlantCase plantCase, LawOptions options) {
  if (plantCase.resizeStep == 0.0) plantCase.resizeStep = options.resizeStep;
  options.resizeStep = plantCase.resizeStep;
  return {std::move(plantCase), options};
}

PlantMeasures measureLaw(const std::string& name, const PlantCase& given,
                         const LawOptions& givenOptions, int seeds) {
  const auto [plantCase, options] = withStep(given, givenOptions);
  PlantMeasures sum;
  bool settles = true;
  int worst = 0;
  for (int seed = 1; seed <= seeds; ++seed) {
    const auto law = makeLaw(name, options);
    const PlantRun run =
        runPlant(*law, plantCase, options.targetMs, static_cast<std::uint32_t>(seed));
    const PlantMeasures m = measureRun(run, plantCase, options.targetMs);
    settles = settles && m.settleFrames.has_value();
    worst = std::max(worst, m.settleFrames.value_or(0));
    sum.longestOver = std::max(sum.longestOver, m.longestOver);
    for (const auto member :
         {&PlantMeasures::overShare, &PlantMeasures::over110Share, &PlantMeasures::usedPixels,
          &PlantMeasures::biasMs, &PlantMeasures::sigmaMs, &PlantMeasures::p50Ms,
          &PlantMeasures::p95Ms, &PlantMeasures::p99Ms, &PlantMeasures::changesPerSecond,
          &PlantMeasures::reversalsPerSecond}) {
      sum.*member += m.*member / seeds;
    }
  }
  if (settles) sum.settleFrames = worst;
  sum.limitCycle = cycles(name, plantCase, options);
  return sum;
}

}  // namespace macula::control
