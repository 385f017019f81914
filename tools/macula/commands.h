// The subcommands. Each adds itself to the command line and runs when it is named.
#pragma once

#include <CLI/CLI.hpp>

namespace macula::tools {

void addChart(CLI::App& root);
void addCompare(CLI::App& root);
void addDevices(CLI::App& root);
void addFeatures(CLI::App& root);
void addGaze(CLI::App& root);
/// @param gaze what addGaze() added
void addGazeStudy(CLI::App& gaze);
void addHold(CLI::App& root);
void addReplay(CLI::App& root);
void addScene(CLI::App& root);
#ifdef MACULA_WINDOW
void addWalk(CLI::App& root);
#endif

}  // namespace macula::tools
