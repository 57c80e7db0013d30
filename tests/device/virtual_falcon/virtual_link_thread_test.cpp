// A window that asks for faults and leads the hand while the servo's thread drives the link.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <thread>

#include "device/virtual_falcon/virtual_link.h"
#include "tests/device/virtual_falcon/link_exchange.h"

namespace ghostforce::virtual_link_thread_test {
namespace {

TEST(VirtualLinkThread, FaultsAndTheHandComeFromOtherThreads) {
  VirtualLink link(
      {.clock = VirtualLink::Clock::stepped, .device = {.starts_with_firmware = true, .starts_homed = true}});
  ASSERT_EQ(link.open(), LinkFault::none);
  std::atomic<bool> is_over = false;
  // They never end the link or the device; what those do is tested where nothing depends on the threads' luck.
  std::thread faults([&] {
    while (!is_over) {
      for (const char* name : {"late-5ms", "garbage", "short-frames", "split-packets"}) {
        link.inject(injected_fault(name));
        link.inject({});
      }
    }
  });
  std::thread mouse([&] {
    for (int i = 0; !is_over; ++i) link.lead_hand(hand_at({0.02 * std::sin(0.01 * i), 0.0, 0.125}, 0.016));
  });
  begin_run_time(link);
  int answered = 0;
  for (int i = 0; i < 2000; ++i) answered += exchange(link, {{100, 100, 100}, 0}) ? 1 : 0;
  is_over = true;
  faults.join();
  mouse.join();
  EXPECT_GT(answered, 500);
  link.inject({});
  link.wait_until(link.now_ns() + 50 * ms);
  EXPECT_TRUE(exchange(link, {}));
}

}  // namespace
}  // namespace ghostforce::virtual_link_thread_test
