// Which room may use which: the table of docs/architecture.md against every #include and against
// the libraries that CMake links.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "engine/core/file.h"

namespace macula {
namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

/// A row of the table: folders that are one room, and the folders that they may use.
struct Room {
  std::vector<std::string> folders;
  Names mayUse;
};

const fs::path kSource = MACULA_SOURCE_DIR;

std::vector<std::string> matches(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern);
  std::vector<std::string> found;
  for (std::sregex_iterator it(text.begin(), text.end(), regex), end; it != end; ++it) {
    found.push_back((*it)[1]);
  }
  return found;
}

std::vector<Room> roomsOf(const std::string& document) {
  std::vector<Room> rooms;
  for (const std::string& row : matches(document, R"((\n\| `[^\n]*))")) {
    std::smatch cells;
    if (!std::regex_match(row, cells, std::regex(R"(\n\|([^|]*)\|[^|]*\|([^|]*)\|)"))) continue;
    rooms.push_back({.folders = matches(cells[1], "`([^`]+)`"), .mayUse = {}});
    for (const std::string& name : matches(cells[2], "([a-z/]+)")) rooms.back().mayUse.insert(name);
  }
  return rooms;
}

const std::vector<Room>& rooms() {
  static const std::vector<Room> all = [] {
    const std::string text = readTextFile(kSource / "docs" / "architecture.md");
    const std::size_t begin = text.find("| folder | holds | may use |");
    return begin == std::string::npos
               ? std::vector<Room>{}
               : roomsOf(text.substr(begin, text.find("\n\n", begin) - begin));
  }();
  return all;
}

/// The room of the longest folder that the path lies in; null where there is none.
const Room* roomOf(const std::string& path) {
  const Room* best = nullptr;
  std::size_t longest = 0;
  for (const Room& room : rooms()) {
    for (const std::string& folder : room.folders) {
      if (path.starts_with(folder + "/") && folder.size() > longest) {
        best = &room;
        longest = folder.size();
      }
    }
  }
  return best;
}

bool mayUse(const Room& user, const Room& used) {
  if (&user == &used || user.mayUse.contains("all")) return true;
  return std::ranges::any_of(used.folders, [&](const std::string& folder) {
    const bool engine = folder.starts_with("engine/");
    return user.mayUse.contains(engine ? folder.substr(7) : folder) ||
           (engine && user.mayUse.contains("engine"));
  });
}

/// One line for each include that the table forbids, "FILE:LINE: ...".
/// @param path from the root of the repository
std::vector<std::string> forbiddenIncludes(const std::string& path, const std::string& text) {
  static const std::regex include(R"re(^\s*#\s*include "([^"]+)".*)re");
  const Room* const user = roomOf(path);
  std::vector<std::string> found;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::smatch match;
    if (!std::regex_match(line, match, include)) continue;
    std::string name = match[1];
    if (name.starts_with("shared/")) name.insert(0, "shaders/");
    const Room* used = roomOf(name);
    if (used == nullptr && name.find("..") == std::string::npos) used = user;  // beside the file
    if (user == nullptr || used == nullptr || !mayUse(*user, *used)) {
      found.push_back(path + ":" + std::to_string(number) + ": " + std::string(match[1]) +
                      " is not of a room that docs/architecture.md lets this one use");
    }
  }
  return found;
}

/// Folders that a folder's CMake libraries of Macula are linked with.
std::map<std::string, Names> linkedFolders() {
  std::map<std::string, std::string> folderOf;
  std::map<std::string, std::string> texts;
  for (const char* top : {"engine", "passes"}) {
    for (const auto& entry : fs::recursive_directory_iterator(kSource / top)) {
      if (entry.path().filename() != "CMakeLists.txt") continue;
      const std::string folder = fs::relative(entry.path().parent_path(), kSource).generic_string();
      texts[folder] = readTextFile(entry.path());
      for (const auto& name : matches(texts[folder], R"(macula_room\((\w+))")) {
        folderOf["macula_" + name] = folder;
      }
    }
  }
  std::map<std::string, Names> linked;
  for (const auto& [folder, text] : texts) {
    for (const std::string& library : matches(text, R"(\b(macula_\w+))")) {
      const auto found = folderOf.find(library);
      if (found != folderOf.end() && found->second != folder) linked[folder].insert(found->second);
    }
  }
  return linked;
}

TEST(Rooms, EveryIncludeIsOfTheTable) {
  std::size_t files = 0;
  for (const char* top : {"engine", "passes", "tools", "tests", "shaders/shared"}) {
    for (const auto& entry : fs::recursive_directory_iterator(kSource / top)) {
      const std::string extension = entry.path().extension();
      if (extension != ".cpp" && extension != ".h") continue;
      ++files;
      const std::string path = fs::relative(entry.path(), kSource).generic_string();
      for (const std::string& line : forbiddenIncludes(path, readTextFile(entry.path()))) {
        ADD_FAILURE() << line;
      }
    }
  }
  EXPECT_GT(files, 400U);
}

TEST(Rooms, AForbiddenIncludeIsSaidWithFileAndLine) {
  const auto lines = forbiddenIncludes("engine/core/a.cpp",
                                       "#include <string>\n"
                                       "#include \"engine/core/file.h\"\n"
                                       "#include \"passes/frame_list.h\"\n"
                                       "#include \"engine/gl/objects.h\"\n"
                                       "#include \"../gl/objects.h\"\n");
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_TRUE(lines[0].starts_with("engine/core/a.cpp:3: passes/frame_list.h is not"));
  EXPECT_TRUE(lines[1].starts_with("engine/core/a.cpp:4: engine/gl/objects.h is not"));
  EXPECT_TRUE(lines[2].starts_with("engine/core/a.cpp:5: ../gl/objects.h is not"));
}

/// Calls of OpenGL by which the CPU may wait for the GPU: one line for each, "FILE: CALL".
std::vector<std::string> blockingCalls(const std::string& path, const std::string& text) {
  std::vector<std::string> found;
  for (const std::string& name :
       matches(text, R"(\b(glFinish|glGetQuery(?:Buffer)?Object\w+|glGet(?:Named)?BufferSubData|)"
                     R"(glGetn?(?:Compressed)?Tex\w*Image|glGetTextureSubImage|glRead\w*Pixels|)"
                     R"(glClientWaitSync|glMap\w*Buffer\w*)\s*\()")) {
    found.push_back(path + ": " + name);
  }
  return found;
}

TEST(Rooms, EveryCallThatMayWaitForTheGpuIsInOnePlace) {
  // Where it is counted; and the mapping of a buffer that nothing uses yet.
  const Names allowed{"engine/gl/blocking.cpp", "engine/gl/readback.cpp"};
  Names seen;
  for (const char* top : {"engine", "passes", "tools"}) {
    for (const auto& entry : fs::recursive_directory_iterator(kSource / top)) {
      const std::string extension = entry.path().extension();
      if (extension != ".cpp" && extension != ".h") continue;
      const std::string path = fs::relative(entry.path(), kSource).generic_string();
      const auto calls = blockingCalls(path, readTextFile(entry.path()));
      if (!calls.empty()) seen.insert(path);
      for (const std::string& call : calls) {
        EXPECT_TRUE(allowed.contains(path)) << call << "; use engine/gl/blocking.h";
      }
    }
  }
  EXPECT_EQ(seen, allowed);
  EXPECT_EQ(blockingCalls("a.cpp", "  glFinish();\n  glGetTextureImage(id, 0);\n  glFlush();\n"),
            (std::vector<std::string>{"a.cpp: glFinish", "a.cpp: glGetTextureImage"}));
}

TEST(Rooms, EveryFolderOfTheEngineHasARow) {
  for (const auto& entry : fs::directory_iterator(kSource / "engine")) {
    if (!entry.is_directory()) continue;
    const std::string name = "engine/" + entry.path().filename().string();
    EXPECT_NE(roomOf(name + "/"), nullptr) << name;
  }
  for (const Room& room : rooms()) {
    for (const std::string& folder : room.folders) {
      EXPECT_TRUE(fs::is_directory(kSource / folder)) << folder;
    }
  }
}

TEST(Rooms, CMakeLinksWhatTheTableSays) {
  const std::map<std::string, Names> linked = linkedFolders();
  EXPECT_GT(linked.size(), 12U);
  for (const auto& [folder, others] : linked) {
    const Room* const user = roomOf(folder + "/");
    ASSERT_NE(user, nullptr) << folder;
    for (const std::string& other : others) {
      EXPECT_TRUE(mayUse(*user, *roomOf(other + "/"))) << folder << " is linked with " << other;
    }
  }
  for (const Room& room : rooms()) {
    const std::string& folder = room.folders.front();
    if (!folder.starts_with("engine/")) continue;
    for (const std::string& name : room.mayUse) {
      if (name == "shaders") continue;  // headers alone
      EXPECT_TRUE(linked.contains(folder) && linked.at(folder).contains("engine/" + name))
          << "docs/architecture.md lets " << folder << " use " << name
          << ", which its CMakeLists.txt does not name";
    }
  }
}

}  // namespace
}  // namespace macula
