// Any bytes as a TOML settings file: an InputError of one line, or values within their ranges.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "engine/core/error.h"
#include "engine/settings/toml_file.h"

namespace {

/// A field of each kind, with the ranges that are checked below.
struct Fields {
  double kAve = 4.0;
  float exposure = 1.0F;
  int layers = 16;
  bool fill = false;
  std::string method = "blend";
  int ssaa = 1;
  std::string note;
  glm::vec3 background{0.0F};
};

void check(bool holds) {
  if (!holds) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Fields fields;
  macula::settings::Registry registry;
  registry.add({.key = "oit.kAve", .alias = "k-ave"}, fields.kAve,
               {.min = 0, .minExclusive = true, .max = 4096});
  registry.add({.key = "exposure"}, fields.exposure, {.min = 0, .max = 64});
  registry.add({.key = "oit.layers"}, fields.layers, {.min = 1, .max = 1024});
  registry.add({.key = "oit.fill"}, fields.fill);
  registry.addChoice({.key = "oit.method", .alias = "method"}, fields.method, {"blend", "peel"});
  registry.addNumberChoice({.key = "ssaa"}, fields.ssaa, {1, 2, 4});
  registry.add({.key = "note"}, fields.note);
  registry.add({.key = "background"}, fields.background, {.min = 0});
  try {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    macula::settings::applyTomlText(registry, text, "fuzz.toml");
  } catch (const macula::InputError& error) {
    check(std::string_view(error.what()).find('\n') == std::string_view::npos);
  }
  check(fields.kAve > 0.0 && fields.kAve <= 4096.0);
  check(fields.exposure >= 0.0F && fields.exposure <= 64.0F);
  check(fields.layers >= 1 && fields.layers <= 1024);
  check(fields.method == "blend" || fields.method == "peel");
  check(fields.ssaa == 1 || fields.ssaa == 2 || fields.ssaa == 4);
  for (int i = 0; i < 3; ++i) check(fields.background[i] >= 0.0F);
  check(registry.toJson().size() == registry.entries().size());
  return 0;
}
