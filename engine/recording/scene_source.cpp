#include "engine/recording/scene_source.h"

#include "engine/core/error.h"
#include "engine/core/sha256.h"

namespace macula::recording {

void checkFile(const std::filesystem::path& file, const std::string& sha256) {
  if (fileSha256(file) == sha256) return;
  failInput("{}: is no longer the file of the recording (SHA-256 {}); put that one back",
            file.string(), sha256);
}

SceneSource sourceOf(const std::string& nameOrPath) {
  SceneSource source;
  source.name = nameOrPath;
  // Procedural names have no extension, and files that can be loaded always have one.
  if (!std::filesystem::path(nameOrPath).has_extension()) return source;
  source.file = std::filesystem::absolute(nameOrPath).lexically_normal().string();
  source.sha256 = fileSha256(nameOrPath);
  return source;
}

std::string checkedScene(const SceneSource& scene) {
  if (scene.file.empty()) return scene.name;
  checkFile(scene.file, scene.sha256);
  return scene.file;
}

}  // namespace macula::recording
