// Once it is made, the virtual port never touches the heap: in a rehearsal the servo's thread lives in it.
#include <gtest/gtest.h>

#include "device/virtual_haply/virtual_port.h"
#include "tests/device/virtual_haply/hapi_bytes.h"
#include "tests/support/heap_guard.h"

namespace ghostforce::virtual_port_heap_test {
namespace {

using namespace hapi_bytes;

TEST(VirtualPortHeap, IsNotTouchedByAnyInjectedFault) {
  for (const InjectedHaplyFaultKind& kind : injected_haply_fault_catalog()) {
    SCOPED_TRACE(kind.name);
    const InjectedHaplyFault wrong = haply_fault(kind.name);
    const Bytes exchange = exchange_of(0.02, -0.02);
    VirtualPort port({.clock = VirtualPort::Clock::stepped});
    HeapGuard guard;
    port.open();
    port.hold_zero_pose(true);
    port.wait_until(port.now_ns() + 100 * ms);
    port.write(set_up_v31);
    port.hold_zero_pose(false);
    port.inject(wrong);
    port.lead_hand(haply_hand_at({0.03, 0.1}, 0.05));
    std::array<std::uint8_t, 64> bytes{};
    for (int i = 0; i < 200; ++i) {
      port.write(exchange);
      port.wait_until(port.now_ns() + 1 * ms);
      port.read(bytes);
    }
    port.write_at_once(exchange);
    port.close();
    port.open();
  }
}

}  // namespace
}  // namespace ghostforce::virtual_port_heap_test
