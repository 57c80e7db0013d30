#include "device/haply_serial/tty_port.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <exception>
#include <filesystem>
#include <optional>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <termios.h>
#include <time.h>
#include <unistd.h>

#include "device/haply/hapi.h"
#include "device/motors/emergency_stop.h"

namespace ghostforce {
namespace {

constexpr std::size_t longest_packet = 64;

constexpr std::int64_t ns_per_ms = 1'000'000;
// While nothing comes, the guard hears this often that the program lives.
constexpr std::int64_t longest_slice_ns = 5 * ns_per_ms;
// A stop that the port does not take is tried for so long in closing, and in a signal handler.
constexpr std::int64_t stop_patience_ns = 500 * ns_per_ms;
constexpr std::int64_t at_once_patience_ns = 30 * ns_per_ms;
// Closing waits no longer for a stop from a signal handler: a process that is ending may have lost the thread.
constexpr std::int64_t last_write_patience_ns = 100 * ns_per_ms;

LinkFault open_fault_of(int error) noexcept {
  switch (error) {
    case EACCES:
    case EPERM:
      return LinkFault::not_allowed;
    case ENOENT:
    case ENOTDIR:
    case ENODEV:
    case ENXIO:
      return LinkFault::absent;
    case EBUSY:
    case EWOULDBLOCK:  // flock()'s word for it
      return LinkFault::busy;
    case ENOTTY:
    case EISDIR:
      return LinkFault::unsupported;
    default:
      return LinkFault::broken;
  }
}

// Stops motors of a board that has forgotten its address, too. Which way and how finely it counts does not matter:
// whoever uses the board next sets it up anew.
hapi::SetUpPacket last_set_up() noexcept {
  return hapi::encode({.counts_per_turn = {4880.0F, 4880.0F}});
}

// The port takes nothing, or has nothing, just now.
bool is_momentary(int error) noexcept {
  return error == EAGAIN || error == EINTR;
}

// --- Which port ---

struct Target {
  LinkFault why_not = LinkFault::none;
  std::string node{};  // with all links followed
  std::string serial{};
};

Target target_at(const std::string& path, const std::vector<SerialPortFound>& ports) {
  std::error_code error;
  Target target;
  target.node = std::filesystem::canonical(path, error).string();
  if (error) return {open_fault_of(error.value())};
  const SerialPortFound* const port = find_port(ports, target.node);
  // Behind a path there may be another device at any time: nothing better is known of what is not on USB.
  target.serial = port == nullptr ? path : port->identity();
  return target;
}

// The ports that a stop may be owed at: all that the search finds, and the one of a person's choice.
std::vector<Target> possible_targets(const TtyPortOptions& options, const std::vector<SerialPortFound>& ports) {
  std::vector<Target> targets;
  if (!options.path.empty()) targets.push_back(target_at(options.path, ports));
  for (const SerialPortFound& port : ports) targets.push_back(target_at(port.path, ports));
  std::erase_if(targets, [](const Target& each) { return each.why_not != LinkFault::none; });
  return targets;
}

// What may be opened, the best first: all that are owed a stop, or else a single one. `in_use`: the identity of the board
// that was before.
std::vector<Target> targets_of(const TtyPortOptions& options, const StopDebts& owed, const std::string& in_use) {
  const std::vector<SerialPortFound> ports = list_serial_ports(options.places);
  const auto debt_of = [&owed](const Target& each) { return owed.place_of(device_serial_of(each.serial)); };
  std::vector<Target> debtors = possible_targets(options, ports);
  std::erase_if(debtors, [&](const Target& each) { return debt_of(each) == StopDebts::most; });
  std::ranges::stable_sort(debtors, {}, debt_of);
  if (!debtors.empty()) return debtors;

  if (!options.path.empty()) return {target_at(options.path, ports)};
  std::vector<Target> known;
  for (const SerialPortFound& port : ports) {
    if (!port.board.empty()) known.push_back(target_at(port.path, ports));
  }
  if (known.size() > 1) std::erase_if(known, [&in_use](const Target& each) { return each.serial != in_use; });
  return known.size() == 1 ? known : std::vector{Target{LinkFault::absent}};
}

// --- A terminal as a wire ---

// Every byte as it is, in both directions, and no flow control: none of them is a sign. Errno of what went wrong.
int make_raw(int file) noexcept {
  termios line{};
  if (tcgetattr(file, &line) != 0) return errno;
  cfmakeraw(&line);  // 8 bits, no parity
  line.c_iflag &= ~tcflag_t{IXOFF | IXANY};
  line.c_cflag &= ~tcflag_t{CSTOPB | CRTSCTS};
  line.c_cflag |= tcflag_t{CLOCAL | CREAD};
  // Closing must not drop DTR: boards fall silent without it, or restart.
  line.c_cflag &= ~tcflag_t{HUPCL};
  // With a 0 here, nothing to read would look as a port does that has gone.
  line.c_cc[VMIN] = 1;
  line.c_cc[VTIME] = 0;
  cfsetispeed(&line, B115200);
  cfsetospeed(&line, B115200);
  if (tcsetattr(file, TCSANOW, &line) != 0) return errno;
  // A pseudo terminal has no such lines.
  int lines = TIOCM_DTR | TIOCM_RTS;
  ioctl(file, TIOCMBIS, &lines);
  tcflush(file, TCIFLUSH);
  return 0;
}

// Two programs on one board would tear each other's packets. The lock is for programs that ask for it, and holds for root
// too, whom the terminal's own refuses nothing; that one keeps out programs that never ask. Both are the guard's as well, so
// that the port is taken until it has stopped the motors. Errno of what went wrong.
int lock_out_others(int file) noexcept {
  if (flock(file, LOCK_EX | LOCK_NB) != 0) return errno;
  return ioctl(file, TIOCEXCL) == 0 ? 0 : errno;
}

// Out of the way of the numbers that a file gets which somebody opens, or closes by mistake.
int moved_up(int file) noexcept {
  constexpr int first = 64;
  const int moved = fcntl(file, F_DUPFD_CLOEXEC, first);
  if (moved < 0) return file;
  ::close(file);
  return moved;
}

void close_quietly(int file) noexcept {
  // A terminal that somebody else has open too would go on being refused to others.
  ioctl(file, TIOCNXCL);
  ::close(file);
}

// The file; or why there is none, in `why_not`.
int open_terminal(const std::string& node, LinkFault& why_not) noexcept {
  struct stat status {};
  // Nothing but a terminal is opened: to open another device may do something by itself.
  int error = stat(node.c_str(), &status) == 0 ? 0 : errno;
  if (error == 0 && !S_ISCHR(status.st_mode)) error = ENOTTY;
  const int file = error == 0 ? ::open(node.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC) : -1;
  if (file < 0) {
    why_not = open_fault_of(error == 0 ? errno : error);
    return -1;
  }
  error = isatty(file) != 0 ? lock_out_others(file) : ENOTTY;
  if (error != 0) {  // what others have locked stays locked
    why_not = open_fault_of(error);
    ::close(file);
    return -1;
  }
  error = make_raw(file);
  why_not = error == 0 ? LinkFault::none : open_fault_of(error);
  if (error == 0) return moved_up(file);
  close_quietly(file);
  return -1;
}

}  // namespace

// --- Opening and closing ---------------------------------------------------------------------------------------------

LinkFault TtyPort::open_first(const StopDebts& owed) noexcept {
  close();
  try {
    fault_ = take_one(owed);
  } catch (const std::exception&) {  // out of memory
    fault_ = LinkFault::broken;
  }
  if (fault_ != LinkFault::none) close();
  return fault_;
}

// Where the first cannot be had, and why says most, another that may push can.
LinkFault TtyPort::take_one(const StopDebts& owed) {
  LinkFault first = LinkFault::none;
  for (const Target& target : targets_of(options_, owed, in_use_)) {
    const bool is_owed = owed.has(device_serial_of(target.serial));
    const LinkFault why_not =
        target.why_not == LinkFault::none ? take(target.node, target.serial, is_owed) : target.why_not;
    if (why_not == LinkFault::none) return LinkFault::none;
    close();
    if (first == LinkFault::none) first = why_not;
  }
  return first;
}

LinkFault TtyPort::take(const std::string& node, const std::string& serial, bool is_owed) {
  LinkFault why_not = LinkFault::none;
  const int file = open_terminal(node, why_not);
  if (file < 0) return why_not;
  struct stat status {};
  if (fstat(file, &status) != 0) {
    close_quietly(file);
    return LinkFault::broken;
  }
  device_ = status.st_rdev;
  descriptor_ = file;
  fault_ = LinkFault::none;
  serial_ = serial;
  may_push_ = is_owed;
  if (!may_push_) in_use_ = serial_;
  if (options_.is_guarded) start_guard(node);
  discard_input();
  return fault_;
}

// A busy machine may not let it begin in time. Without a guard the motors stay off for as long as the port is open.
void TtyPort::start_guard(const std::string& node) noexcept {
  GuardOrders orders;
  orders.wire = GuardOrders::Wire::serial;
  const hapi::ExchangePacket stop = hapi::zero_exchange();
  std::ranges::copy(stop, orders.stop.begin());
  orders.stop_size = static_cast<std::uint8_t>(stop.size());
  const hapi::SetUpPacket set_up = last_set_up();
  std::ranges::copy(set_up, orders.last.begin());
  orders.last_size = static_cast<std::uint8_t>(set_up.size());
  constexpr int attempts = 3;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    if (guard_.start(descriptor_, node, orders, may_push_)) return;
  }
}

bool TtyPort::is_any_plugged_in(const StopDebts& owed) const noexcept {
  try {
    const std::vector<Target> targets = possible_targets(options_, list_serial_ports(options_.places));
    return std::ranges::any_of(targets, [&owed](const Target& each) {
      return owed.has(device_serial_of(each.serial)) && access(each.node.c_str(), R_OK | W_OK) == 0;
    });
  } catch (const std::exception&) {  // out of memory
    return false;
  }
}

void TtyPort::close() noexcept {
  if (descriptor_ < 0) return;
  const std::int64_t deadline_ns = monotonic_ns() + stop_patience_ns;
  const bool is_told = may_push_ && insist_on_stop(deadline_ns);
  const bool has_gone_out = !is_still_port(descriptor_) || empty_output(may_push_ ? deadline_ns : 0);
  guard_.end(!may_push_ || (is_told && has_gone_out));
  may_push_ = false;
  // The number of a file that is closed may be another file's at once: not while somebody writes by it.
  const int file = descriptor_.exchange(-1);
  const std::int64_t last_write_ns = monotonic_ns() + last_write_patience_ns;
  while (is_writing_at_once_ && monotonic_ns() < last_write_ns) sleep_until_monotonic(monotonic_ns() + ns_per_ms / 10);
  if (is_still_port(file)) close_quietly(file);
}

// Whoever closes what is not theirs makes its number another file's: nothing goes there, and nothing of it is closed.
bool TtyPort::is_still_port(int file) const noexcept {
  struct stat status {};
  return fstat(file, &status) == 0 && S_ISCHR(status.st_mode) && status.st_rdev == device_;
}

// Zeros twice, as nobody waits for the answer. Also after a packet that was torn: what of these a board takes for the rest
// of it is a torque of next to nothing, because no byte of them is more than the address. Then a set up, for a board that
// does not take them; once, as the published firmwares allocate at each and free nothing. The guard is told that this
// program lives, or it would do the same at the same time. Whether they have gone out.
bool TtyPort::insist_on_stop(std::int64_t deadline_ns) noexcept {
  const hapi::ExchangePacket stop = hapi::zero_exchange();
  const hapi::SetUpPacket set_up = last_set_up();
  const std::array<std::span<const std::uint8_t>, 3> packets{stop, stop, set_up};
  const bool was_set_up = std::exchange(set_up_in_vain_, serial_) == serial_;
  const std::size_t count = packets.size() - (was_set_up ? 1 : 0);
  for (std::size_t next = 0; next < count;) {
    const std::int64_t now_ns = monotonic_ns();
    if (now_ns >= deadline_ns || !is_still_port(descriptor_)) return false;
    guard_.beat(now_ns);
    const std::span<const std::uint8_t> packet = packets[next];
    const ssize_t sent = ::write(descriptor_, packet.data(), packet.size());
    if (sent < 0 && !is_momentary(errno)) return false;
    if (sent == static_cast<ssize_t>(packet.size())) ++next;
    sleep_until_monotonic(now_ns + ns_per_ms);
  }
  return true;
}

// What a board does not take is dropped: closing would wait for half a minute until it does.
bool TtyPort::empty_output(std::int64_t deadline_ns) noexcept {
  int left = 0;
  while (ioctl(descriptor_, TIOCOUTQ, &left) == 0 && left > 0) {
    const std::int64_t now_ns = monotonic_ns();
    if (now_ns >= deadline_ns) {
      tcflush(descriptor_, TCOFLUSH);
      return false;
    }
    guard_.beat(now_ns);
    sleep_until_monotonic(now_ns + ns_per_ms);
  }
  return true;
}

// --- Faults ----------------------------------------------------------------------------------------------------------

void TtyPort::set_may_push(bool may_push) noexcept {
  may_push_ = may_push;
  if (!may_push && set_up_in_vain_ == serial_) set_up_in_vain_.clear();
  guard_.set_may_push(may_push, monotonic_ns());
}

void TtyPort::heed_guard() noexcept {
  const std::int64_t now_ns = monotonic_ns();
  guard_.beat(now_ns);
  if (is_overruled()) {
    set_fault(LinkFault::overruled);
  } else if (guard_.state() == GuardState::watching && !guard_.is_watching(now_ns)) {
    set_fault(LinkFault::unguarded);
  }
}

void TtyPort::failed(int error) noexcept {
  if (is_momentary(error)) return;
  const bool has_gone = error == EIO || error == ENXIO || error == ENODEV;
  set_fault(has_gone ? LinkFault::unplugged : LinkFault::broken);
}

// The first one is the cause of all others.
void TtyPort::set_fault(LinkFault fault) noexcept {
  if (fault_ == LinkFault::none) fault_ = fault;
}

// --- Out and in ------------------------------------------------------------------------------------------------------

bool TtyPort::write(std::span<const std::uint8_t> packet) noexcept {
  heed_guard();
  if (has_gone() || packet.empty() || packet.size() > longest_packet) return false;
  const bool is_stop = std::ranges::equal(packet, hapi::zero_exchange());
  // A set up stops a board that takes no zeros.
  const bool may_push = !is_stop && !hapi::is_set_up(packet);
  if (!is_stop && fault_ != LinkFault::none) return false;
  if (may_push && emergency_stop::is_ordered()) return false;
  if (!is_still_port(descriptor_)) {
    set_fault(LinkFault::broken);
    return false;
  }
  const ssize_t sent = ::write(descriptor_, packet.data(), packet.size());
  if (sent < 0) failed(errno);
  // The rest would come as a packet of its own, and a board reads it as commands.
  if (sent > 0 && static_cast<std::size_t>(sent) < packet.size()) set_fault(LinkFault::broken);
  return sent == static_cast<ssize_t>(packet.size());
}

// Beside whatever thread is writing: the kernel lets in one at a time, and turns the other away as if the port were full.
void TtyPort::write_at_once(std::span<const std::uint8_t> packet) noexcept {
  const int error_before = errno;
  is_writing_at_once_ = true;
  const std::int64_t deadline_ns = monotonic_ns() + at_once_patience_ns;
  for (;;) {
    const int file = descriptor_;
    if (file < 0 || !is_still_port(file) || ::write(file, packet.data(), packet.size()) >= 0) break;
    if (!is_momentary(errno) || monotonic_ns() >= deadline_ns) break;
    poll(nullptr, 0, 1);
  }
  is_writing_at_once_ = false;
  errno = error_before;
}

std::size_t TtyPort::read(std::span<std::uint8_t> into) noexcept {
  if (has_gone() || into.empty()) return 0;
  if (!is_still_port(descriptor_)) {
    set_fault(LinkFault::broken);
    return 0;
  }
  const ssize_t count = ::read(descriptor_, into.data(), into.size());
  if (count > 0) return static_cast<std::size_t>(count);
  failed(count < 0 ? errno : EIO);  // nothing at all comes of a terminal that has been hung up
  return 0;
}

// To flush it would leave what the kernel has received and not yet handed to the terminal.
void TtyPort::discard_input() noexcept {
  std::array<std::uint8_t, 512> dropped{};
  constexpr int most_reads = 128;  // more than a terminal holds
  for (int i = 0; i < most_reads && read(dropped) > 0; ++i) {
  }
}

// --- Time ------------------------------------------------------------------------------------------------------------

// Whether there is any, or there will be none.
bool TtyPort::await_input(std::int64_t longest_ns) noexcept {
  std::array<pollfd, 2> ends{pollfd{descriptor_, POLLIN, 0}, pollfd{guard_.descriptor(), POLLIN, 0}};
  const timespec longest{0, longest_ns};  // far less than a second
  if (ppoll(ends.data(), ends.size(), &longest, nullptr) <= 0) return false;
  if (ends[1].revents != 0) guard_.note_gone();
  if ((ends[0].revents & (POLLHUP | POLLERR | POLLNVAL)) != 0) set_fault(LinkFault::unplugged);
  return ends[0].revents != 0;
}

void TtyPort::wait_until(std::int64_t deadline_ns) noexcept {
  heed_guard();
  if (descriptor_ < 0 || fault_ != LinkFault::none) return sleep_until_monotonic(deadline_ns);
  for (;;) {
    const std::int64_t left_ns = deadline_ns - monotonic_ns();
    if (await_input(std::clamp<std::int64_t>(left_ns, 0, longest_slice_ns)) || left_ns <= 0) return;
    heed_guard();
    if (fault_ != LinkFault::none) return;
  }
}

}  // namespace ghostforce
