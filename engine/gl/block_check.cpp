#include "engine/gl/block_check.h"

#include <fmt/format.h>

#include <array>
#include <string>

namespace macula::gl {
namespace {

bool checks = false;

struct BlockKind {
  GLenum interface;
  GLenum binding;
  GLenum size;
  std::string_view name;
};

constexpr std::array<BlockKind, 2> kKinds{
    {{GL_SHADER_STORAGE_BLOCK, GL_SHADER_STORAGE_BUFFER_BINDING, GL_SHADER_STORAGE_BUFFER_SIZE,
      "storage"},
     {GL_UNIFORM_BLOCK, GL_UNIFORM_BUFFER_BINDING, GL_UNIFORM_BUFFER_SIZE, "uniform"}}};

std::string nameOfBlock(GLuint program, GLenum interface, GLuint index) {
  constexpr GLsizei kLongest = 64;
  std::array<GLchar, kLongest> name{};
  glGetProgramResourceName(program, interface, index, kLongest, nullptr, name.data());
  return name.data();
}

/// Bytes of the buffer at an indexed binding point; 0 where there is none.
GLint64 backedBytes(const BlockKind& kind, GLuint point) {
  GLint buffer = 0;
  glGetIntegeri_v(kind.binding, point, &buffer);
  if (buffer == 0) return 0;
  GLint64 range = 0;  // 0: the whole buffer
  glGetInteger64i_v(kind.size, point, &range);
  if (range == 0) {
    glGetNamedBufferParameteri64v(static_cast<GLuint>(buffer), GL_BUFFER_SIZE, &range);
  }
  return range;
}

/// Drivers state the size of a block in whole vectors; an array of fewer elements is no mistake.
GLint64 roundedUp(GLint64 bytes) {
  constexpr GLint64 kVector = 16;
  return (bytes + kVector - 1) / kVector * kVector;
}

void checkKind(GLuint program, const BlockKind& kind) {
  GLint blocks = 0;
  glGetProgramInterfaceiv(program, kind.interface, GL_ACTIVE_RESOURCES, &blocks);
  for (GLuint i = 0; i < static_cast<GLuint>(blocks); ++i) {
    constexpr std::array<GLenum, 2> kAsked{GL_BUFFER_BINDING, GL_BUFFER_DATA_SIZE};
    std::array<GLint, 2> answers{};
    glGetProgramResourceiv(program, kind.interface, i, kAsked.size(), kAsked.data(), answers.size(),
                           nullptr, answers.data());
    const GLint64 bytes = backedBytes(kind, static_cast<GLuint>(answers[0]));
    if (bytes > 0 && roundedUp(bytes) >= answers[1]) continue;
    std::array<GLchar, 128> label{};
    glGetObjectLabel(GL_PROGRAM, program, static_cast<GLsizei>(label.size()), nullptr,
                     label.data());
    BlockCheck::report(fmt::format(
        "{}: {} block {} at binding {} needs {} bytes and is backed by {}", label.data(), kind.name,
        nameOfBlock(program, kind.interface, i), answers[0], answers[1], bytes));
  }
}

}  // namespace

void BlockCheck::enableInDebugContext() {
  GLint flags = 0;
  glGetIntegerv(GL_CONTEXT_FLAGS, &flags);
  checks = (static_cast<GLuint>(flags) & GL_CONTEXT_FLAG_DEBUG_BIT) != 0;
}

bool BlockCheck::enabled() {
  return checks;
}

void BlockCheck::report(const std::string& mistake) {
  glDebugMessageInsert(GL_DEBUG_SOURCE_APPLICATION, GL_DEBUG_TYPE_ERROR, 0, GL_DEBUG_SEVERITY_HIGH,
                       static_cast<GLsizei>(mistake.size()), mistake.data());
}

void BlockCheck::beginPass() {
  if (!checks) return;
  GLint points = 0;
  glGetIntegerv(GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS, &points);
  glBindBuffersBase(GL_SHADER_STORAGE_BUFFER, 0, points, nullptr);
}

void BlockCheck::beforeUse() {
  if (!checks) return;
  GLint program = 0;
  glGetIntegerv(GL_CURRENT_PROGRAM, &program);
  for (const BlockKind& kind : kKinds) checkKind(static_cast<GLuint>(program), kind);
}

}  // namespace macula::gl
