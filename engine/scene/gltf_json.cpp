#include "engine/scene/gltf_json.h"

#include <algorithm>
#include <climits>
#include <utility>
#include <vector>

#include "engine/core/error.h"
#include "engine/scene/scene.h"

namespace macula::scene::gltf {
namespace {

// tinygltf copies nested values by recursion; real files nest less than 20 deep.
constexpr int kMaxNesting = 256;
// The decoder of base64 takes lengths as int.
constexpr std::size_t kMaxJsonBytes = INT_MAX;

// Parsing and freeing do without recursion, so that this can come between.
void checkNesting(const Json& root, const std::string& name) {
  std::vector<std::pair<const Json*, int>> open{{&root, 1}};  // with their depth
  while (!open.empty()) {
    const auto [parent, depth] = open.back();
    open.pop_back();
    if (depth > kMaxNesting) {
      failInput("{}: the JSON is nested more than {} deep; export the file again", name,
                kMaxNesting);
    }
    for (const Json& child : *parent) {
      if (child.is_structured()) open.emplace_back(&child, depth + 1);
    }
  }
}

}  // namespace

Json parseJson(std::string_view text, const std::string& name) {
  if (text.size() > kMaxJsonBytes) {
    failInput("{}: the JSON is larger than 2 GiB; export the file as .glb", name);
  }
  try {
    Json root = Json::parse(text.begin(), text.end());
    checkNesting(root, name);
    return root;
  } catch (const Json::exception& error) {
    // "[json.exception.parse_error.101] parse error at line 1, column 2: ..."
    std::string_view reason = error.what();
    reason.remove_prefix(std::min(reason.size(), reason.find(']') + 2));
    failInput("{}: the JSON cannot be read ({}); correct it or export the file again", name,
              reason);
  }
}

const Json* member(const Json& value, const char* key) {
  if (!value.is_object()) return nullptr;
  const auto found = value.find(key);
  return found == value.end() ? nullptr : &*found;
}

std::string stringMember(const Json& value, const char* key) {
  const Json* text = member(value, key);
  return text != nullptr && text->is_string() ? text->get<std::string>() : std::string();
}

std::int32_t indexMember(const Json& value, const char* key) {
  const Json* number = member(value, key);
  if (number == nullptr || !number->is_number_integer()) return kNone;
  const auto index = number->get<std::int64_t>();
  return index >= 0 && index <= INT32_MAX ? static_cast<std::int32_t>(index) : INT32_MAX;
}

const Json& arrayMember(const Json& value, const char* key, const std::string& name) {
  static const Json kEmpty = Json::array();
  const Json* list = member(value, key);
  if (list == nullptr) return kEmpty;
  if (!list->is_array()) failInput("{}: '{}' is not an array; export the file again", name, key);
  return *list;
}

}  // namespace macula::scene::gltf
