// Every combination of transparency options that is accepted.
#pragma once

#include <string>
#include <vector>

#include "engine/core/error.h"
#include "passes/oit/plan.h"

namespace macula::test {

/// Whether checkCombination() lets the settings pass.
inline bool isAccepted(const passes::OitSettings& settings) {
  try {
    passes::checkCombination(settings);
  } catch (const InputError&) {
    return false;
  }
  return true;
}

/// Settings of all methods x tail x fill x importance x cull x fragmentBytes x count that are
/// accepted.
inline std::vector<passes::OitSettings> acceptedSettings() {
  using namespace passes;
  std::vector<OitSettings> all;
  for (const Method& method : methods()) {
    // One digit an option, so that seven options need one loop.
    for (unsigned code = 0; code < 2U * 2U * 4U * 2U * 2U * 2U; ++code) {
      unsigned rest = code;
      const auto digit = [&](unsigned base) {
        const unsigned value = rest % base;
        rest /= base;
        return value;
      };
      OitSettings s;
      s.method = method.id;
      s.tail = digit(2) == 0 ? Tail::None : Tail::Mean;
      s.fill = digit(2) == 1;
      s.importance = static_cast<Predictor>(digit(4));
      s.cull = digit(2) == 0 ? Cull::None : Cull::Occupancy;
      s.fragmentBytes = digit(2) == 0 ? 16 : 8;
      s.count = digit(2) == 0 ? CountSource::Drawn : CountSource::Predicted;
      if (isAccepted(s)) all.push_back(s);
    }
  }
  return all;
}

/// The kinds of per-pixel ordering that a method's fragments can have.
inline std::vector<passes::SyncMode> syncModesOf(const passes::Method& method) {
  using passes::SyncMode;
  if (method.isRacy()) return {SyncMode::None};
  std::vector<SyncMode> modes{SyncMode::Ordered, SyncMode::Spinlock, SyncMode::Interlock};
  if (method.sorts()) modes.push_back(SyncMode::None);
  return modes;
}

/// The plan of settings that are accepted, without sizes.
inline passes::OitPlan planOf(const passes::OitSettings& settings, passes::SyncMode sync) {
  passes::OitPlan plan;
  plan.method = &passes::methodById(settings.method);
  plan.sync = sync;
  plan.options = settings;
  return plan;
}

/// The settings in one line, for messages.
inline std::string combinationName(const passes::OitSettings& s) {
  return s.method + (s.tail == passes::Tail::Mean ? " tail" : "") + (s.fill ? " fill" : "") +
         " importance " + std::to_string(static_cast<int>(s.importance)) +
         (s.cull == passes::Cull::Occupancy ? " cull" : "") + " bytes " +
         std::to_string(s.fragmentBytes) +
         (s.count == passes::CountSource::Predicted ? " predicted" : "");
}

}  // namespace macula::test
