#include "engine/gl/program_binaries.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <span>
#include <string>

#include "engine/core/sha256.h"

namespace macula::gl {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kExtension = ".program";
/// What a file is; another layout gets another line.
constexpr std::string_view kMagic = "macula program 1\n";
constexpr std::size_t kHashDigits = 64;
constexpr std::size_t kFormatDigits = 8;
/// Magic, hash of what follows it, format, binary.
constexpr std::size_t kFormatAt = kMagic.size() + kHashDigits;
constexpr std::size_t kBinaryAt = kFormatAt + kFormatDigits;

std::string hashOf(std::string_view bytes) {
  return sha256Hex(std::as_bytes(std::span(bytes)));
}

std::string textOf(GLenum name) {
  const GLubyte* value = glGetString(name);
  return value == nullptr ? std::string() : reinterpret_cast<const char*>(value);
}

/// Whole content of a file; empty where it cannot be read.
std::string contentOf(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// Writes beside the file, under a name of this process, and renames.
bool write(const fs::path& file, std::string_view bytes) {
  fs::path part = file;
  part += fmt::format(".{}.part", ::getpid());
  std::error_code error;
  {
    std::ofstream out(part, std::ios::binary | std::ios::trunc);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    out.close();
    if (out) fs::rename(part, file, error);
    if (out && !error) return true;
  }
  fs::remove(part, error);
  return false;
}

}  // namespace

std::optional<fs::path> programBinaryFolder() {
  const auto variable = [](const char* name) {
    const char* value = std::getenv(name);
    return fs::path(value == nullptr ? "" : value);
  };
  if (const fs::path chosen = variable("MACULA_SHADER_CACHE"); !chosen.empty()) {
    if (chosen == "off") return std::nullopt;
    return chosen;
  }
  // The XDG base directory specification ignores relative paths.
  if (const fs::path cache = variable("XDG_CACHE_HOME"); cache.is_absolute()) {
    return cache / "macula" / "shaders";
  }
  if (const fs::path home = variable("HOME"); home.is_absolute()) {
    return home / ".cache" / "macula" / "shaders";
  }
  return std::nullopt;
}

ProgramBinaries::ProgramBinaries(fs::path folder, std::uint64_t mostBytes)
    : folder_(std::move(folder)), mostBytes_(mostBytes) {
  GLint count = 0;
  glGetIntegerv(GL_NUM_PROGRAM_BINARY_FORMATS, &count);
  std::vector<GLint> formats(static_cast<std::size_t>(std::max(count, 0)));
  if (!formats.empty()) glGetIntegerv(GL_PROGRAM_BINARY_FORMATS, formats.data());
  for (const GLint format : formats) formats_.push_back(static_cast<GLenum>(format));
  for (const GLenum name : {GL_VENDOR, GL_RENDERER, GL_VERSION, GL_SHADING_LANGUAGE_VERSION}) {
    driver_ += textOf(name) + '\n';
  }
}

std::string ProgramBinaries::nameOf(std::string_view source) const {
  return hashOf(driver_ + std::string(source));
}

bool ProgramBinaries::load(GLuint program, const std::string& name) {
  if (!active()) return false;
  const fs::path file = folder_ / (name + std::string(kExtension));
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return false;
  const std::string bytes = contentOf(file);
  const std::string_view all = bytes;
  GLenum format = 0;
  bool whole = all.size() > kBinaryAt && all.starts_with(kMagic) &&
               all.substr(kMagic.size(), kHashDigits) == hashOf(all.substr(kFormatAt));
  if (whole) {
    const char* digits = all.data() + kFormatAt;
    whole = std::from_chars(digits, digits + kFormatDigits, format, 16).ec == std::errc{};
  }
  GLint linked = GL_FALSE;
  // A format that the driver does not know would be a GL error.
  if (whole && std::find(formats_.begin(), formats_.end(), format) != formats_.end()) {
    const std::string_view binary = all.substr(kBinaryAt);
    glProgramBinary(program, format, binary.data(), static_cast<GLsizei>(binary.size()));
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
  }
  if (linked != GL_TRUE) {
    ++counts_.refused;
    fs::remove(file, error);
    return false;
  }
  ++counts_.loaded;
  fs::last_write_time(file, fs::file_time_type::clock::now(), error);  // used lately
  return true;
}

void ProgramBinaries::store(GLuint program, const std::string& name) {
  if (!active() || !writable_) return;
  GLint length = 0;
  glGetProgramiv(program, GL_PROGRAM_BINARY_LENGTH, &length);
  if (length <= 0) return;
  std::string binary(static_cast<std::size_t>(length), '\0');
  GLenum format = 0;
  GLsizei written = 0;
  glGetProgramBinary(program, length, &written, &format, binary.data());
  if (written <= 0) return;
  binary.resize(static_cast<std::size_t>(written));
  const std::string content = fmt::format("{:08x}", format) + binary;
  std::error_code error;
  fs::create_directories(folder_, error);
  writable_ = !error && write(folder_ / (name + std::string(kExtension)),
                              std::string(kMagic) + hashOf(content) + content);
  ++(writable_ ? counts_.stored : counts_.lost);
}

void ProgramBinaries::trim() {
  if (!active()) return;
  struct File {
    fs::path path;
    std::uint64_t bytes;
    fs::file_time_type used;
  };
  std::vector<File> files;
  std::uint64_t sum = 0;
  std::error_code error;
  for (fs::directory_iterator it(folder_, error), end; !error && it != end; it.increment(error)) {
    std::error_code gone;  // another process trims, too
    const bool ours = it->path().extension() == kExtension || it->path().extension() == ".part";
    if (!ours || !it->is_regular_file(gone)) continue;
    const std::uint64_t bytes = it->file_size(gone);
    const fs::file_time_type used = it->last_write_time(gone);
    if (gone) continue;
    files.push_back({it->path(), bytes, used});
    sum += bytes;
  }
  std::sort(files.begin(), files.end(),
            [](const File& a, const File& b) { return a.used < b.used; });
  for (const File& file : files) {
    if (sum <= mostBytes_) break;
    if (fs::remove(file.path, error)) sum -= file.bytes;
  }
}

}  // namespace macula::gl
