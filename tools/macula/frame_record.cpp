#include "frame_record.h"

#include <algorithm>

namespace macula::tools {
namespace {

double shareOf(std::uint64_t part, std::uint64_t whole) {
  return static_cast<double>(part) / static_cast<double>(whole);
}

void setTimes(measure::FrameRecord& record, const passes::FrameResult& result) {
  double transparency = 0.0;
  double shading = 0.0;
  for (const frame::PassTime& pass : result.passes) {
    record.passMs.emplace_back(pass.name, pass.ms);
    if (pass.name.starts_with("oit.")) transparency += pass.ms;
    if (pass.name == "lighting" || pass.name.starts_with("lod.")) shading += pass.ms;
  }
  record.set("ms.total", result.totalMs);
  record.set("ms.transparency", transparency);
  record.set("ms.shading", shading);
}

void setShading(measure::FrameRecord& record, const passes::FrameResult& result) {
  const passes::ShadingCounts& counts = result.shading;
  record.set("r", result.resizeFactor);
  record.set("shading.pixels", counts.pixels);
  record.set("shading.shaded", counts.shaded);
  record.set("shading.holes", counts.holes);
  if (counts.pixels == 0) return;
  record.set("shading.shaded_share", shareOf(counts.shaded, counts.pixels));
  record.set("shading.holes_share", shareOf(counts.holes, counts.pixels));
}

void setBytes(measure::FrameRecord& record, const passes::FrameRenderer& renderer) {
  const frame::ResourceBytes bytes = renderer.bytes();
  record.set("bytes.total", bytes.oit + bytes.overhead);
  record.set("bytes.oit", bytes.oit);
  record.set("bytes.budget", renderer.plan().budgetBytes);
  record.set("bytes.overhead", bytes.overhead);
  record.set("bytes.gbuffer", bytes.gbuffer);
  record.set("bytes.other", bytes.other);
}

/// What of the budget holds fragments or tails, in slots or in a dense target beside them.
void setBudgetUsed(measure::FrameRecord& record, const passes::FrameRenderer& renderer,
                   const passes::FrameResult& result) {
  const passes::OitPlan& plan = renderer.plan();
  if (!plan.budgetBytes || *plan.budgetBytes == 0 || !result.fragments) return;
  const std::uint64_t oit = renderer.bytes().oit;
  const std::uint64_t dense = oit - std::min(oit, plan.slots * plan.fragmentBytes());
  const std::uint64_t slots = result.fragments->stored + result.tailSlots;
  record.set("budget_used", shareOf(dense + slots * plan.fragmentBytes(), *plan.budgetBytes));
}

void setFragments(measure::FrameRecord& record, const passes::FrameResult& result) {
  if (const auto& f = result.fragments) {
    record.set("fragments.generated", f->generated);
    record.set("fragments.stored", f->stored);
    record.set("fragments.merged", f->merged);
    record.set("fragments.lost", f->lost);
    record.set("tail_slots", result.tailSlots);
    record.set("fragments.loss", f->generated > 0 ? shareOf(f->lost, f->generated) : 0.0);
  }
  if (const auto& k = result.layers) {
    record.set("k.min", k->min);
    record.set("k.max", k->max);
    record.set("k.mean", k->mean);
  }
  if (result.deepest > 0) record.set("deepest", result.deepest);
  record.set("lock_failures", result.lockFailures);
  record.set("recaptures", static_cast<std::uint64_t>(result.recaptures));
  record.set("pool_overflows", result.overflows);
  if (result.counted) record.set("exact", result.exact);
}

}  // namespace

measure::FrameRecord recordOf(const passes::FrameRenderer& renderer,
                              const passes::FrameResult& result) {
  measure::FrameRecord record;
  if (result.timed) setTimes(record, result);
  setShading(record, result);
  setBytes(record, renderer);
  setBudgetUsed(record, renderer, result);
  setFragments(record, result);
  return record;
}

void setGaze(measure::FrameRecord& record, const gaze::PointOfInterest& point) {
  record.set("gaze.x", point.position.x);
  record.set("gaze.y", point.position.y);
  record.set("gaze.raw_x", point.raw.x);
  record.set("gaze.raw_y", point.raw.y);
  record.set("gaze.state", gaze::stateName(point.state));
  record.set("gaze.age_s", point.ageSeconds);
  record.set("fovea.radius", point.radius);
  record.set("fovea.saccade", point.saccade);
}

std::vector<std::pair<std::string, std::uint64_t>> transparencyBytes(
    const passes::FrameRenderer& renderer) {
  std::vector<std::pair<std::string, std::uint64_t>> bytes;
  for (const frame::Resource* resource : renderer.resources().list()) {
    const frame::ByteClass kind = resource->bytes;
    if (kind != frame::ByteClass::Oit && kind != frame::ByteClass::Overhead) continue;
    bytes.emplace_back(resource->name, renderer.resources().bytesOf(*resource));
  }
  return bytes;
}

}  // namespace macula::tools
