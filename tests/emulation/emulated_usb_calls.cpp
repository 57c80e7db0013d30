// The calls that a program makes on the emulated device's file: what usbfs answers.
#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstddef>
#include <cstring>
#include <limits>
#include <string_view>
#include <utility>

#include <linux/usbdevice_fs.h>
#include <sys/ioctl.h>

#include "device/input/monotonic_clock.h"
#include "tests/emulation/emulated_usb_file.h"

namespace ghostforce {
namespace {

constexpr std::int64_t ms = 1'000'000;

// The one that there is.
constexpr unsigned int the_interface = 0;
constexpr std::string_view usbfs = "usbfs";

// What is larger belongs to nothing that this device can do. [bytes]
constexpr std::size_t longest_transfer = 4096;

// Between looks at what the clock alone changes.
constexpr std::chrono::milliseconds tick{1};

// How long the kernel waits for an answer of the control endpoint to a request of its own.
constexpr std::int64_t control_patience_ns = 5000 * ms;

}  // namespace

EmulatedUsbDevice::File::File(EmulatedUsbDevice& device, const CallerMemory& caller)
    : device_(device), caller_(caller) {
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
  switch (request) {
    case USBDEVFS_CLAIMINTERFACE:
      return device_.claim(*this, memory, argument);
    case USBDEVFS_DISCONNECT_CLAIM:
      return device_.disconnect_and_claim(*this, memory, argument);
    case USBDEVFS_BULK:
      return device_.transfer_now(*this, memory, argument);
    case USBDEVFS_CONTROL:
      return device_.control_now(*this, memory, argument);
    case USBDEVFS_CLEAR_HALT:
      return device_.clear_halt(*this, memory, argument);
    case USBDEVFS_RESET:
      return device_.reset(*this);
    case USBDEVFS_SETINTERFACE:
      return device_.set_interface(*this, memory, argument);
    case USBDEVFS_SETCONFIGURATION:
      return device_.set_configuration(*this);
    default:
      break;
  }
  const auto lock = device_.lock_device();
  if (request == USBDEVFS_REAPURBNDELAY) return device_.reap(*this, memory, argument);
  if (request == USBDEVFS_SUBMITURB) return device_.submit(*this, memory, argument);
  if (is_unplugged) return CallResult::failure(ENODEV);
  switch (request) {
    case USBDEVFS_DISCARDURB:
      return device_.discard(*this, argument);
    case USBDEVFS_GET_CAPABILITIES: {
      const std::uint32_t capabilities = USBDEVFS_CAP_ZERO_PACKET | USBDEVFS_CAP_BULK_CONTINUATION |
                                         USBDEVFS_CAP_NO_PACKET_SIZE_LIM | USBDEVFS_CAP_BULK_SCATTER_GATHER |
                                         USBDEVFS_CAP_REAP_AFTER_DISCONNECT;
      return memory.store(argument, &capabilities, sizeof capabilities) ? CallResult{} : CallResult::failure(EFAULT);
    }
    case USBDEVFS_RELEASEINTERFACE:
      return device_.release(*this, memory, argument);
    case USBDEVFS_GETDRIVER:
      return device_.tell_driver(memory, argument);
    case USBDEVFS_IOCTL:
      return device_.order_driver(memory, argument);
    default:
      return CallResult::failure(ENOTTY);
  }
}

CallResult EmulatedUsbDevice::File::read(const CallerMemory& /*memory*/, std::uintptr_t /*into*/,
                                         std::size_t /*size*/) {
  return CallResult::failure(EINVAL);  // descriptors are read from /sys
}

// --- The interface belongs to one file -------------------------------------------------------------------------------

CallResult EmulatedUsbDevice::claim(File& file, const CallerMemory& memory, std::uintptr_t argument) {
  unsigned int number = 0;
  if (!memory.fetch(argument, &number, sizeof number)) return CallResult::failure(EFAULT);
  auto lock = lock_device();
  if (const int error = claim_obstacle(file, ENOENT); error != 0) return CallResult::failure(error);
  if (number != the_interface) return CallResult::failure(ENOENT);
  const int error = take(file);
  return error == 0 ? CallResult{} : CallResult::failure(error);
}

// Whoever has the interface loses it, unless the caller spares him: the kernel asks by the name of the driver, and that
// of every program is usbfs.
CallResult EmulatedUsbDevice::disconnect_and_claim(File& file, const CallerMemory& memory, std::uintptr_t argument) {
  usbdevfs_disconnect_claim order{};
  if (!memory.fetch(argument, &order, sizeof order)) return CallResult::failure(EFAULT);
  auto lock = lock_device();
  if (const int error = claim_obstacle(file, EINVAL); error != 0) return CallResult::failure(error);
  if (order.interface != the_interface) return CallResult::failure(EINVAL);
  if (owner_ != nullptr) {
    const bool names_usbfs = std::string_view(order.driver, strnlen(order.driver, sizeof order.driver)) == usbfs;
    if ((order.flags & USBDEVFS_DISCONNECT_CLAIM_IF_DRIVER) != 0 && !names_usbfs) return CallResult::failure(EBUSY);
    if ((order.flags & USBDEVFS_DISCONNECT_CLAIM_EXCEPT_DRIVER) != 0 && names_usbfs) return CallResult::failure(EBUSY);
    let_go();
  }
  const int error = take(file);
  return error == 0 ? CallResult{} : CallResult::failure(error);
}

// Returns an errno; 0: it can be tried.
int EmulatedUsbDevice::claim_obstacle(const File& file, int not_ready) {
  if (file.is_unplugged) return ENODEV;
  // In a kernel a program that has closed its file a moment ago is gone; here it may not have been heard of yet.
  if (owner_ != nullptr && owner_ != &file && owner_->caller().has_gone()) let_go();
  if (claims_to_delay_ == 0) return 0;
  --claims_to_delay_;
  return not_ready;
}

// Returns an errno. Also what a transfer does whose program has claimed nothing.
int EmulatedUsbDevice::take(File& file) {
  if (owner_ == &file) return 0;
  if (owner_ != nullptr && owner_->caller().has_gone()) let_go();
  if (owner_ != nullptr) return EBUSY;
  owner_ = &file;
  takers_.push_back(file.caller().process());
  if (const int nak_ms = std::exchange(wrong_.control_nak_ms_when_taken, 0); nak_ms != 0) {
    control_naks_until_ns_ = end_of(nak_ms);
  }
  return 0;
}

// Its endpoints are disabled, so that all that is under way on them ends.
void EmulatedUsbDevice::let_go() {
  if (owner_ == nullptr) return;
  end_transfers_of(*owner_, -ESHUTDOWN);
  owner_ = nullptr;
  changed_.notify_all();
}

CallResult EmulatedUsbDevice::release(const File& file, const CallerMemory& memory, std::uintptr_t argument) {
  unsigned int number = 0;
  if (!memory.fetch(argument, &number, sizeof number)) return CallResult::failure(EFAULT);
  if (number != the_interface) return CallResult::failure(ENOENT);
  if (owner_ != &file) return CallResult::failure(EINVAL);
  let_go();
  return {};
}

CallResult EmulatedUsbDevice::tell_driver(const CallerMemory& memory, std::uintptr_t argument) {
  usbdevfs_getdriver answer{};
  if (!memory.fetch(argument, &answer, sizeof answer)) return CallResult::failure(EFAULT);
  if (answer.interface != the_interface || owner_ == nullptr) return CallResult::failure(ENODATA);
  usbfs.copy(answer.driver, sizeof answer.driver);
  return memory.store(argument, &answer, sizeof answer) ? CallResult{} : CallResult::failure(EFAULT);
}

CallResult EmulatedUsbDevice::order_driver(const CallerMemory& memory, std::uintptr_t argument) {
  usbdevfs_ioctl order{};
  if (!memory.fetch(argument, &order, sizeof order)) return CallResult::failure(EFAULT);
  if (order.ifno != static_cast<int>(the_interface)) return CallResult::failure(EINVAL);
  switch (static_cast<unsigned int>(order.ioctl_code)) {
    case USBDEVFS_DISCONNECT:
      if (owner_ == nullptr) return CallResult::failure(ENODATA);
      let_go();
      return {};
    case USBDEVFS_CONNECT:  // no driver of the kernel's wants it
      return owner_ == nullptr ? CallResult{} : CallResult::failure(EBUSY);
    default:
      return CallResult::failure(ENOTTY);
  }
}

// --- Transfers -------------------------------------------------------------------------------------------------------

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
    if (const int error = take(file); error != 0) return CallResult::failure(error);
    out_.queue.push_back(std::move(urb));
  } else if (raw.endpoint == bulk_in) {
    if (file.is_unplugged) return CallResult::failure(ENODEV);
    if (const int error = take(file); error != 0) return CallResult::failure(error);
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

// In its turn behind what waits already, and done when this returns. It holds no lock while it waits.
CallResult EmulatedUsbDevice::transfer_now(File& file, const CallerMemory& memory, std::uintptr_t argument) {
  usbdevfs_bulktransfer transfer{};
  if (!memory.fetch(argument, &transfer, sizeof transfer)) return CallResult::failure(EFAULT);
  const bool inwards = transfer.ep == bulk_in;
  if (!inwards && transfer.ep != bulk_out) return CallResult::failure(ENOENT);
  if (transfer.len > longest_transfer) return CallResult::failure(ENOMEM);
  const auto buffer = reinterpret_cast<std::uintptr_t>(transfer.data);
  Waiter waiter;
  Urb urb;
  urb.file = &file;
  urb.length = transfer.len;
  urb.waiter = &waiter;
  if (!inwards) {
    urb.data.resize(transfer.len);
    if (!memory.fetch(buffer, urb.data.data(), urb.data.size())) return CallResult::failure(EFAULT);
  }
  {
    auto lock = lock_device();
    if (!inwards) note_attempt(urb.data);
    if (file.is_unplugged) return CallResult::failure(ENODEV);
    if (const int error = take(file); error != 0) return CallResult::failure(error);
    std::deque<Urb>& queue = (inwards ? in_ : out_).queue;
    queue.push_back(std::move(urb));
    move_packets();
    changed_.notify_all();
    wait_for(waiter, lock, transfer.timeout);
    std::erase_if(queue, [&](const Urb& one) { return one.waiter == &waiter; });
  }
  if (!waiter.is_over) return CallResult::failure(ETIMEDOUT);
  if (waiter.status != 0) return CallResult::failure(-waiter.status);
  if (inwards && !memory.store(buffer, waiter.data.data(), waiter.data.size())) return CallResult::failure(EFAULT);
  return {static_cast<long>(waiter.length), 0};
}

// A request to the device or to its maker's own part of it needs no claim.
CallResult EmulatedUsbDevice::control_now(File& file, const CallerMemory& memory, std::uintptr_t argument) {
  constexpr std::uint8_t type_mask = 0x60;
  constexpr std::uint8_t vendor = 0x40;
  constexpr std::uint8_t recipient_mask = 0x1F;
  usbdevfs_ctrltransfer request{};
  if (!memory.fetch(argument, &request, sizeof request)) return CallResult::failure(EFAULT);
  if (request.wLength > longest_transfer) return CallResult::failure(EINVAL);
  const auto buffer = reinterpret_cast<std::uintptr_t>(request.data);
  const bool inwards = (request.bRequestType & 0x80U) != 0;
  const auto low = [](std::uint16_t word) { return static_cast<std::uint8_t>(word & 0xFFU); };
  const auto high = [](std::uint16_t word) { return static_cast<std::uint8_t>(word >> 8U); };
  Waiter waiter;
  ControlUrb control;
  control.urb.file = &file;
  control.urb.length = request.wLength;
  control.urb.waiter = &waiter;
  control.setup = {request.bRequestType, request.bRequest,     low(request.wValue),  high(request.wValue),
                   low(request.wIndex),  high(request.wIndex), low(request.wLength), high(request.wLength)};
  {
    auto lock = lock_device();
    if (file.is_unplugged) return CallResult::failure(ENODEV);
    if ((request.bRequestType & type_mask) != vendor && (request.bRequestType & recipient_mask) != 0) {
      if (const int error = take(file); error != 0) return CallResult::failure(error);
    }
    control_.push_back(std::move(control));
    move_packets();
    changed_.notify_all();
    wait_for(waiter, lock, request.timeout);
    std::erase_if(control_, [&](const ControlUrb& one) { return one.urb.waiter == &waiter; });
  }
  if (!waiter.is_over) return CallResult::failure(ETIMEDOUT);
  if (waiter.status != 0) return CallResult::failure(-waiter.status);
  if (inwards && !memory.store(buffer, waiter.data.data(), waiter.data.size())) return CallResult::failure(EFAULT);
  return {static_cast<long>(waiter.length), 0};
}

// And for the device, which the kernel locks again before it returns. Timeout 0: for ever.
void EmulatedUsbDevice::wait_for(const Waiter& waiter, std::unique_lock<std::mutex>& lock, unsigned int timeout_ms) {
  const std::int64_t deadline_ns =
      timeout_ms == 0 ? std::numeric_limits<std::int64_t>::max() : monotonic_ns() + timeout_ms * ms;
  while (!waiter.is_over && monotonic_ns() < deadline_ns && !is_ending_) changed_.wait_for(lock, tick);
  changed_.wait(lock, [this] { return !is_waiting_for_device_; });
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
  if (file.is_unplugged) return CallResult::failure(ENODEV);
  if (const int error = take(file); error != 0) return CallResult::failure(error);
  if (const int error = ask_device(file, lock, wrong_.clear_halt_ms); error != 0) return CallResult::failure(error);
  ++halts_cleared_;
  (number == bulk_in ? in_ : out_).is_halted = (number == bulk_in ? wrong_.in : wrong_.out).halts_again;
  return {};
}

// The interface is nobody's afterwards, and the chip as new.
CallResult EmulatedUsbDevice::reset(File& file) {
  auto lock = lock_device();
  if (file.is_unplugged) return CallResult::failure(ENODEV);
  let_go();
  if (const int error = ask_device(file, lock, 0); error != 0) return CallResult::failure(error);
  in_.is_halted = out_.is_halted = false;
  chip_.power_up(monotonic_ns());
  return {};
}

CallResult EmulatedUsbDevice::set_interface(File& file, const CallerMemory& memory, std::uintptr_t argument) {
  usbdevfs_setinterface order{};
  if (!memory.fetch(argument, &order, sizeof order)) return CallResult::failure(EFAULT);
  auto lock = lock_device();
  if (file.is_unplugged) return CallResult::failure(ENODEV);
  if (order.interface != the_interface) return CallResult::failure(ENOENT);
  if (order.altsetting != 0) return CallResult::failure(EINVAL);
  if (const int error = take(file); error != 0) return CallResult::failure(error);
  if (const int error = ask_device(file, lock, 0); error != 0) return CallResult::failure(error);
  in_.is_halted = out_.is_halted = false;
  return {};
}

CallResult EmulatedUsbDevice::set_configuration(File& file) {
  auto lock = lock_device();
  if (file.is_unplugged) return CallResult::failure(ENODEV);
  if (owner_ != nullptr) return CallResult::failure(EBUSY);
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

// Those of its bulk endpoints: the control endpoint belongs to no interface.
void EmulatedUsbDevice::end_transfers_of(const File& file, int status) {
  for (Endpoint* const endpoint : {&in_, &out_}) {
    std::erase_if(endpoint->queue, [&](const Urb& urb) {
      if (urb.file != &file) return false;
      complete(urb, status, endpoint == &in_);
      return true;
    });
  }
}

// A program knows its own transfers only.
CallResult EmulatedUsbDevice::discard(const File& file, std::uintptr_t address) {
  const auto is_meant = [&](const Urb& urb) {
    return urb.file == &file && urb.waiter == nullptr && urb.address == address;
  };
  for (Endpoint* const endpoint : {&in_, &out_}) {
    const auto urb = std::ranges::find_if(endpoint->queue, is_meant);
    if (urb == endpoint->queue.end()) continue;
    complete(*urb, -ENOENT, endpoint == &in_);
    endpoint->queue.erase(urb);
    return {};
  }
  const auto control = std::ranges::find_if(control_, [&](const ControlUrb& one) { return is_meant(one.urb); });
  if (control == control_.end()) return CallResult::failure(EINVAL);
  complete(control->urb, -ENOENT, false);
  control_.erase(control);
  return {};
}

}  // namespace ghostforce
