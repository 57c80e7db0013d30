// A window that asks for faults and leads the hand while the servo's thread drives the port; and a signal handler's
// stop.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <thread>

#include "device/virtual_haply/virtual_port.h"
#include "tests/device/virtual_haply/hapi_bytes.h"

namespace ghostforce::virtual_port_thread_test {
namespace {

using namespace hapi_bytes;

TEST(VirtualPortThread, FaultsAndTheHandComeFromOtherThreads) {
  VirtualPort port({.clock = VirtualPort::Clock::stepped});
  ASSERT_EQ(port.open(), LinkFault::none);
  ASSERT_TRUE(port.write(set_up_v31));
  std::atomic<bool> is_over = false;
  // They never end the port or the set up; what those do is tested where nothing depends on the threads' luck.
  std::thread faults([&] {
    while (!is_over) {
      for (const char* name : {"late-5ms", "garbage", "duplicated-replies", "wrong-sign-1"}) {
        port.inject(haply_fault(name));
        port.inject({});
      }
    }
  });
  std::thread mouse([&] {
    for (int i = 0; !is_over; ++i) {
      port.lead_hand(haply_hand_at({0.02 + 0.01 * std::sin(0.01 * i), 0.09}, 0.016));
      port.hold_zero_pose(i % 100 == 0);
    }
  });
  std::size_t heard = 0;
  std::array<std::uint8_t, 256> bytes{};
  for (int i = 0; i < 1000; ++i) {
    port.write(exchange_at_port_2);
    for (const std::int64_t end_ns = port.now_ns() + 1 * ms; port.now_ns() < end_ns;) port.wait_until(end_ns);
    heard += port.read(bytes);
  }
  is_over = true;
  faults.join();
  mouse.join();
  EXPECT_GT(heard, 9U * 500U);
  std::thread handler([&] { port.write_at_once(exchange_of(0.0, 0.0)); });
  while (port.duties()[0] != 0.0) port.wait_until(port.now_ns() + 1 * ms);
  handler.join();
}

}  // namespace
}  // namespace ghostforce::virtual_port_thread_test
