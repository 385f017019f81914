// macula compare REF TEST
#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "commands.h"
#include "common.h"
#include "engine/measure/compare_files.h"

namespace macula::tools {
namespace {

struct Options {
  std::string reference;
  std::string test;
  std::string json;
  std::string gaze;
  std::string maps;
  measure::CompareOptions compare;
};

void print(const measure::ImageError& error) {
  fmt::print("rmse       {:.6f}\npsnr_db    {}\nmax        {:.6f}\nflip       {:.6f}\n", error.rmse,
             error.psnrDb ? fmt::format("{:.2f}", *error.psnrDb) : "- (identical)", error.max,
             error.flip.value());
  if (error.flipGaze) fmt::print("flip_gaze  {:.6f}\n", *error.flipGaze);
}

void run(const Options& options) {
  measure::CompareOptions compare = options.compare;
  if (!options.gaze.empty()) compare.gaze = parsePlace("--gaze", options.gaze);
  const bool quiet = options.json == "-";
  if (options.maps.empty()) {
    const auto error = measure::compareFiles(options.reference, options.test, compare);
    if (!quiet) print(error);
    writeJson(options.json, measure::toJson(error));
    return;
  }
  const auto [error, maps] =
      measure::compareFilesToMaps(options.reference, options.test, options.maps, compare);
  if (!quiet) {
    print(error);
    const std::string scale =
        maps.differenceWhite == 0.0
            ? "no difference, all black"
            : fmt::format(
                  "absolute differences times {:.4g}; white is {:.4g} (99th percentile) and more",
                  maps.differenceScale, maps.differenceWhite);
    fmt::print("{}: {}\n{}: FLIP 0..1 from black to light yellow{}\n{}: colour bars of both\n",
               maps.difference.string(), scale, maps.flip.string(),
               maps.differenceWhite == 0.0 ? "; no difference" : "", maps.bars.string());
  }
  nlohmann::json json = measure::toJson(error);
  json["maps"] = {{"difference", maps.difference.string()},
                  {"difference_scale", maps.differenceScale},
                  {"difference_white", maps.differenceWhite},
                  {"flip", maps.flip.string()},
                  {"colour_bars", maps.bars.string()}};
  writeJson(options.json, json);
}

}  // namespace

void addCompare(CLI::App& root) {
  auto options = std::make_shared<Options>();
  CLI::App* command = root.add_subcommand("compare", "Errors between two images of one size");
  command->add_option("reference", options->reference, "PNG, EXR or HDR")->required();
  command->add_option("test", options->test, "PNG, EXR or HDR")->required();
  command->add_flag("--hdr", options->compare.hdr, "Compare linear values; FLIP is HDR-FLIP");
  command
      ->add_option("--pixels-per-degree", options->compare.pixelsPerDegree,
                   "Of FLIP and eccentricity (default 67.0206)")
      ->check(CLI::Range(1.0, 1000.0));
  command->add_option("--gaze", options->gaze,
                      "X,Y (0..1 from the top left): also FLIP weighted by acuity around it");
  command
      ->add_option(
          "--maps", options->maps,
          "Write PREFIX_difference.png and PREFIX_flip.png, and PREFIX_scale.svg with their "
          "colour bars")
      ->type_name("PREFIX");
  addJsonOption(*command, options->json);
  command->callback([options] { run(*options); });
}

}  // namespace macula::tools
