// A Falcon that was told to stop and has not answered is owed that stop, whatever USB has taken and whatever else is
// plugged in; and a chip that has lost its settings gets them again.
#include "device/motors/stop_debts.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "device/falcon/falcon.h"
#include "tests/device/falcon/fake_falcons.h"

namespace ghostforce::stop_debts_test {
namespace {

constexpr std::int64_t ms = 1'000'000;

DeviceSerial numbered(int number) {
  return *DeviceSerial::from("FALCON" + std::to_string(number));
}

TEST(StopDebts, KeepsTheOldestFirstAndEachOnce) {
  StopDebts debts;
  EXPECT_TRUE(debts.empty());
  for (const int number : {3, 1, 2, 1}) debts.add(numbered(number));
  ASSERT_EQ(debts.serials().size(), 3U);
  EXPECT_EQ(debts.place_of(numbered(3)), 0U);
  EXPECT_EQ(debts.place_of(numbered(2)), 2U);
  EXPECT_FALSE(debts.has(numbered(4)));
  debts.remove(numbered(4));
  debts.remove(numbered(1));
  ASSERT_EQ(debts.serials().size(), 2U);
  EXPECT_EQ(debts.serials()[1], numbered(2));
  debts.remove(numbered(2));
  debts.remove(numbered(3));
  EXPECT_TRUE(debts.empty());
  for (int number = 0; number < 20; ++number) debts.add(numbered(number));
  EXPECT_EQ(debts.serials().size(), StopDebts::most);
  EXPECT_EQ(debts.serials().front(), numbered(0)) << "the oldest is not forgotten for a new one";
}

class OwedStops : public testing::Test {
 protected:
  // What the servo does.
  void tick() {
    const std::int64_t end_ns = now_ns + tick_ns;
    while (now_ns < end_ns) {
      driver->update();
      driver->wait_until(end_ns);
    }
    driver->update();
    driver->set_force({0.0, 0.0, force}, is_armed);
  }
  void run(double seconds) {
    for (const std::int64_t end_ns = now_ns + static_cast<std::int64_t>(seconds * 1e9); now_ns < end_ns;) tick();
  }
  void push_with(const FakeFalcon& falcon) {
    for (int i = 0; i < 5000 && !falcon.pushes(); ++i) tick();
    run(0.1);
    ASSERT_TRUE(falcon.pushes());
    ASSERT_EQ(report().serial.text(), falcon.serial);
  }
  // Until it is so [ms]; -1: it was not.
  template <typename Condition>
  int ms_until(const Condition& is_so, double longest_s) {
    const std::int64_t began_ns = now_ns;
    while (!is_so()) {
      if (static_cast<double>(now_ns - began_ns) * 1e-9 > longest_s) return -1;
      tick();
    }
    return static_cast<int>((now_ns - began_ns) / ms);
  }
  const FalconReport& report() const { return driver->report(); }
  std::unique_ptr<Falcon> driver_with(FalconOptions options) {
    auto falcons = std::make_unique<FakeFalcons>(std::vector{&a, &b}, now_ns);
    link = falcons.get();
    return std::make_unique<Falcon>(std::move(falcons), std::move(options));
  }

  FakeFalcon a{"12PZ657E"};
  FakeFalcon b{"FTPNM0FB"};
  std::int64_t now_ns = 1000 * ms;
  FakeFalcons* link = nullptr;  // the driver's
  std::unique_ptr<Falcon> driver = driver_with({});
  std::int64_t tick_ns = ms;
  double force = 1.0;
  bool is_armed = true;
};

TEST_F(OwedStops, ADebtIsPaidByAReplyAndNotByWhatUsbHasTaken) {
  b.is_plugged = false;
  push_with(a);
  EXPECT_FALSE(report().may_still_push);
  a.is_deaf = true;
  run(3.0);
  EXPECT_TRUE(a.pushes());
  EXPECT_TRUE(report().may_still_push) << "the chip has taken the stop, the device has not";
  EXPECT_EQ(report().owed_serial.text(), a.serial);
  is_armed = false;
  a.is_deaf = false;
  EXPECT_GE(ms_until([&] { return !report().may_still_push; }, 3.0), 0);
  EXPECT_FALSE(a.pushes());
  EXPECT_EQ(report().owed_serial, DeviceSerial());
}

// The stop goes out beside a force that is not answered yet, and the device hangs before it has heard the stop.
TEST_F(OwedStops, TheReplyToAForceThatWasSentBeforeTheStopPaysNothing) {
  b.is_plugged = false;
  push_with(a);
  a.reply_delay_ns = 4 * ms;
  run(0.1);
  for (int i = 0; i < 100 && (!driver->is_waiting_for_reply() || link->is_sending()); ++i) tick();
  ASSERT_TRUE(driver->is_waiting_for_reply());
  a.is_deaf = true;
  is_armed = false;
  run(3.0);
  EXPECT_TRUE(a.pushes());
  EXPECT_TRUE(report().may_still_push);
}

TEST_F(OwedStops, AChipThatWasPluggedInAgainIsSetUpBeforeItGetsTheStop) {
  b.is_plugged = false;
  push_with(a);
  a.unplug();
  run(1.0);
  EXPECT_TRUE(report().may_still_push);
  EXPECT_TRUE(a.pushes());
  is_armed = false;
  a.plug();
  const int took_ms = ms_until([&] { return !a.pushes(); }, 10.0);
  EXPECT_GE(took_ms, 0);
  EXPECT_LE(took_ms, 200) << "it is looked for ten times a second";
  EXPECT_EQ(a.noise_bytes, 0);
  run(0.1);
  EXPECT_FALSE(report().may_still_push);
  EXPECT_EQ(report().state, FalconState::idle) << "and it goes on with the device that was in use";
}

TEST_F(OwedStops, AnotherOneIsUsedMeanwhileAndStopsWhenTheOwedOneIsBack) {
  push_with(a);
  a.unplug();
  push_with(b);
  EXPECT_TRUE(report().may_still_push);
  EXPECT_EQ(report().owed_serial.text(), a.serial) << "not that of the device in use";
  a.plug();
  const int took_ms = ms_until([&] { return !a.pushes(); }, 10.0);
  EXPECT_GE(took_ms, 0);
  EXPECT_LE(took_ms, 300);
  EXPECT_FALSE(b.pushes()) << "nothing else pushes while one is owed and there";
  is_armed = false;
  run(1.0);
  EXPECT_FALSE(report().may_still_push) << report().owed_serial.text();
  EXPECT_TRUE(report().is_readable());
  EXPECT_FALSE(a.pushes());
  EXPECT_FALSE(b.pushes());
}

TEST_F(OwedStops, SaysWhyTheSecondOneStopped) {
  push_with(a);
  a.unplug();
  push_with(b);
  a.plug();
  EXPECT_GE(ms_until([&] { return report().state == FalconState::fault; }, 1.0), 0);
  EXPECT_EQ(report().fault, FalconFault::stop_owed);
}

TEST_F(OwedStops, TheDebtsOfTwoAreKeptApart) {
  push_with(a);
  a.unplug();
  push_with(b);
  b.unplug();
  run(1.0);
  is_armed = false;
  b.plug();
  EXPECT_GE(ms_until([&] { return !b.pushes(); }, 1.0), 0);
  run(0.2);
  EXPECT_TRUE(report().may_still_push) << "the other one's is not paid by this one's answers";
  EXPECT_EQ(report().owed_serial.text(), a.serial);
  EXPECT_EQ(report().serial.text(), b.serial);
  EXPECT_TRUE(report().is_readable());
  a.plug();
  EXPECT_GE(ms_until([&] { return !a.pushes(); }, 1.0), 0);
  run(0.2);
  EXPECT_FALSE(report().may_still_push);
}

TEST_F(OwedStops, NothingElseIsUsedWhileTheOwedOneIsThereAndCannotBeHad) {
  push_with(a);
  a.unplug();
  run(0.05);
  a.plug();
  a.is_busy = true;
  is_armed = false;
  run(3.0);
  EXPECT_EQ(report().fault, FalconFault::busy);
  EXPECT_EQ(report().state, FalconState::fault);
  EXPECT_EQ(b.times_opened, 0);
  EXPECT_TRUE(report().may_still_push);
  a.is_busy = false;
  EXPECT_GE(ms_until([&] { return !a.pushes(); }, 0.5), 0);
}

// As before: what has answered is owed nothing.
TEST_F(OwedStops, WhoHasNotPushedIsOwedNothing) {
  is_armed = false;
  ASSERT_GE(ms_until([&] { return report().state == FalconState::idle; }, 5.0), 0);
  a.unplug();
  run(0.5);
  EXPECT_FALSE(report().may_still_push);
  EXPECT_EQ(report().serial.text(), b.serial);
  a.plug();
  const int before = a.times_opened;
  run(1.0);
  EXPECT_EQ(a.times_opened, before) << "it waits for its turn";
}

// Another scene or input is chosen, and with it another driver.
TEST_F(OwedStops, ADebtOutlivesItsDriver) {
  FalconOptions options;
  options.debts = std::make_shared<StopDebts>();
  driver = driver_with(options);
  a.is_plugged = false;
  push_with(b);
  b.unplug();
  run(0.1);
  driver = driver_with(options);
  EXPECT_TRUE(report().may_still_push) << "from the first moment";
  EXPECT_TRUE(b.pushes());
  run(0.1);
  EXPECT_TRUE(report().may_still_push);
  EXPECT_EQ(report().owed_serial.text(), b.serial);
  a.plug();
  b.plug();
  is_armed = false;
  run(1.0);
  EXPECT_FALSE(b.pushes());
  EXPECT_FALSE(report().may_still_push);
}

// A moment before somebody chooses another input, or ends the program.
TEST_F(OwedStops, AChipThatIsResetBeforeItIsLetGoIsSetUpForTheStop) {
  for (const int before_ms : {0, 5, 15, 22, 50}) {
    SCOPED_TRACE(before_ms);
    a = FakeFalcon("12PZ657E");
    driver = driver_with({});
    b.is_plugged = false;
    push_with(a);
    a.reset_chip();
    const std::int64_t began_ns = now_ns;
    run(1e-3 * before_ms);
    driver->shut_down();
    EXPECT_FALSE(a.pushes());
    EXPECT_LE(a.last_force_ns - began_ns, 25 * ms);
    EXPECT_FALSE(report().may_still_push) << "and it has answered";
  }
}

// Three answers are on their way, all of them to forces.
TEST_F(OwedStops, ADeviceThatHearsNoGoodbyeIsOwedAStopWhateverItStillAnswers) {
  b.is_plugged = false;
  push_with(a);
  for (int delay_ms = 0; delay_ms < 20; ++delay_ms) {
    SCOPED_TRACE(delay_ms);
    a = FakeFalcon("12PZ657E");
    driver = driver_with({});
    push_with(a);
    a.reply_delay_ns = delay_ms * ms;
    run(0.03);
    if (!a.pushes()) continue;
    a.is_deaf = true;
    driver->shut_down();
    EXPECT_TRUE(a.pushes());
    EXPECT_TRUE(report().may_still_push);
  }
}

TEST_F(OwedStops, ADeviceThatIsLetGoIsAskedForNothingWhateverItsAnswersTell) {
  b.is_plugged = is_armed = false;
  tick_ns = ms / 4;
  for (int ticks = 0; ticks < 40; ++ticks) {
    a = FakeFalcon("12PZ657E");
    driver = driver_with({});
    run(0.25e-3 * ticks);
    driver->shut_down();
    EXPECT_EQ(a.asked, 0) << ticks << ": it is believed to be homed while it is let go";
  }
}

// As a program ends: the servo first, then what it had.
TEST_F(OwedStops, AtTheEndOfTheProgramTheOwedOneIsStoppedIfItIsThere) {
  b.is_plugged = false;
  push_with(a);
  a.unplug();
  run(0.01);
  a.plug();
  driver->shut_down();
  EXPECT_TRUE(a.pushes());
  driver.reset();
  EXPECT_FALSE(a.pushes());
}

TEST_F(OwedStops, AtTheEndOfTheProgramTheOtherOneIsNoHindrance) {
  push_with(a);
  a.unplug();
  push_with(b);
  a.plug();
  driver->shut_down();
  EXPECT_TRUE(a.pushes());
  driver.reset();
  EXPECT_FALSE(a.pushes());
  EXPECT_FALSE(b.pushes());
}

TEST_F(OwedStops, TheEndOfTheProgramDoesNotWaitForEver) {
  b.is_plugged = false;
  push_with(a);
  a.is_deaf = true;
  run(0.1);
  const std::int64_t began_ns = now_ns;
  driver.reset();
  EXPECT_GT(now_ns - began_ns, 1000 * ms) << "it was tried";
  EXPECT_LT(now_ns - began_ns, 5000 * ms);
}

TEST_F(OwedStops, AtTheEndOfTheProgramADeviceThatAnotherProgramHoldsIsTriedForLonger) {
  b.is_plugged = false;
  push_with(a);
  a.unplug();
  run(0.01);
  a.plug();
  a.is_busy = true;
  const std::int64_t began_ns = now_ns;
  driver.reset();
  EXPECT_GT(now_ns - began_ns, 2000 * ms);
}

std::vector<std::string> left_pushing;

TEST_F(OwedStops, TheEndOfTheProgramSaysWhichOnesAreLeftPushing) {
  for (const bool comes_back : {false, true}) {
    left_pushing.clear();
    FalconOptions options;
    options.when_left_pushing = [](const DeviceSerial& serial) noexcept { left_pushing.emplace_back(serial.text()); };
    a = FakeFalcon("12PZ657E");
    b.is_plugged = false;
    driver = driver_with(options);
    push_with(a);
    a.unplug();
    run(0.01);
    if (comes_back) a.plug();
    driver.reset();
    EXPECT_EQ(left_pushing, comes_back ? std::vector<std::string>{} : std::vector<std::string>{"12PZ657E"});
  }
}

// It may just be on its way.
TEST_F(OwedStops, TheEndOfTheProgramWaitsForADeviceThatIsAwayForAMomentOnly) {
  b.is_plugged = false;
  push_with(a);
  a.unplug();
  run(0.01);
  const std::int64_t began_ns = now_ns;
  driver.reset();
  EXPECT_GE(now_ns - began_ns, 400 * ms);
  EXPECT_LT(now_ns - began_ns, 800 * ms);
}

// Whenever that is within the time for which it is looked for, and whatever else is open then.
TEST_F(OwedStops, AtTheEndOfTheProgramADeviceMayReturnAtAnyMoment) {
  for (const bool is_alone : {true, false}) {
    for (int at_ms = 1; at_ms < 480; at_ms += 7) {
      SCOPED_TRACE(std::to_string(at_ms) + (is_alone ? " ms, alone" : " ms, beside another one"));
      a = FakeFalcon("12PZ657E");
      b = FakeFalcon("FTPNM0FB");
      driver = driver_with({});
      b.is_plugged = !is_alone;
      push_with(a);
      a.unplug();
      run(0.01);
      if (!is_alone) push_with(b);
      a.return_ns = now_ns + at_ms * ms;
      driver.reset();
      EXPECT_TRUE(a.is_plugged);
      EXPECT_FALSE(a.pushes());
      EXPECT_FALSE(b.pushes());
    }
  }
}

// --- What a chip may lose or refuse while its cable is in ---

// Wherever that falls between the chip's being set up and the stop.
TEST_F(OwedStops, AChipThatIsResetWhileItReturnsGetsTheStopSoon) {
  constexpr std::int64_t no_reset = -1;
  const auto stopped_after_ns = [&](std::int64_t reset_after_ns) {
    a = FakeFalcon{"12PZ657E"};
    b.is_plugged = false;
    driver = driver_with({});
    is_armed = true;
    push_with(a);
    a.unplug();
    run(1.0);
    is_armed = false;
    a.plug();
    const std::int64_t plugged_ns = now_ns;
    if (reset_after_ns != no_reset) a.reset_ns = now_ns + reset_after_ns;
    EXPECT_GE(ms_until([&] { return !a.pushes(); }, 10.0), 0);
    return a.last_force_ns - plugged_ns;
  };
  const std::int64_t usual_ns = stopped_after_ns(no_reset);
  for (std::int64_t before_ns = 0; before_ns <= ms; before_ns += 20'000) {
    EXPECT_LE(stopped_after_ns(usual_ns - before_ns) - usual_ns, 50 * ms) << before_ns << " ns before the stop";
  }
}

TEST_F(OwedStops, AChipThatIsResetWhileItsCableIsInGetsTheStopInTime) {
  push_with(a);
  a.reset_chip();
  const int took_ms = ms_until([&] { return !a.pushes(); }, 5.0);
  EXPECT_GE(took_ms, 0);
  EXPECT_LE(took_ms, 25);
  is_armed = false;
  EXPECT_GE(ms_until([&] { return !report().may_still_push; }, 0.3), 0);
  run(1.2);
  EXPECT_EQ(a.times_opened, 1) << "it is well again without being opened anew";
  EXPECT_TRUE(report().is_readable());
  EXPECT_TRUE(report().is_fast_enough()) << report().exchange_hz;
}

// However seldom it is asked, and wherever between two questions.
TEST_F(OwedStops, AChipThatIsResetGetsTheStopInTimeAtAnyRate) {
  b.is_plugged = false;
  for (const int tick_ms : {1, 5, 8}) {
    for (int offset = 0; offset < 10; ++offset) {
      SCOPED_TRACE(std::to_string(tick_ms) + " ms, " + std::to_string(offset));
      a = FakeFalcon("12PZ657E");
      driver = driver_with({});
      tick_ns = tick_ms * ms;
      is_armed = true;
      push_with(a);
      link->wait_until(now_ns + offset * tick_ns / 10);
      a.reset_chip();
      const std::int64_t began_ns = now_ns;
      EXPECT_GE(ms_until([&] { return !a.pushes(); }, 5.0), 0);
      EXPECT_LE(a.last_force_ns - began_ns, 25 * ms);
      is_armed = false;
      EXPECT_GE(ms_until([&] { return !report().may_still_push; }, 0.5), 0) << "and it is well again";
    }
  }
}

// Nothing was asked meanwhile, and so nothing was left unanswered.
TEST_F(OwedStops, AProgramThatDidNotRunForAWhileDoesNotTakeTheDeviceForSilent) {
  is_armed = false;
  ASSERT_GE(ms_until([&] { return report().state == FalconState::idle; }, 5.0), 0);
  run(0.1);
  for (int pause = 0; pause < 20; ++pause) {
    link->pause(5'000 * ms);
    run(0.0137);
  }
  EXPECT_EQ(report().faults, 0U);
  EXPECT_EQ(a.times_opened, 1);
  a.is_deaf = true;
  EXPECT_GE(ms_until([&] { return report().fault == FalconFault::no_replies; }, 1.2), 900);
}

TEST_F(OwedStops, ALatencyThatWasRefusedIsAskedForUntilTheDeviceIsFast) {
  is_armed = false;
  a.refuses_latency = true;
  run(3.0);
  ASSERT_TRUE(report().is_readable());
  EXPECT_FALSE(report().is_fast_enough());
  const int before = a.latency_requests;
  run(2.0);
  EXPECT_GE(a.latency_requests - before, 3) << "about each half second";
  EXPECT_LE(a.latency_requests - before, 5);
  a.refuses_latency = false;
  run(1.6);
  EXPECT_TRUE(report().is_fast_enough()) << report().exchange_hz;
  const int once_fast = a.latency_requests;
  run(2.0);
  EXPECT_EQ(a.latency_requests, once_fast);
}

TEST_F(OwedStops, NoRequestDelaysAForce) {
  push_with(a);
  a.refuses_latency = true;
  a.reply_delay_ns = 4 * ms;
  run(1.0);
  const int before = a.latency_requests;
  run(2.0);
  ASSERT_TRUE(a.pushes());
  EXPECT_FALSE(report().is_fast_enough());
  EXPECT_EQ(a.latency_requests, before);
}

}  // namespace
}  // namespace ghostforce::stop_debts_test
