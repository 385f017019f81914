#include "tests/hid/uhid_device.h"

#include <fcntl.h>
#include <linux/uhid.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <stdexcept>

namespace macula::gaze::hid::testing {
namespace {

constexpr std::uint8_t kConfigurationReport = 0x12;
constexpr std::uint8_t kControlReport = 0x14;
constexpr int kPollMs = 20;
/// As of <linux/input.h>; hid_enumerate passes over BUS_VIRTUAL.
constexpr std::uint16_t kBusUsb = 0x03;

void put(std::uint8_t* to, std::size_t size, const std::string& text) {
  std::memcpy(to, text.data(), std::min(size - 1, text.size()));
}

void write(int file, const uhid_event& event) {
  if (::write(file, &event, sizeof event) != static_cast<ssize_t>(sizeof event)) {
    throw std::runtime_error(std::string("uhid: ") + std::strerror(errno));
  }
}

}  // namespace

UhidDevice::UhidDevice(DeviceSettings settings) : settings_(std::move(settings)) {
  file_ = ::open("/dev/uhid", O_RDWR | O_CLOEXEC);
  if (file_ < 0) throw std::runtime_error(std::string("/dev/uhid: ") + std::strerror(errno));
  const auto event = std::make_unique<uhid_event>();
  event->type = UHID_CREATE2;
  uhid_create2_req& create = event->u.create2;
  put(create.name, sizeof create.name, settings_.name);
  put(create.uniq, sizeof create.uniq, settings_.serial);
  create.rd_size = static_cast<std::uint16_t>(settings_.descriptor.size());
  std::copy(settings_.descriptor.begin(), settings_.descriptor.end(), create.rd_data);
  create.bus = kBusUsb;
  create.vendor = settings_.vendorId;
  create.product = settings_.productId;
  write(file_, *event);
  server_ = std::thread([this] { serve(); });
}

UhidDevice::~UhidDevice() {
  stopServing();
  uhid_event event{};
  event.type = UHID_DESTROY;
  [[maybe_unused]] const ssize_t written = ::write(file_, &event, sizeof event);
  ::close(file_);
}

void UhidDevice::configure(std::vector<std::uint8_t> configuration) {
  const std::scoped_lock lock(mutex_);
  settings_.configuration = std::move(configuration);
}

void UhidDevice::stopServing() {
  stop_ = true;
  if (server_.joinable()) server_.join();
}

void UhidDevice::send(const std::vector<std::uint8_t>& report) {
  uhid_event event;
  event.type = UHID_INPUT2;
  event.u.input2.size = static_cast<std::uint16_t>(report.size());
  std::copy(report.begin(), report.end(), event.u.input2.data);
  // Only what is filled in: the kernel takes short events, and a whole one is four kilobytes.
  const std::size_t size =
      offsetof(uhid_event, u) + offsetof(uhid_input2_req, data) + report.size();
  if (::write(file_, &event, size) < 0) {
    throw std::runtime_error(std::string("uhid: ") + std::strerror(errno));
  }
}

void UhidDevice::serve() {
  const auto event = std::make_unique<uhid_event>();
  while (!stop_) {
    pollfd waited{.fd = file_, .events = POLLIN, .revents = 0};
    if (::poll(&waited, 1, kPollMs) <= 0) continue;
    *event = {};
    if (::read(file_, event.get(), sizeof *event) < 0) continue;
    const std::uint32_t type = event->type;
    if (type == UHID_OPEN) open_ = true;
    if (type == UHID_CLOSE) open_ = false;
    if (type == UHID_GET_REPORT && settings_.answersGet) {
      const uhid_get_report_req request = event->u.get_report;
      *event = {};
      event->type = UHID_GET_REPORT_REPLY;
      uhid_get_report_reply_req& reply = event->u.get_report_reply;
      reply.id = request.id;
      const std::scoped_lock lock(mutex_);
      const bool known = request.rnum == kConfigurationReport && !settings_.configuration.empty();
      reply.err = known ? std::uint16_t{0} : std::uint16_t{EIO};
      if (known) {
        reply.size = static_cast<std::uint16_t>(settings_.configuration.size());
        std::copy(settings_.configuration.begin(), settings_.configuration.end(), reply.data);
      }
      write(file_, *event);
    }
    if (type == UHID_SET_REPORT && settings_.answersSet) {
      const uhid_set_report_req request = event->u.set_report;
      if (request.rnum == kControlReport && request.size >= 2) mode_ = request.data[1];
      *event = {};
      event->type = UHID_SET_REPORT_REPLY;
      event->u.set_report_reply.id = request.id;
      event->u.set_report_reply.err = 0;
      write(file_, *event);
    }
  }
}

}  // namespace macula::gaze::hid::testing
