// The one list of all settings. A setting is registered once and thereby appears on the command
// line, in TOML files, behind --set, in the panels and in reports.
#pragma once

#include <deque>
#include <functional>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "engine/settings/entry.h"

namespace macula::settings {

/// Holds references to the registered fields, which must outlive it. Registering wrongly (a name
/// taken twice, a default out of range) is a mistake in the program: std::logic_error.
class Registry {
 public:
  Registry() = default;
  Registry(const Registry&) = delete;
  Registry& operator=(const Registry&) = delete;
  ~Registry() = default;

  /// Registers a field of any type that bindField() knows; its present value is the default.
  ///   registry.add({.key = "oit.kAve", .alias = "k-ave", .unit = "fragments/pixel", .help =
  ///   "..."},
  ///                settings.kAve, Range{.min = 0, .minExclusive = true, .max = 4096});
  template <typename Field>
  Entry& add(Description description, Field& field, Range range = {}) {  // NOLINT: it is moved
    return insert(std::move(description), bindField(field), range, {});
  }

  /// A string that is one of `choices`.
  Entry& addChoice(Description description, std::string& field, std::vector<std::string> choices);
  /// A number that is an index into `choices`.
  Entry& addChoice(Description description, int& field, std::vector<std::string> choices);
  /// An enumeration whose enumerators are 0, 1, ... in the order of `choices`.
  template <typename Enum, typename = std::enable_if_t<std::is_enum_v<Enum>>>  // NOLINTNEXTLINE
  Entry& addChoice(Description description, Enum& field, std::vector<std::string> choices) {
    return insertIndexed(
        std::move(description), [&field] { return static_cast<std::size_t>(field); },
        [&field](std::size_t index) { field = static_cast<Enum>(index); }, std::move(choices));
  }
  /// A number that is one of `numbers`, for example 1, 2 or 4 samples.
  Entry& addNumberChoice(Description description, int& field, const std::vector<int>& numbers);

  /// What settings of a group do that are registered from now on and state no effect themselves.
  void setGroupEffect(std::string_view group, Effect effect);

  /// Two registered settings that say the same thing in different terms, so that a user gives one.
  /// @param standing holds where the other is left alone
  /// @param overriding wins where it is not its default
  void addRivals(std::string_view standing, std::string_view overriding);
  /// @throws InputError naming the places where both of two rivals were given, and what remains
  ///   where either is dropped
  void checkRivals() const;
  /// The rival that would hide a setting's present value, or be hidden by it: null where there is
  /// none, or it is its default.
  [[nodiscard]] Entry* rivalOf(const Entry& entry);

  /// In the order of registration. References to entries stay valid.
  [[nodiscard]] std::deque<Entry>& entries() { return entries_; }
  [[nodiscard]] const std::deque<Entry>& entries() const { return entries_; }

  /// The entry with this key or alias, or null.
  [[nodiscard]] Entry* find(std::string_view name);
  [[nodiscard]] const Entry* find(std::string_view name) const;
  /// @param where begins the message: an option or a file and line
  /// @throws InputError naming the nearest known setting.
  [[nodiscard]] Entry& at(std::string_view name, std::string_view where);

  /// Sets by key or alias from text. @throws InputError, see at() and Entry::set().
  void setText(std::string_view name, std::string_view text, std::string_view where);
  /// Sets from "key=value". @throws InputError, also where there is no '='.
  void setAssignment(std::string_view assignment, std::string_view where);
  /// All settings back to their defaults.
  void reset();

  /// Every key, then every alias.
  [[nodiscard]] std::vector<std::string> names() const;
  /// One flat object, dotted key to value; choices and paths as text, a colour as [r, g, b].
  [[nodiscard]] nlohmann::json toJson() const;

 private:
  Entry& insert(Description description, Binding binding, Range range,
                std::vector<std::string> choices);
  Entry& insertIndexed(Description description, std::function<std::size_t()> get,
                       std::function<void(std::size_t)> set, std::vector<std::string> choices);

  struct Rivals {
    Entry* standing;
    Entry* overriding;
  };

  std::deque<Entry> entries_;
  std::map<std::string, Effect, std::less<>> groupEffects_;
  std::vector<Rivals> rivals_;
};

}  // namespace macula::settings
