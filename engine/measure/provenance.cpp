#include "engine/measure/provenance.h"

#include "engine/core/sha256.h"

namespace macula::measure {
namespace {

using Json = nlohmann::ordered_json;

Json orNull(const std::string& text) {
  return text.empty() ? Json(nullptr) : Json(text);
}

}  // namespace

Input inputOf(const std::filesystem::path& file) {
  return {.name = file.string(), .path = file.string(), .sha256 = fileSha256(file), .files = {}};
}

Json toJson(const Input& input) {
  Json files = Json::array();
  for (const InputFile& file : input.files) {
    files.push_back({{"path", file.path}, {"sha256", orNull(file.sha256)}});
  }
  return {{"name", input.name},
          {"path", orNull(input.path)},
          {"sha256", orNull(input.sha256)},
          {"files", files}};
}

Json toJson(const std::vector<Input>& inputs) {
  Json all = Json::array();
  for (const Input& input : inputs) all.push_back(toJson(input));
  return all;
}

Json toJson(const Provenance& provenance) {
  Json block{{"command", provenance.command},
             {"version", provenance.version},
             {"commit", provenance.commit}};
  block.update(provenance.inputs);
  // A path may hold any bytes, and JSON only UTF-8.
  return Json::parse(block.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace macula::measure
