#include "engine/control/control_settings.h"

namespace macula::control {

LawOptions lawOptionsOf(const ControlSettings& settings) {
  LawOptions options;
  options.targetMs = settings.targetMs;
  options.expectedWorkMs = settings.expectedWorkMs;
  options.fixedResize = settings.fixedResize;
  options.resizeStep = settings.resizeStep;
  options.mostResize = settings.mostResize;
  options.leastAim = settings.leastAim;
  return options;
}

void registerSettings(settings::Registry& registry, ControlSettings& s) {
  registry.setGroupEffect("control", settings::Effect::Immediate);
  constexpr double kMostMs = 10000.0;
  std::vector<std::string> laws{"off"};
  for (std::string& name : lawNames()) laws.push_back(std::move(name));
  registry.addChoice({.key = "control.law",
                      .alias = "law",
                      .help = "what chooses r from the times of past frames; off: lod.r holds"},
                     s.law, std::move(laws));
  registry.add(
      {.key = "control.targetMs", .alias = "target-ms", .unit = "ms", .help = "frame time to hold"},
      s.targetMs, {.min = 0.01, .max = kMostMs});
  registry.add({.key = "control.expectedWorkMs",
                .unit = "ms",
                .help = "of yang2008: K', the resizable work at r = 1 (Yang 2008, Eq. 3)"},
               s.expectedWorkMs, {.min = 0.0, .minExclusive = true, .max = kMostMs});
  registry.add({.key = "control.fixedR", .help = "r of the law fixed"}, s.fixedResize,
               {.min = kLeastResize, .max = kMostResize});
  registry.add({.key = "control.resizeStep", .help = "r comes in multiples of it; 0: any r"},
               s.resizeStep, {.min = 0.0, .max = 1.0});
  registry.add({.key = "control.mostResize",
                .help = "r goes no further; then the fovea's slope and the layers follow"},
               s.mostResize, {.min = kLeastResize, .max = kMostResize});
  constexpr double kLeast = 0.5;
  constexpr double kMost = 0.99;
  registry.add({.key = "control.leastAim",
                .unit = "of the target",
                .help = "of macula: what it aims at, at the least, where times spread",
                .share = true},
               s.leastAim, {.min = kLeast, .max = kMost});
  registry.add({.key = "control.fovea", .help = "the fovea's slope may be raised where r ends"},
               s.fovea);
  registry.add({.key = "control.layers", .help = "the layers' share may be lowered after that"},
               s.layers);
}

}  // namespace macula::control
