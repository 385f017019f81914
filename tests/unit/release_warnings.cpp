// Built as a release is, with warnings as errors in continuous integration: a newcomer's build of
// common code prints none. GCC 12's false alarm about concatenated strings (bug 105329) is the
// known one.
#include <string>

namespace macula::test {

std::string quoted(const std::string& text) {
  return "\"" + std::string(text) + "\"";
}

std::string bracketed(const char* text) {
  return "(" + std::string(text) + ")";
}

}  // namespace macula::test
