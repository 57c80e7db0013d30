// Once it is made, the virtual Falcon never touches the heap: in a rehearsal the servo's thread lives in it.
#include <gtest/gtest.h>

#include <vector>

#include "device/virtual_falcon/practice_firmware.h"
#include "device/virtual_falcon/virtual_link.h"
#include "tests/device/virtual_falcon/link_exchange.h"
#include "tests/support/heap_guard.h"

namespace ghostforce::virtual_link_heap_test {
namespace {

TEST(VirtualLinkHeap, IsNotTouchedFromOpeningToUnplugging) {
  const std::vector<std::uint8_t> firmware = practice_firmware();
  VirtualLink link({.clock = VirtualLink::Clock::stepped, .hand = {.homes_when_asked = true}});
  std::optional<ReplyFrame> reply;
  {
    HeapGuard guard;
    link.open();
    load_firmware(link, firmware);
    begin_run_time(link);
    for (int i = 0; i < 3000; ++i) reply = exchange(link, {{10, 20, 30}, CommandFrame::homing});
    link.lead_hand(hand_at({0.01, 0.0, 0.12}, 0.1));
    for (int i = 0; i < 100; ++i) exchange(link, {{10, 20, 30}, 0});
  }
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->status, ReplyFrame::homed);
}

TEST(VirtualLinkHeap, IsNotTouchedByAnyInjectedFault) {
  for (const InjectedFaultKind& kind : injected_fault_catalog()) {
    SCOPED_TRACE(kind.name);
    const std::vector<std::uint8_t> firmware = practice_firmware();
    const InjectedFault wrong = injected_fault(kind.name);
    VirtualLink link({.clock = VirtualLink::Clock::stepped});
    HeapGuard guard;
    link.open();
    link.inject(wrong);
    load_firmware(link, firmware);
    begin_run_time(link);
    for (int i = 0; i < 50; ++i) exchange(link, {});
    link.close();
    link.open();
  }
}

}  // namespace
}  // namespace ghostforce::virtual_link_heap_test
