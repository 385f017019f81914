// macula gaze info FILE, macula gaze convert FILE --out F.csv
#include <fmt/format.h>

#include <memory>

#include "commands.h"
#include "common.h"
#include "engine/core/interrupt.h"
#include "engine/gaze/canonical_csv.h"
#include "engine/gaze/log_reader.h"
#include "engine/gaze/quality.h"
#include "engine/settings/command_line.h"

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

void printInfo(const gaze::GazeLogHead& head, const gaze::GazeQuality& q,
               const gaze::QualityOptions& options) {
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
  line("fixations",
       fmt::format("{}, mean {:.0f} ms", q.movements.fixations, 1e3 * q.movements.fixationSeconds));
  line("saccades",
       fmt::format("{}, mean {:.2f} deg (from {:g} deg/s on a display of {:g}x{:g} mm "
                   "at {:g} mm)",
                   q.movements.saccades, q.movements.saccadeDegrees, options.ivtThreshold,
                   options.display.widthMm, options.display.heightMm, options.display.distanceMm));
  line("other rows", fmt::format("{} event, {} truncated", c.eventRows, c.truncatedRows));
  line("marked", fmt::format("{} blinks, {} saccades, {} blocks", c.blinks, c.saccades, c.blocks));
  line("times", fmt::format("{} duplicate, {} backward, {} gaps, {} clock restarts",
                            c.duplicateTimes, c.backwardTimes, c.gaps, c.clockRestarts));
  line("places", fmt::format("{} sentinels, {} frozen runs", c.sentinels, q.frozenRuns));
  for (const std::string& note : head.notes) line("note", note);
}

nlohmann::ordered_json toJson(const gaze::GazeLogHead& head, const gaze::GazeQuality& q,
                              const gaze::QualityOptions& options) {
  const gaze::GazeCounters& c = head.counters;
  nlohmann::ordered_json eyes;  // null where the file does not tell the eyes apart
  if (c.twoEyeSamples > 0) {
    eyes = {{"left_lost", c.leftLost}, {"right_lost", c.rightLost}, {"both_lost", c.bothLost}};
  }
  nlohmann::ordered_json screen;
  if (head.coordinates.screenPixels) {
    screen = {head.coordinates.screenPixels->x, head.coordinates.screenPixels->y};
  }
  return {
      {"format", head.format},
      {"samples", q.samples},
      {"lost", q.lost},
      {"rate_hz", q.rateHz},
      {"duration_s", q.durationSeconds},
      {"longest_dropout_s", q.longestDropoutSeconds},
      {"off_screen", q.offScreen},
      {"jitter_ms", 1e3 * q.jitterSeconds},
      {"eyes", eyes},
      {"fixations", {{"count", q.movements.fixations}, {"mean_s", q.movements.fixationSeconds}}},
      {"saccades", {{"count", q.movements.saccades}, {"mean_deg", q.movements.saccadeDegrees}}},
      {"ivt_deg_per_s", options.ivtThreshold},
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
      {"notes", head.notes}};
}

void info(const Options& options) {
  gaze::GazeLogReader reader(options.file, options.log);
  gaze::QualityMeter meter(options.quality);
  gaze::GazeSample sample;
  while (reader.next(sample)) meter.add(sample);
  const gaze::GazeQuality quality = meter.quality();
  if (options.json != "-") printInfo(reader.head(), quality, options.quality);
  writeJson(options.json, toJson(reader.head(), quality, options.quality));
}

void convert(const Options& options) {
  const InterruptGuard guard;
  const gaze::Conversion done = gaze::convertGazeLog(options.file, options.out, options.log);
  fmt::print("{}: {} samples of {} written\ncoordinates were {}\n", options.out, done.samples,
             done.head.format, gaze::describe(done.head.coordinates));
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
    options->quality.display = options->log.display;
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
