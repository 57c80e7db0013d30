#include "tests/emulation/emulated_usb_device.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <utility>

#include <linux/usbdevice_fs.h>
#include <sys/ioctl.h>
#include <time.h>

namespace ghostforce {
namespace {

constexpr std::uint8_t in_endpoint = 0x81;
constexpr std::uint8_t out_endpoint = 0x02;

// The kernel answers a program that closes a file and claims on another one at once; here the first may arrive later.
constexpr std::chrono::milliseconds release_patience{100};

std::int64_t monotonic_ns() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

std::string string_descriptor(const std::string& text) {
  std::string bytes{static_cast<char>(2 + 2 * text.size()), 3};
  for (const char letter : text) bytes += {letter, '\0'};
  return bytes;
}

}  // namespace

class EmulatedUsbDevice::File final : public OpenFile {
 public:
  struct Completion {
    std::uintptr_t urb = 0;
    std::uintptr_t buffer = 0;  // 0: nothing to store
    int status = 0;
    int length = 0;
    std::vector<std::uint8_t> data;
  };

  explicit File(EmulatedUsbDevice& device) : device_(device) {
    const std::lock_guard lock(device_.mutex_);
    is_unplugged = !device_.is_plugged_;
    device_.files_.push_back(this);
  }

  ~File() override {
    const std::lock_guard lock(device_.mutex_);
    std::erase(device_.files_, this);
    const auto mine = [this](const Urb& urb) { return urb.file == this; };
    std::erase_if(device_.in_, mine);
    std::erase_if(device_.out_, mine);
    if (device_.owner_ == this) device_.owner_ = nullptr;
    device_.show_completions();
    device_.changed_.notify_all();
  }

  CallResult ioctl(const CallerMemory& memory, unsigned long request, std::uintptr_t argument) override {
    if (request == USBDEVFS_CLAIMINTERFACE) return device_.claim(*this, ENOENT);
    if (request == USBDEVFS_DISCONNECT_CLAIM) return device_.claim(*this, EINVAL);
    const std::lock_guard lock(device_.mutex_);
    if (request == USBDEVFS_REAPURBNDELAY) return device_.reap(*this, memory, argument);
    if (is_unplugged) return CallResult::failure(ENODEV);
    switch (request) {
      case USBDEVFS_SUBMITURB:
        return device_.submit(*this, memory, argument);
      case USBDEVFS_DISCARDURB:
        return device_.discard(argument);
      case USBDEVFS_BULK:
        return device_.send_now(memory, argument);
      case USBDEVFS_GET_CAPABILITIES: {
        const std::uint32_t capabilities = USBDEVFS_CAP_ZERO_PACKET | USBDEVFS_CAP_BULK_CONTINUATION |
                                           USBDEVFS_CAP_NO_PACKET_SIZE_LIM | USBDEVFS_CAP_BULK_SCATTER_GATHER |
                                           USBDEVFS_CAP_REAP_AFTER_DISCONNECT;
        return memory.store(argument, &capabilities, sizeof capabilities) ? CallResult{} : CallResult::failure(EFAULT);
      }
      case USBDEVFS_RELEASEINTERFACE:
        if (device_.owner_ != this) return CallResult::failure(EINVAL);
        device_.owner_ = nullptr;
        device_.changed_.notify_all();
        return {};
      case USBDEVFS_CLEAR_HALT:
        ++device_.halts_cleared_;
        return {};
      case USBDEVFS_SETINTERFACE:
      case USBDEVFS_SETCONFIGURATION:
      case USBDEVFS_RESET:
        return {};
      case USBDEVFS_GETDRIVER:  // no driver of the kernel's has the interface
      case USBDEVFS_IOCTL:
        return CallResult::failure(ENODATA);
      default:
        return CallResult::failure(ENOTTY);
    }
  }

  CallResult read(const CallerMemory& /*memory*/, std::uintptr_t /*into*/, std::size_t /*size*/) override {
    return CallResult::failure(EINVAL);  // descriptors are read from /sys
  }

  std::deque<Completion> completions;
  bool is_unplugged = false;  // for good, even if the device comes back: that is another file

 private:
  EmulatedUsbDevice& device_;
};

// --- The test's side -------------------------------------------------------------------------------------------------

EmulatedUsbDevice::EmulatedUsbDevice(TestBed& bed, EmulatedChip& chip, std::string serial, UsbId id)
    : bed_(bed), chip_(chip), serial_(std::move(serial)), id_(id) {
  clock_ = std::thread([this] { keep_time(); });
}

EmulatedUsbDevice::~EmulatedUsbDevice() {
  unplug();
  // Ends the files that are still open.
  past_files_.clear();
  file_.door.reset();
  {
    const std::lock_guard lock(mutex_);
    is_ending_ = true;
  }
  changed_.notify_all();
  clock_.join();
}

void EmulatedUsbDevice::plug() {
  unplug();
  const int address = bed_.next_address();
  char node[64];
  std::snprintf(node, sizeof node, "/dev/bus/usb/001/%03d", address);
  DeviceFile file = bed_.make_file(node, [this] { return std::make_unique<File>(*this); });
  {
    const std::lock_guard lock(mutex_);
    if (file_.door) past_files_.push_back(std::move(file_));
    file_ = std::move(file);
    is_plugged_ = true;
  }
  syspath_ = std::string(TestBed::hub) + "/1-" + std::to_string(address);
  char ids[64];
  std::snprintf(ids, sizeof ids, "A: idVendor=%04x\\n\nA: idProduct=%04x\\n\n", unsigned{id_.vendor},
                unsigned{id_.product});
  bed_.add("P: " + syspath_ + "\nE: DEVNAME=" + node + "\nE: DEVTYPE=usb_device\nE: SUBSYSTEM=usb\nA: busnum=1\\n\n" +
           "A: devnum=" + std::to_string(address) + "\\n\nA: speed=12\\n\nA: bConfigurationValue=1\\n\n" + ids +
           "A: dev=" + file_.number() + "\\n\nA: serial=" + serial_ + "\\n\nH: descriptors=" + hex_of(configuration()) +
           "\n");
}

void EmulatedUsbDevice::unplug() {
  {
    const std::lock_guard lock(mutex_);
    if (!is_plugged_) return;
    is_plugged_ = false;
    for (std::deque<Urb>* const queue : {&in_, &out_}) {
      for (const Urb& urb : *queue) complete(urb, -ESHUTDOWN, queue == &in_);
      queue->clear();
    }
    for (File* const file : files_) file->is_unplugged = true;
    owner_ = nullptr;
    changed_.notify_all();
  }
  bed_.remove_name(file_.path);
  file_.terminal->hang_up();
  bed_.remove(syspath_);
}

void EmulatedUsbDevice::fail_in(int count, int error) {
  const std::lock_guard lock(mutex_);
  failures_to_come_ = count;
  failure_ = error;
  move_packets();
}

void EmulatedUsbDevice::delay_claims(int count) {
  const std::lock_guard lock(mutex_);
  claims_to_delay_ = count;
}

std::uint64_t EmulatedUsbDevice::halts_cleared() const {
  const std::lock_guard lock(mutex_);
  return halts_cleared_;
}

std::uint64_t EmulatedUsbDevice::transfers_pending() const {
  const std::lock_guard lock(mutex_);
  return in_.size() + out_.size();
}

std::size_t EmulatedUsbDevice::most_packets_in_a_transfer() const {
  const std::lock_guard lock(mutex_);
  return most_packets_;
}

// The device descriptor and its one configuration, as they come over the cable.
std::string EmulatedUsbDevice::configuration() const {
  const auto low = [](std::uint16_t value) { return static_cast<char>(value & 0xFFU); };
  const auto high = [](std::uint16_t value) { return static_cast<char>(value >> 8U); };
  std::string bytes{18, 1, 0, 2, 0, 0, 0, 8};
  bytes += {low(id_.vendor), high(id_.vendor), low(id_.product), high(id_.product), 0, 6, 1, 2, 3, 1};
  bytes += {9, 2, 32, 0, 1, 1, 0, '\x80', 45};
  bytes += {9, 4, 0, 0, 2, '\xff', '\xff', '\xff', 2};
  for (const std::uint8_t endpoint : {in_endpoint, out_endpoint}) {
    bytes += {7, 5, static_cast<char>(endpoint), 2, char{EmulatedChip::packet_size}, 0, 0};
  }
  return bytes;
}

// --- The program's side; the lock is held, except in claim() ---------------------------------------------------------

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
    std::uint8_t setup[8];
    if (urb.length < sizeof setup || !memory.fetch(urb.buffer, setup, sizeof setup)) return CallResult::failure(EFAULT);
    urb.buffer += sizeof setup;
    urb.length -= sizeof setup;
    const int status = answer_control(urb, setup);
    complete(urb, status, (setup[0] & 0x80U) != 0);
    return {};
  }
  if (raw.type != USBDEVFS_URB_TYPE_BULK) return CallResult::failure(EINVAL);
  if (owner_ != &file) return CallResult::failure(EINVAL);  // the kernel would claim it, and complain in its log
  if (raw.endpoint == in_endpoint) {
    in_.push_back(std::move(urb));
  } else if (raw.endpoint == out_endpoint) {
    urb.data.resize(urb.length);
    if (!memory.fetch(urb.buffer, urb.data.data(), urb.length)) return CallResult::failure(EFAULT);
    out_.push_back(std::move(urb));
  } else {
    return CallResult::failure(ENOENT);
  }
  move_packets();
  changed_.notify_all();
  return {};
}

// Returns the status of the transfer.
int EmulatedUsbDevice::answer_control(Urb& urb, const std::uint8_t (&setup)[8]) {
  const auto word = [&](int at) { return static_cast<std::uint16_t>(setup[at] | setup[at + 1] << 8); };
  if (setup[0] == 0x40) {
    chip_.control({setup[1], word(2), word(4)}, monotonic_ns());
    move_packets();
    changed_.notify_all();
    return 0;
  }
  if (setup[0] == 0x80 && setup[1] == 6 && setup[3] == 3) {
    const std::string texts[] = {string_descriptor(""), string_descriptor("NOVINT"), string_descriptor("FALCON HAPTIC"),
                                 string_descriptor(serial_)};
    if (setup[2] >= std::size(texts)) return -EPIPE;
    std::string text = texts[setup[2]];
    if (setup[2] == 0) text = {4, 3, 9, 4};  // the one language: English
    text.resize(std::min(text.size(), urb.length));
    urb.data.assign(text.begin(), text.end());
    return 0;
  }
  return -EPIPE;
}

// Past the queue, and done when this returns; the program has no more than this one call to make.
CallResult EmulatedUsbDevice::send_now(const CallerMemory& memory, std::uintptr_t argument) {
  usbdevfs_bulktransfer transfer{};
  if (!memory.fetch(argument, &transfer, sizeof transfer)) return CallResult::failure(EFAULT);
  if (transfer.ep != out_endpoint || transfer.len > 4096) return CallResult::failure(EINVAL);
  std::vector<std::uint8_t> bytes(transfer.len);
  if (!memory.fetch(reinterpret_cast<std::uintptr_t>(transfer.data), bytes.data(), bytes.size())) {
    return CallResult::failure(EFAULT);
  }
  chip_.receive(bytes, monotonic_ns());
  move_packets();
  changed_.notify_all();
  return {static_cast<long>(bytes.size()), 0};
}

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

CallResult EmulatedUsbDevice::discard(std::uintptr_t address) {
  for (std::deque<Urb>* const queue : {&in_, &out_}) {
    const auto urb = std::find_if(queue->begin(), queue->end(), [&](const Urb& u) { return u.address == address; });
    if (urb == queue->end()) continue;
    complete(*urb, -ENOENT, queue == &in_);
    queue->erase(urb);
    return {};
  }
  return CallResult::failure(EINVAL);
}

void EmulatedUsbDevice::complete(const Urb& urb, int status, bool inwards) {
  File::Completion completion;
  completion.urb = urb.address;
  completion.status = status;
  completion.buffer = urb.buffer;
  if (inwards) {
    completion.data = urb.data;
    completion.length = static_cast<int>(urb.data.size());
    if (status == 0) most_packets_ = std::max(most_packets_, urb.packets);
  } else if (status == 0) {
    completion.length = static_cast<int>(urb.length);
  }
  urb.file->completions.push_back(std::move(completion));
  show_completions();
}

void EmulatedUsbDevice::show_completions() {
  if (!file_.terminal) return;
  file_.terminal->set_writable(std::any_of(files_.begin(), files_.end(), [](const File* file) {
    return !file->is_unplugged && !file->completions.empty();
  }));
}

// What a host controller does once per frame.
void EmulatedUsbDevice::move_packets() {
  while (!out_.empty() && out_.front().data.size() <= chip_.room()) {
    chip_.receive(out_.front().data, monotonic_ns());
    complete(out_.front(), 0, false);
    out_.pop_front();
  }
  while (!in_.empty()) {
    Urb& urb = in_.front();
    if (failures_to_come_ > 0) {
      --failures_to_come_;
      complete(urb, -failure_, true);
      in_.pop_front();
      continue;
    }
    std::uint8_t packet[EmulatedChip::packet_size];
    const std::size_t size = chip_.take_packet(packet, monotonic_ns());
    if (size == 0) break;
    const std::size_t fits = std::min(size, urb.length - urb.data.size());
    urb.data.insert(urb.data.end(), packet, packet + fits);
    ++urb.packets;
    const bool is_full = urb.data.size() == urb.length;
    if (size == EmulatedChip::packet_size && fits == size && !is_full) continue;  // more may come
    complete(urb, fits < size ? -EOVERFLOW : 0, true);
    in_.pop_front();
  }
}

void EmulatedUsbDevice::keep_time() {
  std::unique_lock lock(mutex_);
  while (!is_ending_) {
    if (in_.empty()) {
      changed_.wait(lock);
      continue;
    }
    move_packets();
    // A chip may have to be asked again without more being due: not in a circle. It may also get room at any time.
    const std::int64_t longest_ns = out_.empty() ? 20'000'000 : 1'000'000;
    const std::int64_t wait_ns = std::clamp<std::int64_t>(chip_.next_due_ns() - monotonic_ns(), 50'000, longest_ns);
    changed_.wait_for(lock, std::chrono::nanoseconds(wait_ns));
  }
}

}  // namespace ghostforce
