// macula gaze info FILE, macula gaze convert FILE --out F.csv
#include <fmt/format.h>

#include <memory>

#include "commands.h"
#include "common.h"
#include "engine/core/interrupt.h"
#include "engine/gaze/canonical_csv.h"
#include "engine/gaze/cells.h"
#include "engine/gaze/log_reader.h"
#include "engine/gaze/quality.h"
#include "engine/gaze/viewing.h"
#include "engine/settings/command_line.h"
#include "gaze_report.h"

namespace macula::tools {
namespace {

struct Options {
  std::string file;
  std::string format;
  std::string out;
  std::string json;
  gaze::LogOptions log;
  gaze::QualityOptions quality;
  settings::Registry registry;
};

double percent(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

/// Degrees of movements, or why there are none.
void printMovements(const gaze::EyeMovements& movements, const gaze::Viewing& viewing,
                    double threshold) {
  if (!viewing.hasDegrees) {
    fmt::print("{:<17}none: {}\n", "fixations", gaze::kNoDegrees);
    return;
  }
  fmt::print("{:<17}{}, mean {:.0f} ms\n", "fixations", movements.fixations,
             1e3 * movements.fixationSeconds);
  fmt::print("{:<17}{}, mean {:.2f} deg (from {:g} deg/s on a display of {})\n", "saccades",
             movements.saccades, movements.saccadeDegrees, threshold, describe(viewing.display));
}

void printInfo(const gaze::GazeLogHead& head, const gaze::GazeQuality& q,
               const gaze::Viewing& viewing, double threshold) {
  const gaze::GazeCounters& c = head.counters;
  const auto line = [](std::string_view label, const std::string& text) {
    fmt::print("{:<17}{}\n", label, text);
  };
  line("format", head.format);
  line("coordinates", gaze::describe(head.coordinates));
  line("samples", fmt::format("{}", q.samples));
  line("lost", fmt::format("{} ({:.1f} %)", q.lost, percent(q.lost, q.samples)));
  if (c.twoEyeSamples > 0) {
    line("eyes lost",
         fmt::format("left {}, right {}, both {}", c.leftLost, c.rightLost, c.bothLost));
  }
  line("rate", fmt::format("{:.2f} Hz, jitter {:.3f} ms", q.rateHz, 1e3 * q.jitterSeconds));
  line("duration", fmt::format("{:.3f} s", q.durationSeconds));
  line("longest dropout", fmt::format("{:.3f} s", q.longestDropoutSeconds));
  line("off screen", fmt::format("{} ({:.1f} %)", q.offScreen, percent(q.offScreen, q.samples)));
  printMovements(q.movements, viewing, threshold);
  using gaze::counted;
  line("other rows", fmt::format("{} event, {} truncated", c.eventRows, c.truncatedRows));
  line("marked", fmt::format("{}, {}, {}", counted(c.blinks, "blink"),
                             counted(c.saccades, "saccade"), counted(c.blocks, "block")));
  line("times", fmt::format("{} duplicate, {} backward, {}, {}", c.duplicateTimes, c.backwardTimes,
                            counted(c.gaps, "gap"), counted(c.clockRestarts, "clock restart")));
  line("places", fmt::format("{}, {}", counted(c.sentinels, "sentinel"),
                             counted(q.frozenRuns, "frozen run")));
  for (const std::string& note : head.notes) line("note", note);
  for (const std::string& warning : viewing.warnings) line("warning", warning);
}

nlohmann::ordered_json toJson(const gaze::GazeLogHead& head, const gaze::GazeQuality& q,
                              const gaze::Viewing& viewing, double threshold) {
  const gaze::GazeCounters& c = head.counters;
  nlohmann::ordered_json eyes;  // null where the file does not tell the eyes apart
  if (c.twoEyeSamples > 0) {
    eyes = {{"left_lost", c.leftLost}, {"right_lost", c.rightLost}, {"both_lost", c.bothLost}};
  }
  nlohmann::ordered_json screen;
  if (head.coordinates.screenPixels) {
    screen = {head.coordinates.screenPixels->x, head.coordinates.screenPixels->y};
  }
  nlohmann::ordered_json fixations{{"count", nullptr}, {"mean_s", nullptr}};
  nlohmann::ordered_json saccades{{"count", nullptr}, {"mean_deg", nullptr}};
  if (viewing.hasDegrees) {
    fixations = {{"count", q.movements.fixations}, {"mean_s", q.movements.fixationSeconds}};
    saccades = {{"count", q.movements.saccades}, {"mean_deg", q.movements.saccadeDegrees}};
  }
  return {{"format", head.format},
          {"samples", q.samples},
          {"lost", q.lost},
          {"rate_hz", q.rateHz},
          {"duration_s", q.durationSeconds},
          {"longest_dropout_s", q.longestDropoutSeconds},
          {"off_screen", q.offScreen},
          {"jitter_ms", 1e3 * q.jitterSeconds},
          {"eyes", eyes},
          {"fixations", fixations},
          {"saccades", saccades},
          {"ivt_deg_per_s", threshold},
          {"display", tools::toJson(viewing.display)},
          {"event_rows", c.eventRows},
          {"truncated_rows", c.truncatedRows},
          {"duplicate_times", c.duplicateTimes},
          {"backward_times", c.backwardTimes},
          {"gaps", c.gaps},
          {"clock_restarts", c.clockRestarts},
          {"sentinels", c.sentinels},
          {"frozen_runs", q.frozenRuns},
          {"marked_blinks", c.blinks},
          {"marked_saccades", c.saccades},
          {"blocks", c.blocks},
          {"coordinates",
           {{"unit", head.coordinates.unit},
            {"unit_by", head.coordinates.unitBy},
            {"origin", head.coordinates.origin},
            {"origin_by", head.coordinates.originBy},
            {"of", head.coordinates.of},
            {"screen_px", screen},
            {"statement", gaze::describe(head.coordinates)}}},
          {"notes", head.notes},
          {"warnings", viewing.warnings}};
}

/// Measures the whole log, with its angles on this display.
gaze::GazeLogHead measure(const Options& options, const gaze::Display& display,
                          gaze::GazeQuality& quality) {
  gaze::GazeLogReader reader(options.file, options.log);
  gaze::QualityMeter meter({.ivtThreshold = options.quality.ivtThreshold, .display = display});
  gaze::GazeSample sample;
  while (reader.next(sample)) meter.add(sample);
  quality = meter.quality();
  return reader.head();
}

void info(const Options& options) {
  gaze::GazeQuality quality;
  const gaze::GazeLogHead head = measure(options, options.log.display, quality);
  const gaze::Viewing viewing = viewingOf(head, options.log);
  // Only the whole file tells how far the eyes were on average.
  if (viewing.display.sizeBy == "file" || viewing.display.distanceBy == "file") {
    (void)measure(options, viewing.display.display, quality);
  }
  const double threshold = options.quality.ivtThreshold;
  if (options.json != "-") printInfo(head, quality, viewing, threshold);
  writeJson(options.json, toJson(head, quality, viewing, threshold));
}

void convert(const Options& options) {
  const InterruptGuard guard;
  const gaze::Conversion done = gaze::convertGazeLog(options.file, options.out, options.log);
  fmt::print("{}: {} of {} written\ncoordinates were {}\n", options.out,
             gaze::counted(done.samples, "sample"), done.head.format,
             gaze::describe(done.head.coordinates));
}

/// A subcommand with what both take: the file, how it is to be read, and the display.
CLI::App& addReader(CLI::App& parent, const std::string& name, const std::string& help,
                    const std::shared_ptr<Options>& options, void (*run)(const Options&)) {
  CLI::App* command = parent.add_subcommand(name, help);
  command->add_option("file", options->file, "Gaze log")->required();
  command->add_option("--format", options->format, "Short for --gaze.format")
      ->check(CLI::IsMember(gaze::gazeFormatNames()));
  settings::addOptions(*command, options->registry);
  command->callback([options, command, run] {
    settings::applyOptions(*command, options->registry);
    if (!options->format.empty()) options->log.format = options->format;
    run(*options);
  });
  return *command;
}

}  // namespace

void addGaze(CLI::App& root) {
  auto options = std::make_shared<Options>();
  registerSettings(options->registry, options->log);
  registerSettings(options->registry, options->quality);
  registerSettings(options->registry, options->log.display);
  CLI::App* command = root.add_subcommand("gaze", "Look at and convert recorded gaze logs");
  command->require_subcommand(1);
  CLI::App& infoCommand =
      addReader(*command, "info", "Format, rate, losses, eye movements", options, info);
  addJsonOption(infoCommand, options->json);
  CLI::App& convertCommand =
      addReader(*command, "convert", "Write Macula's canonical CSV", options, convert);
  convertCommand.add_option("--out", options->out, "CSV file")->required();
}

}  // namespace macula::tools
