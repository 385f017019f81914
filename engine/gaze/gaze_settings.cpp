#include "engine/gaze/gaze_settings.h"

namespace macula::gaze {
namespace {

constexpr settings::Range kFrequencies{.min = 0.0, .minExclusive = true, .max = 1000.0};

void registerPipeline(settings::Registry& registry, PipelineSettings& s) {
  registry.addChoice({.key = "gaze.filter",
                      .help = "smoothing of believed gaze; auto: one-euro for live trackers only"},
                     s.filter, {"auto", "none", "one-euro"});
  registry.add({.key = "gaze.minCutoff", .unit = "Hz", .help = "of One Euro, for an eye at rest"},
               s.oneEuro.minCutoffHz, kFrequencies);
  registry.add({.key = "gaze.beta",
                .unit = "Hz s/degree",
                .help = "of One Euro: by how much speed raises the cutoff"},
               s.oneEuro.beta, {.min = 0.0, .max = 1000.0});
  registry.add({.key = "gaze.derivativeCutoff",
                .unit = "Hz",
                .help = "of One Euro, for the speed that raises the cutoff"},
               s.oneEuro.derivativeCutoffHz, kFrequencies);
  registry.add({.key = "gaze.saccadeSpeed",
                .unit = "degrees/s",
                .help = "gaze that moves as fast is in a saccade until it is half as fast"},
               s.saccade.onsetSpeed, {.min = 10.0, .max = 1000.0});
  registry.addChoice({.key = "gaze.prediction",
                      .help = "landing: in a saccade the point goes to where it will land"},
                     s.prediction, {"none", "landing"});
  registry.add({.key = "gaze.widen", .help = "the fovea grows where gaze is old or in a saccade"},
               s.widen);
  constexpr settings::Range kOffsets{.min = -1.0, .max = 1.0};
  registry.add({.key = "gaze.offsetX",
                .unit = "widths",
                .help = "added to every place, against a calibration that has drifted",
                .share = true},
               s.offsetX, kOffsets);
  registry.add(
      {.key = "gaze.offsetY", .unit = "heights", .help = "the same, downwards", .share = true},
      s.offsetY, kOffsets);
}

}  // namespace

LogOptions logOptionsOf(const GazeSettings& settings) {
  LogOptions options = settings.log;
  options.display = settings.display;
  return options;
}

void registerSettings(settings::Registry& registry, GazeSettings& settings) {
  registry.setGroupEffect("gaze", settings::Effect::ReopensGaze);
  registry.setGroupEffect("display", settings::Effect::ReopensGaze);
  registerSettings(registry, settings.log);
  registerPipeline(registry, settings.pipeline);
  registry.add({.key = "gaze.latencyMs",
                .alias = "gaze-latency-ms",
                .unit = "ms",
                .help = "a frame knows gaze that is this much older"},
               settings.latencyMs, {.min = 0.0, .max = 10000.0});
  constexpr double kMostMonitors = 16.0;
  registry.add({.key = "gaze.monitor",
                .help = "that a live tracker watches; 0: the one that the window is on"},
               settings.monitor, {.min = 0.0, .max = kMostMonitors});
  registerSettings(registry, settings.display);
}

}  // namespace macula::gaze
