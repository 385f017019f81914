// The JSON of a glTF file, safe looks into it, and its objects as tinygltf's.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace macula::scene::gltf {

using Json = nlohmann::json;
struct Document;

/// Parses the JSON text of a glTF file.
/// @param name the file, for messages
/// @throws InputError where it is no JSON, larger than 2 GiB or nested more than 256 deep
[[nodiscard]] Json parseJson(std::string_view text, const std::string& name);

/// A member of an object; nullptr where there is none or `value` is no object.
[[nodiscard]] const Json* member(const Json& value, const char* key);

/// A member that is text; empty where there is none.
[[nodiscard]] std::string stringMember(const Json& value, const char* key);

/// A member that is an index; kNone where there is none, INT32_MAX where it leads nowhere.
[[nodiscard]] std::int32_t indexMember(const Json& value, const char* key);

/// A member that is an array; an empty one where there is none.
/// @throws InputError where it is something else
[[nodiscard]] const Json& arrayMember(const Json& value, const char* key, const std::string& name);

/// Fills document.model from the JSON of a file, except buffers, images, animations and extras of
/// the root.
/// @throws InputError naming the object that tinygltf cannot read, and primitives that need Draco
void readModel(const Json& root, Document& document);

}  // namespace macula::scene::gltf
