// An eye tracker that the kernel takes for real, made through /dev/uhid.
#pragma once

#include <atomic>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace macula::gaze::hid::testing {

struct DeviceSettings {
  std::string name = "Test tracker";
  std::string serial;
  std::uint16_t vendorId = 0x1209;
  std::uint16_t productId = 0x0001;
  std::vector<std::uint8_t> descriptor;
  std::vector<std::uint8_t> configuration;  ///< answer to a get of feature 0x12
  bool answersGet = true;                   ///< otherwise the kernel waits until its timeout
  bool answersSet = true;
};

/// Plugged in by its constructor, unplugged by its destructor. Throws std::runtime_error.
class UhidDevice {
 public:
  explicit UhidDevice(DeviceSettings settings);
  UhidDevice(const UhidDevice&) = delete;
  UhidDevice& operator=(const UhidDevice&) = delete;
  ~UhidDevice();

  /// Ends answering requests, so that the destructor unplugs without delay.
  void stopServing();
  /// Changes the answer to a get of feature 0x12.
  void configure(std::vector<std::uint8_t> configuration);
  /// Sends an input report.
  void send(const std::vector<std::uint8_t>& report);
  /// The last mode that was written to feature 0x14; 0 before.
  [[nodiscard]] int mode() const { return mode_; }
  /// Some program has it open.
  [[nodiscard]] bool isOpen() const { return open_; }

 private:
  void serve();

  DeviceSettings settings_;
  std::mutex mutex_;  ///< of settings_.configuration
  int file_ = -1;
  std::atomic<int> mode_{0};
  std::atomic<bool> open_{false};
  std::atomic<bool> stop_{false};
  std::thread server_;
};

}  // namespace macula::gaze::hid::testing
