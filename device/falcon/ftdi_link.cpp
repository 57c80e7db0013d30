#include "device/falcon/ftdi_link.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <exception>
#include <utility>
#include <vector>

#include <dirent.h>
#include <libusb.h>
#include <linux/usbdevice_fs.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <time.h>

#include "device/monotonic_clock.h"

namespace ghostforce {
namespace {

constexpr int interface_number = 0;
constexpr std::size_t status_size = 2;  // at the beginning of every packet that comes in
constexpr std::uint8_t line_error_bits = 0x0E;
constexpr std::uint8_t vendor_request_type = 0x40;  // to the device, of the maker's, without data

// A transfer may fail once; a cable that is being pulled makes several fail before the system says that it is
// unplugged. All posted transfers fail together, so that this stands for a few incidents.
constexpr int most_failures_in_a_row = 16;

constexpr unsigned send_timeout_ms = 1000;
constexpr unsigned last_send_timeout_ms = 20;
constexpr std::int64_t close_timeout_ns = 200'000'000;
// While nothing comes, libusb is asked this often whether a transfer has timed out.
constexpr std::int64_t longest_wait_ns = 20'000'000;

// Right after a device was plugged in, the kernel has shown it and not yet given it its interfaces.
constexpr int claim_attempts = 10;
constexpr std::int64_t claim_pause_ns = 10'000'000;

timespec timespec_of(std::int64_t ns) noexcept {
  return {ns / 1'000'000'000, ns % 1'000'000'000};
}

LinkFault fault_of(int libusb_error) noexcept {
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

}  // namespace

struct FtdiLink::Callbacks {
  static void LIBUSB_CALL received(libusb_transfer* transfer) {
    auto& receiver = *static_cast<Receiver*>(transfer->user_data);
    receiver.link->received(receiver);
  }
  static void LIBUSB_CALL sent(libusb_transfer* transfer) {
    static_cast<FtdiLink*>(transfer->user_data)->sent(*transfer);
  }
};

// --- Opening and closing ---------------------------------------------------------------------------------------------

LinkFault FtdiLink::open() noexcept {
  close();
  counters_ = {};
  modem_status_ = 0;
  first_ = held_ = 0;
  failures_in_a_row_ = 0;
  ++counters_.library_calls;
  if (libusb_init(&context_) != LIBUSB_SUCCESS) {
    context_ = nullptr;
    return fault_ = LinkFault::unsupported;
  }
  try {
    fault_ = find_and_take();
    if (fault_ == LinkFault::none && !make_transfers()) fault_ = LinkFault::broken;
    if (fault_ == LinkFault::none) {
      find_descriptor();
      find_poll_descriptors();
    }
  } catch (const std::exception&) {  // out of memory
    fault_ = LinkFault::broken;
  }
  for (Receiver& receiver : receivers_) {
    if (fault_ == LinkFault::none) post(receiver);
  }
  if (fault_ != LinkFault::none) close();
  return fault_;
}

LinkFault FtdiLink::find_and_take() {
  struct Candidate {
    std::string serial;
    libusb_device_handle* handle;
  };
  std::vector<Candidate> candidates;
  LinkFault fault = LinkFault::absent;
  libusb_device** devices = nullptr;
  ++counters_.library_calls;
  const ssize_t count = libusb_get_device_list(context_, &devices);
  if (count < 0) return fault_of(static_cast<int>(count));
  for (ssize_t i = 0; i < count; ++i) {
    libusb_device_descriptor descriptor{};
    if (libusb_get_device_descriptor(devices[i], &descriptor) != LIBUSB_SUCCESS) continue;
    if (UsbId{descriptor.idVendor, descriptor.idProduct} != options_.id) continue;
    libusb_device_handle* handle = nullptr;
    ++counters_.library_calls;
    const int error = libusb_open(devices[i], &handle);
    if (error != LIBUSB_SUCCESS) {
      // One that may not be opened cannot tell whether it has the serial number that is wanted; it may be the one.
      if (fault == LinkFault::absent) fault = fault_of(error);
      continue;
    }
    std::string serial = usb_serial_of(handle);
    if (options_.serial.empty() || serial == options_.serial) {
      candidates.push_back({std::move(serial), handle});
    } else {
      libusb_close(handle);
    }
  }
  libusb_free_device_list(devices, 1);

  std::sort(candidates.begin(), candidates.end(),
            [](const Candidate& a, const Candidate& b) { return a.serial < b.serial; });
  for (Candidate& candidate : candidates) {
    if (handle_ == nullptr) {
      const LinkFault why_not = take(candidate.handle);
      if (why_not == LinkFault::none) {
        serial_ = std::move(candidate.serial);
        continue;
      }
      if (fault == LinkFault::absent) fault = why_not;
    }
    libusb_close(candidate.handle);
  }
  return handle_ != nullptr ? LinkFault::none : fault;
}

LinkFault FtdiLink::take(libusb_device_handle* handle) {
  // Another driver may have it if a person told the kernel so, or with the ids of another chip. Where the system knows
  // no such thing there is nothing to detach.
  libusb_set_auto_detach_kernel_driver(handle, 1);
  int error = LIBUSB_SUCCESS;
  for (int attempt = 0; attempt < claim_attempts; ++attempt) {
    if (attempt > 0) {
      const timespec pause = timespec_of(claim_pause_ns);
      nanosleep(&pause, nullptr);
    }
    ++counters_.library_calls;
    error = libusb_claim_interface(handle, interface_number);
    // Two words for an interface that is not there yet: the second where a driver was to be detached first.
    if (error != LIBUSB_ERROR_NOT_FOUND && error != LIBUSB_ERROR_INVALID_PARAM) break;
  }
  if (error != LIBUSB_SUCCESS) return fault_of(error);
  handle_ = handle;
  const LinkFault fault = find_endpoints();
  if (fault != LinkFault::none) {
    libusb_release_interface(handle, interface_number);
    handle_ = nullptr;
  }
  is_claimed_ = handle_ != nullptr;
  return fault;
}

LinkFault FtdiLink::find_endpoints() {
  libusb_config_descriptor* configuration = nullptr;
  ++counters_.library_calls;
  const int error = libusb_get_active_config_descriptor(libusb_get_device(handle_), &configuration);
  if (error != LIBUSB_SUCCESS) return fault_of(error);
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
      in_endpoint_ != 0 && out_endpoint_ != 0 && packet_size_ > status_size && in_size % packet_size_ == 0;
  return fits ? LinkFault::none : LinkFault::unsupported;
}

bool FtdiLink::make_transfers() {
  for (Receiver& receiver : receivers_) {
    receiver.link = this;
    receiver.transfer = libusb_alloc_transfer(0);
    if (receiver.transfer == nullptr) return false;
    libusb_fill_bulk_transfer(receiver.transfer, handle_, in_endpoint_, receiver.buffer.data(), int{in_size},
                              &Callbacks::received, &receiver, 0);
  }
  out_transfer_ = libusb_alloc_transfer(0);
  control_transfer_ = libusb_alloc_transfer(0);
  return out_transfer_ != nullptr && control_transfer_ != nullptr;
}

// libusb does not tell which file it has opened; it is the one that is the same device as the node on the bus.
void FtdiLink::find_descriptor() {
  struct stat node {};
  if (stat(usb_node_of(libusb_get_device(handle_)).c_str(), &node) != 0) return;
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

void FtdiLink::find_poll_descriptors() {
  poll_count_ = 0;
  const libusb_pollfd** const list = libusb_get_pollfds(context_);
  if (list == nullptr) return;
  for (const libusb_pollfd** entry = list; *entry != nullptr && poll_count_ < poll_descriptors_.size(); ++entry) {
    poll_descriptors_[poll_count_++] = {(*entry)->fd, (*entry)->events, 0};
  }
  libusb_free_pollfds(list);
}

void FtdiLink::close() noexcept {
  if (context_ == nullptr) return;
  descriptor_ = -1;
  closing_ = true;
  for (Receiver& receiver : receivers_) {
    if (receiver.is_posted) libusb_cancel_transfer(receiver.transfer);
  }
  if (sending_) {
    libusb_cancel_transfer(out_transfer_);
    libusb_cancel_transfer(control_transfer_);
  }
  const std::int64_t deadline_ns = monotonic_ns() + close_timeout_ns;
  while (is_anything_posted() && monotonic_ns() < deadline_ns) handle_events(10);
  if (is_claimed_) libusb_release_interface(handle_, interface_number);
  if (handle_ != nullptr) libusb_close(handle_);
  // After the handle: a transfer that did not come back in time is libusb's until then.
  for (Receiver& receiver : receivers_) {
    libusb_free_transfer(std::exchange(receiver.transfer, nullptr));
    receiver.is_posted = false;
  }
  libusb_free_transfer(std::exchange(out_transfer_, nullptr));
  libusb_free_transfer(std::exchange(control_transfer_, nullptr));
  libusb_exit(context_);
  context_ = nullptr;
  handle_ = nullptr;
  is_claimed_ = sending_ = closing_ = false;
  poll_count_ = 0;
}

bool FtdiLink::is_anything_posted() const noexcept {
  return sending_ ||
         std::any_of(receivers_.begin(), receivers_.end(), [](const Receiver& receiver) { return receiver.is_posted; });
}

// --- Out -------------------------------------------------------------------------------------------------------------

bool FtdiLink::request(const VendorRequest& request) noexcept {
  if (handle_ == nullptr || fault_ != LinkFault::none || sending_) return false;
  libusb_fill_control_setup(setup_buffer_.data(), vendor_request_type, request.request, request.value, request.index,
                            0);
  libusb_fill_control_transfer(control_transfer_, handle_, setup_buffer_.data(), &Callbacks::sent, this,
                               send_timeout_ms);
  return send(control_transfer_);
}

bool FtdiLink::write(std::span<const std::uint8_t> bytes) noexcept {
  if (handle_ == nullptr || fault_ != LinkFault::none || sending_ || bytes.size() > out_size) return false;
  std::copy(bytes.begin(), bytes.end(), out_buffer_.begin());
  libusb_fill_bulk_transfer(out_transfer_, handle_, out_endpoint_, out_buffer_.data(), static_cast<int>(bytes.size()),
                            &Callbacks::sent, this, send_timeout_ms);
  return send(out_transfer_);
}

bool FtdiLink::send(libusb_transfer* transfer) noexcept {
  ++counters_.library_calls;
  const int error = libusb_submit_transfer(transfer);
  if (error != LIBUSB_SUCCESS) set_fault(fault_of(error));
  sending_ = error == LIBUSB_SUCCESS;
  return sending_;
}

void FtdiLink::sent(const libusb_transfer& transfer) noexcept {
  sending_ = false;
  something_happened_ = true;
  if (transfer.status == LIBUSB_TRANSFER_COMPLETED) {
    if (&transfer == out_transfer_) counters_.bytes_out += static_cast<std::uint64_t>(transfer.actual_length);
    return;
  }
  // A control endpoint that refused a request is ready for the next.
  failed(transfer.status);
}

void FtdiLink::send_at_once(std::span<const std::uint8_t> bytes) noexcept {
  const int descriptor = descriptor_.load(std::memory_order_relaxed);
  if (descriptor < 0) return;
  const int error_before = errno;
  usbdevfs_bulktransfer transfer{};
  transfer.ep = out_endpoint_;
  transfer.len = static_cast<unsigned>(bytes.size());
  transfer.timeout = last_send_timeout_ms;
  transfer.data = const_cast<std::uint8_t*>(bytes.data());  // outwards: the kernel reads it
  ioctl(descriptor, USBDEVFS_BULK, &transfer);
  errno = error_before;
}

// --- In --------------------------------------------------------------------------------------------------------------

void FtdiLink::post(Receiver& receiver) noexcept {
  ++counters_.library_calls;
  const int error = libusb_submit_transfer(receiver.transfer);
  receiver.is_posted = error == LIBUSB_SUCCESS;
  if (error != LIBUSB_SUCCESS) set_fault(fault_of(error));
}

void FtdiLink::received(Receiver& receiver) noexcept {
  receiver.is_posted = false;
  const libusb_transfer& transfer = *receiver.transfer;
  // Also of a transfer that failed half-way: what had come by then has come.
  take_packets({receiver.buffer.data(), static_cast<std::size_t>(transfer.actual_length)});
  if (transfer.status == LIBUSB_TRANSFER_COMPLETED) {
    failures_in_a_row_ = 0;
    if (!closing_ && fault_ == LinkFault::none) post(receiver);
    return;
  }
  failed(transfer.status);
}

void FtdiLink::take_packets(std::span<const std::uint8_t> bytes) noexcept {
  while (bytes.size() >= status_size) {
    const auto packet = bytes.first(std::min(bytes.size(), packet_size_));
    bytes = bytes.subspan(packet.size());
    modem_status_ = packet[0];
    if ((packet[1] & line_error_bits) != 0) ++counters_.line_errors;
    if (packet.size() == status_size) ++counters_.status_packets;
    keep(packet.subspan(status_size));
  }
}

// Never asked to keep more than the ring holds. What is oldest goes first: news of the device is worth more.
void FtdiLink::keep(std::span<const std::uint8_t> payload) noexcept {
  if (payload.empty()) return;
  something_happened_ = true;
  counters_.bytes_in += payload.size();
  if (held_ + payload.size() > ring_size) {
    const std::size_t lost = held_ + payload.size() - ring_size;
    first_ = (first_ + lost) % ring_size;
    held_ -= lost;
    counters_.discarded_bytes += lost;
  }
  for (const std::uint8_t byte : payload) ring_[(first_ + held_++) % ring_size] = byte;
}

std::size_t FtdiLink::read(std::span<std::uint8_t> into) noexcept {
  const std::size_t count = std::min(into.size(), held_);
  for (std::size_t i = 0; i < count; ++i) into[i] = ring_[(first_ + i) % ring_size];
  first_ = (first_ + count) % ring_size;
  held_ -= count;
  return count;
}

// --- Faults ----------------------------------------------------------------------------------------------------------

// The first one is the cause of all others.
void FtdiLink::set_fault(LinkFault fault) noexcept {
  if (fault_ == LinkFault::none) fault_ = fault;
  something_happened_ = true;
}

void FtdiLink::failed(int transfer_status) noexcept {
  if (closing_) return;
  if (transfer_status == LIBUSB_TRANSFER_NO_DEVICE) {
    set_fault(LinkFault::unplugged);
  } else if (transfer_status == LIBUSB_TRANSFER_STALL) {
    // To clear an endpoint's halt is to wait for the device, for seconds if it pleases: it is opened anew instead.
    set_fault(LinkFault::broken);
  } else if (++failures_in_a_row_ > most_failures_in_a_row) {
    set_fault(LinkFault::broken);
  }
}

// Not from a callback.
void FtdiLink::recover() noexcept {
  if (fault_ != LinkFault::none) return;
  for (Receiver& receiver : receivers_) {
    if (!receiver.is_posted && fault_ == LinkFault::none) post(receiver);
  }
}

// --- Time ------------------------------------------------------------------------------------------------------------

std::int64_t FtdiLink::now_ns() const noexcept {
  return monotonic_ns();
}

void FtdiLink::handle_events(int timeout_ms) noexcept {
  timeval timeout{0, timeout_ms * 1000L};
  ++counters_.library_calls;
  libusb_handle_events_timeout_completed(context_, &timeout, nullptr);
}

// libusb waits in whole milliseconds, rounded up, and here one of them is a whole tick; so it is only asked to look,
// and the waiting is done here.
void FtdiLink::wait_until(std::int64_t deadline_ns) noexcept {
  something_happened_ = false;
  if (handle_ == nullptr || fault_ != LinkFault::none) {  // nothing but the deadline will come
    const timespec deadline = timespec_of(std::max<std::int64_t>(deadline_ns, 0));
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &deadline, nullptr) == EINTR) {
    }
    return;
  }
  for (;;) {
    handle_events(0);
    recover();
    const std::int64_t left_ns = deadline_ns - monotonic_ns();
    if (something_happened_ || left_ns <= 0) return;
    const timespec wait = timespec_of(std::min(left_ns, longest_wait_ns));
    ppoll(poll_descriptors_.data(), poll_count_, &wait, nullptr);
  }
}

}  // namespace ghostforce
