#include "walk/file_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "engine/scene/load.h"

namespace macula::tools {

namespace fs = std::filesystem;

bool isCameraPathFile(const fs::path& path) {
  constexpr std::string_view kFirstColumns = "time_s,x,y,z,target_x";
  constexpr std::size_t kHeadBytes = 4096;  // comments before the header may fill as much
  std::string head(kHeadBytes, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(file.gcount()));
  std::istringstream lines(head);
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line.front() == '#' || line == "\r") continue;
    std::erase(line, ' ');
    return line.find(kFirstColumns) != std::string::npos;
  }
  return false;
}

std::vector<fs::path> sceneFiles(const fs::path& folder) {
  constexpr std::size_t kMost = 1000;
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end && files.size() < kMost;
       it.increment(error)) {
    if (scene::isSceneFile(it->path())) files.push_back(it->path().lexically_normal());
  }
  std::sort(files.begin(), files.end());
  return files;
}

fs::path nextFreeName(const std::string& prefix, std::string_view extension,
                      const std::set<std::string>& taken) {
  for (int number = 1;; ++number) {
    fs::path path = fmt::format("{}_{:03}.{}", prefix, number, extension);
    std::error_code error;
    if (!fs::exists(path, error) && !taken.contains(path.string())) return path;
  }
}

}  // namespace macula::tools
