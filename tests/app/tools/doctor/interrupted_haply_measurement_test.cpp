// `doctor haply --measure` at its terminal: a rehearsal from a file of answers, and Ctrl+C in the moment before it waits for
// a line. Each in a process of its own, because what remembers an interruption is for a whole process.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "app/base/interruption.h"
#include "app/files/haply_calibration_file.h"
#include "app/tools/doctor/haply_measure_command.h"
#include "device/motors/emergency_stop.h"
#include "tests/support/before_waiting.h"
#include "tests/support/exit_code_of.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::interrupted_haply_measurement_test {
namespace {

// A person who types this, and then, unless `ends`, nothing more.
void give_to_read(const std::string& text, bool ends) {
  std::array<int, 2> pipe_ends{};
  if (pipe2(pipe_ends.data(), O_CLOEXEC) != 0 || dup2(pipe_ends[0], STDIN_FILENO) < 0) std::abort();
  if (write(pipe_ends[1], text.data(), text.size()) != static_cast<ssize_t>(text.size())) std::abort();
  if (ends) close(pipe_ends[1]);
}

int measured(const TemporaryFolder& folder) {
  HaplyMeasureCall call;
  call.report = folder / "report.md";
  call.calibration = folder / "haply.toml";
  return exit_code_of([&] {
    if (const int code = measure_haply_with_doctor(std::move(call)); code != 0) std::exit(code);
  });
}

TEST(InterruptedHaplyMeasurementDeathTest, WithoutAnInterruptionThereAreBothFiles) {
  const TemporaryFolder folder;
  const auto measure = [&] {
    remember_interruptions(emergency_stop::stop_motors);
    give_to_read(std::string(40, '\n'), true);
    std::exit(measured(folder));
  };
  EXPECT_EXIT(measure(), testing::ExitedWithCode(0), "");
  EXPECT_EQ(folder.count(), 2);
}

TEST(InterruptedHaplyMeasurementDeathTest, InputThatEndsTooEarlyLeavesNoFile) {
  const TemporaryFolder folder;
  const auto measure = [&] {
    remember_interruptions(emergency_stop::stop_motors);
    give_to_read(std::string(9, '\n'), true);
    std::exit(measured(folder));
  };
  EXPECT_EXIT(measure(), testing::ExitedWithCode(1), "");
  EXPECT_EQ(folder.count(), 0);
}

// The signal itself turns motors off, before anybody has heard of it.
TEST(InterruptedHaplyMeasurementDeathTest, MotorsAreOffBeforeTheProgramHasHeardOfIt) {
  const TemporaryFolder folder;
  const auto measure = [&] {
    remember_interruptions(emergency_stop::stop_motors);
    give_to_read("", false);
    before_waiting([] {
      if (emergency_stop::is_ordered()) std::exit(2);
      std::raise(SIGINT);
      if (!emergency_stop::is_ordered()) std::exit(1);
    });
    std::exit(measured(folder));
  };
  EXPECT_EXIT(measure(), testing::ExitedWithCode(130), "");
  EXPECT_EQ(folder.count(), 0);
}

}  // namespace
}  // namespace ghostforce::interrupted_haply_measurement_test
