#include "engine/gl/program.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <thread>

#include "engine/gl/capabilities.h"

namespace macula::gl {
namespace {

GLenum stageOf(std::string_view file) {
  if (file.ends_with(".vert")) return GL_VERTEX_SHADER;
  if (file.ends_with(".frag")) return GL_FRAGMENT_SHADER;
  if (file.ends_with(".comp")) return GL_COMPUTE_SHADER;
  throw std::logic_error(fmt::format("{}: the suffix names no shader stage", file));
}

std::string infoLog(GLuint id, bool program) {
  GLint length = 0;
  if (program) {
    glGetProgramiv(id, GL_INFO_LOG_LENGTH, &length);
  } else {
    glGetShaderiv(id, GL_INFO_LOG_LENGTH, &length);
  }
  std::string text(static_cast<std::size_t>(length), '\0');
  if (program) {
    glGetProgramInfoLog(id, length, nullptr, text.data());
  } else {
    glGetShaderInfoLog(id, length, nullptr, text.data());
  }
  return text;
}

/// Waits until a question about the program does not block.
void awaitLink(GLuint program) {
  constexpr auto kPause = std::chrono::milliseconds(1);
  for (;;) {
    GLint done = GL_FALSE;
    glGetProgramiv(program, GL_COMPLETION_STATUS_KHR, &done);
    if (done == GL_TRUE) return;
    std::this_thread::sleep_for(kPause);
  }
}

/// Does not ask for the outcome, which would wait for it.
void compileInto(GLuint program, std::string_view file, const std::string& text) {
  const GLuint shader = glCreateShader(stageOf(file));
  const char* source = text.c_str();
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  glAttachShader(program, shader);
  glDeleteShader(shader);  // goes with the program
}

/// Throws for the first shader of a program that does not compile.
void checkShaders(GLuint program, const std::vector<std::string>& files) {
  std::vector<GLuint> shaders(files.size());
  GLsizei count = 0;
  glGetAttachedShaders(program, static_cast<GLsizei>(shaders.size()), &count, shaders.data());
  for (GLsizei i = 0; i < count; ++i) {
    const GLuint shader = shaders[static_cast<std::size_t>(i)];
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled == GL_TRUE) continue;
    GLint stage = 0;
    glGetShaderiv(shader, GL_SHADER_TYPE, &stage);
    const auto file = std::find_if(files.begin(), files.end(), [&](const std::string& name) {
      return stageOf(name) == static_cast<GLenum>(stage);
    });
    throw std::runtime_error(fmt::format("shader {} does not compile: {}",
                                         file == files.end() ? files.back() : *file,
                                         infoLog(shader, false)));
  }
}

}  // namespace

ProgramCache::ProgramCache(std::filesystem::path shaderFolder, ProgramBinaries binaries)
    : folder_(std::move(shaderFolder)), binaries_(std::move(binaries)) {}

GLuint ProgramCache::get(const ProgramKey& key) {
  ProgramKey whole = key;
  whole.defines.insert(whole.defines.end(), defines_.begin(), defines_.end());
  const auto found = programs_.find(whole);
  GLuint id = 0;
  if (found != programs_.end()) {
    id = found->second.id();
  } else {
    ProgramId program(glCreateProgram());
    id = program.id();
    programs_.emplace(whole, std::move(program));
    waiting_.push_back({.key = std::move(whole), .program = id, .binary = {}, .loaded = false});
  }
  if (!batched_ && !waiting_.empty()) {
    const Batch alone(*this);
    makeWaiting();
  }
  if (record_ != nullptr) record_->push_back(id);
  return id;
}

void ProgramCache::endBatch() {
  batched_ = false;
  for (const Job& job : waiting_) programs_.erase(job.key);
  waiting_.clear();
}

void ProgramCache::makeWaiting() {
  const bool polls = compilesInParallel();
  const std::size_t total = 2 * waiting_.size();
  std::size_t done = 0;
  const auto advance = [&] {
    ++done;
    if (progress_) progress_(done, total);
  };
  // One driver compiles here, another aside, and a third while its answer is waited for.
  for (Job& job : waiting_) {
    issue(job);
    advance();
  }
  bool stores = false;
  for (const Job& job : waiting_) {
    if (polls && !job.loaded) awaitLink(job.program);
    complete(job);
    advance();
    stores = stores || !job.loaded;
  }
  waiting_.clear();
  if (stores) binaries_.trim();
}

void ProgramCache::issue(Job& job) {
  std::vector<std::string> texts;
  std::string source;
  for (const std::string& file : job.key.files) {
    texts.push_back(assembleShader(folder_, file, job.key.defines, job.key.extensions));
    source += fmt::format("{} {}\n", file, texts.back().size()) + texts.back();
  }
  if (binaries_.active()) {
    job.binary = binaries_.nameOf(source);
    job.loaded = binaries_.load(job.program, job.binary);
    if (job.loaded) return;
    glProgramParameteri(job.program, GL_PROGRAM_BINARY_RETRIEVABLE_HINT, GL_TRUE);
  }
  for (std::size_t i = 0; i < texts.size(); ++i) {
    compileInto(job.program, job.key.files[i], texts[i]);
  }
  glLinkProgram(job.program);
}

void ProgramCache::complete(const Job& job) {
  const std::string& name = job.key.files.back();
  if (!job.loaded) {
    GLint linked = GL_FALSE;
    glGetProgramiv(job.program, GL_LINK_STATUS, &linked);
    if (linked != GL_TRUE) {
      checkShaders(job.program, job.key.files);
      throw std::runtime_error(
          fmt::format("program {} does not link: {}", name, infoLog(job.program, true)));
    }
    binaries_.store(job.program, job.binary);
  }
  label(GL_PROGRAM, job.program, name);
}

}  // namespace macula::gl
