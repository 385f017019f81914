// The command line of `macula walk`.
#include <memory>

#include "commands.h"
#include "common.h"
#include "engine/scene/load.h"
#include "engine/settings/command_line.h"
#include "walk/options.h"
#include "walk/panels.h"

namespace macula::tools {

void addWalk(CLI::App& root) {
  constexpr int kMaxFrames = 1000000;
  constexpr double kLeastScale = 0.5;
  constexpr double kMostScale = 4.0;
  auto o = std::make_shared<WalkOptions>();
  o->scene = scene::kDefaultScene;
  passes::registerSettings(o->registry, o->settings);
  gaze::registerSettings(o->registry, o->gazeSettings);
  o->settings.foveation.display = &o->gazeSettings.display;
  CLI::App* command = root.add_subcommand("walk", "Walk through a scene in a window");
  command->add_option("scene", o->scene, "File (.gltf, .glb) or procedural name (default gallery)");
  command->add_option("--size", o->size, "Of the window (default 1280x720)")
      ->type_name("WIDTHxHEIGHT");
  command
      ->add_option(
          "--gaze", o->gaze,
          "Where the viewer looks: mouse, center, x,y (0..1), a log file, which plays in real "
          "time, "
          "or an eye tracker: hid, hid:VENDOR:PRODUCT[:SERIAL], hid:SERIAL, hid:PROFILE.toml "
          "(default mouse)")
      ->type_name("GAZE");
  command
      ->add_option(
          "--camera", o->camera,
          "auto (plays an orbit), scene (the file's first camera), or a path file or recording "
          "to play")
      ->type_name("CAMERA");
  command->add_option("--frames", o->frames, "Close after this many; 0: stay open (default 0)")
      ->check(CLI::Range(0, kMaxFrames));
  command->add_flag("--no-panels", o->hidePanels, "Begin with the panels hidden (F1 shows them)");
  command->add_option("--panel", o->panel, "The tab that is open at first (default view)")
      ->check(CLI::IsMember(tabNames()));
  command
      ->add_option("--ui-scale", o->uiScale,
                   "Of the panels' text, 0.5 to 4 (default: what the monitor says)")
      ->check(CLI::Range(kLeastScale, kMostScale));
  command
      ->add_option("--script", o->script,
                   "Lines of FRAME ACTION [ARGUMENT], done at these frames, as 2 press F2")
      ->type_name("FILE");
  command->add_option("--screenshot", o->screenshot, "Write the window after the last frame (PNG)")
      ->type_name("FILE.png");
  CLI::Option* record =
      command->add_option("--record", o->record, "Record the walk into this new folder")
          ->type_name("DIR");
  command
      ->add_flag("--record-hashes", o->recordHashes,
                 "Also the SHA-256 of each image, which a replay then compares")
      ->needs(record);
  command
      ->add_option("--probe", o->probes,
                   "Report the mean k around this place, 0..1 from the top left; repeatable")
      ->type_name("X,Y")
      ->allow_extra_args(false);  // a scene may follow
  addJsonOption(*command, o->json);
  control::registerSettings(o->registry, o->control);
  settings::addOptions(*command, o->registry);
  command->callback([o, command] {
    settings::applyOptions(*command, o->registry);
    walk(*o);
  });
}

}  // namespace macula::tools
