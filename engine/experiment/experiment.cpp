// What experiments, variants and targets say of themselves.
#include "engine/experiment/experiment.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace macula::experiment {
namespace {

template <typename Element>
const Element& checkedFind(const std::vector<Element>& elements, std::string_view id) {
  const auto found = std::find_if(elements.begin(), elements.end(),
                                  [&](const Element& element) { return element.id == id; });
  if (found == elements.end()) throw std::logic_error("an id that was not checked");
  return *found;
}

}  // namespace

std::string Sweep::label(double value) const {
  return fmt::format("{}={:g}", setting.substr(setting.rfind('.') + 1), value);
}

bool Sweep::holds(double value) const {
  return std::find(values.begin(), values.end(), value) != values.end();
}

std::string Variant::labelAt(const std::optional<double>& value) const {
  return sweep && value ? label + " " + sweep->label(*value) : label;
}

bool Study::isOptional(std::string_view scene) const {
  return std::find(optionalScenes.begin(), optionalScenes.end(), scene) != optionalScenes.end();
}

bool Target::admits(double value) const {
  switch (bound) {
    case Bound::AtMost:
      return value <= limit;
    case Bound::AtLeast:
      return value >= limit;
    case Bound::Above:
      return value > limit;
  }
  return false;
}

std::string Target::limitText() const {
  if (kind == Kind::Order) return "strictly falling";
  const char* sign = bound == Bound::AtMost ? "<=" : bound == Bound::AtLeast ? ">=" : ">";
  const std::string text = fmt::format("{} {:g}", sign, limit);
  if (kind == Kind::Mean) return "mean " + text;
  if (kind != Kind::Curve) return text;
  return (statistic == Statistic::Least ? "least " : "mean ") + text;
}

const Variant& Experiment::variant(std::string_view id) const {
  return checkedFind(variants, id);
}

const Study& Experiment::study(std::string_view id) const {
  return checkedFind(studies, id);
}

}  // namespace macula::experiment
