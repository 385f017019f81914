#include "engine/ui/setting_row.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

namespace macula::ui {
namespace {

using settings::Entry;
using settings::Range;
using settings::Type;
using settings::Value;
using Chosen = std::optional<Value>;

/// Ranges up to this length get a slider; over longer ones a pixel of a slider would jump too far.
constexpr double kSliderSpan = 1.0;
/// What a drag by one pixel adds: this share of the number, and at least this much.
constexpr double kDragStep = 0.01;
/// Smallest distance from a bound that is itself not allowed.
constexpr double kAboveBound = 0.01;
/// Whole numbers beyond this are not exact in the doubles that ranges are made of.
constexpr double kLargestWhole = 9007199254740992.0;

double lowest(const Range& range) {
  return range.minExclusive ? range.min + kAboveBound : range.min;
}
double highest(const Range& range) {
  return range.maxExclusive ? range.max - kAboveBound : range.max;
}

/// A printf format with the unit behind the number.
std::string withUnit(const char* format, const std::string& unit) {
  std::string text = format;
  if (unit.empty()) return text;
  text += ' ';
  for (const char c : unit) {
    text += c;
    if (c == '%') text += c;
  }
  return text;
}

Chosen chooseFrom(const Entry& entry, const std::string& present) {
  Chosen chosen;
  if (!ImGui::BeginCombo("##value", present.c_str())) return chosen;
  for (const std::string& choice : entry.choices()) {
    const bool selected = choice == present;
    if (ImGui::Selectable(choice.c_str(), selected)) {
      if (entry.type() == Type::Int) {
        if (const auto number = settings::parseInt(choice)) chosen = *number;
      } else {
        chosen = choice;
      }
    }
    if (selected) ImGui::SetItemDefaultFocus();
  }
  ImGui::EndCombo();
  return chosen;
}

Chosen editWhole(const Entry& entry, PendingEdit& pending) {
  const Value shown = pending.entry == &entry ? pending.value : entry.get();
  auto number = std::get<std::int64_t>(shown);
  const auto bound = [](double value) {
    return static_cast<std::int64_t>(std::clamp(value, -kLargestWhole, kLargestWhole));
  };
  const std::int64_t least = bound(entry.range().min);
  const std::int64_t most = bound(entry.range().max);
  const float speed =
      static_cast<float>(std::max(0.1, kDragStep * std::abs(static_cast<double>(number))));
  const std::string format = withUnit("%lld", entry.unit());
  ImGui::DragScalar("##value", ImGuiDataType_S64, &number, speed, &least, &most, format.c_str(),
                    ImGuiSliderFlags_AlwaysClamp);
  if (ImGui::IsItemActive()) pending = {&entry, number};
  if (!ImGui::IsItemDeactivated() || pending.entry != &entry) return {};
  const Value edited = pending.value;
  pending = {};
  // What was typed arrives in the frame in which the field closes.
  const Value last = number != std::get<std::int64_t>(shown) ? Value{number} : edited;
  return last == entry.get() ? Chosen{} : Chosen{last};
}

Chosen editReal(const Entry& entry, PendingEdit& pending) {
  auto number = std::get<double>(pending.entry == &entry ? pending.value : entry.get());
  const double least = lowest(entry.range());
  const double most = highest(entry.range());
  const std::string format = withUnit("%.4g", entry.unit());
  const bool changed =
      most - least <= kSliderSpan
          ? ImGui::SliderScalar("##value", ImGuiDataType_Double, &number, &least, &most,
                                format.c_str(), ImGuiSliderFlags_AlwaysClamp)
          : ImGui::DragScalar("##value", ImGuiDataType_Double, &number,
                              static_cast<float>(kDragStep * std::max(1.0, std::abs(number))),
                              &least, &most, format.c_str(), ImGuiSliderFlags_AlwaysClamp);
  // Half a typed number is not what the user means.
  if (changed && ImGui::IsItemActive() && ImGui::GetIO().WantTextInput) {
    pending = {&entry, number};
    return {};
  }
  if (pending.entry != &entry) return changed ? Chosen{number} : Chosen{};
  if (!ImGui::IsItemDeactivated()) return {};
  pending = {};
  return Value{number} == entry.get() ? Chosen{} : Chosen{number};
}

Chosen editColour(const Entry& entry) {
  auto colour = std::get<glm::vec3>(entry.get());
  if (!ImGui::ColorEdit3("##value", &colour[0],
                         ImGuiColorEditFlags_Float | ImGuiColorEditFlags_HDR)) {
    return {};
  }
  const glm::vec3 least(static_cast<float>(lowest(entry.range())));
  const glm::vec3 most(static_cast<float>(highest(entry.range())));
  return Chosen{glm::clamp(colour, least, most)};
}

Chosen editText(const Entry& entry) {
  // The field keeps what is being typed; leaving it without Enter drops that.
  auto text = std::get<std::string>(entry.get());
  const bool entered = ImGui::InputText("##value", &text, ImGuiInputTextFlags_EnterReturnsTrue);
  return entered ? Chosen{text} : Chosen{};
}

}  // namespace

std::optional<Value> drawSettingWidget(const Entry& entry, PendingEdit& pending) {
  if (!entry.choices().empty()) {
    return chooseFrom(entry, settings::formatValue(entry.get()));
  }
  switch (entry.type()) {
    case Type::Bool: {
      bool on = std::get<bool>(entry.get());
      return ImGui::Checkbox("##value", &on) ? Chosen{on} : Chosen{};
    }
    case Type::Int:
      return editWhole(entry, pending);
    case Type::Real:
      return editReal(entry, pending);
    case Type::Colour:
      return editColour(entry);
    case Type::Choice:
    case Type::Text:
    case Type::Path:
      break;
  }
  return editText(entry);
}

}  // namespace macula::ui
