#include "walk/script.h"

#include <sstream>
#include <string>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/core/nearest.h"
#include "engine/settings/value.h"
#include "walk/actions.h"

namespace macula::tools {
namespace {

std::string trimmed(std::string text) {
  constexpr const char* kBlank = " \t\r";
  text.erase(0, std::min(text.size(), text.find_first_not_of(kBlank)));
  text.erase(text.find_last_not_of(kBlank) + 1);
  return text;
}

Request parseRequest(const std::string& word, const std::string& argument,
                     const std::string& place) {
  if (word == "press") {
    if (std::optional<Request> request = requestOfKey(argument)) return *request;
    failInput("{}: no action has the key '{}'; 'macula walk' shows all keys by F2", place,
              oneLine(argument));
  }
  const std::optional<Action> action = actionByName(word);
  if (!action) {
    failInput("{}: unknown action '{}'; the nearest is '{}'", place, oneLine(word),
              nearestName(word, actionNames()));
  }
  return {*action, argument};
}

}  // namespace

Script::Script(std::string_view text, const std::string& name) {
  std::istringstream lines{std::string(text)};
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    line = trimmed(line);
    if (line.empty() || line.front() == '#') continue;
    const std::string place = fmt::format("{}, line {}", name, number);
    std::istringstream words(line);
    std::string frame;
    std::string word;
    std::string argument;
    words >> frame >> word;
    std::getline(words, argument);
    const auto at = settings::parseInt(frame);
    constexpr std::int64_t kLastFrame = 1000000;
    if (!at || *at < 0 || *at > kLastFrame || word.empty()) {
      failInput("{}: '{}' is no step; write FRAME ACTION [ARGUMENT], as 2 press F2", place,
                oneLine(line));
    }
    const int index = static_cast<int>(*at);
    if (!steps_.empty() && index < steps_.back().frame) {
      failInput("{}: frame {} after frame {}; order the steps by frame", place, index,
                steps_.back().frame);
    }
    steps_.push_back({index, parseRequest(word, trimmed(argument), place)});
  }
}

void Script::due(int frame, Requests& requests) {
  for (; next_ < steps_.size() && steps_[next_].frame <= frame; ++next_) {
    requests.push_back(steps_[next_].request);
  }
}

Script readScript(const std::filesystem::path& file) {
  return {readTextFile(file), file.string()};
}

}  // namespace macula::tools
