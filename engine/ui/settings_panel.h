// Panels made from the settings registry: what is registered can be seen and changed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/settings/registry.h"
#include "engine/ui/setting_row.h"

namespace macula::ui {

/// A setting that was changed, and what it was before, so that a change that the machine cannot
/// take can be taken back.
struct SettingChange {
  settings::Entry* entry = nullptr;
  settings::Value before;
  void undo() const { entry->set(before); }
};

class SettingsPanel {
 public:
  /// @param registry must outlive the panel
  /// @param fixed keys that are shown but cannot be changed while the program runs
  SettingsPanel(settings::Registry& registry, std::vector<std::string> fixed);

  /// Name and widget of one setting over the width of the current window. The tooltip holds help,
  /// range, default and option; a right click takes the default.
  /// @param key a key of the registry
  void row(const std::string& key);
  /// All settings under a heading for each group, closed at first.
  void groups();

  /// Sets the next of the choices of a setting, the first after the last.
  void chooseNext(const std::string& key);

  /// The last change since the previous call.
  [[nodiscard]] std::optional<SettingChange> takeChange();
  /// Why the last value was refused; empty after one that was taken.
  [[nodiscard]] const std::string& refusal() const { return refusal_; }
  void setRefusal(std::string text) { refusal_ = std::move(text); }

 private:
  void row(settings::Entry& entry);
  void change(settings::Entry& entry, const settings::Value& value);
  [[nodiscard]] bool isFixed(const settings::Entry& entry) const;

  settings::Registry& registry_;
  std::vector<std::string> fixed_;
  PendingEdit pending_;
  std::optional<SettingChange> change_;
  std::string refusal_;
};

}  // namespace macula::ui
