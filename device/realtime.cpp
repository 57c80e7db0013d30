#include "device/realtime.h"

#include <cerrno>
#include <system_error>

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>

namespace ghostforce {
namespace {

// Above every ordinary thread, below the kernel's interrupt threads (50), which bring what the servo waits for.
constexpr int priority = 40;

int request_priority() noexcept {
  sched_param parameters{};
  parameters.sched_priority = priority;
  return pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters);
}

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

}  // namespace

RealtimeStatus request_realtime() noexcept {
  prctl(PR_SET_TIMERSLACK, 1UL, 0UL, 0UL, 0UL);  // [ns]; always granted
  return {request_priority(), request_memory_lock()};
}

std::string describe(const RealtimeStatus& status) {
  if (status.priority_error == 0 && status.memory_lock_error == 0) return "real-time priority, memory locked";
  const auto why = [](int error) { return " (" + std::generic_category().message(error) + ")"; };
  return (status.priority_error == 0 ? "real-time priority" : "no real-time priority" + why(status.priority_error)) +
         (status.memory_lock_error == 0 ? ", memory locked" : ", memory not locked" + why(status.memory_lock_error));
}

}  // namespace ghostforce
