#include "engine/gl/readback.h"

#include <cassert>

#include "engine/core/error.h"
#include "engine/gl/blocking.h"

namespace macula::gl {

Readback::Readback(std::string_view name, std::size_t bytes, std::size_t slots)
    : bytes_(bytes), fences_(slots) {
  // Coherent: the GPU's writes before a fence can be read once it is reached, without a barrier.
  constexpr GLbitfield kAccess = GL_MAP_READ_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
  const auto size = static_cast<GLsizeiptr>(bytes * slots);
  GLuint id = 0;
  glCreateBuffers(1, &id);
  buffer_ = Object<BufferTraits>(id);
  glNamedBufferStorage(id, size, nullptr, kAccess | GL_CLIENT_STORAGE_BIT);
  label(GL_BUFFER, id, name);
  mapped_ = static_cast<const std::byte*>(glMapNamedBufferRange(id, 0, size, kAccess));
  if (mapped_ == nullptr) failInput("the GPU has no memory for {}; use a smaller --size", name);
}

void Readback::begin() {
  // The first bit is what a copy needs. But zink (Mesa 22.3) then still moves the copy before draws
  // of its batch that write the source as shader storage: so the batch is complete, and submitted.
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
  glFlush();
}

void Readback::copy(std::size_t slot, GLuint buffer, std::size_t offset, std::size_t bytes,
                    std::size_t at) {
  assert(at + bytes <= bytes_);
  glCopyNamedBufferSubData(buffer, buffer_.id(), static_cast<GLintptr>(offset),
                           static_cast<GLintptr>(slot * bytes_ + at),
                           static_cast<GLsizeiptr>(bytes));
}

void Readback::fence(std::size_t slot) {
  fences_[slot].reset(glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0));
}

bool Readback::ready(std::size_t slot) {
  if (fences_[slot] && isReached(fences_[slot].get())) fences_[slot].reset();
  return !fences_[slot];
}

void Readback::wait(std::size_t slot) {
  if (!fences_[slot]) return;
  waitFor(fences_[slot].get());
  fences_[slot].reset();
}

}  // namespace macula::gl
