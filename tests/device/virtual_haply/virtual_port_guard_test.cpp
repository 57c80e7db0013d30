// The virtual port's guard, with a real clock: a program that stands still for a while finds its motors off.
#include <gtest/gtest.h>

#include <cmath>

#include "device/input/monotonic_clock.h"
#include "device/motors/guard_memory.h"
#include "device/virtual_haply/virtual_port.h"
#include "tests/device/virtual_haply/hapi_bytes.h"

namespace ghostforce::virtual_port_guard_test {
namespace {

using namespace hapi_bytes;

// Until it does: a machine that has other things to do may stand still by itself.
void make_push(VirtualPort& port) {
  do {
    ASSERT_EQ(port.open(), LinkFault::none);
    port.set_may_push(true);
    ASSERT_TRUE(port.write(set_up_v31));
    ASSERT_TRUE(port.write(exchange_at_port_2));
    for (const std::int64_t end_ns = port.now_ns() + 2 * ms; port.now_ns() < end_ns;) port.wait_until(end_ns);
  } while (port.fault() == LinkFault::overruled);
  ASSERT_NE(port.duties()[0], 0.0);
}

void stand_still() {
  sleep_until_monotonic(monotonic_ns() + 2 * longest_beat_gap_ns);
}

TEST(VirtualPortGuard, StopsMotorsOfAProgramThatStandsStill) {
  VirtualPort port({});
  ASSERT_NO_FATAL_FAILURE(make_push(port));
  stand_still();
  port.wait_until(port.now_ns());
  EXPECT_EQ(port.fault(), LinkFault::overruled);
  EXPECT_FALSE(port.write(exchange_at_port_2));
  port.open();
  port.wait_until(port.now_ns() + 1 * ms);
  EXPECT_EQ(port.duties(), (std::array{0.0, 0.0}));
}

TEST(VirtualPortGuard, LeavesAProgramAloneThatHasTurnedItsMotorsOff) {
  VirtualPort port({});
  ASSERT_NO_FATAL_FAILURE(make_push(port));
  port.set_may_push(false);
  stand_still();
  port.wait_until(port.now_ns());
  EXPECT_EQ(port.fault(), LinkFault::none);
}

}  // namespace
}  // namespace ghostforce::virtual_port_guard_test
