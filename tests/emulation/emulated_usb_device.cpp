#include "tests/emulation/emulated_usb_device.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <limits>
#include <utility>

#include "device/input/monotonic_clock.h"
#include "tests/emulation/emulated_usb_file.h"

namespace ghostforce {
namespace {

std::string string_descriptor(const std::string& text) {
  std::string bytes{static_cast<char>(2 + 2 * text.size()), 3};
  for (const char letter : text) bytes += {letter, '\0'};
  return bytes;
}

}  // namespace

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
  DeviceFile file =
      bed_.make_file(node, [this](const CallerMemory& caller) { return std::make_unique<File>(*this, caller); });
  {
    const std::lock_guard lock(mutex_);
    if (file_.door) past_files_.push_back(std::move(file_));
    file_ = std::move(file);
    is_plugged_ = true;
    chip_.power_up(monotonic_ns());
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
    for (Endpoint* const endpoint : {&in_, &out_}) {
      for (const Urb& urb : endpoint->queue) complete(urb, -ESHUTDOWN, endpoint == &in_);
      endpoint->queue.clear();
      endpoint->is_halted = false;
    }
    for (const ControlUrb& control : control_) complete(control.urb, -ESHUTDOWN, false);
    control_.clear();
    for (File* const file : files_) file->is_unplugged = true;
    owner_ = nullptr;
    changed_.notify_all();
  }
  bed_.remove_name(file_.path);
  file_.terminal->hang_up();
  bed_.remove(syspath_);
}

void EmulatedUsbDevice::inject(const UsbFault& wrong) {
  if (wrong.is_unplugged) unplug();
  bool was_unplugged = false;
  {
    const std::lock_guard lock(mutex_);
    was_unplugged = wrong_.is_unplugged;
    wrong_ = wrong;
    in_.inject(wrong.in);
    out_.inject(wrong.out);
    control_naks_until_ns_ = end_of(wrong.control_nak_ms);
    move_packets();
    changed_.notify_all();
  }
  if (was_unplugged && !wrong.is_unplugged) plug();
}

void EmulatedUsbDevice::fail_in(int count, int error) {
  const std::lock_guard lock(mutex_);
  in_.failures_to_come = count;
  in_.error = error;
  move_packets();
}

void EmulatedUsbDevice::delay_claims(int count) {
  const std::lock_guard lock(mutex_);
  claims_to_delay_ = count;
}

EmulatedUsbDevice::OutAttempt EmulatedUsbDevice::last_out() const {
  const std::lock_guard lock(mutex_);
  return last_out_;
}

std::uint64_t EmulatedUsbDevice::times_taken() const {
  const std::lock_guard lock(mutex_);
  return takers_.size();
}

std::uint64_t EmulatedUsbDevice::times_taken_by(int process) const {
  const std::lock_guard lock(mutex_);
  return static_cast<std::uint64_t>(std::ranges::count(takers_, process));
}

std::uint64_t EmulatedUsbDevice::halts_cleared() const {
  const std::lock_guard lock(mutex_);
  return halts_cleared_;
}

std::uint64_t EmulatedUsbDevice::transfers_pending() const {
  const std::lock_guard lock(mutex_);
  return in_.queue.size() + out_.queue.size() + control_.size();
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
  for (const std::uint8_t endpoint : {bulk_in, bulk_out}) {
    bytes += {7, 5, static_cast<char>(endpoint), 2, char{EmulatedChip::packet_size}, 0, 0};
  }
  return bytes;
}

// --- Transfers -------------------------------------------------------------------------------------------------------

// Returns the status of the transfer.
int EmulatedUsbDevice::answer_control(Urb& urb, const std::array<std::uint8_t, 8>& setup) {
  const auto word = [&](std::size_t at) { return static_cast<std::uint16_t>(setup[at] | setup[at + 1] << 8); };
  if (setup[0] == 0x40) {
    if (setup[1] == wrong_.refused_request && wrong_.refusals != 0) {
      if (wrong_.refusals > 0) --wrong_.refusals;
      return -EPIPE;
    }
    chip_.control({setup[1], word(2), word(4)}, monotonic_ns());
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

void EmulatedUsbDevice::complete(const Urb& urb, int status, bool inwards) {
  if (urb.waiter != nullptr) {
    *urb.waiter = {true, status, inwards ? urb.data.size() : urb.length, urb.data};
    changed_.notify_all();
    return;
  }
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

// When something ends that begins now and takes so many ms, or for ever.
std::int64_t EmulatedUsbDevice::end_of(int duration_ms) {
  if (duration_ms == EndpointFaults::for_ever) return std::numeric_limits<std::int64_t>::max();
  return duration_ms > 0 ? monotonic_ns() + duration_ms * std::int64_t{1'000'000} : 0;
}

void EmulatedUsbDevice::Endpoint::inject(const EndpointFaults& wrong) {
  failures_to_come = wrong.failures;
  error = wrong.error;
  is_halted |= wrong.halts;
  naks_until_ns = end_of(wrong.nak_ms);
}

bool EmulatedUsbDevice::Endpoint::naks() const {
  return !is_halted && monotonic_ns() < naks_until_ns;
}

int EmulatedUsbDevice::Endpoint::next_failure() {
  if (is_halted) return EPIPE;
  if (failures_to_come <= 0) return 0;
  --failures_to_come;
  return error;
}

// Whether a transfer waits that can go on; those that fail are done.
bool EmulatedUsbDevice::has_turn(Endpoint& endpoint) {
  while (!endpoint.queue.empty() && !endpoint.naks()) {
    const int error = endpoint.next_failure();
    if (error == 0) return true;
    complete(endpoint.queue.front(), -error, &endpoint == &in_);
    endpoint.queue.pop_front();
  }
  return false;
}

// What a host controller does once per frame.
void EmulatedUsbDevice::move_packets() {
  while (!control_.empty() && monotonic_ns() >= control_naks_until_ns_) {
    ControlUrb control = std::move(control_.front());
    control_.pop_front();
    const int status = answer_control(control.urb, control.setup);
    complete(control.urb, status, (control.setup[0] & 0x80U) != 0);
  }
  while (has_turn(out_) && out_.queue.front().data.size() <= chip_.room()) {
    chip_.receive(out_.queue.front().data, monotonic_ns());
    complete(out_.queue.front(), 0, false);
    out_.queue.pop_front();
  }
  while (has_turn(in_)) {
    Urb& urb = in_.queue.front();
    std::uint8_t packet[EmulatedChip::packet_size];
    const std::size_t size = chip_.take_packet(packet, monotonic_ns());
    if (size == 0) break;
    const std::size_t fits = std::min(size, urb.length - urb.data.size());
    urb.data.insert(urb.data.end(), packet, packet + fits);
    ++urb.packets;
    const bool is_full = urb.data.size() == urb.length;
    if (size == EmulatedChip::packet_size && fits == size && !is_full) continue;  // more may come
    complete(urb, fits < size ? -EOVERFLOW : 0, true);
    in_.queue.pop_front();
  }
}

void EmulatedUsbDevice::keep_time() {
  std::unique_lock lock(mutex_);
  while (!is_ending_) {
    if (in_.queue.empty() && out_.queue.empty() && control_.empty()) {
      changed_.wait(lock);
      continue;
    }
    move_packets();
    // A chip may have to be asked again without more being due: not in a circle. It may also get room at any time, as
    // an endpoint may find words again.
    const bool takes_packets = !in_.queue.empty() && !in_.naks();
    const std::int64_t shortest_ns = takes_packets ? 50'000 : 1'000'000;
    const std::int64_t longest_ns = takes_packets && out_.queue.empty() && control_.empty() ? 20'000'000 : 1'000'000;
    const std::int64_t wait_ns =
        std::clamp<std::int64_t>(chip_.next_due_ns() - monotonic_ns(), shortest_ns, longest_ns);
    changed_.wait_for(lock, std::chrono::nanoseconds(wait_ns));
  }
}

}  // namespace ghostforce
