#include "engine/gl/debug.h"

namespace macula::gl {
namespace {

void GLAPIENTRY receive(GLenum /*source*/, GLenum type, GLuint id, GLenum /*severity*/,
                        GLsizei length, const GLchar* text, const void* user) {
  // Only what a program does wrong; drivers also report shader statistics and buffer placement.
  if (type != GL_DEBUG_TYPE_ERROR && type != GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR &&
      type != GL_DEBUG_TYPE_DEPRECATED_BEHAVIOR) {
    return;
  }
  auto* log = static_cast<DebugLog*>(const_cast<void*>(user));
  log->add(type, id, std::string_view(text, static_cast<std::size_t>(length)));
}

// A faulty frame repeats its message for ever; the first ones tell what is wrong.
constexpr std::size_t kMaxMessages = 64;

}  // namespace

DebugLog::DebugLog() {
  glEnable(GL_DEBUG_OUTPUT);
  glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  glDebugMessageCallback(receive, this);
}

DebugLog::~DebugLog() {
  glDebugMessageCallback(nullptr, nullptr);
}

void DebugLog::add(GLenum /*type*/, GLuint id, std::string_view text) {
  outOfMemory_ = outOfMemory_ || id == GL_OUT_OF_MEMORY;
  if (messages_.size() < kMaxMessages) messages_.emplace_back(text);
}

bool isDebugContext() {
  GLint flags = 0;
  glGetIntegerv(GL_CONTEXT_FLAGS, &flags);
  return (static_cast<GLuint>(flags) & GL_CONTEXT_FLAG_DEBUG_BIT) != 0;
}

void reportMistake(std::string_view mistake) {
  glDebugMessageInsert(GL_DEBUG_SOURCE_APPLICATION, GL_DEBUG_TYPE_ERROR, 0, GL_DEBUG_SEVERITY_HIGH,
                       static_cast<GLsizei>(mistake.size()), mistake.data());
}

DebugGroup::DebugGroup(std::string_view name) {
  glPushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, static_cast<GLsizei>(name.size()), name.data());
}

DebugGroup::~DebugGroup() {
  glPopDebugGroup();
}

}  // namespace macula::gl
