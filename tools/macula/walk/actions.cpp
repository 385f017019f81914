#include "walk/actions.h"

#define GLFW_INCLUDE_NONE  // OpenGL is declared by the loader
#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace macula::tools {
namespace {

constexpr std::string_view kWindow = "Window";
constexpr std::string_view kPicture = "Picture";
constexpr std::string_view kGaze = "Gaze";
constexpr std::string_view kCamera = "Camera";
constexpr std::string_view kFiles = "Files";

constexpr std::array kRows{
    ActionRow{Action::TogglePanels, "", GLFW_KEY_F1, "F1", kWindow, "panels on and off"},
    ActionRow{Action::ToggleHelp, "", GLFW_KEY_F2, "F2", kWindow, "these keys"},
    ActionRow{Action::ShowTab, "view", GLFW_KEY_F3, "F3", kWindow, "view: method, heat map"},
    ActionRow{Action::ShowTab, "scene", GLFW_KEY_F4, "F4", kWindow, "scenes"},
    ActionRow{Action::ShowTab, "gaze", GLFW_KEY_F5, "F5", kWindow, "gaze source"},
    ActionRow{Action::ShowTab, "camera", GLFW_KEY_F6, "F6", kWindow, "camera path"},
    ActionRow{Action::ShowTab, "compare", GLFW_KEY_F7, "F7", kWindow, "two methods, errors"},
    ActionRow{Action::ShowTab, "settings", GLFW_KEY_F8, "F8", kWindow, "all settings"},
    ActionRow{Action::ToggleNumbers, "", GLFW_KEY_F9, "F9", kWindow, "times and numbers"},
    ActionRow{Action::Search, "", GLFW_KEY_SLASH, "/", kWindow, "search the settings"},
    ActionRow{Action::Close, "", GLFW_KEY_ESCAPE, "Esc", kWindow, "close, cancel"},
    ActionRow{Action::Quit, "", 0, "Ctrl Q", kWindow, "leave"},
    ActionRow{Action::NextMethod, "", GLFW_KEY_M, "M", kPicture, "next method"},
    ActionRow{Action::NextHeatmap, "", GLFW_KEY_H, "H", kPicture, "next heat map"},
    ActionRow{Action::View, "", GLFW_KEY_B, "B", kPicture,
              "two methods: split, side by side, "
              "difference, off"},
    ActionRow{Action::ScaleDifference, "down", GLFW_KEY_COMMA, ",", kPicture,
              "smaller differences hot"},
    ActionRow{Action::ScaleDifference, "up", GLFW_KEY_PERIOD, ".", kPicture,
              "only larger ones hot"},
    ActionRow{Action::Measure, "exact", GLFW_KEY_X, "X", kPicture, "error against the exact image"},
    ActionRow{Action::ShowMap, "", GLFW_KEY_Z, "Z", kPicture, "map of that error"},
    ActionRow{Action::NextGaze, "", GLFW_KEY_G, "G", kGaze, "next source"},
    ActionRow{Action::ToggleCursor, "", GLFW_KEY_V, "V", kGaze, "gaze and fovea drawn or hidden"},
    ActionRow{Action::ResetCamera, "", GLFW_KEY_R, "R", kCamera, "back to the start"},
    ActionRow{Action::PlayPath, "", GLFW_KEY_P, "P", kCamera, "play the path, or stop"},
    ActionRow{Action::RecordPath, "", GLFW_KEY_L, "L", kCamera, "record a path, or end it"},
    ActionRow{Action::Exr, "", GLFW_KEY_F11, "F11", kFiles, "EXR picture, linear"},
    ActionRow{Action::Png, "", GLFW_KEY_F12, "F12", kFiles, "PNG picture, without panels"},
    ActionRow{Action::CopyCommand, "", GLFW_KEY_C, "C", kFiles, "copy as command line"},
};

constexpr std::array kHeld{
    HeldKeyRow{"W A S D", "fly"},
    HeldKeyRow{"Q E", "down, up"},
    HeldKeyRow{"Shift", "faster"},
    HeldKeyRow{"wheel", "speed"},
    HeldKeyRow{"right button", "look around; arrows too"},
};

struct NamedAction {
  std::string_view name;
  Action action;
};

constexpr std::array kNames{
    NamedAction{"panels", Action::TogglePanels},
    NamedAction{"help", Action::ToggleHelp},
    NamedAction{"tab", Action::ShowTab},
    NamedAction{"numbers", Action::ToggleNumbers},
    NamedAction{"search", Action::Search},
    NamedAction{"close", Action::Close},
    NamedAction{"quit", Action::Quit},
    NamedAction{"method", Action::NextMethod},
    NamedAction{"heatmap", Action::NextHeatmap},
    NamedAction{"set", Action::Set},
    NamedAction{"set-second", Action::SetSecond},
    NamedAction{"scene", Action::LoadScene},
    NamedAction{"drop", Action::Drop},
    NamedAction{"reset", Action::ResetCamera},
    NamedAction{"record", Action::RecordPath},
    NamedAction{"play", Action::PlayPath},
    NamedAction{"gaze", Action::GazeSource},
    NamedAction{"next-gaze", Action::NextGaze},
    NamedAction{"cursor", Action::ToggleCursor},
    NamedAction{"view", Action::View},
    NamedAction{"scale", Action::ScaleDifference},
    NamedAction{"measure", Action::Measure},
    NamedAction{"map", Action::ShowMap},
    NamedAction{"png", Action::Png},
    NamedAction{"exr", Action::Exr},
    NamedAction{"copy", Action::CopyCommand},
};

bool equalIgnoringCase(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) {
    return std::tolower(static_cast<unsigned char>(x)) ==
           std::tolower(static_cast<unsigned char>(y));
  });
}

}  // namespace

std::span<const ActionRow> actionRows() {
  return kRows;
}

std::span<const HeldKeyRow> heldKeyRows() {
  return kHeld;
}

std::optional<Request> requestOfKey(std::string_view keyName) {
  for (const ActionRow& row : kRows) {
    if (equalIgnoringCase(row.keyName, keyName)) {
      return Request{row.action, std::string(row.argument)};
    }
  }
  return {};
}

std::optional<Action> actionByName(std::string_view name) {
  const auto found =
      std::find_if(kNames.begin(), kNames.end(), [&](const auto& row) { return row.name == name; });
  return found == kNames.end() ? std::nullopt : std::optional(found->action);
}

std::vector<std::string> actionNames() {
  std::vector<std::string> names;
  for (const NamedAction& row : kNames) names.emplace_back(row.name);
  return names;
}

}  // namespace macula::tools
