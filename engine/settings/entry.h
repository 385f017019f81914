// One setting: a field of the program with its name, unit, range, help and default.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/settings/binding.h"
#include "engine/settings/value.h"

namespace macula::settings {

/// What takes effect how, where a setting changes between two frames.
enum class Effect : std::uint8_t {
  DropsHistory,  ///< the next frame is drawn without history: what most settings need
  ReloadsScene,  ///< goes into the scene while it is loaded, which is done again
  ReopensGaze,   ///< goes into the source of gaze, which is opened again
  Immediate,     ///< is looked at in each frame; nothing has to be done
};

/// The words of a setting, written where it is registered.
struct Description {
  std::string key = {};    ///< dotted, unique: "oit.kAve"
  std::string alias = {};  ///< short name, unique, may be empty: "k-ave"
  std::string unit = {};   ///< "fragments/pixel"; empty for pure numbers
  std::string help = {};   ///< one line
  std::string group = {};  ///< heading of panel and help; empty: the part of the key before its dot
  bool share = false;      ///< a share of a whole: percentages are refused with the number to write
  std::optional<Effect> effect = {};  ///< none: that of its group, see Registry::setGroupEffect()
};

/// A registered setting. Panels and help read it; every way of setting it goes through set() or
/// setText(), which check the value first and leave the field alone where it is refused.
class Entry {
 public:
  /// @throws std::logic_error where the field's present value, the default, is out of range.
  Entry(Description description, Binding binding, Range range, std::vector<std::string> choices);

  [[nodiscard]] const std::string& key() const { return description_.key; }
  [[nodiscard]] const std::string& alias() const { return description_.alias; }
  [[nodiscard]] const std::string& unit() const { return description_.unit; }
  [[nodiscard]] const std::string& help() const { return description_.help; }
  [[nodiscard]] const std::string& group() const { return description_.group; }
  [[nodiscard]] Effect effect() const { return description_.effect.value_or(Effect::DropsHistory); }
  [[nodiscard]] Type type() const { return binding_.type; }
  /// For Int, Real and Colour: bounds after the field's own limits; may be infinite.
  [[nodiscard]] const Range& range() const { return range_; }
  /// For Choice, and for an Int that takes only some numbers; else empty.
  [[nodiscard]] const std::vector<std::string>& choices() const { return choices_; }
  [[nodiscard]] const Value& defaultValue() const { return default_; }
  /// The option as a user types it: "--k-ave" if there is an alias, else "--oit.kAve".
  [[nodiscard]] std::string option() const;
  /// What it takes, without the unit: "a number > 0 and <= 4096", "one of blend, ab-sbuffer".
  [[nodiscard]] std::string allowed() const;

  [[nodiscard]] Value get() const { return binding_.get(); }
  [[nodiscard]] bool isDefault() const { return get() == default_; }
  void reset();
  /// Where it was set last, as the message of a refusal would begin; empty: nowhere, or reset().
  [[nodiscard]] const std::string& setAt() const { return setAt_; }

  /// Checks and sets. A whole number is taken for a Real, and what toBool() takes for a Bool;
  /// otherwise the alternative must be right.
  /// @param where begins the message: an option, a key, or a file and line
  /// @throws InputError naming the setting, the value and what is allowed.
  void set(const Value& value, std::string_view where);
  void set(const Value& value) { set(value, key()); }
  /// The same from text as typed on a command line.
  void setText(std::string_view text, std::string_view where);

 private:
  /// A value as the field would hold it, or why it cannot: the end of "'7' ...".
  struct Checked {
    Value value = false;
    std::string refusal = {};  ///< empty where the value is taken
  };

  [[nodiscard]] Checked check(const Value& value) const;
  [[nodiscard]] Checked checkInt(const Value& value) const;
  [[nodiscard]] Checked checkReal(const Value& value) const;
  [[nodiscard]] Checked checkColour(const Value& value) const;
  [[nodiscard]] Checked checkText(const Value& value) const;
  [[nodiscard]] Checked parse(std::string_view text) const;
  /// Sets, or throws with the value as it was `shown`.
  void assign(const Checked& checked, std::string_view shown, std::string_view where);

  Description description_;
  Binding binding_;
  Range range_;
  std::vector<std::string> choices_;
  Value default_;
  std::string setAt_;
};

}  // namespace macula::settings
