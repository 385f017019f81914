// Panels made from the settings registry: what is registered can be seen and changed.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/settings/registry.h"
#include "engine/ui/setting_row.h"

namespace macula::ui {

/// A setting that was changed, and what it was before, so that a change that the machine cannot
/// take can be taken back.
struct SettingChange {
  settings::Entry* entry = nullptr;
  settings::Value before;
  bool cycled = false;  ///< by chooseNext(): any further choice will do as well
  /// The rival (settings::Registry::addRivals()) that went back to its default, so that the change
  /// takes effect; null: none had to.
  settings::Entry* rival = nullptr;
  settings::Value rivalBefore = false;
  void undo() const;
  /// "oit.memoryMiB is 0 again: oit.kAve holds in its place"; empty without a rival.
  [[nodiscard]] std::string rivalNote() const;
  /// Where the present choice cannot be used: sets the one after it.
  /// @returns false where all were tried; the setting is then what it was before
  [[nodiscard]] bool advance() const;
};

class SettingsPanel {
 public:
  /// @param registry must outlive the panel
  /// @param fixed keys that are shown but cannot be changed while the program runs
  explicit SettingsPanel(settings::Registry& registry, std::vector<std::string> fixed = {});

  /// Name and widget of one setting over the width of the current window. The tooltip holds help,
  /// range, default and option; a right click takes the default.
  /// @param key a key of the registry
  void row(const std::string& key);
  /// A field for words, and below it all settings that hold them, or else every group under a
  /// heading that is closed at first.
  /// @param only names of the groups that are shown; empty: all
  void searchableGroups(std::span<const std::string_view> only = {});
  /// The text of the search field.
  void search(std::string text) { query_ = std::move(text); }
  /// Moves the keyboard into the search field when it is drawn next.
  void focusSearch() { focusSearch_ = true; }
  /// Number of settings that the search found; none where nothing is searched.
  [[nodiscard]] std::optional<int> hits() const { return hits_; }

  /// Sets the next of the choices of a setting, the first after the last.
  void chooseNext(const std::string& key);

  /// Sets from "key=value"; a refused value is noted as if it came from a widget.
  /// @throws InputError where the setting is unknown or there is no '='
  void assign(std::string_view assignment);

  /// The last change since the previous call.
  [[nodiscard]] std::optional<SettingChange> takeChange();
  /// Why the last value was refused; empty after one that was taken.
  [[nodiscard]] const std::string& refusal() const { return refusal_; }
  void setRefusal(std::string text) { refusal_ = std::move(text); }

 private:
  void row(settings::Entry& entry);
  void groupRows(const std::string& group, bool matchesOnly);
  void change(settings::Entry& entry, const settings::Value& value);
  template <typename Setter>
  void tryToSet(settings::Entry& entry, Setter&& setter);
  [[nodiscard]] bool isFixed(const settings::Entry& entry) const;

  settings::Registry& registry_;
  std::vector<std::string> fixed_;
  PendingEdit pending_;
  std::optional<SettingChange> change_;
  std::string refusal_;
  std::string query_;
  std::optional<int> hits_;
  bool focusSearch_ = false;
};

/// Whether every word of a query stands in the setting's key, alias, unit, help or choices, without
/// regard to case. An empty query matches all.
[[nodiscard]] bool matchesQuery(const settings::Entry& entry, std::string_view query);

}  // namespace macula::ui
