// The command line of `macula hold`.
#include "hold.h"

#include <charconv>
#include <memory>

#include "commands.h"
#include "engine/core/error.h"
#include "engine/settings/command_line.h"

namespace macula::tools {
namespace {

constexpr int kMostTimes = 64;

void addSceneOptions(CLI::App& command, HoldOptions& o) {
  constexpr int kLeastFrames = 30;
  constexpr int kMostFrames = 1000000;
  command.add_option("--gaze", o.gaze, "center, x,y (0..1) or a log file (default center)");
  command.add_option("--camera", o.camera,
                     "auto, scene, a path file or a recording (default auto)");
  command.add_option("--frames", o.frames, "Number of frames (default 300)")
      ->check(CLI::Range(kLeastFrames, kMostFrames));
  command.add_option("--size", o.size, "WIDTHxHEIGHT (default 640x360)");
  command.add_option("--fps", o.fps, "Frame i is at i / fps of the path (default 60)")
      ->check(CLI::Range(0.001, 100000.0));
  command
      .add_option("--warmup", o.warmup,
                  "Frames by which each load is measured at first (default 8)")
      ->check(CLI::Range(1, 1000));
  command
      .add_option("--load", o.loads,
                  "From FRAME on, shading is computed TIMES over; repeatable (default: 2 from the "
                  "middle on; none: no change)")
      ->type_name("FRAME:TIMES")
      ->allow_extra_args(false);  // a scene may follow
  addPlatformOption(command, o.platform);
}

}  // namespace

std::vector<LoadStep> parseLoads(const std::vector<std::string>& texts, int frames) {
  if (texts.empty()) return {{static_cast<std::size_t>(frames / 2), 2}};
  std::vector<LoadStep> steps;
  for (const std::string& text : texts) {
    if (text == "none") {
      if (texts.size() == 1) return {};
      failInput("--load: none stands alone; leave out the others");
    }
    LoadStep step;
    const char* end = text.data() + text.size();
    const auto frame = std::from_chars(text.data(), end, step.frame);
    const bool colon = frame.ec == std::errc{} && frame.ptr != end && *frame.ptr == ':';
    const auto times = colon ? std::from_chars(frame.ptr + 1, end, step.times) : frame;
    if (!colon || times.ec != std::errc{} || times.ptr != end || step.times < 1 ||
        step.times > kMostTimes) {
      failInput("--load: '{}' is no step; give FRAME:TIMES with 1 to {} times, as 150:2, or none",
                oneLine(text), kMostTimes);
    }
    if (step.frame >= static_cast<std::size_t>(frames)) {
      failInput("--load: frame {} of '{}' is beyond the last; give one below --frames {}",
                step.frame, text, frames);
    }
    if (!steps.empty() && step.frame <= steps.back().frame) {
      failInput("--load: '{}' does not come after frame {}; give steps in their order", text,
                steps.back().frame);
    }
    steps.push_back(step);
  }
  return steps;
}

void addHold(CLI::App& root) {
  constexpr double kLeastShare = 0.1;
  constexpr double kMostShare = 2.0;
  auto o = std::make_shared<HoldOptions>();
  o->control.law = "macula";
  passes::registerSettings(o->registry, o->settings);
  gaze::registerSettings(o->registry, o->gazeSettings);
  o->settings.foveation.display = &o->gazeSettings.display;
  control::registerSettings(o->registry, o->control);
  CLI::App* command = root.add_subcommand("hold", "Holds a frame time, and measures how well");
  CLI::Option* scene =
      command->add_option("scene", o->scene, "File (.gltf, .glb) or procedural name");
  CLI::Option* plant =
      command
          ->add_flag("--plant", o->plant, "Every control law on a simulated GPU, without a scene")
          ->excludes(scene);
  command->add_option("--seeds", o->seeds, "Runs of each law on each case (default 20)")
      ->check(CLI::Range(1, 1000))
      ->needs(plant);
  CLI::Option* share =
      command
          ->add_option("--target-share", o->targetShare,
                       "The target as a share of the time that full rate takes in this run")
          ->check(settings::shareIn({.min = kLeastShare, .max = kMostShare}))
          ->needs(scene);
  addSceneOptions(*command, *o);
  for (const char* name :
       {"--gaze", "--camera", "--frames", "--size", "--fps", "--warmup", "--load", "--platform"}) {
    plant->excludes(command->get_option(name));
  }
  addOutOption(*command, o->out, o->force, "Folder for results.csv, results.json and report.html");
  addJsonOption(*command, o->json);
  settings::addOptions(*command, o->registry);
  share->excludes(command->get_option("--target-ms"));
  command->callback([o, command] {
    settings::applyOptions(*command, o->registry);
    if (o->plant) return holdPlant(*o);
    if (o->scene.empty()) failInput("hold: name a scene, as gallery, or give --plant");
    holdScene(*o);
  });
}

}  // namespace macula::tools
