#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>
#include <string_view>

#include "engine/core/error.h"
#include "engine/core/plural.h"
#include "engine/network/parts.h"
#include "engine/settings/typed_reader.h"

namespace macula::network {
namespace {

using settings::shownText;
using settings::TypedReader;

/// The parts of a text between separators; one, maybe empty, where there is none.
std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  for (;;) {
    const std::size_t end = text.find(separator);
    parts.emplace_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

/// The only value that this program knows.
void expect(TypedReader& reader, const std::string& key, std::string_view value,
            std::string_view fix) {
  const auto text = reader.get<std::string>(key);
  if (text == value) return;
  reader.fail(key, fmt::format("is '{}' and not '{}'; {}", shownText(text), value, fix));
}

/// Names in order, none empty and none twice.
std::vector<std::string> namesOf(TypedReader& reader, const std::string& key, std::size_t most) {
  std::vector<std::string> names = split(reader.get<std::string>(key), ',');
  if (names.size() > most) {
    reader.fail(key, fmt::format("holds {} names, the limit is {}; train a smaller network",
                                 names.size(), most));
  }
  std::set<std::string> seen;
  for (const std::string& name : names) {
    // Blanks around a comma would make names that match nothing.
    const bool good = !name.empty() && std::all_of(name.begin(), name.end(),
                                                   [](char c) { return c > ' ' && c < '\x7F'; });
    if (!good) {
      reader.fail(key, fmt::format("holds the name '{}'; separate names by commas alone, each of "
                                   "printable ASCII without blanks",
                                   shownText(name)));
    }
    if (!seen.insert(name).second) {
      reader.fail(key, fmt::format("holds '{}' twice; name each once", shownText(name)));
    }
  }
  return names;
}

float numberOf(const TypedReader& reader, const std::string& key, const std::string& part) {
  double number = 0.0;
  const char* end = part.data() + part.size();
  const auto [stop, error] = std::from_chars(part.data(), end, number);
  if (stop != end || error == std::errc::invalid_argument) {
    reader.fail(
        key, fmt::format("holds '{}', which is no number; write decimal numbers", shownText(part)));
  }
  const auto single = static_cast<float>(number);
  if (error == std::errc::result_out_of_range || !std::isfinite(single)) {
    reader.fail(key, fmt::format("holds '{}', which is no finite float; look for constant or "
                                 "broken features in the training data",
                                 shownText(part)));
  }
  return single;
}

/// Finite numbers, `count` of them.
std::vector<float> numbersOf(TypedReader& reader, const std::string& key, std::size_t count) {
  const std::vector<std::string> parts = split(reader.get<std::string>(key), ' ');
  if (parts.size() != count) {
    reader.fail(key, fmt::format("holds {} for {}; write one a feature, separated by single blanks",
                                 counted(parts.size(), "number"), counted(count, "feature")));
  }
  std::vector<float> numbers;
  for (const std::string& part : parts) numbers.push_back(numberOf(reader, key, part));
  return numbers;
}

/// 64 hexadecimal digits.
std::string hashOf(TypedReader& reader) {
  constexpr std::size_t kDigits = 64;
  auto text = reader.get<std::string>("data");
  if (text.size() != kDigits ||
      text.find_first_not_of("0123456789abcdefABCDEF") != std::string::npos) {
    reader.fail("data", fmt::format("is '{}' and no SHA-256 of 64 hexadecimal digits; {} with the "
                                    "hash of its training data",
                                    shownText(text), kExportAgain));
  }
  return text;
}

}  // namespace

Network parseMetadata(const nlohmann::json& metadata, const std::string& name) {
  TypedReader reader(settings::DataNode(metadata), name + ": __metadata__",
                     fmt::format("{} with it", kExportAgain));
  expect(reader, "format", "macula-network", "name the file of a network made for Macula");
  expect(reader, "version", "1", "this Macula reads no other, export the network for it");
  expect(reader, "activation", "relu", "train the hidden layers with it");
  Network network;
  network.model = reader.get<std::string>("model", {}, "a name");
  network.features = namesOf(reader, "features", kMaxInputs);
  network.outputs = namesOf(reader, "outputs", kMaxWidth);
  network.mean = numbersOf(reader, "mean", network.features.size());
  network.scale = numbersOf(reader, "scale", network.features.size());
  const auto zero = std::find(network.scale.begin(), network.scale.end(), 0.0F);
  if (zero != network.scale.end()) {
    const auto index = static_cast<std::size_t>(zero - network.scale.begin());
    reader.fail("scale", fmt::format("is 0 for '{}'; leave a feature out that says nothing",
                                     shownText(network.features[index])));
  }
  network.outputActivation =
      static_cast<OutputActivation>(reader.getChoice("output_activation", {"none", "sigmoid"}));
  network.command = reader.get<std::string>("command");
  network.dataHash = hashOf(reader);
  // All of these are needed, so that no misspelt key passes: further ones are notes on the
  // training, which safetensors files keep here.
  return network;
}

}  // namespace macula::network
