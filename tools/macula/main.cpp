// macula: walk, replay, chart, compare, features, gaze, hold, scene, devices.
#include <cstdio>
#include <exception>
#include <new>

#include "commands.h"
#include "common.h"
#include "engine/core/error.h"
#include "engine/core/interrupt.h"
#include "engine/settings/command_line.h"
#include "macula_version.h"

namespace {

constexpr int kDifference = 1;
constexpr int kBadInput = 2;  ///< what a user can fix
constexpr int kFault = 3;     ///< a fault of Macula or of the driver

}  // namespace

int main(int argc, char** argv) {
  try {
    CLI::App root(
        "Deferred shading whose frame follows the eye: order-independent transparency under "
        "a budget, gaze-log replay, walkthrough.",
        "macula");
    root.require_subcommand(1);
    root.set_version_flag("--version", "macula " MACULA_VERSION " (" MACULA_COMMIT ")");
#ifdef MACULA_WINDOW
    macula::tools::addWalk(root);
#endif
    macula::tools::addReplay(root);
    macula::tools::addChart(root);
    macula::tools::addCompare(root);
    macula::tools::addFeatures(root);
    macula::tools::addGaze(root);
    macula::tools::addGazeStudy(*root.get_subcommand("gaze"));
    macula::tools::addHold(root);
    macula::tools::addScene(root);
    macula::tools::addDevices(root);
    macula::settings::parseCommandLine(root, argc, argv);
    return 0;
  } catch (const macula::tools::Difference& error) {
    std::fprintf(stderr, "macula: %s\n", macula::oneLine(error.what()).c_str());
    return kDifference;
  } catch (const macula::Interrupted& interrupted) {
    std::fprintf(stderr, "macula: %s\n", macula::oneLine(interrupted.what()).c_str());
    return macula::kInterruptedStatus;
  } catch (const macula::InputError& error) {
    std::fprintf(stderr, "macula: %s\n", error.what());
    return kBadInput;
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "macula: out of memory; use a smaller scene or --size\n");
    return kBadInput;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "macula: fault: %s\n", macula::oneLine(error.what()).c_str());
    return kFault;
  }
}
