// Errors that a user can fix. The program prints them as one line and exits with status 2.
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace macula {

/// Bad input or a limit of the machine: what() is one line that names the file (or setting), the
/// place in it, what is wrong and how to fix it. Never thrown for a mistake in Macula itself.
class InputError : public std::runtime_error {
 public:
  explicit InputError(const std::string& message);
};

/// Replaces line breaks and control characters, so that a message stays one line.
/// @param text any bytes, for example a path or a field of a damaged file
[[nodiscard]] std::string oneLine(std::string_view text);

/// Throws an InputError with a formatted message.
template <typename... Args>
[[noreturn]] void failInput(fmt::format_string<Args...> format, Args&&... args) {
  throw InputError(fmt::format(format, std::forward<Args>(args)...));
}

}  // namespace macula
