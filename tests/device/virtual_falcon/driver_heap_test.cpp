// The way from a thousand exchanges a second to forces on a handle, and every way out of it, never touches the heap.
#include <gtest/gtest.h>

#include "tests/device/virtual_falcon/rehearsal.h"
#include "tests/support/heap_guard.h"

namespace ghostforce::driver_heap_test {
namespace {

TEST(DriverHeap, IsNotTouchedFromTheFirstLookToTheLastFrame) {
  Rehearsal rehearsal;
  HeapGuard guard;
  rehearsal.turn_on();
  for (const Strategy& entry : strategy_catalog()) {
    rehearsal.use(entry.id);
    rehearsal.input().move_to({0.02, -0.02}, 0.3);
    rehearsal.run(1.0);
    ASSERT_EQ(rehearsal.motors().state, SafetyState::on);
  }
  InjectedFault injected_fault;
  injected_fault.silence = true;
  rehearsal.input().inject(injected_fault);
  rehearsal.run(3.0);
  ASSERT_EQ(rehearsal.motors().state, SafetyState::off);
  rehearsal.input().shut_down();
}

TEST(DriverHeap, IsNotTouchedByAHandThatIsNotStill) {
  Rehearsal rehearsal({}, {}, 0.0, restless_scene());
  rehearsal.command().measures_hand = true;
  HeapGuard guard;
  rehearsal.turn_on();
  rehearsal.input().move_to({0.02, -0.02}, 0.3);
  rehearsal.run(2.0);
  ASSERT_EQ(rehearsal.motors().state, SafetyState::on);
}

}  // namespace
}  // namespace ghostforce::driver_heap_test
