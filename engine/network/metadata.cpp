#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>
#include <string_view>

#include "engine/core/error.h"
#include "engine/core/plural.h"
#include "engine/network/parts.h"

namespace macula::network {
namespace {

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

/// Reads keys and names the one that is wrong.
class Metadata {
 public:
  Metadata(const std::map<std::string, std::string>& texts, const std::string& name)
      : texts_(&texts), name_(&name) {}

  [[noreturn]] void fail(const char* key, const std::string& what) const {
    failInput("{}: __metadata__: '{}' {}", *name_, key, what);
  }

  [[nodiscard]] const std::string& text(const char* key) const {
    const auto found = texts_->find(key);
    if (found == texts_->end()) fail(key, fmt::format("is missing; {} with it", kExportAgain));
    return found->second;
  }

  /// The only value that this program knows.
  void expect(const char* key, std::string_view value, const char* fix) const {
    if (text(key) == value) return;
    fail(key, fmt::format("is '{}' and not '{}'; {}", shown(text(key)), value, fix));
  }

  /// Names in order, none empty and none twice.
  [[nodiscard]] std::vector<std::string> names(const char* key, std::size_t most) const {
    std::vector<std::string> names = split(text(key), ',');
    if (names.size() > most) {
      fail(key, fmt::format("holds {} names, the limit is {}; train a smaller network",
                            names.size(), most));
    }
    std::set<std::string> seen;
    for (const std::string& name : names) {
      // Blanks around a comma would make names that match nothing.
      const bool good = !name.empty() && std::all_of(name.begin(), name.end(),
                                                     [](char c) { return c > ' ' && c < '\x7F'; });
      if (!good) {
        fail(key, fmt::format("holds the name '{}'; separate names by commas alone, each of "
                              "printable ASCII without blanks",
                              shown(name)));
      }
      if (!seen.insert(name).second) {
        fail(key, fmt::format("holds '{}' twice; name each once", shown(name)));
      }
    }
    return names;
  }

  /// Finite numbers, `count` of them.
  [[nodiscard]] std::vector<float> numbers(const char* key, std::size_t count) const {
    const std::vector<std::string> parts = split(text(key), ' ');
    if (parts.size() != count) {
      fail(key, fmt::format("holds {} for {}; write one a feature, separated by single blanks",
                            counted(parts.size(), "number"), counted(count, "feature")));
    }
    std::vector<float> numbers;
    for (const std::string& part : parts) numbers.push_back(number(key, part));
    return numbers;
  }

 private:
  [[nodiscard]] float number(const char* key, const std::string& part) const {
    double number = 0.0;
    const char* end = part.data() + part.size();
    const auto [stop, error] = std::from_chars(part.data(), end, number);
    if (stop != end || error == std::errc::invalid_argument) {
      fail(key, fmt::format("holds '{}', which is no number; write decimal numbers", shown(part)));
    }
    const auto single = static_cast<float>(number);
    if (error == std::errc::result_out_of_range || !std::isfinite(single)) {
      fail(key, fmt::format("holds '{}', which is no finite float; look for constant or broken "
                            "features in the training data",
                            shown(part)));
    }
    return single;
  }

  const std::map<std::string, std::string>* texts_;
  const std::string* name_;
};

OutputActivation outputActivationOf(const Metadata& metadata) {
  const std::string& text = metadata.text("output_activation");
  if (text == "sigmoid") return OutputActivation::Sigmoid;
  if (text == "none") return OutputActivation::None;
  metadata.fail("output_activation",
                fmt::format("is '{}'; write 'sigmoid' or 'none'", shown(text)));
}

/// 64 hexadecimal digits.
std::string hashOf(const Metadata& metadata) {
  constexpr std::size_t kDigits = 64;
  const std::string& text = metadata.text("data");
  if (text.size() != kDigits ||
      text.find_first_not_of("0123456789abcdefABCDEF") != std::string::npos) {
    metadata.fail("data", fmt::format("is '{}' and no SHA-256 of 64 hexadecimal digits; {} with "
                                      "the hash of its training data",
                                      shown(text), kExportAgain));
  }
  return text;
}

}  // namespace

Network parseMetadata(const std::map<std::string, std::string>& texts, const std::string& name) {
  const Metadata metadata(texts, name);
  metadata.expect("format", "macula-network", "name the file of a network made for Macula");
  metadata.expect("version", "1", "this Macula reads no other, export the network for it");
  metadata.expect("activation", "relu", "train the hidden layers with it");
  Network network;
  network.model = metadata.text("model");
  if (network.model.empty()) metadata.fail("model", "is empty; give the network a name");
  network.features = metadata.names("features", kMaxInputs);
  network.outputs = metadata.names("outputs", kMaxWidth);
  network.mean = metadata.numbers("mean", network.features.size());
  network.scale = metadata.numbers("scale", network.features.size());
  const auto zero = std::find(network.scale.begin(), network.scale.end(), 0.0F);
  if (zero != network.scale.end()) {
    const auto index = static_cast<std::size_t>(zero - network.scale.begin());
    metadata.fail("scale", fmt::format("is 0 for '{}'; leave a feature out that says nothing",
                                       shown(network.features[index])));
  }
  network.outputActivation = outputActivationOf(metadata);
  network.command = metadata.text("command");
  network.dataHash = hashOf(metadata);
  return network;
}

}  // namespace macula::network
