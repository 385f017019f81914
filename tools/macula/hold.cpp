// The command line of `macula hold`.
#include "hold.h"

#include <memory>

#include "commands.h"

namespace macula::tools {

void addHold(CLI::App& root) {
  auto o = std::make_shared<HoldOptions>();
  CLI::App* command = root.add_subcommand("hold", "Holds a frame time, and measures how well");
  command->add_flag("--plant", o->plant, "Every control law on a made-up GPU, without a scene")
      ->required();
  command->add_option("--target-ms", o->targetMs, "Frame time to hold (default 16.667)")
      ->check(CLI::Range(0.01, 10000.0));
  command->add_option("--seeds", o->seeds, "Runs of each law on each case (default 20)")
      ->check(CLI::Range(1, 1000));
  command->add_option("--out", o->out, "Folder for results.csv, results.json and report.html");
  addJsonOption(*command, o->json);
  command->callback([o] { holdPlant(*o); });
}

}  // namespace macula::tools
