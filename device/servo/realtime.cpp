#include "device/servo/realtime.h"

#include <cerrno>
#include <cstddef>
#include <cstdint>

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace ghostforce {
namespace {

// Above every ordinary thread, below the kernel's interrupt threads (50), which bring what the servo waits for.
constexpr int priority = 40;

int request_priority() noexcept {
  sched_param parameters{};
  parameters.sched_priority = priority;
  return pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters);
}

// How long an ordinary thread runs before others get their turn. From Linux 6.12 on one that asks for less gets it
// sooner when it wakes: the shortest that there is [ns].
constexpr std::uint64_t shortest_slice_ns = 100'000;

// Linux's struct sched_attr, of which the C library (glibc 2.36) knows nothing.
struct SchedulingAttributes {
  std::uint32_t size = sizeof(SchedulingAttributes);
  std::uint32_t policy = 0;
  std::uint64_t flags = 0;
  std::int32_t nice = 0;
  std::uint32_t priority = 0;
  std::uint64_t runtime_ns = 0;  // of an ordinary thread: its slice
  std::uint64_t deadline_ns = 0;
  std::uint64_t period_ns = 0;
};

// Older systems take no notice, and say so when they are asked.
bool request_short_slice() noexcept {
  SchedulingAttributes attributes;
  if (syscall(SYS_sched_getattr, 0, &attributes, sizeof attributes, 0U) != 0) return false;
  attributes.runtime_ns = shortest_slice_ns;
  if (syscall(SYS_sched_setattr, 0, &attributes, 0U) != 0) return false;
  if (syscall(SYS_sched_getattr, 0, &attributes, sizeof attributes, 0U) != 0) return false;
  return attributes.runtime_ns == shortest_slice_ns;
}

// The processor that drawing leaves, where it leaves one; written before there is a servo to read it.
cpu_set_t servos_processor;
bool is_one_left = false;

// Locking future memory under a limit would make every later allocation of the whole process fail once the limit is
// reached, and what is locked now would keep stacks from growing. So memory is locked only where there is no limit, or
// where we may lift it. MCL_ONFAULT: pages stay once they are touched, instead of all that is mapped being read in.
int request_memory_lock() noexcept {
  rlimit limit{RLIM_INFINITY, RLIM_INFINITY};
  if (setrlimit(RLIMIT_MEMLOCK, &limit) != 0 && getrlimit(RLIMIT_MEMLOCK, &limit) == 0) {
    limit.rlim_cur = limit.rlim_max;
    if (limit.rlim_max != RLIM_INFINITY || setrlimit(RLIMIT_MEMLOCK, &limit) != 0) return EPERM;
  }
  return mlockall(MCL_CURRENT | MCL_FUTURE | MCL_ONFAULT) == 0 ? 0 : errno;
}

// A real-time thread that never pauses is told so by a signal once it reaches the lower limit, and there is time for a
// last word; at the upper one the process is killed, without any. Where both are one, the lower gives way.
void put_signal_before_kill() noexcept {
  rlimit limit{};
  if (getrlimit(RLIMIT_RTTIME, &limit) != 0 || limit.rlim_max == RLIM_INFINITY || limit.rlim_cur < limit.rlim_max)
    return;
  limit.rlim_cur = limit.rlim_max / 2;
  setrlimit(RLIMIT_RTTIME, &limit);
}

}  // namespace

void leave_processor_to_servo() noexcept {
  cpu_set_t processors;
  if (is_one_left || sched_getaffinity(0, sizeof processors, &processors) != 0 || CPU_COUNT(&processors) < 2) return;
  if (request_priority() == 0) {
    const sched_param ordinary{};
    pthread_setschedparam(pthread_self(), SCHED_OTHER, &ordinary);
    return;
  }
  std::size_t last = CPU_SETSIZE - 1;
  while (!CPU_ISSET(last, &processors)) --last;
  CPU_CLR(last, &processors);
  CPU_ZERO(&servos_processor);
  CPU_SET(last, &servos_processor);
  is_one_left = sched_setaffinity(0, sizeof processors, &processors) == 0;
}

RealtimeStatus request_realtime() noexcept {
  prctl(PR_SET_TIMERSLACK, 1UL, 0UL, 0UL, 0UL);  // [ns]; always granted
  if (is_one_left) sched_setaffinity(0, sizeof servos_processor, &servos_processor);
  put_signal_before_kill();
  RealtimeStatus status;
  status.priority_error = request_priority();
  status.has_short_slice = status.priority_error != 0 && request_short_slice();
  status.memory_lock_error = request_memory_lock();
  return status;
}

}  // namespace ghostforce
