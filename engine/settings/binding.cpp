#include "engine/settings/binding.h"

#include <limits>
#include <type_traits>

namespace macula::settings {
namespace {

template <typename Integer>
Binding bindInteger(Integer& field) {
  Binding binding;
  binding.type = Type::Int;
  binding.get = [&field] { return Value{static_cast<std::int64_t>(field)}; };
  binding.set = [&field](const Value& value) {
    field = static_cast<Integer>(std::get<std::int64_t>(value));
  };
  // Bounds of 64 bits are the value's own and stay unsaid; a double could not name them anyway.
  if constexpr (sizeof(Integer) < sizeof(std::int64_t)) {
    binding.limits.min = static_cast<double>(std::numeric_limits<Integer>::min());
    binding.limits.max = static_cast<double>(std::numeric_limits<Integer>::max());
  } else if constexpr (std::is_unsigned_v<Integer>) {
    binding.limits.min = 0.0;
  }
  return binding;
}

template <typename Text>
Binding bindText(Text& field, Type type) {
  Binding binding;
  binding.type = type;
  if constexpr (std::is_same_v<Text, std::string>) {
    binding.get = [&field] { return Value{field}; };
  } else {
    binding.get = [&field] { return Value{field.string()}; };
  }
  binding.set = [&field](const Value& value) { field = std::get<std::string>(value); };
  return binding;
}

template <typename Triple>
Binding bindTriple(Triple& field) {
  Binding binding;
  binding.type = Type::Colour;
  binding.get = [&field] { return Value{glm::vec3{field[0], field[1], field[2]}}; };
  binding.set = [&field](const Value& value) {
    const auto& colour = std::get<glm::vec3>(value);
    field = Triple{colour.r, colour.g, colour.b};
  };
  return binding;
}

}  // namespace

Binding bindField(bool& field) {
  Binding binding;
  binding.type = Type::Bool;
  binding.get = [&field] { return Value{field}; };
  binding.set = [&field](const Value& value) { field = std::get<bool>(value); };
  return binding;
}

Binding bindField(int& field) {
  return bindInteger(field);
}
Binding bindField(std::uint32_t& field) {
  return bindInteger(field);
}
Binding bindField(std::int64_t& field) {
  return bindInteger(field);
}
Binding bindField(std::uint64_t& field) {
  return bindInteger(field);
}

Binding bindField(float& field) {
  Binding binding;
  binding.type = Type::Real;
  binding.get = [&field] { return Value{shortestDouble(field)}; };
  binding.set = [&field](const Value& v) { field = static_cast<float>(std::get<double>(v)); };
  binding.singlePrecision = true;
  return binding;
}

Binding bindField(double& field) {
  Binding binding;
  binding.type = Type::Real;
  binding.get = [&field] { return Value{field}; };
  binding.set = [&field](const Value& value) { field = std::get<double>(value); };
  return binding;
}

Binding bindField(std::string& field) {
  return bindText(field, Type::Text);
}
Binding bindField(std::filesystem::path& field) {
  return bindText(field, Type::Path);
}
Binding bindField(glm::vec3& field) {
  return bindTriple(field);
}
Binding bindField(std::array<float, 3>& field) {
  return bindTriple(field);
}

}  // namespace macula::settings
