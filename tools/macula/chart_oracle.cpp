#include "chart_oracle.h"

#include <algorithm>
#include <cmath>

#include "engine/core/error.h"
#include "engine/experiment/tone_curve.h"
#include "engine/measure/oracle.h"
#include "passes/oit/statistics/read_fragments.h"

namespace macula::tools {
namespace {

/// Counts what becomes of the fragments under a choice of k.
void count(const measure::FragmentImage& image, const measure::LayerChoice& choice,
           measure::Tail tail, OracleAnswer& answer) {
  std::uint64_t covered = 0;
  std::uint64_t slots = 0;
  for (std::size_t p = 0; p < image.pixels(); ++p) {
    const std::uint32_t depth = image.depth(p);
    if (depth == 0) continue;
    const std::uint32_t k = std::min(choice.k[p], depth);
    const bool merges = tail == measure::Tail::Mean && k > 0 && k < depth;
    const std::uint32_t stored = merges ? k - 1 : k;  // the tail takes one of the slots
    answer.stored += stored;
    (merges ? answer.merged : answer.lost) += depth - stored;
    answer.kMin = covered == 0 ? k : std::min(answer.kMin, k);
    answer.kMax = std::max(answer.kMax, k);
    slots += k;
    ++covered;
  }
  if (covered > 0) answer.kMean = static_cast<double>(slots) / static_cast<double>(covered);
}

}  // namespace

measure::FrameRecord recordOf(const OracleAnswer& answer, std::uint64_t bytes) {
  const std::uint64_t generated = answer.stored + answer.merged + answer.lost;
  measure::FrameRecord record;
  record.set("bytes.total", bytes);
  record.set("bytes.oit", bytes);
  record.set("bytes.budget", bytes);
  record.set("fragments.generated", generated);
  record.set("fragments.stored", answer.stored);
  record.set("fragments.merged", answer.merged);
  record.set("fragments.lost", answer.lost);
  record.set(
      "fragments.loss",
      generated > 0 ? static_cast<double>(answer.lost) / static_cast<double>(generated) : 0.0);
  record.set("k.min", answer.kMin);
  record.set("k.max", answer.kMax);
  record.set("k.mean", answer.kMean);
  return record;
}

struct Oracles::Fragments {
  measure::FragmentImage image;
  measure::DisplayTransform display;
};

Oracles::Oracles(const Contender& exact, const Stage& stage) {
  const passes::RenderSettings& settings = exact.settings();
  if (!exact.result().exact) failInput("the exact frame was not exact; use a smaller size");
  if (settings.tonemap.ssaa != 1) failInput("oracles need frame.ssaa = 1");
  passes::FrameRenderer opaque(settings, stage.device);
  opaque.resize(stage.size);
  opaque.setScene(stage.gpu);
  opaque.showTransparency(false);
  opaque.want({.times = false, .statistics = false});
  static_cast<void>(opaque.render(stage.camera, stage.gaze));
  const float exposure = static_cast<float>(std::exp2(settings.tonemap.exposure));
  const auto display = [curve = settings.tonemap.curve, exposure](const glm::vec3& linear) {
    return measure::displayColour(experiment::toneCurve(curve, linear * exposure));
  };
  fragments_ = std::make_unique<Fragments>(
      Fragments{passes::readFragments(exact.renderer(), opaque), display});
}

Oracles::~Oracles() = default;

OracleAnswer Oracles::ask(experiment::Oracle oracle, std::uint64_t slots) const {
  const auto& [image, display] = *fragments_;
  const bool merges = oracle == experiment::Oracle::LeastRmseTail;
  const measure::Tail tail = merges ? measure::Tail::Mean : measure::Tail::None;
  const measure::LayerChoice choice = oracle == experiment::Oracle::OptimalK
                                          ? measure::optimalK(image, slots, display)
                                          : measure::leastRmse(image, slots, tail, display);
  OracleAnswer answer;
  answer.display = {image.width, image.height, 3, {}, false};
  answer.display.pixels.reserve(3 * choice.image.size());
  for (const glm::vec3& c : choice.image) {
    answer.display.pixels.insert(answer.display.pixels.end(), {c.r, c.g, c.b});
  }
  count(image, choice, tail, answer);
  return answer;
}

}  // namespace macula::tools
