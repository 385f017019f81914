#include "engine/core/file.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>
#include <system_error>

#include "engine/core/error.h"

namespace macula {
namespace fs = std::filesystem;

std::string readTextFile(const fs::path& path) {
  std::error_code error;
  if (!fs::exists(path, error)) {
    failInput("{}: no such file; check the path", path.string());
  }
  if (fs::is_directory(path, error)) {
    failInput("{}: is a folder; name a file in it", path.string());
  }
  if (!fs::is_regular_file(path, error)) {  // a device may never end
    failInput("{}: is no regular file; name one", path.string());
  }
  std::ifstream in(path, std::ios::binary);
  if (!in) {
    failInput("{}: cannot be read ({}); check its permissions", path.string(),
              std::strerror(errno));
  }
  std::ostringstream bytes;
  bytes << in.rdbuf();
  return std::move(bytes).str();
}

void writeFileAtomically(const fs::path& path, const std::function<void(const fs::path&)>& write) {
  fs::path temporary = path;
  temporary.replace_extension();
  temporary += ".part";
  temporary += path.extension();
  std::error_code error;
  try {
    write(temporary);
  } catch (...) {
    fs::remove(temporary, error);
    throw;
  }
  fs::rename(temporary, path, error);
  if (error) {
    const std::string reason = error.message();
    fs::remove(temporary, error);
    failInput("{}: cannot be written ({}); check the folder", path.string(), reason);
  }
}

void writeFileAtomically(const fs::path& path, std::string_view bytes) {
  writeFileAtomically(path, [&](const fs::path& temporary) {
    std::ofstream out(temporary, std::ios::binary | std::ios::trunc);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    out.close();
    if (!out) {
      failInput("{}: cannot be written ({}); check the folder and the space left", path.string(),
                std::strerror(errno));
    }
  });
}

void makeOutputFolder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error || !fs::is_directory(folder)) {
    failInput("{}: the output folder cannot be made ({}); choose another with --out",
              folder.string(), error ? error.message() : "a file stands there");
  }
  const fs::path probe = folder / fmt::format(".macula-{}.part", ::getpid());
  std::ofstream out(probe);
  if (!out) {
    failInput("{}: the output folder cannot be written ({}); choose another with --out",
              folder.string(), std::strerror(errno));
  }
  out.close();
  fs::remove(probe, error);
}

namespace {

/// The folder of the running program.
fs::path programFolder() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  return error ? fs::path() : program.parent_path();
}

}  // namespace

fs::path dataFolder(std::string_view name) {
  std::error_code error;
  std::vector<fs::path> roots;
  if (const char* chosen = std::getenv("MACULA_DATA")) roots.emplace_back(chosen);
  const fs::path program = programFolder();
  if (!program.empty()) roots.push_back(program / ".." / "share" / "macula");
  roots.emplace_back(MACULA_SOURCE_DIR);
  for (const fs::path& root : roots) {
    if (fs::is_directory(root / name, error)) return (root / name).lexically_normal();
  }
  failInput(
      "the folder '{}' that ships with Macula is missing; set MACULA_DATA to the folder that "
      "holds it",
      name);
}

fs::path moduleFile(std::string_view file) {
  const char* chosen = std::getenv("MACULA_MODULES");
  const fs::path program = programFolder();
  std::vector<fs::path> folders;  // absolute: without a folder the loader would search its own
  if (chosen != nullptr && *chosen != '\0') {
    folders = {fs::absolute(chosen)};
  } else if (!program.empty()) {
    folders = {program, program / ".." / "lib" / "macula"};
  }
  fs::path path = file;
  std::error_code error;
  for (const fs::path& folder : folders) {
    path = (folder / file).lexically_normal();
    if (fs::is_regular_file(path, error)) return path;
  }
  failInput(
      "{}: this part of Macula is missing; build or install Macula again, or set MACULA_MODULES to "
      "the folder that holds it",
      path.string());
}

}  // namespace macula
