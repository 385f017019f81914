#include "engine/gl/shader_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "engine/core/error.h"
#include "engine/core/file.h"

namespace macula::gl {
namespace {

class Assembler {
 public:
  explicit Assembler(std::filesystem::path root) : root_(std::move(root)) {}

  void append(const std::string& file, std::string& out) {
    if (std::find(included_.begin(), included_.end(), file) != included_.end()) return;
    included_.push_back(file);
    const std::size_t number = included_.size() - 1;  // shows in the compiler's messages
    std::istringstream lines(readTextFile(root_ / file));
    std::string line;
    out += fmt::format("#line 1 {}\n", number);
    for (int lineNumber = 1; std::getline(lines, line); ++lineNumber) {
      if (!line.starts_with("#include")) {
        out += line + '\n';
        continue;
      }
      // Headers that C++ shares with GLSL name standard headers for C++ alone.
      if (line.find('<') != std::string::npos) {
        out += '\n';
        continue;
      }
      const std::size_t open = line.find('"');
      const std::size_t close = line.rfind('"');
      if (open == std::string::npos || close <= open) {
        failInput("{}:{}: #include without a file in quotes", file, lineNumber);
      }
      append(line.substr(open + 1, close - open - 1), out);
      out += fmt::format("#line {} {}\n", lineNumber + 1, number);
    }
  }

 private:
  std::filesystem::path root_;
  std::vector<std::string> included_;
};

}  // namespace

std::string assembleShader(const std::filesystem::path& root, std::string_view file,
                           const Defines& defines, const std::vector<std::string>& extensions) {
  std::string text = "#version 450 core\n";
  for (const std::string& name : extensions) text += fmt::format("#extension {} : require\n", name);
  text += "#define MACULA_GLSL 1\n";
  for (const auto& [name, value] : defines) text += fmt::format("#define {} {}\n", name, value);
  Assembler(root).append(std::string(file), text);
  return text;
}

std::string literal(float value) {
  std::string text = fmt::format("{:.9g}", value);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  // In parentheses: a second minus, even that of -0, would make a decrement.
  return std::signbit(value) ? "(" + text + ")" : text;
}

}  // namespace macula::gl
