#include "engine/settings/registry.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "engine/core/error.h"
#include "engine/core/nearest.h"

namespace macula::settings {
namespace {

/// Longer names are cut before they are compared and shown: no setting's name comes near it.
constexpr std::size_t kShownCharacters = 80;

/// Names must work on a command line, in TOML and in "key=value" without quotes.
bool isName(std::string_view name) {
  const auto isLetter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  return !name.empty() && isLetter(name.front()) && name.back() != '.' &&
         name.find("..") == std::string_view::npos &&
         std::all_of(name.begin(), name.end(), [&](char c) {
           return isLetter(c) || (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '_';
         });
}

nlohmann::json valueJson(const Value& value) {
  struct Convert {
    nlohmann::json operator()(bool flag) const { return flag; }
    nlohmann::json operator()(std::int64_t number) const { return number; }
    nlohmann::json operator()(double number) const { return number; }
    nlohmann::json operator()(const std::string& text) const { return text; }
    nlohmann::json operator()(const glm::vec3& c) const {
      return {shortestDouble(c.r), shortestDouble(c.g), shortestDouble(c.b)};
    }
  };
  return std::visit(Convert{}, value);
}

}  // namespace

Entry& Registry::insert(Description description, Binding binding, Range range,
                        std::vector<std::string> choices) {
  const auto reserve = [&](const std::string& name) {
    if (!isName(name)) throw std::logic_error("'" + name + "' cannot name a setting");
    if (find(name) != nullptr) throw std::logic_error("setting '" + name + "' is there twice");
  };
  reserve(description.key);
  if (!description.alias.empty()) reserve(description.alias);
  if (description.group.empty()) {
    description.group = description.key.substr(0, description.key.find('.'));
  }
  const auto known = groupEffects_.find(description.group);
  if (!description.effect && known != groupEffects_.end()) description.effect = known->second;
  return entries_.emplace_back(std::move(description), std::move(binding), range,
                               std::move(choices));
}

Entry& Registry::insertIndexed(Description description, std::function<std::size_t()> get,
                               std::function<void(std::size_t)> set,
                               std::vector<std::string> choices) {
  if (get() >= choices.size()) {
    throw std::logic_error("setting '" + description.key + "': the default is no choice");
  }
  Binding binding;
  binding.type = Type::Choice;
  // A field that the program itself set beyond the choices shows as empty, never as another one.
  binding.get = [get = std::move(get), choices] {
    const std::size_t index = get();
    return Value{index < choices.size() ? choices[index] : std::string{}};
  };
  binding.set = [set = std::move(set), choices](const Value& value) {
    const auto found = std::find(choices.begin(), choices.end(), std::get<std::string>(value));
    set(static_cast<std::size_t>(found - choices.begin()));
  };
  return insert(std::move(description), std::move(binding), {}, std::move(choices));
}

Entry& Registry::addChoice(Description description, std::string& field,
                           std::vector<std::string> choices) {
  Binding binding = bindField(field);
  binding.type = Type::Choice;
  return insert(std::move(description), std::move(binding), {}, std::move(choices));
}

Entry& Registry::addChoice(Description description, int& field, std::vector<std::string> choices) {
  return insertIndexed(
      std::move(description), [&field] { return static_cast<std::size_t>(field); },
      [&field](std::size_t index) { field = static_cast<int>(index); }, std::move(choices));
}

Entry& Registry::addNumberChoice(Description description, int& field,
                                 const std::vector<int>& numbers) {
  std::vector<std::string> choices;
  for (const int number : numbers) choices.push_back(std::to_string(number));
  return insert(std::move(description), bindField(field), {}, std::move(choices));
}

const Entry* Registry::find(std::string_view name) const {
  if (name.empty()) return nullptr;
  const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) {
    return entry.key() == name || entry.alias() == name;
  });
  return found == entries_.end() ? nullptr : &*found;
}

Entry* Registry::find(std::string_view name) {
  return const_cast<Entry*>(static_cast<const Registry*>(this)->find(name));
}

Entry& Registry::at(std::string_view name, std::string_view where) {
  if (Entry* entry = find(name)) return *entry;
  const std::string_view shown = name.substr(0, kShownCharacters);
  failInput("{}: unknown setting '{}{}'; the nearest is '{}'", where, shown,
            shown.size() < name.size() ? "..." : "", nearestName(shown, names()));
}

void Registry::setText(std::string_view name, std::string_view text, std::string_view where) {
  at(name, where).setText(text, where);
}

void Registry::setAssignment(std::string_view assignment, std::string_view where) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string_view::npos) {
    failInput("{}: '{}' has no '='; write it as key=value", where,
              assignment.substr(0, kShownCharacters));
  }
  const std::string_view name = assignment.substr(0, equals);
  const std::string_view shown = name.substr(0, kShownCharacters);
  setText(name, assignment.substr(equals + 1), std::string(where) + " " + std::string(shown));
}

void Registry::setGroupEffect(std::string_view group, Effect effect) {
  groupEffects_.insert_or_assign(std::string(group), effect);
}

void Registry::addRivals(std::string_view standing, std::string_view overriding) {
  Entry* first = find(standing);
  Entry* second = find(overriding);
  if (first == nullptr || second == nullptr) throw std::logic_error("rivals are not registered");
  rivals_.push_back({first, second});
}

void Registry::checkRivals() const {
  // "x.toml:3: oit.kAve" is dropped as "oit.kAve".
  const auto nameIn = [](const std::string& place) {
    const std::size_t colon = place.rfind(": ");
    return colon == std::string::npos ? place : place.substr(colon + 2);
  };
  const auto held = [](const Entry& entry) {
    return formatValue(entry.get()) + " " + entry.unit();
  };
  for (const auto& [standing, overriding] : rivals_) {
    const std::string& first = standing->setAt();
    const std::string& second = overriding->setAt();
    if (first.empty() || second.empty() || overriding->isDefault()) continue;
    failInput("{} and {} cannot hold together; drop {} to keep {}, or {} to keep {}", first, second,
              nameIn(first), held(*overriding), nameIn(second), held(*standing));
  }
}

Entry* Registry::rivalOf(const Entry& entry) {
  for (const auto& [standing, overriding] : rivals_) {
    if (&entry == standing && !overriding->isDefault()) return overriding;
    if (&entry == overriding && !entry.isDefault() && !standing->isDefault()) return standing;
  }
  return nullptr;
}

void Registry::reset() {
  for (Entry& entry : entries_) entry.reset();
}

std::vector<std::string> Registry::names() const {
  std::vector<std::string> all;
  for (const Entry& entry : entries_) all.push_back(entry.key());
  for (const Entry& entry : entries_) {
    if (!entry.alias().empty()) all.push_back(entry.alias());
  }
  return all;
}

nlohmann::json Registry::toJson() const {
  nlohmann::json all = nlohmann::json::object();
  for (const Entry& entry : entries_) all[entry.key()] = valueJson(entry.get());
  return all;
}

}  // namespace macula::settings
