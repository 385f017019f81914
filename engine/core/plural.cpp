#include "engine/core/plural.h"

namespace macula {

std::string nounFor(std::uint64_t count, std::string_view noun, std::string_view plural) {
  if (count == 1) return std::string(noun);
  return plural.empty() ? std::string(noun) + "s" : std::string(plural);
}

std::string counted(std::uint64_t count, std::string_view noun, std::string_view plural) {
  return std::to_string(count) + " " + nounFor(count, noun, plural);
}

}  // namespace macula
