#include "engine/gl/program.h"

#include <fmt/format.h>

#include <stdexcept>

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

void compileInto(GLuint program, std::string_view file, const std::string& text) {
  const GLuint shader = glCreateShader(stageOf(file));
  const char* source = text.c_str();
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  GLint compiled = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  const std::string messages = compiled == GL_TRUE ? std::string() : infoLog(shader, false);
  glAttachShader(program, shader);
  glDeleteShader(shader);  // goes with the program
  if (compiled != GL_TRUE) {
    throw std::runtime_error(fmt::format("shader {} does not compile: {}", file, messages));
  }
}

}  // namespace

ProgramCache::ProgramCache(std::filesystem::path shaderFolder) : folder_(std::move(shaderFolder)) {}

GLuint ProgramCache::get(const ProgramKey& key) {
  const auto found = programs_.find(key);
  const GLuint id = found != programs_.end() ? found->second.id() : make(key);
  if (record_ != nullptr) record_->push_back(id);
  return id;
}

GLuint ProgramCache::make(const ProgramKey& key) {
  ProgramId program(glCreateProgram());
  for (const std::string& file : key.files) {
    compileInto(program.id(), file, assembleShader(folder_, file, key.defines, key.extensions));
  }
  glLinkProgram(program.id());
  GLint linked = GL_FALSE;
  glGetProgramiv(program.id(), GL_LINK_STATUS, &linked);
  if (linked != GL_TRUE) {
    throw std::runtime_error(
        fmt::format("program {} does not link: {}", key.files.back(), infoLog(program.id(), true)));
  }
  label(GL_PROGRAM, program.id(), key.files.back());
  return programs_.emplace(key, std::move(program)).first->second.id();
}

}  // namespace macula::gl
