// An open hidraw device.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace macula::gaze::hid {

/// Reads the device file itself and not through hidapi: hid_read_timeout answers an unplug with an
/// error that has no number, and throws away the reports that still wait; the file gives them all,
/// then EIO. Reading and the feature requests may run on two threads.
class HidrawLink {
 public:
  /// Opens for reading and writing, without waiting. See isOpen() and error().
  explicit HidrawLink(const std::string& path);
  HidrawLink(const HidrawLink&) = delete;
  HidrawLink& operator=(const HidrawLink&) = delete;
  ~HidrawLink();

  [[nodiscard]] bool isOpen() const { return file_ >= 0; }
  /// errno of the failed open.
  [[nodiscard]] int error() const { return error_; }

  enum class Read { Report, Nothing, Gone };
  /// The next report that waits, else waits for one. An unplug ends the waiting at once.
  /// @param bytes holds the report afterwards; it takes up to its own size @param length of it
  [[nodiscard]] Read read(std::span<std::uint8_t> bytes, std::size_t& length,
                          int timeoutMilliseconds) const;

  /// Asks for a feature report; empty where the device does not answer or refuses. The kernel waits
  /// for the device, five seconds at most, and opens no other hidraw device meanwhile.
  [[nodiscard]] std::vector<std::uint8_t> getFeature(std::uint8_t reportId,
                                                     std::size_t bytes) const;
  /// Sends one. @param bytes begin with the report id, 0 where reports are not numbered
  /// @return false as above
  [[nodiscard]] bool setFeature(std::span<const std::uint8_t> bytes) const;

 private:
  int file_ = -1;
  int error_ = 0;
};

}  // namespace macula::gaze::hid
