// The command line of `macula replay`.
#include <algorithm>
#include <array>
#include <string_view>

#include "commands.h"
#include "common.h"
#include "engine/settings/command_line.h"
#include "replay.h"

namespace macula::tools {

namespace {

/// What can be asked of a recording; everything else it answers itself.
bool goesWithRecording(const CLI::Option& option) {
  constexpr std::array<std::string_view, 10> kNames{
      "scene", "--out",  "--force",    "--images", "--reference",
      "--hdr", "--json", "--platform", "--help",   "--pixels-per-degree"};
  return std::find(kNames.begin(), kNames.end(), option.get_name()) != kNames.end();
}

}  // namespace

void addReplay(CLI::App& root) {
  constexpr int kMaxFrames = 1000000;
  auto o = std::make_shared<ReplayOptions>();
  passes::registerSettings(o->registry, o->settings);
  gaze::registerSettings(o->registry, o->gazeSettings);
  o->settings.foveation.display = &o->gazeSettings.display;
  CLI::App* command =
      root.add_subcommand("replay", "Headless, deterministic frames along a gaze log and a camera");
  command
      ->add_option("scene", o->scene,
                   "File (.gltf, .glb), procedural name, or the folder of a recording")
      ->required();
  command->add_option("--gaze", o->gaze, "center, x,y (0..1) or a log file (default center)");
  command->add_option("--camera", o->camera,
                      "auto, scene, a path file or a recording (default auto)");
  command->add_option("--frames", o->frames, "Number of frames (default 60)")
      ->check(CLI::Range(1, kMaxFrames));
  command->add_option("--size", o->size, "WIDTHxHEIGHT (default 1024x1024)");
  addOutOption(*command, o->out, o->force, "Folder for report.json and images")->required();
  command->add_option("--images", o->images, "Also write each frame")
      ->check(CLI::IsMember({"png", "exr"}));
  command->add_flag("--reference", o->reference,
                    "Draw ab-sbuffer beside each frame and report errors");
  command->add_flag("--hdr", o->hdr, "Errors on linear values, HDR-FLIP");
  command->add_option("--fps", o->fps, "Frame i is at i / fps (default 60)")
      ->check(CLI::Range(0.001, 100000.0));
  command->add_option("--warmup", o->warmup, "Frames before frame 0, not reported (default 3)")
      ->check(CLI::Range(0, 1000));
  command
      ->add_option("--pixels-per-degree", o->pixelsPerDegree,
                   "Of FLIP and eccentricity (default 67.0206)")
      ->check(CLI::Range(1.0, 1000.0));
  addPlatformOption(*command, o->platform);
  addJsonOption(*command, o->json);
  settings::addOptions(*command, o->registry);
  command->callback([o, command] {
    settings::applyOptions(*command, o->registry);
    for (const CLI::Option* option : command->get_options()) {
      if (option->count() > 0 && !goesWithRecording(*option)) {
        o->answeredByRecording.push_back(option->get_name());
      }
    }
    replay(*o);
  });
}

}  // namespace macula::tools
