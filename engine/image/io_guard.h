// What both image modules need at their border: exceptions become a status, words a message.
#pragma once

#include <algorithm>
#include <cstring>
#include <exception>
#include <new>
#include <string_view>

#include "engine/image/io_module.h"

namespace macula::image {

/// @return the status, so that a call can end with it
inline IoStatus explained(IoStatus status, std::string_view why, IoMessage* message) {
  const std::size_t length = std::min(why.size(), sizeof(message->text) - 1);
  std::memcpy(message->text, why.data(), length);
  message->text[length] = '\0';
  return status;
}

/// Runs `call`, which gives a status; its exceptions become one.
template <typename Call>
IoStatus guarded(IoMessage* message, Call call) {
  try {
    return call();
  } catch (const std::bad_alloc&) {
    return IoStatus::OutOfMemory;
  } catch (const std::exception& error) {
    return explained(IoStatus::Fault, error.what(), message);
  } catch (...) {
    return explained(IoStatus::Fault, "an exception of an unknown type", message);
  }
}

}  // namespace macula::image
