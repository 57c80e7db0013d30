// The calls that a program makes on the emulated device's file: what usbfs answers.
#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstddef>
#include <limits>
#include <utility>

#include <linux/usbdevice_fs.h>
#include <sys/ioctl.h>

#include "device/input/monotonic_clock.h"
#include "tests/emulation/emulated_usb_file.h"

namespace ghostforce {
namespace {

constexpr std::int64_t ms = 1'000'000;

// The kernel answers a program that closes a file and claims on another one at once; here the first may arrive later.
constexpr std::chrono::milliseconds release_patience{100};

// Between looks at what the clock alone changes.
constexpr std::chrono::milliseconds tick{1};

// How long the kernel waits for an answer of the control endpoint to a request of its own.
constexpr std::int64_t control_patience_ns = 5000 * ms;

}  // namespace

EmulatedUsbDevice::File::File(EmulatedUsbDevice& device) : device_(device) {
  const auto lock = device_.lock_device();
  is_unplugged = !device_.is_plugged_;
  device_.files_.push_back(this);
}

EmulatedUsbDevice::File::~File() {
  const auto lock = device_.lock_device();
  std::erase(device_.files_, this);
  const auto mine = [this](const Urb& urb) { return urb.file == this; };
  std::erase_if(device_.in_.queue, mine);
  std::erase_if(device_.out_.queue, mine);
  std::erase_if(device_.control_, [this](const ControlUrb& control) { return control.urb.file == this; });
  if (device_.owner_ == this) device_.owner_ = nullptr;
  device_.show_completions();
  device_.changed_.notify_all();
}

CallResult EmulatedUsbDevice::File::ioctl(const CallerMemory& memory, unsigned long request, std::uintptr_t argument) {
  if (request == USBDEVFS_CLAIMINTERFACE) return device_.claim(*this, ENOENT);
  if (request == USBDEVFS_DISCONNECT_CLAIM) return device_.claim(*this, EINVAL);
  if (request == USBDEVFS_BULK) return device_.send_now(*this, memory, argument);
  if (request == USBDEVFS_CLEAR_HALT) return device_.clear_halt(*this, memory, argument);
  if (request == USBDEVFS_SETINTERFACE || request == USBDEVFS_SETCONFIGURATION || request == USBDEVFS_RESET) {
    return device_.reset(*this);
  }
  const auto lock = device_.lock_device();
  if (request == USBDEVFS_REAPURBNDELAY) return device_.reap(*this, memory, argument);
  if (request == USBDEVFS_SUBMITURB) return device_.submit(*this, memory, argument);
  if (is_unplugged) return CallResult::failure(ENODEV);
  switch (request) {
    case USBDEVFS_DISCARDURB:
      return device_.discard(argument);
    case USBDEVFS_GET_CAPABILITIES: {
      const std::uint32_t capabilities = USBDEVFS_CAP_ZERO_PACKET | USBDEVFS_CAP_BULK_CONTINUATION |
                                         USBDEVFS_CAP_NO_PACKET_SIZE_LIM | USBDEVFS_CAP_BULK_SCATTER_GATHER |
                                         USBDEVFS_CAP_REAP_AFTER_DISCONNECT;
      return memory.store(argument, &capabilities, sizeof capabilities) ? CallResult{} : CallResult::failure(EFAULT);
    }
    case USBDEVFS_RELEASEINTERFACE:
      if (device_.owner_ != this) return CallResult::failure(EINVAL);
      device_.owner_ = nullptr;
      device_.end_transfers_of(*this);
      device_.changed_.notify_all();
      return {};
    case USBDEVFS_GETDRIVER:  // no driver of the kernel's has the interface
    case USBDEVFS_IOCTL:
      return CallResult::failure(ENODATA);
    default:
      return CallResult::failure(ENOTTY);
  }
}

CallResult EmulatedUsbDevice::File::read(const CallerMemory& /*memory*/, std::uintptr_t /*into*/,
                                         std::size_t /*size*/) {
  return CallResult::failure(EINVAL);  // descriptors are read from /sys
}

CallResult EmulatedUsbDevice::claim(File& file, int not_ready) {
  std::unique_lock lock(mutex_);
  if (file.is_unplugged) return CallResult::failure(ENODEV);
  if (claims_to_delay_ > 0) {
    --claims_to_delay_;
    return CallResult::failure(not_ready);
  }
  changed_.wait_for(lock, release_patience, [&] { return owner_ == nullptr || owner_ == &file || file.is_unplugged; });
  if (file.is_unplugged) return CallResult::failure(ENODEV);
  if (owner_ != nullptr && owner_ != &file) return CallResult::failure(EBUSY);
  owner_ = &file;
  ++times_taken_;
  if (const int nak_ms = std::exchange(wrong_.control_nak_ms_when_taken, 0); nak_ms != 0) {
    control_naks_until_ns_ = end_of(nak_ms);
  }
  return {};
}

CallResult EmulatedUsbDevice::submit(File& file, const CallerMemory& memory, std::uintptr_t address) {
  usbdevfs_urb raw;  // ends in an array without a length, which clang has no braces for
  if (!memory.fetch(address, &raw, sizeof raw) || raw.buffer_length < 0) return CallResult::failure(EFAULT);
  Urb urb;
  urb.file = &file;
  urb.address = address;
  urb.buffer = reinterpret_cast<std::uintptr_t>(raw.buffer);
  urb.length = static_cast<std::size_t>(raw.buffer_length);
  if (raw.type == USBDEVFS_URB_TYPE_CONTROL) {
    std::array<std::uint8_t, 8> setup{};
    if (urb.length < setup.size() || !memory.fetch(urb.buffer, setup.data(), setup.size())) {
      return CallResult::failure(EFAULT);
    }
    if (file.is_unplugged) return CallResult::failure(ENODEV);
    urb.buffer += setup.size();
    urb.length -= setup.size();
    control_.push_back({std::move(urb), setup});
  } else if (raw.type != USBDEVFS_URB_TYPE_BULK) {
    return CallResult::failure(EINVAL);
  } else if (raw.endpoint == bulk_out) {
    urb.data.resize(urb.length);
    if (!memory.fetch(urb.buffer, urb.data.data(), urb.length)) return CallResult::failure(EFAULT);
    note_attempt(urb.data);
    if (file.is_unplugged) return CallResult::failure(ENODEV);
    if (owner_ != &file) return CallResult::failure(EINVAL);  // the kernel would claim it, and complain in its log
    out_.queue.push_back(std::move(urb));
  } else if (raw.endpoint == bulk_in) {
    if (file.is_unplugged) return CallResult::failure(ENODEV);
    if (owner_ != &file) return CallResult::failure(EINVAL);
    in_.queue.push_back(std::move(urb));
  } else {
    return CallResult::failure(ENOENT);
  }
  move_packets();
  changed_.notify_all();
  return {};
}

void EmulatedUsbDevice::note_attempt(const std::vector<std::uint8_t>& bytes) {
  last_out_ = {bytes, monotonic_ns()};
}

// Past what waits for room in the chip, and done when this returns; the program has no more than this one call to make.
// It holds no lock while it waits.
CallResult EmulatedUsbDevice::send_now(File& file, const CallerMemory& memory, std::uintptr_t argument) {
  usbdevfs_bulktransfer transfer{};
  if (!memory.fetch(argument, &transfer, sizeof transfer)) return CallResult::failure(EFAULT);
  if (transfer.ep != bulk_out || transfer.len > 4096) return CallResult::failure(EINVAL);
  std::vector<std::uint8_t> bytes(transfer.len);
  if (!memory.fetch(reinterpret_cast<std::uintptr_t>(transfer.data), bytes.data(), bytes.size())) {
    return CallResult::failure(EFAULT);
  }
  auto lock = lock_device();
  note_attempt(bytes);
  const std::int64_t deadline_ns =
      transfer.timeout == 0 ? std::numeric_limits<std::int64_t>::max() : monotonic_ns() + transfer.timeout * ms;
  while (!file.is_unplugged && out_.naks() && monotonic_ns() < deadline_ns) changed_.wait_for(lock, tick);
  if (file.is_unplugged) return CallResult::failure(ENODEV);
  if (out_.naks()) return CallResult::failure(ETIMEDOUT);
  move_packets();
  if (const int error = out_.next_failure(); error != 0) return CallResult::failure(error);
  chip_.receive(bytes, monotonic_ns());
  move_packets();
  changed_.notify_all();
  return {static_cast<long>(bytes.size()), 0};
}

// --- The control endpoint, asked by the kernel itself ----------------------------------------------------------------

std::unique_lock<std::mutex> EmulatedUsbDevice::lock_device() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return !is_waiting_for_device_; });
  return lock;
}

// Waits for its answer, which comes after so long; returns an errno, 0: it has come. All other calls wait meanwhile.
int EmulatedUsbDevice::ask_device(File& file, std::unique_lock<std::mutex>& lock, int answer_ms) {
  is_waiting_for_device_ = true;
  const std::int64_t start_ns = monotonic_ns();
  const auto has_answered = [&] {
    const std::int64_t now_ns = monotonic_ns();
    return now_ns >= control_naks_until_ns_ && now_ns >= start_ns + answer_ms * ms;
  };
  while (!file.is_unplugged && !has_answered() && monotonic_ns() < start_ns + control_patience_ns) {
    changed_.wait_for(lock, tick);
  }
  is_waiting_for_device_ = false;
  changed_.notify_all();
  if (file.is_unplugged) return ENODEV;
  return has_answered() ? 0 : ETIMEDOUT;
}

CallResult EmulatedUsbDevice::clear_halt(File& file, const CallerMemory& memory, std::uintptr_t argument) {
  unsigned int number = 0;
  if (!memory.fetch(argument, &number, sizeof number)) return CallResult::failure(EFAULT);
  if (number != bulk_in && number != bulk_out) return CallResult::failure(ENOENT);
  auto lock = lock_device();
  if (const int error = ask_device(file, lock, wrong_.clear_halt_ms); error != 0) return CallResult::failure(error);
  ++halts_cleared_;
  (number == bulk_in ? in_ : out_).is_halted = (number == bulk_in ? wrong_.in : wrong_.out).halts_again;
  return {};
}

CallResult EmulatedUsbDevice::reset(File& file) {
  auto lock = lock_device();
  if (const int error = ask_device(file, lock, 0); error != 0) return CallResult::failure(error);
  in_.is_halted = out_.is_halted = false;
  return {};
}

// --- What is over ----------------------------------------------------------------------------------------------------

CallResult EmulatedUsbDevice::reap(File& file, const CallerMemory& memory, std::uintptr_t into) {
  if (file.completions.empty()) return CallResult::failure(file.is_unplugged ? ENODEV : EAGAIN);
  const File::Completion completion = std::move(file.completions.front());
  file.completions.pop_front();
  show_completions();
  const auto field = [&](std::size_t offset) { return completion.urb + offset; };
  const bool stored =
      memory.store(field(offsetof(usbdevfs_urb, status)), &completion.status, sizeof completion.status) &&
      memory.store(field(offsetof(usbdevfs_urb, actual_length)), &completion.length, sizeof completion.length) &&
      memory.store(completion.buffer, completion.data.data(), completion.data.size()) &&
      memory.store(into, &completion.urb, sizeof completion.urb);
  return stored ? CallResult{} : CallResult::failure(EFAULT);
}

void EmulatedUsbDevice::end_transfers_of(const File& file) {
  for (Endpoint* const endpoint : {&in_, &out_}) {
    std::erase_if(endpoint->queue, [&](const Urb& urb) {
      if (urb.file != &file) return false;
      complete(urb, -ENOENT, endpoint == &in_);
      return true;
    });
  }
}

CallResult EmulatedUsbDevice::discard(std::uintptr_t address) {
  for (Endpoint* const endpoint : {&in_, &out_}) {
    const auto urb = std::ranges::find(endpoint->queue, address, &Urb::address);
    if (urb == endpoint->queue.end()) continue;
    complete(*urb, -ENOENT, endpoint == &in_);
    endpoint->queue.erase(urb);
    return {};
  }
  const auto control = std::ranges::find(control_, address, [](const ControlUrb& c) { return c.urb.address; });
  if (control == control_.end()) return CallResult::failure(EINVAL);
  complete(control->urb, -ENOENT, false);
  control_.erase(control);
  return {};
}

}  // namespace ghostforce
