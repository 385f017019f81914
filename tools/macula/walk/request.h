// What a user can ask for. Keys, buttons, dropped files and scripts all end as requests, which the
// session grants between two frames.
#pragma once

#include <string>
#include <vector>

namespace macula::tools {

enum class Action {
  TogglePanels,
  ToggleHelp,
  ShowTab,  ///< argument: name of a tab
  ToggleNumbers,
  Search,  ///< argument: words, may be empty
  Close,   ///< the uppermost thing that can be closed
  Quit,
  NextMethod,
  NextHeatmap,
  Set,        ///< argument: key=value
  SetSecond,  ///< the same for method B
  LoadScene,  ///< argument: name or file
  Drop,       ///< argument: a file of any kind that is understood
  ResetCamera,
  RecordPath,  ///< begins or ends
  PlayPath,    ///< argument: "auto", a file, or empty for the last; ends what plays
  GazeSource,  ///< argument: as --gaze takes it
  NextGaze,
  ToggleCursor,
  View,             ///< argument: one of viewModeNames(), or empty for the next
  ScaleDifference,  ///< argument: "up" or "down"
  Measure,          ///< argument: "exact" or "second"
  ShowMap,          ///< argument: one of mapNames(), or empty for the next
  Png,              ///< argument: a file, or empty for a numbered one
  Exr,
  CopyCommand,
  Refuse,  ///< says why nothing is done; argument: the reason
};

struct Request {
  Action action;
  std::string argument = {};
};

using Requests = std::vector<Request>;

}  // namespace macula::tools
