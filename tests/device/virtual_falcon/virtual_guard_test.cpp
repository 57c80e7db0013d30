// The virtual Falcon's guard, with a real clock: a program that stands still for a while finds its motors off.
#include <chrono>
#include <thread>

#include <gtest/gtest.h>

#include "device/motors/guard_memory.h"
#include "device/virtual_falcon/virtual_link.h"
#include "tests/device/virtual_falcon/link_exchange.h"

namespace ghostforce::virtual_guard_test {
namespace {

constexpr MotorNumbers push{300, 300, 300};

// Until it does: a machine that has other things to do may stand still by itself.
void make_push(VirtualLink& link) {
  do {
    ASSERT_EQ(link.open(), LinkFault::none);
    begin_run_time(link);
    link.set_may_push(true);
    exchange(link, {push, 0});
  } while (link.fault() == LinkFault::overruled);
  ASSERT_EQ(link.motors(), push);
}

void stand_still() {
  std::this_thread::sleep_for(std::chrono::nanoseconds(2 * longest_beat_gap_ns));
}

TEST(VirtualGuard, StopsMotorsOfAProgramThatStandsStill) {
  VirtualLink link({.device = {.starts_with_firmware = true}});
  ASSERT_NO_FATAL_FAILURE(make_push(link));
  stand_still();
  link.wait_until(link.now_ns());
  EXPECT_EQ(link.fault(), LinkFault::overruled);
  link.open();
  link.wait_until(link.now_ns() + 1 * ms);
  EXPECT_EQ(link.motors(), MotorNumbers{});
}

TEST(VirtualGuard, LeavesAProgramAloneThatHasTurnedItsMotorsOff) {
  VirtualLink link({.device = {.starts_with_firmware = true}});
  ASSERT_NO_FATAL_FAILURE(make_push(link));
  link.set_may_push(false);
  stand_still();
  link.wait_until(link.now_ns());
  EXPECT_EQ(link.fault(), LinkFault::none);
}

}  // namespace
}  // namespace ghostforce::virtual_guard_test
