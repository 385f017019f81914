// The one table of actions: their keys, their names in scripts and the words of the help page.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "walk/request.h"

namespace macula::tools {

struct ActionRow {
  Action action;
  std::string_view argument;  ///< that the key gives
  int key;                    ///< of GLFW; 0: none
  std::string_view keyName;   ///< as help and scripts say it
  std::string_view group;     ///< heading of the help page; empty: not on it
  std::string_view help;
};

/// Rows of a group stand together.
[[nodiscard]] std::span<const ActionRow> actionRows();

/// Camera keys that are held down and thus are no actions: names and what they do.
struct HeldKeyRow {
  std::string_view keys;
  std::string_view help;
};
[[nodiscard]] std::span<const HeldKeyRow> heldKeyRows();

/// What a key asks for. @param keyName as in the table, without regard to case
[[nodiscard]] std::optional<Request> requestOfKey(std::string_view keyName);

/// The action that a script calls by this name: "load", "drop", "set".
[[nodiscard]] std::optional<Action> actionByName(std::string_view name);
/// All names of actionByName(), for messages.
[[nodiscard]] std::vector<std::string> actionNames();

}  // namespace macula::tools
