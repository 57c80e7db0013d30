// Ctrl+C while `doctor --measure` waits for a person: in the moment before it begins to wait, whatever it reads. Each in
// a process of its own, because what remembers an interruption is for a whole process.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdint>
#include <cstdlib>

#include "app/base/interruption.h"
#include "app/tools/doctor/measure_command.h"
#include "device/motors/emergency_stop.h"
#include "tests/app/tools/doctor/measured_rehearsal.h"
#include "tests/support/before_waiting.h"
#include "tests/support/exit_code_of.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::interrupted_measurement_test {
namespace {

// A person who types nothing.
void give_nothing_to_read() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0 || dup2(ends[0], STDIN_FILENO) < 0) std::abort();
}

// Nothing should have left motors on at a prompt. If something has, they go off all the same.
void push_and_interrupt(VirtualLink& link) {
  link.write(encode(CommandFrame{.motors = {300, 300, 300}}));
  const std::int64_t heard_ns = link.now_ns() + 10'000'000;
  while (link.now_ns() < heard_ns) link.wait_until(heard_ns);
  if (link.motors() == MotorNumbers{}) std::exit(2);
  std::raise(SIGINT);
}

TEST(InterruptedMeasurementDeathTest, AtAPromptMotorsGoOff) {
  const auto measure = [] {
    remember_interruptions(emergency_stop::stop_motors);
    give_nothing_to_read();
    MeasuredRehearsal rehearsal;
    TerminalOperator person(nullptr);
    await_homed(*rehearsal.falcon, person);
    before_waiting([&] { push_and_interrupt(rehearsal.link->link); });
    const int code = exit_code_of([&] { measure_falcon(*rehearsal.falcon, person, FalconCalibration{}); });
    std::exit(rehearsal.link->link.motors() == MotorNumbers{} ? code : 1);
  };
  EXPECT_EXIT(measure(), testing::ExitedWithCode(130), "");
}

// The command's own: the signal itself turns them off, before anybody has heard of it.
TEST(InterruptedMeasurementDeathTest, MotorsAreOffBeforeTheProgramHasHeardOfIt) {
  const TemporaryFolder folder;
  const auto measure = [&] {
    remember_interruptions(emergency_stop::stop_motors);
    give_nothing_to_read();
    before_waiting([] {
      if (emergency_stop::is_ordered()) std::exit(2);
      std::raise(SIGINT);
      if (!emergency_stop::is_ordered()) std::exit(1);
    });
    const MeasureCall call{.firmware = {},
                           .falcon = {},
                           .injected_fault = {},
                           .cable = {},
                           .is_virtual = true,
                           .report = folder / "report.md",
                           .calibration = folder / "falcon.toml"};
    std::exit(exit_code_of([&] { measure_with_doctor(call); }));
  };
  EXPECT_EXIT(measure(), testing::ExitedWithCode(130), "");
  EXPECT_EQ(folder.count(), 0);
}

}  // namespace
}  // namespace ghostforce::interrupted_measurement_test
