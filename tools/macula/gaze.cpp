// macula gaze info FILE, macula gaze convert FILE --out F.csv
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "commands.h"
#include "common.h"
#include "engine/core/file.h"
#include "engine/gaze/log.h"
#include "engine/gaze/quality.h"

namespace macula::tools {
namespace {

struct Options {
  std::string file;
  std::string format;
  std::string out;
  std::string json;
};

gaze::GazeLog read(const Options& options) {
  return gaze::readGazeLog(options.file, options.format.empty()
                                             ? std::nullopt
                                             : std::optional<std::string>(options.format));
}

void info(const Options& options) {
  const gaze::GazeLog log = read(options);
  const gaze::GazeQuality quality = gaze::assess(log);
  if (options.json != "-") {
    fmt::print("format           {}\n", log.format);
    fmt::print("coordinates      {}, origin {}{}\n", log.coordinates.unit, log.coordinates.origin,
               log.coordinates.screenPixels
                   ? fmt::format(", screen {:.0f}x{:.0f}", log.coordinates.screenPixels->x,
                                 log.coordinates.screenPixels->y)
                   : "");
    fmt::print("samples          {}\nlost             {}\nrate             {:.2f} Hz\n",
               quality.samples, quality.lost, quality.rateHz);
    fmt::print("duration         {:.3f} s\nlongest dropout  {:.3f} s\noff screen       {}\n",
               quality.durationSeconds, quality.longestDropoutSeconds, quality.offScreen);
    fmt::print("other rows       {} event, {} truncated\n", log.counters.eventRows,
               log.counters.truncatedRows);
    fmt::print("times            {} duplicate, {} backward\n", log.counters.duplicateTimes,
               log.counters.backwardTimes);
  }
  writeJson(options.json, {{"format", log.format},
                           {"samples", quality.samples},
                           {"lost", quality.lost},
                           {"rate_hz", quality.rateHz},
                           {"duration_s", quality.durationSeconds},
                           {"longest_dropout_s", quality.longestDropoutSeconds},
                           {"off_screen", quality.offScreen}});
}

void convert(const Options& options) {
  const gaze::GazeLog log = read(options);
  writeFileAtomically(options.out, gaze::canonicalCsv(log));
  fmt::print("{}: {} samples of {} written\n", options.out, log.samples.size(), log.format);
}

void addFormat(CLI::App& command, const std::shared_ptr<Options>& options) {
  command.add_option("--format", options->format, "Take the file for this format")
      ->check(CLI::IsMember(gaze::gazeFormatNames()));
}

}  // namespace

void addGaze(CLI::App& root) {
  auto options = std::make_shared<Options>();
  CLI::App* command = root.add_subcommand("gaze", "Look at and convert recorded gaze logs");
  command->require_subcommand(1);
  CLI::App* infoCommand = command->add_subcommand("info", "Format, rate, losses");
  infoCommand->add_option("file", options->file, "Gaze log")->required();
  addFormat(*infoCommand, options);
  addJsonOption(*infoCommand, options->json);
  infoCommand->callback([options] { info(*options); });
  CLI::App* convertCommand = command->add_subcommand("convert", "Write Macula's canonical CSV");
  convertCommand->add_option("file", options->file, "Gaze log")->required();
  convertCommand->add_option("--out", options->out, "CSV file")->required();
  addFormat(*convertCommand, options);
  convertCommand->callback([options] { convert(*options); });
}

}  // namespace macula::tools
