#include "engine/gaze/hid/choice.h"

#include <fmt/format.h>

#include <charconv>

namespace macula::gaze::hid {
namespace {

constexpr std::size_t kIdDigits = 4;

std::optional<std::uint16_t> parseId(std::string_view text) {
  std::uint16_t id = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), id, 16);
  const bool whole = error == std::errc{} && end == text.data() + text.size();
  return whole && text.size() == kIdDigits ? std::optional(id) : std::nullopt;
}

}  // namespace

bool TrackerChoice::matches(const TrackerInfo& info) const {
  const auto vendor = profile ? std::optional(profile->vendorId) : vendorId;
  const auto product = profile ? std::optional(profile->productId) : productId;
  return (!vendor || *vendor == info.vendorId) && (!product || *product == info.productId) &&
         (serial.empty() || serial == info.serial);
}

std::string TrackerChoice::text() const {
  const auto vendor = profile ? std::optional(profile->vendorId) : vendorId;
  const auto product = profile ? std::optional(profile->productId) : productId;
  std::string text;
  if (vendor && product) text = fmt::format("{:04x}:{:04x}", *vendor, *product);
  if (!serial.empty()) text += fmt::format("{}serial {}", text.empty() ? "" : " ", serial);
  return text.empty() ? "any" : text;
}

TrackerChoice parseTrackerChoice(std::string_view text) {
  TrackerChoice choice;
  if (text.empty() || text == "first") return choice;
  constexpr std::size_t kIdsLength = 2 * kIdDigits + 1;
  const bool hasIds = text.size() >= kIdsLength && text[kIdDigits] == ':' &&
                      (text.size() == kIdsLength || text[kIdsLength] == ':');
  if (hasIds) {
    choice.vendorId = parseId(text.substr(0, kIdDigits));
    choice.productId = parseId(text.substr(kIdDigits + 1, kIdDigits));
    if (choice.vendorId && choice.productId) {
      if (text.size() > kIdsLength) choice.serial = text.substr(kIdsLength + 1);
      return choice;
    }
    choice = {};
  }
  choice.serial = text;
  return choice;
}

}  // namespace macula::gaze::hid
