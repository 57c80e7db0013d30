// For tests: a program that holds an armed Haply (armed_haply.cpp) at a simulated board whose motors push into a wall;
// and what must be so once it has died, or was kept from running.
#pragma once

#include <signal.h>

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/base/failure.h"
#include "device/haply/haply.h"
#include "device/haply/haply_input.h"
#include "device/haply_serial/tty_port.h"
#include "tests/device/haply_serial/listening_board.h"
#include "tests/emulation/machine_watch.h"
#include "tests/support/becomes.h"
#include "tests/support/program.h"

namespace ghostforce {

class DyingHaplyTest : public testing::Test {
 protected:
  // A program at the board, which is in its hand's zero pose.
  void launch(const std::string& name, const std::string& detail = "") {
    board.hold_zero_pose(true);
    ASSERT_TRUE(becomes([&] { return board.heard().is_in_zero_pose && !board.heard().is_open; }));
    program = std::make_unique<RunningProgram>(ARMED_HAPLY, call_of(name, detail));
  }

  ProgramCall call_of(const std::string& name, const std::string& detail = "") {
    ProgramCall call;
    call.words = {board.port(), name, detail};
    return call;
  }

  // Does what it says it wants of the hand.
  void obey(const std::string& line) {
    static constexpr Vector<2> free_place{-0.015, 0.015};
    static constexpr Vector<2> deep_place{0.011, -0.011};
    const HaplyPlane plane(usual_haply_variant().calibration, Vector<2>(0.0));
    if (line == "zero pose") {
      board.hold_zero_pose(true);
      becomes([&] { return board.heard().is_in_zero_pose; });
      program->order("it is held");
    }
    if (line == "outside") {
      board.hold_zero_pose(false);
      board.lead_hand(haply_hand_at(plane.in_workspace(free_place), 0.4));
    }
    if (line == "inside") board.lead_hand(haply_hand_at(plane.in_workspace(deep_place), 0.5));
  }

  // Returns when its motors push, and its own way out begins.
  void start(const std::string& name, const std::string& detail = "") {
    ASSERT_NO_FATAL_FAILURE(launch(name, detail));
    for (;;) {
      const auto line = program->next_line();
      if (!line) skip_if_too_busy();
      ASSERT_TRUE(line) << "the program has ended, or has not got so far";
      obey(*line);
      if (line->starts_with("ends ")) {
        event_ns = std::stoll(line->substr(5));
        resets = board.heard().truth.resets;
        return;
      }
    }
  }

  // While a duty stands: the force of a program that goes on dips now and then, to ask whether the encoders count.
  void send(int signal) {
    ASSERT_TRUE(becomes([&] { return board.heard().has_duty(); }));
    event_ns = monotonic_ns();
    program->send(signal);
  }

  void skip_if_too_busy() const {
    if (!watch.is_too_busy()) return;
    [] { GTEST_SKIP() << MachineTooBusy().what(); }();
    throw testing::AssertionException(
        testing::TestPartResult(testing::TestPartResult::kSkip, __FILE__, __LINE__, MachineTooBusy().what()));
  }

  // The one child that the program has; 0: none.
  pid_t guard() const {
    pid_t child = 0;
    std::error_code gone;
    const std::string tasks = "/proc/" + std::to_string(program->pid()) + "/task";
    for (const auto& thread : std::filesystem::directory_iterator(tasks, gone)) {
      if (child == 0) std::ifstream(thread.path() / "children") >> child;
    }
    return child;
  }

  // --- What must be so then ---

  // However long it takes here: a test is no measurement. Not one of the dips in which it asks whether encoders count.
  void expect_zero() {
    const auto is_over = [this] {
      constexpr std::int64_t longer_than_a_dip_ns = 300'000'000;
      const ListeningBoard::Heard heard = board.heard();
      return !heard.has_duty() && heard.truth.time_ns - heard.last_push_ns > longer_than_a_dip_ns;
    };
    EXPECT_TRUE(becomes(is_over)) << "the motors push";
    note_time();
  }

  // Nothing comes on again in the time in which a program would send some hundred packets.
  void expect_it_stays() {
    const std::uint64_t pushes = board.heard().pushes;
    std::this_thread::sleep_for(std::chrono::milliseconds(400));
    EXPECT_FALSE(board.heard().has_duty());
    EXPECT_EQ(board.heard().pushes, pushes) << "they have pushed again";
  }

  void expect_whole_packets() {
    const PacketCount packets = board.heard().packets;
    EXPECT_GT(packets.exchanges, 0U);
    EXPECT_EQ(packets.stray_bytes, 0U);
    EXPECT_EQ(packets.unfinished, 0U);
    EXPECT_EQ(board.heard().truth.resets, resets);
  }

  void expect_port_is_free() {
    EXPECT_TRUE(becomes([&] { return !board.heard().is_open; })) << "somebody holds the port";
  }

  // One that knows of the debt.
  void expect_next_driver_is_owed_nothing() {
    HaplyOptions options;
    options.debts = std::make_shared<StopDebts>();
    options.debts->add(device_serial_of(std::filesystem::canonical(board.port()).string()));
    Haply next(std::make_unique<TtyPort>(TtyPortOptions{.path = board.port()}), options);
    EXPECT_TRUE(next.report().may_still_push);
    EXPECT_TRUE(becomes([&] { return next.report().state == HaplyState::zero_pose; }, [&] { next.update(); }));
    EXPECT_FALSE(next.report().may_still_push);
    EXPECT_TRUE(next.report().was_set_up);
    EXPECT_FALSE(board.heard().has_duty());
  }

  // All of it, of a program that is no more.
  void expect_well() {
    expect_port_is_free();
    EXPECT_FALSE(board.heard().was_left_pushing) << "the port was let go of while a motor pushed";
    expect_zero();
    expect_it_stays();
    expect_whole_packets();
    expect_next_driver_is_owed_nothing();
    expect_whole_packets();
  }

  // From the event to when the last duty stood.
  void note_time() {
    const double time_ms = std::max(0.0, 1e-6 * static_cast<double>(board.heard().last_push_ns - event_ns));
    if (std::exchange(has_noted, true)) return;
    if (std::getenv("GHOSTFORCE_PRINT_HAPLY_FAULTS") != nullptr) {
      std::printf("| %s | %.2f | %.2f |\n", title.c_str(), time_ms, 1e-6 * static_cast<double>(board.heard().late_ns));
    }
    RecordProperty("zero_us_after", std::to_string(static_cast<int>(1000.0 * time_ms)));
  }

  const MachineWatch watch;
  ListeningBoard board;
  std::unique_ptr<RunningProgram> program;
  std::string title;  // of its fault, in the table
  std::int64_t event_ns = 0;
  // To a board that nobody has set up the eight zeros of the first question are four resets. None may come later.
  std::uint64_t resets = 0;
  bool has_noted = false;
};

}  // namespace ghostforce
