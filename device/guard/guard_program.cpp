// ghostforce-guard: stops the motors of a program that cannot do it itself. See motor_guard.h; guard_memory.h says how it is
// called. It has one thread, allocates nothing once it watches, and needs the C library alone.
#include <fcntl.h>
#include <poll.h>
#include <sched.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <span>

#include "device/guard/usb_node.h"
#include "device/input/monotonic_clock.h"
#include "device/motors/guard_memory.h"

namespace ghostforce {
namespace {

// How often it looks [ms]: while motors may push, and otherwise.
constexpr int watchful_ms = 1;
constexpr int easy_ms = 4;
// Between two attempts to stop motors [ms].
constexpr int attempt_pause_ms = 5;
constexpr int enough_stops = 10;
// A device that is only waiting for the rest of a packet has it then.
constexpr int stops_before_last = 2;
// For so long a guard whose program is gone keeps trying [ns].
constexpr std::int64_t insist_ns = 5'000'000'000;

// Below what the kernel keeps for itself, far above the servo's: it runs for some microseconds at a time.
constexpr int wanted_priority = 90;

void take_priority() noexcept {
  cpu_set_t all;
  CPU_ZERO(&all);
  for (std::size_t i = 0; i < CPU_SETSIZE; ++i) CPU_SET(i, &all);
  sched_setaffinity(0, sizeof all, &all);  // the program may have left one to its servo
  sched_param parameters{};
  parameters.sched_priority = wanted_priority;
  if (sched_setscheduler(0, SCHED_FIFO, &parameters) == 0) return;
  // As high as this user may: the servo has no more.
  rlimit limit{};
  if (getrlimit(RLIMIT_RTPRIO, &limit) != 0 || limit.rlim_cur == 0) return;
  parameters.sched_priority = static_cast<int>(std::min<rlim_t>(limit.rlim_cur, wanted_priority));
  sched_setscheduler(0, SCHED_FIFO, &parameters);
}

// Where less may be locked than that, it runs from memory that the system may take away.
void lock_memory() noexcept {
  if (mlockall(MCL_CURRENT | MCL_FUTURE) == 0) return;
  mlockall(MCL_CURRENT | MCL_FUTURE | MCL_ONFAULT);
}

// No signal is for it, and no file but its own three.
void become_independent() noexcept {
  sigset_t all;
  sigfillset(&all);
  sigprocmask(SIG_SETMASK, &all, nullptr);
  syscall(SYS_close_range, static_cast<unsigned>(guard_call::lifeline_descriptor) + 1U, ~0U, 0U);
  [[maybe_unused]] const int ignored = chdir("/");
  prctl(PR_SET_TIMERSLACK, 1UL, 0UL, 0UL, 0UL);
}

class Guard {
 public:
  Guard(GuardMemory& page, const char* node) noexcept
      : page_(page),
        inherited_(guard_call::device_descriptor),
        own_(open(node, O_RDWR | O_CLOEXEC | O_NOCTTY | O_NONBLOCK)) {}

  // It can reach the device by one of its two files at least.
  bool has_device() const noexcept {
    if (own_ >= 0) return true;
    return is_serial() ? isatty(inherited_) != 0 : usb_node::is_one(inherited_);
  }

  void watch() noexcept {
    guard();
    // A pseudo terminal would go on being refused to others.
    if (is_serial()) ioctl(inherited_, TIOCNXCL);
  }

 private:
  void guard() noexcept {
    take_priority();
    lock_memory();
    page_.guard_beat_ns.store(monotonic_ns(), std::memory_order_release);
    page_.state.store(GuardState::watching, std::memory_order_release);
    for (;;) {
      const bool may_push = page_.may_push.load(std::memory_order_acquire);
      const bool program_is_gone = wait(may_push ? watchful_ms : easy_ms);
      const std::int64_t now_ns = monotonic_ns();
      page_.guard_beat_ns.store(now_ns, std::memory_order_release);
      // In this order: the beat that belongs to a force is older than the word that there is one.
      const bool has_ended = page_.has_ended.load(std::memory_order_acquire);
      const bool pushes_now = page_.may_push.load(std::memory_order_acquire);
      const std::int64_t beat_ns = page_.beat_ns.load(std::memory_order_acquire);
      switch (guard_action(has_ended, pushes_now, beat_ns, program_is_gone, now_ns)) {
        case GuardAction::watch:
          break;
        case GuardAction::stop_motors:
          return stop_motors();
        case GuardAction::end:
          return;
      }
    }
  }

  // Whether the program is gone.
  static bool wait(int longest_ms) noexcept {
    pollfd lifeline{guard_call::lifeline_descriptor, POLLIN, 0};
    return poll(&lifeline, 1, longest_ms) > 0;
  }

  // Until the program has closed the device or is gone. It is locked out first: if it goes on, what it was just about to
  // send must not come after the stop.
  void stop_motors() noexcept {
    page_.state.store(GuardState::stopping, std::memory_order_release);
    send_stop(inherited_);
    take_over();
    // That USB has taken a stop proves little: the chip before the motors may have lost its rate, and gets that first. So
    // it is repeated, and counts where the chip has taken all of it.
    const std::int64_t began_ns = monotonic_ns();
    int stops = 0;
    bool last_is_sent = false;
    for (;;) {
      if (set_up_and_stop(own_) || set_up_and_stop(inherited_)) ++stops;
      page_.state.store(stops >= enough_stops ? GuardState::stopped : GuardState::failing, std::memory_order_release);
      if (stops >= stops_before_last && !last_is_sent) last_is_sent = send_last();
      if (stops >= enough_stops && last_is_sent) break;
      const bool program_is_gone = wait(attempt_pause_ms);
      if (page_.has_ended.load() || (program_is_gone && monotonic_ns() - began_ns > insist_ns)) return;
      if (program_is_gone) poll(nullptr, 0, attempt_pause_ms);
    }
    while (!wait(easy_ms)) {
      page_.guard_beat_ns.store(monotonic_ns(), std::memory_order_release);
      // Nothing keeps the program's last packet out of a serial port: it may come at any time, as long as that is open.
      if (is_serial()) send_stop(inherited_);
    }
  }

  bool is_serial() const noexcept { return page_.orders.wire == GuardOrders::Wire::serial; }

  void take_over() noexcept {
    if (own_ < 0 || is_serial()) return;
    usb_node::release(inherited_, page_.orders.interface);  // ends what is under way through it
    usb_node::take_over(own_, page_.orders.interface);
  }

  bool set_up_and_stop(int wire) noexcept {
    if (wire < 0) return false;
    const std::span<const LineRequest> set_up(page_.orders.set_up.data(), page_.orders.set_up_count);
    bool is_set_up = true;
    for (const LineRequest& request : set_up) is_set_up = usb_node::control(wire, request) && is_set_up;
    return send_stop(wire) && is_set_up;
  }

  bool send_stop(int wire) noexcept {
    if (is_serial()) {
      return write(wire, page_.orders.stop.data(), page_.orders.stop_size) == page_.orders.stop_size;
    }
    return usb_node::send(wire, page_.orders.out_endpoint, {page_.orders.stop.data(), page_.orders.stop_size});
  }

  // Whether all of it has gone.
  bool send_last() noexcept {
    if (!is_serial()) return true;
    const int wire = own_ >= 0 ? own_ : inherited_;
    return write(wire, page_.orders.last.data(), page_.orders.last_size) == page_.orders.last_size;
  }

  GuardMemory& page_;
  int inherited_;
  int own_;  // negative: it may not be opened twice
};

// All three files are there, and the page is that of a program of the same version.
bool is_called_rightly() noexcept {
  struct stat page {};
  return fcntl(guard_call::device_descriptor, F_GETFD) >= 0 && fcntl(guard_call::lifeline_descriptor, F_GETFD) >= 0 &&
         fstat(guard_call::page_descriptor, &page) == 0 && page.st_size == static_cast<off_t>(sizeof(GuardMemory));
}

int run(const char* node) noexcept {
  if (!is_called_rightly()) return 2;
  become_independent();
  void* const memory =
      mmap(nullptr, sizeof(GuardMemory), PROT_READ | PROT_WRITE, MAP_SHARED, guard_call::page_descriptor, 0);
  if (memory == MAP_FAILED) return 1;
  Guard guard(*static_cast<GuardMemory*>(memory), node);
  if (!guard.has_device()) return 1;
  guard.watch();
  return 0;
}

}  // namespace
}  // namespace ghostforce

int main(int argc, char** argv) {
  return argc == 2 ? ghostforce::run(argv[1]) : 2;
}
