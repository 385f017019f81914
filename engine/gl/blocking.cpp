#include "engine/gl/blocking.h"

#include <chrono>
#include <numeric>

namespace macula::gl {
namespace {

BlockingCount& ofThisThread() {
  thread_local BlockingCount count;
  return count;
}

/// Counts a call and the time until it returns.
class Call {
 public:
  explicit Call(Blocking kind) { ++ofThisThread().calls[static_cast<std::size_t>(kind)]; }
  ~Call() {
    ofThisThread().waitedMs +=
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin_)
            .count();
  }
  Call(const Call&) = delete;
  Call& operator=(const Call&) = delete;

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace

std::uint64_t BlockingCount::total() const {
  return std::accumulate(calls.begin(), calls.end(), std::uint64_t{0});
}

const BlockingCount& blockingCount() {
  return ofThisThread();
}

void finish() {
  const Call call(Blocking::Finish);
  glFinish();
}

std::uint64_t queryResult(GLuint query) {
  const Call call(Blocking::QueryResult);
  GLuint64 result = 0;
  glGetQueryObjectui64v(query, GL_QUERY_RESULT, &result);
  return result;
}

void readBuffer(GLuint buffer, std::size_t offset, std::size_t bytes, void* into) {
  const Call call(Blocking::BufferRead);
  glGetNamedBufferSubData(buffer, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes),
                          into);
}

void readTexture(GLuint texture, PixelLayout layout, std::size_t bytes, void* into) {
  const Call call(Blocking::TextureRead);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glGetTextureImage(texture, 0, layout.format, layout.type, static_cast<GLsizei>(bytes), into);
}

void readTexture(GLuint texture, glm::ivec2 low, glm::ivec2 extent, PixelLayout layout,
                 std::size_t bytes, void* into) {
  const Call call(Blocking::TextureRead);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glGetTextureSubImage(texture, 0, low.x, low.y, 0, extent.x, extent.y, 1, layout.format,
                       layout.type, static_cast<GLsizei>(bytes), into);
}

void readPixels(glm::ivec2 size, PixelLayout layout, void* into) {
  const Call call(Blocking::PixelRead);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, size.x, size.y, layout.format, layout.type, into);
}

void waitFor(GLsync fence) {
  const Call call(Blocking::FenceWait);
  constexpr GLuint64 kNanoseconds = 1'000'000'000;
  // A long frame is waited for in several parts; a lost context ends the wait.
  while (glClientWaitSync(fence, GL_SYNC_FLUSH_COMMANDS_BIT, kNanoseconds) == GL_TIMEOUT_EXPIRED) {
  }
}

std::optional<std::uint64_t> resultIfThere(GLuint query) {
  // QUERY_RESULT_NO_WAIT would tell nothing from a result of 0.
  GLuint there = GL_FALSE;
  glGetQueryObjectuiv(query, GL_QUERY_RESULT_AVAILABLE, &there);
  if (there == GL_FALSE) return {};
  GLuint64 result = 0;
  glGetQueryObjectui64v(query, GL_QUERY_RESULT_NO_WAIT, &result);
  return result;
}

bool isReached(GLsync fence) {
  const GLenum state = glClientWaitSync(fence, GL_SYNC_FLUSH_COMMANDS_BIT, 0);
  return state == GL_ALREADY_SIGNALED || state == GL_CONDITION_SATISFIED;
}

}  // namespace macula::gl
