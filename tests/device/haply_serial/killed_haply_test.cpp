// A program with an armed Haply is killed or stopped at random moments, many times; and two programs at one port.
#include <csignal>
#include <random>

#include "tests/device/haply_serial/dying_haply.h"
#include "tests/support/long_run.h"

namespace ghostforce::killed_haply_test {
namespace {

using std::chrono::microseconds;

class KilledHaply : public DyingHaplyTest {
 protected:
  // Another one for each run; a failure says which.
  const unsigned seed = std::random_device()();
  std::mt19937 random{seed};

  microseconds some_time(int longest_us) { return microseconds(std::uniform_int_distribution(0, longest_us)(random)); }
};

// Exchanges are under way all the time: a thousand a second and more.
TEST_F(KilledHaply, WhileItsMotorsPush) {
  title = "SIGKILL at a random moment";
  const int times = is_long_run() ? 50 : 2;
  for (int i = 0; i < times; ++i) {
    SCOPED_TRACE(fmt::format("seed {}, time {}", seed, i));
    ASSERT_NO_FATAL_FAILURE(start("wait"));
    std::this_thread::sleep_for(some_time(50'000));
    has_noted = false;
    event_ns = monotonic_ns();
    program->send(SIGKILL);
    EXPECT_EQ(program->wait_for_end(), 128 + SIGKILL);
    expect_well();
    if (HasFailure()) return;
  }
}

// From the first byte on: while it asks, sets up, waits, arms, checks its motors and leans in.
TEST_F(KilledHaply, WhateverItIsDoing) {
  title = "SIGKILL at any moment";
  const int times = is_long_run() ? 50 : 2;
  for (int i = 0; i < times; ++i) {
    SCOPED_TRACE(fmt::format("seed {}, time {}", seed, i));
    has_noted = false;
    ASSERT_NO_FATAL_FAILURE(launch("wait"));
    event_ns = monotonic_ns() + some_time(6'000'000) / std::chrono::nanoseconds(1);
    while (monotonic_ns() < event_ns) {
      if (const auto line = program->next_line(std::chrono::milliseconds((event_ns - monotonic_ns()) / 1'000'000))) {
        obey(*line);
      }
    }
    event_ns = monotonic_ns();
    program->send(SIGKILL);
    EXPECT_EQ(program->wait_for_end(), 128 + SIGKILL);
    expect_port_is_free();
    expect_zero();
    expect_it_stays();
    EXPECT_EQ(board.heard().packets.stray_bytes, 0U);
    EXPECT_EQ(board.heard().packets.unfinished, 0U);
    if (HasFailure()) return;
  }
  expect_next_driver_is_owed_nothing();
}

// For about as long as its guard has patience: one of the two goes on, and never both.
TEST_F(KilledHaply, IsStoppedForAMoment) {
  title = "SIGSTOP for a moment";
  has_noted = true;
  const int times = is_long_run() ? 50 : 2;
  for (int i = 0; i < times; ++i) {
    SCOPED_TRACE(fmt::format("seed {}, time {}", seed, i));
    ASSERT_NO_FATAL_FAILURE(start("wait"));
    program->send(SIGSTOP);
    std::this_thread::sleep_for(microseconds(10'000) + some_time(20'000));
    program->send(SIGCONT);
    const auto live_on = [this] {
      const std::uint64_t exchanges = board.heard().packets.exchanges;
      EXPECT_TRUE(becomes([&] { return board.heard().packets.exchanges > exchanges + 300; }));
      return board.heard().packets.forces;
    };
    const std::uint64_t forces = live_on();
    if (live_on() == forces) expect_zero();
    expect_whole_packets();
    program->send(SIGTERM);
    EXPECT_EQ(program->wait_for_end(), static_cast<int>(ExitCode::interrupted));
    expect_port_is_free();
    expect_zero();
    if (HasFailure()) return;
  }
}

// --- Two at once -----------------------------------------------------------------------------------------------------

class TwoAtOnePort : public DyingHaplyTest {
 protected:
  TwoAtOnePort() { has_noted = true; }

  // The second is told so, and asks again.
  void expect_busy(RunningProgram& second) {
    constexpr int looks = 3;
    for (int i = 0; i < looks; ++i) EXPECT_EQ(second.next_line(), "busy");
  }
};

// Once more where this machine held the first up for so long that its guard ended the force.
TEST_F(TwoAtOnePort, TheSecondIsToldBusyAndDisturbsNobody) {
  constexpr int most_attempts = 5;
  bool pushes_on = false;
  for (int attempt = 0; !pushes_on && attempt < most_attempts; ++attempt) {
    ASSERT_NO_FATAL_FAILURE(start("wait"));
    RunningProgram second(ARMED_HAPLY, call_of("look"));
    expect_busy(second);
    second.send(SIGTERM);
    EXPECT_EQ(second.wait_for_end(), static_cast<int>(ExitCode::interrupted));
    const std::uint64_t forces = board.heard().packets.forces;
    const auto was_ended = [&] { return board.heard().truth.resets != resets; };
    EXPECT_TRUE(becomes([&] { return board.heard().packets.forces > forces + 200 || was_ended(); }));
    pushes_on = !was_ended();
    if (pushes_on) {
      expect_whole_packets();
      ASSERT_NO_FATAL_FAILURE(send(SIGTERM));
    } else {
      program->send(SIGTERM);
    }
    EXPECT_EQ(program->wait_for_end(), static_cast<int>(ExitCode::interrupted));
    pushes_on ? expect_well() : expect_zero();
  }
  EXPECT_TRUE(pushes_on);
}

// The one that has it says nothing: whatever comes is the other's.
TEST_F(TwoAtOnePort, TheSecondNeverWritesAByte) {
  TtyPort first({.path = board.port(), .is_guarded = false});
  ASSERT_EQ(first.open(), LinkFault::none);
  for (const int signal : {SIGTERM, SIGABRT, SIGKILL}) {
    RunningProgram second(ARMED_HAPLY, call_of("look"));
    expect_busy(second);
    second.send(signal);
    second.wait_for_end();
  }
  EXPECT_TRUE(board.heard().is_open);
  first.close();
  expect_port_is_free();
  EXPECT_EQ(board.heard().packets.bytes, 0U);
}

// It waits until the guard of the first has done its work, and then gets the board with its motors off.
TEST_F(TwoAtOnePort, TheSecondGetsThePortOfAFirstThatWasKilled) {
  ASSERT_NO_FATAL_FAILURE(start("wait"));
  RunningProgram second(ARMED_HAPLY, call_of("wait"));
  ASSERT_NO_FATAL_FAILURE(send(SIGKILL));
  EXPECT_EQ(program->wait_for_end(), 128 + SIGKILL);
  const std::uint64_t exchanges = board.heard().packets.exchanges;
  EXPECT_TRUE(becomes([&] { return board.heard().packets.exchanges > exchanges + 500; }));
  expect_zero();
  expect_it_stays();
  expect_whole_packets();
  second.send(SIGTERM);
  EXPECT_EQ(second.wait_for_end(), static_cast<int>(ExitCode::interrupted));
  expect_well();
}

}  // namespace
}  // namespace ghostforce::killed_haply_test
