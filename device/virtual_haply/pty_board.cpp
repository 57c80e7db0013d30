#include "device/virtual_haply/pty_board.h"

#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <ctime>
#include <system_error>

#include "device/input/monotonic_clock.h"
#include "device/input/thread_signals.h"

namespace ghostforce {
namespace {

// Of the terminal, as its master sees it; B0 if it cannot be asked.
speed_t speed_of(int master) noexcept {
  termios settings{};
  return tcgetattr(master, &settings) == 0 ? cfgetospeed(&settings) : speed_t{B0};
}

// Nothing in between reads, echoes or changes a byte.
bool make_raw(int master, speed_t speed) noexcept {
  termios settings{};
  if (tcgetattr(master, &settings) != 0) return false;
  cfmakeraw(&settings);
  cfsetspeed(&settings, speed);
  return tcsetattr(master, TCSANOW, &settings) == 0;
}

// Somebody's file is never replaced.
bool may_be_replaced(const char* path) noexcept {
  struct stat found {};
  return lstat(path, &found) != 0 ? errno == ENOENT : S_ISLNK(found.st_mode);
}

}  // namespace

PtyBoard::PtyBoard(const Options& options)
    : link_(options.link), new_link_(options.link + ".new"), bench_(options.device, monotonic_ns()), news_(News{}) {
  if (!link_.empty() && !may_be_replaced(link_.c_str())) {
    throw std::system_error(EEXIST, std::generic_category(), link_);
  }
  if (!options.device.fault.is_off_the_cable() && !plug_in()) {
    const int error = errno;
    unplug();
    throw std::system_error(error, std::generic_category(), "pseudo-terminal");
  }
  bench_.obey_injected_fault();
  obey(bench_.fault());
  news_.publish({bench_.truth(), slave_, false});
  thread_ = std::thread([this] { run(); });
}

PtyBoard::~PtyBoard() {
  is_over_ = true;
  if (thread_.joinable()) thread_.join();
  unplug();
}

std::string PtyBoard::port() {
  const News& news = news_.latest();
  if (news.port[0] == '\0') return {};
  return link_.empty() ? std::string(news.port.data()) : link_;
}

void PtyBoard::run() noexcept {
  // A real board has a processor of its own. Where the system grants it, this one comes before what draws and after the
  // servo, whose priority is higher.
  const sched_param parameters{.sched_priority = 5};
  pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters);
  leave_process_signals();
  const AlternateStack stack;
  while (!is_over_) {
    if (bench_.obey_injected_fault()) obey(bench_.fault());
    const std::int64_t now = monotonic_ns();
    listen();
    bench_.live_until(now);
    speak(now);
    news_.publish({bench_.truth(), slave_, is_open_});
    wait_for_host(std::min(now + tick_ns, std::max(now, bench_.next_event_ns())));
  }
}

// --- The plug --------------------------------------------------------------------------------------------------------

bool PtyBoard::plug_in() noexcept {
  if (master_ >= 0) return true;
  master_ = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC | O_NONBLOCK);
  if (master_ < 0 || grantpt(master_) != 0 || unlockpt(master_) != 0) return false;
  if (ptsname_r(master_, slave_.data(), slave_.size()) != 0 || !make_raw(master_, B9600)) return false;
  // A terminal that nobody has opened yet does not say that nobody has it open; one that was closed does.
  const int once = open(slave_.data(), O_RDWR | O_NOCTTY | O_CLOEXEC);
  if (once < 0) return false;
  close(once);
  return point_link(slave_.data());
}

void PtyBoard::unplug() noexcept {
  set_busy(false);
  point_link(nullptr);
  if (master_ >= 0) close(master_);
  master_ = -1;
  slave_ = {};
  is_open_ = false;
  bench_.lose_cable();
}

void PtyBoard::obey(const InjectedHaplyFault& wrong) noexcept {
  if (wrong.is_off_the_cable()) {
    unplug();
    return;
  }
  if (!plug_in()) {
    unplug();
    return;
  }
  constexpr mode_t for_its_user = S_IRUSR | S_IWUSR;
  chmod(slave_.data(), wrong.link == LinkFault::not_allowed ? 0 : for_its_user);
  set_busy(wrong.link == LinkFault::busy);
  if (wrong.touched_at_1200_baud) make_raw(master_, B1200);
}

void PtyBoard::set_busy(bool is_busy) noexcept {
  if (is_busy == (claim_ >= 0)) return;
  if (is_busy) {
    claim_ = open(slave_.data(), O_RDWR | O_NOCTTY | O_CLOEXEC);
    if (claim_ >= 0) ioctl(claim_, TIOCEXCL);
  } else {
    ioctl(claim_, TIOCNXCL);
    close(claim_);
    claim_ = -1;
  }
}

// To nowhere: there is none.
bool PtyBoard::point_link(const char* target) noexcept {
  if (link_.empty()) return true;
  if (!may_be_replaced(link_.c_str())) return false;
  if (target == nullptr) return unlink(link_.c_str()) == 0;
  unlink(new_link_.c_str());
  return symlink(target, new_link_.c_str()) == 0 && rename(new_link_.c_str(), link_.c_str()) == 0;
}

// --- The cable -------------------------------------------------------------------------------------------------------

// While nobody has the port open, poll would not wait at all.
void PtyBoard::wait_for_host(std::int64_t until_ns) noexcept {
  const std::int64_t left_ns = until_ns - monotonic_ns();
  if (left_ns <= 0) return;
  const timespec timeout{.tv_sec = 0, .tv_nsec = static_cast<long>(std::min<std::int64_t>(left_ns, 999'999'999))};
  pollfd host{.fd = master_, .events = POLLIN, .revents = 0};
  const bool listens = master_ >= 0 && is_open_;
  ppoll(&host, listens ? 1 : 0, &timeout, nullptr);
}

void PtyBoard::listen() noexcept {
  if (master_ < 0) return;
  std::array<std::uint8_t, 512> packet{};
  // What has piled up on a busy machine came in whole packets, wherever it is cut here: it all comes at one time.
  const std::int64_t now_ns = monotonic_ns();
  for (;;) {
    const ssize_t size = ::read(master_, packet.data(), packet.size());
    if (size > 0) {
      bench_.receive(std::span{packet}.first(static_cast<std::size_t>(size)), now_ns);
      continue;
    }
    if (size < 0 && errno == EINTR) continue;
    break;
  }
  pollfd host{.fd = master_, .events = POLLIN, .revents = 0};
  poll(&host, 1, 0);
  const bool was_open = is_open_;
  is_open_ = (host.revents & POLLHUP) == 0;
  if (was_open && !is_open_) note_closed();
}

void PtyBoard::note_closed() noexcept {
  if (speed_of(master_) == B1200) unplug();
}

// What nobody listens to is lost, as is what there is no room for.
void PtyBoard::speak(std::int64_t now_ns) noexcept {
  std::array<std::uint8_t, HaplyBench::most_bytes> packet{};
  for (std::size_t size = 0; (size = bench_.take(packet, now_ns)) > 0;) {
    if (master_ < 0 || !is_open_ || speed_of(master_) == B0) continue;
    const ssize_t written = ::write(master_, packet.data(), size);
    static_cast<void>(written);
  }
}

}  // namespace ghostforce
