#include "device/falcon_usb/usb_connection.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <exception>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include <dirent.h>
#include <libusb.h>
#include <sys/stat.h>

#include "device/guard/usb_node.h"
#include "device/input/monotonic_clock.h"

namespace ghostforce {
namespace {

constexpr std::size_t transfer_unit = 512;  // a transfer from the device is a multiple of this

// Right after a device was plugged in, the kernel has shown it and not yet given it its interfaces.
constexpr int claim_attempts = 10;
constexpr std::int64_t claim_pause_ns = 10'000'000;

constexpr unsigned attempt_ms = 10;    // of send()
constexpr unsigned last_send_ms = 20;  // of send_at_once()
// Closing waits no longer for that: a process that is ending may have lost the thread that sends.
constexpr std::int64_t last_send_patience_ns = 100'000'000;

void pause(std::int64_t ns) noexcept {
  sleep_until_monotonic(monotonic_ns() + ns);
}

}  // namespace

LinkFault link_fault_of(int libusb_error) noexcept {
  switch (libusb_error) {
    case LIBUSB_SUCCESS:
      return LinkFault::none;
    case LIBUSB_ERROR_ACCESS:
      return LinkFault::not_allowed;
    case LIBUSB_ERROR_BUSY:
      return LinkFault::busy;
    case LIBUSB_ERROR_NO_DEVICE:
      return LinkFault::unplugged;
    case LIBUSB_ERROR_NOT_SUPPORTED:
      return LinkFault::unsupported;
    default:
      return LinkFault::broken;
  }
}

LinkFault UsbConnection::open(const UsbId& id, const std::string& serial, const StopDebts& owed) noexcept {
  close();
  if (libusb_init(&context_) != LIBUSB_SUCCESS) {
    context_ = nullptr;
    return LinkFault::unsupported;
  }
  LinkFault fault = LinkFault::broken;
  try {
    fault = find_and_take(id, serial, owed);
    if (fault == LinkFault::none) find_descriptor();
  } catch (const std::exception&) {  // out of memory
    fault = LinkFault::broken;
  }
  if (fault != LinkFault::none) close();
  return fault;
}

LinkFault UsbConnection::find_and_take(const UsbId& id, const std::string& wanted, const StopDebts& owed) {
  struct Candidate {
    std::size_t place;  // among the debts
    std::string serial;
    libusb_device_handle* handle;
  };
  std::vector<Candidate> candidates;
  LinkFault fault = LinkFault::absent;
  libusb_device** devices = nullptr;
  const ssize_t count = libusb_get_device_list(context_, &devices);
  if (count < 0) return link_fault_of(static_cast<int>(count));
  for (ssize_t i = 0; i < count; ++i) {
    libusb_device_descriptor descriptor{};
    if (libusb_get_device_descriptor(devices[i], &descriptor) != LIBUSB_SUCCESS) continue;
    if (UsbId{descriptor.idVendor, descriptor.idProduct} != id) continue;
    libusb_device_handle* handle = nullptr;
    const int error = libusb_open(devices[i], &handle);
    if (error != LIBUSB_SUCCESS) {
      // One that may not be opened cannot tell whether it has the serial number that is wanted; it may be the one.
      if (fault == LinkFault::absent) fault = link_fault_of(error);
      continue;
    }
    // A device that does not even tell its name now is left for later: its calibration goes by it.
    std::optional<std::string> serial = usb_serial_of(handle);
    if (!serial && fault == LinkFault::absent) fault = LinkFault::broken;
    const std::size_t place = serial ? owed.place_of(device_serial_of(*serial)) : StopDebts::most;
    if (serial && (wanted.empty() || *serial == wanted || place < StopDebts::most)) {
      candidates.push_back({place, *std::move(serial), handle});
    } else {
      libusb_close(handle);
    }
  }
  libusb_free_device_list(devices, 1);

  std::ranges::sort(candidates, {}, [](const Candidate& one) { return std::tie(one.place, one.serial); });
  const bool is_any_owed = !candidates.empty() && candidates.front().place < StopDebts::most;
  for (Candidate& candidate : candidates) {
    const bool comes_later = is_any_owed && candidate.place == StopDebts::most;
    if (handle_ == nullptr && !comes_later) {
      const LinkFault why_not = take(candidate.handle);
      if (why_not == LinkFault::none) {
        serial_ = std::move(candidate.serial);
        continue;
      }
      // Why the device that comes first cannot be had says more than why another one tells nothing.
      if (fault == LinkFault::absent || is_any_owed) fault = why_not;
    }
    libusb_close(candidate.handle);
  }
  return handle_ != nullptr ? LinkFault::none : fault;
}

LinkFault UsbConnection::take(libusb_device_handle* handle) {
  // Another driver may have it if a person told the kernel so, or with the ids of another chip. Where the system knows
  // no such thing there is nothing to detach.
  libusb_set_auto_detach_kernel_driver(handle, 1);
  int error = LIBUSB_SUCCESS;
  for (int attempt = 0; attempt < claim_attempts; ++attempt) {
    if (attempt > 0) pause(claim_pause_ns);
    error = libusb_claim_interface(handle, interface_number);
    // Two words for an interface that is not there yet: the second where a driver was to be detached first.
    if (error != LIBUSB_ERROR_NOT_FOUND && error != LIBUSB_ERROR_INVALID_PARAM) break;
  }
  if (error != LIBUSB_SUCCESS) return link_fault_of(error);
  LinkFault fault = find_endpoints(handle);
  if (fault == LinkFault::none) {
    handle_ = handle;
    fault = clear_halts(handle);
  }
  if (fault != LinkFault::none) {
    handle_ = nullptr;
    libusb_release_interface(handle, interface_number);
  }
  return fault;
}

LinkFault UsbConnection::find_endpoints(libusb_device_handle* handle) {
  libusb_config_descriptor* configuration = nullptr;
  const int error = libusb_get_active_config_descriptor(libusb_get_device(handle), &configuration);
  if (error != LIBUSB_SUCCESS) return link_fault_of(error);
  in_endpoint_ = out_endpoint_ = 0;
  if (configuration->bNumInterfaces > 0 && configuration->interface[0].num_altsetting > 0) {
    const libusb_interface_descriptor& interface = configuration->interface[0].altsetting[0];
    for (int i = 0; i < interface.bNumEndpoints; ++i) {
      const libusb_endpoint_descriptor& endpoint = interface.endpoint[i];
      if ((endpoint.bmAttributes & LIBUSB_TRANSFER_TYPE_MASK) != LIBUSB_TRANSFER_TYPE_BULK) continue;
      if ((endpoint.bEndpointAddress & LIBUSB_ENDPOINT_DIR_MASK) == LIBUSB_ENDPOINT_IN) {
        in_endpoint_ = endpoint.bEndpointAddress;
        packet_size_ = endpoint.wMaxPacketSize;
      } else {
        out_endpoint_ = endpoint.bEndpointAddress;
      }
    }
  }
  libusb_free_config_descriptor(configuration);
  // A transfer has to end where a packet ends.
  const bool fits =
      in_endpoint_ != 0 && out_endpoint_ != 0 && packet_size_ > ftdi_status_size && transfer_unit % packet_size_ == 0;
  return fits ? LinkFault::none : LinkFault::unsupported;
}

// A chip that refuses the request has nothing to clear.
LinkFault UsbConnection::clear_halts(libusb_device_handle* handle) const noexcept {
  for (const std::uint8_t endpoint : {out_endpoint_, in_endpoint_}) {
    const int error = libusb_clear_halt(handle, endpoint);
    if (error != LIBUSB_SUCCESS && error != LIBUSB_ERROR_PIPE) return link_fault_of(error);
  }
  return LinkFault::none;
}

std::string UsbConnection::node() const {
  return usb_node_of(libusb_get_device(handle_));
}

// libusb does not tell which file it has opened; it is the one that is the same device as the node on the bus.
void UsbConnection::find_descriptor() {
  struct stat node {};
  if (stat(this->node().c_str(), &node) != 0) return;
  DIR* folder = opendir("/proc/self/fd");
  if (folder == nullptr) return;
  while (const dirent* entry = readdir(folder)) {
    // By its name: other threads may be closing theirs.
    const std::string name = std::string("/proc/self/fd/") + entry->d_name;
    struct stat file {};
    if (stat(name.c_str(), &file) != 0 || !S_ISCHR(file.st_mode) || file.st_rdev != node.st_rdev) continue;
    descriptor_ = std::atoi(entry->d_name);
  }
  closedir(folder);
}

LinkFault UsbConnection::send(std::span<const std::uint8_t> bytes) noexcept {
  if (handle_ == nullptr) return LinkFault::absent;
  int sent = 0;
  // Outwards: libusb reads it.
  const int error = libusb_bulk_transfer(handle_, out_endpoint_, const_cast<std::uint8_t*>(bytes.data()),
                                         static_cast<int>(bytes.size()), &sent, attempt_ms);
  if (error == LIBUSB_ERROR_PIPE) libusb_clear_halt(handle_, out_endpoint_);
  return link_fault_of(error);
}

void UsbConnection::send_at_once(std::span<const std::uint8_t> bytes) noexcept {
  const int error_before = errno;
  is_sending_at_once_ = true;
  if (const int descriptor = descriptor_; descriptor >= 0)
    usb_node::send_once(descriptor, out_endpoint_, bytes, last_send_ms);
  is_sending_at_once_ = false;
  errno = error_before;
}

// The number of a file that is closed may be another file's at once: not while somebody sends by it.
void UsbConnection::release_device() noexcept {
  if (handle_ == nullptr) return;
  descriptor_ = -1;
  const std::int64_t deadline_ns = monotonic_ns() + last_send_patience_ns;
  while (is_sending_at_once_ && monotonic_ns() < deadline_ns) pause(100'000);
  libusb_release_interface(handle_, interface_number);
  libusb_close(std::exchange(handle_, nullptr));
}

void UsbConnection::close() noexcept {
  release_device();
  if (context_ != nullptr) libusb_exit(std::exchange(context_, nullptr));
}

}  // namespace ghostforce
