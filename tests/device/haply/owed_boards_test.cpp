// A board that may still push comes before any other: it is stopped as soon as it is there again, whatever else is in
// use, and is not used for that.
#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "device/haply/haply.h"
#include "tests/device/haply/two_boards.h"

namespace ghostforce::owed_boards_test {
namespace {

constexpr std::int64_t ms = 1'000'000;

std::vector<std::string> left_pushing;

class OwedBoards : public testing::Test {
 protected:
  std::unique_ptr<Haply> driver_with(HaplyOptions options, const SimulatedBoard* named = nullptr) {
    auto boards = std::make_unique<TwoBoards>(a, b, named);
    port = boards.get();
    return std::make_unique<Haply>(std::move(boards), std::move(options));
  }
  std::int64_t now_ns() const { return a.port.now_ns(); }
  // What the servo does.
  void tick() {
    const std::int64_t end_ns = now_ns() + ms;
    while (now_ns() < end_ns) {
      driver->update();
      driver->wait_until(end_ns);
    }
    driver->update();
    driver->set_force(force, is_armed);
  }
  void run(double seconds) {
    for (const std::int64_t end_ns = now_ns() + static_cast<std::int64_t>(seconds * 1e9); now_ns() < end_ns;) tick();
  }
  // Until it is so [ms]; -1: it was not.
  template <typename Condition>
  int ms_until(const Condition& is_so, double longest_s) {
    const std::int64_t began_ns = now_ns();
    while (!is_so()) {
      if (static_cast<double>(now_ns() - began_ns) * 1e-9 > longest_s) return -1;
      tick();
    }
    return static_cast<int>((now_ns() - began_ns) / ms);
  }
  // A person holds its zero pose, says so, and arms.
  void push_with(SimulatedBoard& board) {
    is_armed = false;
    board.port.hold_zero_pose(true);
    run(1.5);
    driver->confirm_zero_pose();
    run(0.2);
    board.port.hold_zero_pose(false);
    run(1.0);
    is_armed = true;
    run(0.1);
    ASSERT_TRUE(board.pushes());
    ASSERT_EQ(report().serial.text(), board.serial);
  }
  // A has pushed and is away; B, which was plugged in meanwhile, pushes.
  void push_with_b_while_a_is_owed() {
    b.unplug();
    push_with(a);
    a.unplug();
    run(0.05);
    b.plug();
    push_with(b);
    ASSERT_TRUE(a.pushes());
    ASSERT_EQ(report().owed_serial.text(), a.serial);
  }
  // Another scene is chosen, and with it another driver, with the other port by --haply-port.
  void name_b_while_a_is_owed() {
    HaplyOptions options;
    options.debts = std::make_shared<StopDebts>();
    driver = driver_with(options, &a);
    push_with(a);
    a.unplug();
    run(0.05);
    ASSERT_TRUE(a.pushes());
    is_armed = false;
    driver = driver_with(options, &b);
  }
  const HaplyReport& report() const { return driver->report(); }

  SimulatedBoard a{"BOARD-A"};
  SimulatedBoard b{"BOARD-B"};
  TwoBoards* port = nullptr;  // the driver's
  std::unique_ptr<Haply> driver = driver_with({});
  Vector<2> force{0.5, 0.5};
  bool is_armed = false;
};

TEST_F(OwedBoards, TheOwedOneIsStoppedAsSoonAsItIsBackWhateverElseIsInUse) {
  push_with_b_while_a_is_owed();
  a.packets.clear();
  a.plug();
  const int took_ms = ms_until([&] { return !a.pushes(); }, 5.0);
  EXPECT_GE(took_ms, 0);
  EXPECT_LE(took_ms, 300) << "it is looked for ten times a second";
  EXPECT_FALSE(b.pushes()) << "nothing else pushes while one is owed and there";
  ASSERT_FALSE(a.packets.empty());
  const auto zeros = hapi::zero_exchange();
  EXPECT_TRUE(std::ranges::equal(a.packets.front(), zeros)) << "before anything else";
  is_armed = false;
  run(0.5);
  EXPECT_FALSE(report().may_still_push);
  EXPECT_EQ(report().serial.text(), b.serial) << "and it goes on with the one that was in use";
  EXPECT_EQ(report().state, HaplyState::zero_pose);
}

TEST_F(OwedBoards, SaysWhyTheOtherOneStopped) {
  push_with_b_while_a_is_owed();
  a.plug();
  EXPECT_GE(ms_until([&] { return report().state == HaplyState::fault; }, 1.0), 0);
  EXPECT_EQ(report().fault, HaplyFault::stop_owed);
}

TEST_F(OwedBoards, NobodyLooksForABoardThatIsOwedNothing) {
  b.unplug();
  push_with(a);
  run(1.0);
  EXPECT_EQ(port->looks, 0);
}

// By --haply-port.
TEST_F(OwedBoards, TheNamedOneIsUsedOnceTheOwedOneHasStopped) {
  name_b_while_a_is_owed();
  a.plug();
  EXPECT_GE(ms_until([&] { return !a.pushes(); }, 1.0), 0);
  EXPECT_GE(ms_until([&] { return report().state == HaplyState::zero_pose; }, 1.0), 0);
  EXPECT_EQ(report().serial.text(), b.serial);
  EXPECT_FALSE(report().may_still_push);
  EXPECT_EQ(report().fault, HaplyFault::none);
  const int before = a.times_opened;
  push_with(b);
  EXPECT_EQ(a.times_opened, before);
}

// It has been set up anew while it was away, and knows no zero but after another set up.
TEST_F(OwedBoards, TheNamedOneIsUsedOnceAnOwedOneThatHasForgottenHasStopped) {
  name_b_while_a_is_owed();
  InjectedHaplyFault taken;
  taken.link = LinkFault::unplugged;
  taken.is_another_programs = true;
  a.port.inject(taken);
  run(0.2);
  ASSERT_TRUE(a.pushes());
  a.plug();
  bool has_asked_for_a_zero_pose = false;
  const auto is_b_in_use = [&] {
    has_asked_for_a_zero_pose |= report().state == HaplyState::zero_pose && report().serial.text() == a.serial;
    return report().state == HaplyState::zero_pose && report().serial.text() == b.serial;
  };
  EXPECT_GE(ms_until([&] { return is_b_in_use() && !a.pushes(); }, 2.0), 0);
  EXPECT_FALSE(has_asked_for_a_zero_pose) << "of a board that nobody chose";
  EXPECT_FALSE(a.pushes());
  EXPECT_FALSE(report().may_still_push);
}

TEST_F(OwedBoards, TheOneThatWasInUseIsUsedOnAndNotOpenedAnew) {
  b.unplug();
  push_with(a);
  a.unplug();
  run(0.3);
  is_armed = false;
  a.plug();
  EXPECT_GE(ms_until([&] { return report().state == HaplyState::zero_pose; }, 1.0), 0);
  EXPECT_EQ(report().serial.text(), a.serial);
  EXPECT_EQ(a.times_opened, 2);
}

TEST_F(OwedBoards, NothingElseIsUsedWhileTheOwedOneIsThereAndCannotBeHad) {
  b.unplug();
  push_with(a);
  a.unplug();
  run(0.05);
  a.plug();
  b.plug();
  a.is_busy = true;
  is_armed = false;
  run(3.0);
  EXPECT_EQ(report().fault, HaplyFault::busy);
  EXPECT_EQ(b.times_opened, 0);
  EXPECT_TRUE(report().may_still_push);
  a.is_busy = false;
  EXPECT_GE(ms_until([&] { return !a.pushes(); }, 0.5), 0);
}

// The first one answers nothing, or is another program's.
TEST_F(OwedBoards, AnOwedOneThatCannotBeStoppedKeepsNoOtherFromIt) {
  for (const bool is_busy : {true, false}) {
    SCOPED_TRACE(is_busy);
    push_with_b_while_a_is_owed();
    b.unplug();
    run(0.05);
    InjectedHaplyFault mute;
    mute.reply = HaplyReplyFault::lost;
    a.plug();
    a.is_busy = is_busy;
    if (!is_busy) a.port.inject(mute);
    b.plug();
    is_armed = false;
    EXPECT_GE(ms_until([&] { return !b.pushes(); }, 4.0), 0);
    EXPECT_TRUE(report().may_still_push);
    a.is_busy = false;
    a.port.inject({});
    EXPECT_GE(ms_until([&] { return !report().may_still_push; }, 4.0), 0);
    EXPECT_FALSE(a.pushes());
  }
}

TEST_F(OwedBoards, AtTheEndOfTheProgramTheOtherOneIsNoHindrance) {
  push_with_b_while_a_is_owed();
  a.plug();
  driver->shut_down();
  EXPECT_TRUE(a.pushes());
  driver.reset();
  EXPECT_FALSE(a.pushes());
  EXPECT_FALSE(b.pushes());
}

// Within the time for which it is looked for.
TEST_F(OwedBoards, AtTheEndOfTheProgramABoardMayReturnAtAnyMoment) {
  b.unplug();
  for (int at_ms = 1; at_ms < 480; at_ms += 37) {
    SCOPED_TRACE(at_ms);
    a.plug();
    driver = driver_with({});
    push_with(a);
    a.unplug();
    run(0.01);
    a.return_ns = now_ns() + at_ms * ms;
    driver.reset();
    EXPECT_TRUE(a.is_plugged);
    EXPECT_FALSE(a.pushes());
  }
}

// It may just be on its way.
TEST_F(OwedBoards, TheEndOfTheProgramWaitsForABoardThatIsAwayForAMomentOnly) {
  left_pushing.clear();
  b.unplug();
  HaplyOptions options;
  options.when_left_pushing = [](const DeviceSerial& serial) noexcept { left_pushing.emplace_back(serial.text()); };
  driver = driver_with(options);
  push_with(a);
  a.unplug();
  run(0.01);
  const std::int64_t began_ns = now_ns();
  driver.reset();
  EXPECT_GE(now_ns() - began_ns, 400 * ms);
  EXPECT_LT(now_ns() - began_ns, 800 * ms);
  EXPECT_EQ(left_pushing, std::vector<std::string>{a.serial});
}

}  // namespace
}  // namespace ghostforce::owed_boards_test
