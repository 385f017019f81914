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
  measure::CompareOptions compare;
};

std::string shown(const std::optional<double>& value) {
  return value ? fmt::format("{:.6f}", *value) : "-";
}

void run(const Options& options) {
  const measure::ImageError error =
      measure::compareFiles(options.reference, options.test, options.compare);
  if (options.json != "-") {
    fmt::print("rmse     {:.6f}\npsnr_db  {}\nmax      {:.6f}\nflip     {}\n", error.rmse,
               error.psnrDb ? fmt::format("{:.2f}", *error.psnrDb) : "- (identical)", error.max,
               shown(error.flip));
  }
  writeJson(options.json, measure::toJson(error));
}

}  // namespace

void addCompare(CLI::App& root) {
  auto options = std::make_shared<Options>();
  CLI::App* command = root.add_subcommand("compare", "Errors between two images of one size");
  command->add_option("reference", options->reference, "PNG, EXR or HDR")->required();
  command->add_option("test", options->test, "PNG, EXR or HDR")->required();
  command->add_flag("--hdr", options->compare.hdr, "Compare linear values");
  command
      ->add_option("--pixels-per-degree", options->compare.pixelsPerDegree,
                   "Of FLIP (default 67.0206)")
      ->check(CLI::Range(1.0, 1000.0));
  addJsonOption(*command, options->json);
  command->callback([options] { run(*options); });
}

}  // namespace macula::tools
