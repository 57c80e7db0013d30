#include "device/servo/realtime.h"

#include <algorithm>
#include <cerrno>
#include <thread>

#include <gtest/gtest.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/utsname.h>
#include <unistd.h>

namespace ghostforce::realtime_test {
namespace {

// From Linux 6.12 on threads have slices of their own.
bool system_has_slices() {
  utsname system{};
  int major = 0;
  int minor = 0;
  uname(&system);
  return std::sscanf(system.release, "%d.%d", &major, &minor) == 2 && (major > 6 || (major == 6 && minor >= 12));
}

TEST(Realtime, SaysWhatTheThreadHasGot) {
  std::thread([] {
    const RealtimeStatus status = request_realtime();
    EXPECT_EQ(status.priority_error == 0, sched_getscheduler(0) == SCHED_FIFO);
    EXPECT_EQ(status.has_short_slice, status.priority_error != 0 && system_has_slices());
  }).join();
  munlockall();
}

TEST(Realtime, GivesAnOrdinaryUserShortSlices) {
  rlimit limit{};
  getrlimit(RLIMIT_RTPRIO, &limit);
  if (limit.rlim_cur > 0) GTEST_SKIP() << "this user may have the priority";
  std::thread([] {
    // The system call, unlike the function, is about this thread alone.
    constexpr int nobody = 65534;
    if (geteuid() == 0) {
      ASSERT_EQ(syscall(SYS_setresuid, nobody, nobody, nobody), 0);
    }
    const RealtimeStatus status = request_realtime();
    EXPECT_EQ(status.priority_error, EPERM);
    EXPECT_EQ(status.has_short_slice, system_has_slices());
    EXPECT_EQ(sched_getscheduler(0), SCHED_OTHER);
  }).join();
  munlockall();
}

// The kernel kills a thread that runs for too long without a pause, at once where both limits are one.
TEST(Realtime, ASignalComesBeforeTheKill) {
  const auto look = [] {
    rlimit limit{};
    getrlimit(RLIMIT_RTTIME, &limit);
    limit.rlim_max = std::min<rlim_t>(limit.rlim_max, 10'000'000);
    limit.rlim_cur = limit.rlim_max;
    setrlimit(RLIMIT_RTTIME, &limit);
    request_realtime();
    rlimit now{};
    getrlimit(RLIMIT_RTTIME, &now);
    _exit(now.rlim_max == limit.rlim_max && now.rlim_cur < limit.rlim_cur && now.rlim_cur > 0 ? 0 : 1);
  };
  EXPECT_EXIT(look(), testing::ExitedWithCode(0), "");
}

// That the thread may run on.
cpu_set_t processors() {
  cpu_set_t processors;
  CPU_ZERO(&processors);
  sched_getaffinity(0, sizeof processors, &processors);
  return processors;
}

int processors_of_thread() {
  const cpu_set_t all = processors();
  return CPU_COUNT(&all);
}

TEST(Realtime, LeavesNoProcessorToAServoWithPriority) {
  std::thread([] {
    const int before = processors_of_thread();
    const int policy = sched_getscheduler(0);
    if (request_realtime().priority_error != 0) GTEST_SKIP() << "this user may not have the priority";
    leave_processor_to_servo();
    EXPECT_EQ(processors_of_thread(), before);
    EXPECT_EQ(sched_getscheduler(0), policy);
  }).join();
  munlockall();
}

// Last of those that ask: what it does holds for the rest of the process.
TEST(Realtime, DrawingLeavesAProcessorToAnOrdinaryUsersServo) {
  rlimit limit{};
  getrlimit(RLIMIT_RTPRIO, &limit);
  if (limit.rlim_cur > 0) GTEST_SKIP() << "this user may have the priority";
  if (processors_of_thread() < 2) GTEST_SKIP() << "there is only one";
  std::thread([] {
    constexpr int nobody = 65534;
    if (geteuid() == 0) {
      ASSERT_EQ(syscall(SYS_setresuid, nobody, nobody, nobody), 0);
    }
    const int all = processors_of_thread();
    leave_processor_to_servo();
    EXPECT_EQ(processors_of_thread(), all - 1);
    leave_processor_to_servo();
    EXPECT_EQ(processors_of_thread(), all - 1) << "once";
    std::thread([all] {
      EXPECT_EQ(processors_of_thread(), all - 1) << "as a graphics driver's";
      const cpu_set_t of_drawing = processors();
      request_realtime();
      cpu_set_t shared;
      const cpu_set_t of_servo = processors();
      CPU_AND(&shared, &of_drawing, &of_servo);
      EXPECT_EQ(processors_of_thread(), 1);
      EXPECT_EQ(CPU_COUNT(&shared), 0) << "not where drawing is";
    }).join();
    EXPECT_EQ(processors_of_thread(), all - 1);
  }).join();
  munlockall();
}

TEST(Realtime, NamesWhatWasRefusedInAFewWords) {
  EXPECT_EQ(refused_words({0, 0}), "");
  EXPECT_EQ(refused_words({0, ENOMEM}), "memory not locked");
  EXPECT_EQ(refused_words({EPERM, EPERM, true}), "no real-time priority");
  EXPECT_EQ(refused_words({EPERM, 0}), "no real-time priority");
}

TEST(Realtime, SaysWhatWasGranted) {
  EXPECT_EQ(describe({0, 0}), "real-time priority, memory locked");
}

TEST(Realtime, SaysWhatWasNotAndWhy) {
  EXPECT_EQ(describe({EPERM, EPERM}),
            "no real-time priority (Operation not permitted), memory not locked (Operation not permitted)");
  EXPECT_EQ(describe({0, ENOMEM}), "real-time priority, memory not locked (Cannot allocate memory)");
  EXPECT_EQ(describe({EPERM, 0, true}),
            "no real-time priority (Operation not permitted), short time slices, memory locked");
}

}  // namespace
}  // namespace ghostforce::realtime_test
