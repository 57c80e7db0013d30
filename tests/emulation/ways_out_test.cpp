// Every way out of a process that can run code ends in zero force on the device: a program that holds an armed Falcon,
// through the real libusb, ends while the motors push, and the far end of the cable tells what it was told last.
#include <chrono>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/base/failure.h"
#include "tests/emulation/emulated_usb_device.h"
#include "tests/emulation/falcon_chip.h"
#include "tests/emulation/hand_in_scene.h"
#include "tests/emulation/machine_watch.h"
#include "tests/support/long_run.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::ways_out_test {
namespace {

using std::chrono::milliseconds;

constexpr std::chrono::minutes patience{4};  // of a machine that is busy with other things

std::int64_t now_ns() {
  return std::chrono::steady_clock::now().time_since_epoch() / std::chrono::nanoseconds(1);
}

// Ends the test's body from any depth; the test counts as skipped.
[[noreturn]] void skip_because(const std::string& reason) {
  [&] { GTEST_SKIP() << reason; }();
  throw testing::AssertionException(
      testing::TestPartResult(testing::TestPartResult::kSkip, __FILE__, __LINE__, reason.c_str()));
}

class WaysOutTest : public testing::Test {
 protected:
  WaysOutTest() { falcon.plug(); }

  // Returns when its motors push.
  void start(const std::string& name, const std::string& detail = "") {
    way = name;
    ProgramCall call;
    call.words = {way, detail};
    call.folder = folder.path();
    program = std::make_unique<RunningProgram>(armed_program, call);
    for (;;) {
      const auto line = program->next_line();
      if (!line || *line != "pushing") skip_if_too_busy();
      ASSERT_TRUE(line) << "the program has ended, or has not got so far";
      lead_hand(chip, *line);
      if (*line == "pushing") break;
    }
    const auto line = program->next_line();
    ASSERT_TRUE(line && line->starts_with("ends "));
    event_ns = std::stoll(line->substr(5));
  }

  // Motors that push may go off again at once, because this machine has other things to do: then once more.
  void see_it_push() {
    for (int attempt = 0; attempt < 20 && chip.told().motors == MotorNumbers{}; ++attempt) {
      program.reset();
      ASSERT_NO_FATAL_FAILURE(start(way));
    }
    if (chip.told().motors == MotorNumbers{}) skip_if_too_busy();
    ASSERT_NE(chip.told().motors, MotorNumbers{});
  }

  void skip_if_too_busy() const {
    if (watch.is_too_busy()) skip_because(MachineTooBusy().what());
  }

  // While the motors push.
  void send(int signal) {
    ASSERT_NO_FATAL_FAILURE(see_it_push());
    event_ns = now_ns();
    program->send(signal);
  }

  // The program has not taken it yet, on any thread.
  bool is_pending(int signal) const {
    const std::string tasks = "/proc/" + std::to_string(program->pid()) + "/task";
    for (const auto& thread : std::filesystem::directory_iterator(tasks)) {
      std::ifstream status(thread.path() / "status");
      for (std::string name, value; status >> name && std::getline(status, value);) {
        const bool is_mask = name == "SigPnd:" || name == "ShdPnd:";
        if (is_mask && ((std::stoull(value, nullptr, 16) >> (signal - 1)) & 1) != 0) return true;
      }
    }
    return false;
  }

  // What was on the way when the program ended has arrived.
  FalconChip::Told told_in_the_end() {
    std::this_thread::sleep_for(milliseconds(30));
    return chip.told();
  }

  void expect_no_force(int exit_code) {
    EXPECT_EQ(program->wait_for_end(), exit_code);
    const FalconChip::Told told = told_in_the_end();
    EXPECT_EQ(told.motors, MotorNumbers{});
    EXPECT_GT(told.last_force_ns, 0);
    // How soon: fault_table measures it.
    RecordProperty("last_force_us_after", std::to_string((told.last_force_ns - event_ns) / 1000));
  }

  // There was time for a goodbye: the device has answered what it was told last, and has been heard.
  void expect_goodbye(int exit_code) {
    expect_no_force(exit_code);
    EXPECT_GE(chip.told().silent_frames, 3U);
  }

  const MachineWatch watch;
  TemporaryFolder folder;
  TestBed bed;
  // It runs and is homed, so that each test takes seconds.
  FalconChip chip{{.starts_with_firmware = true, .starts_homed = true}};
  EmulatedUsbDevice falcon{bed, chip, "12PZ657E"};
  std::string armed_program = ARMED_PROGRAM;
  std::string way;  // of the program that runs
  std::unique_ptr<RunningProgram> program;
  std::int64_t event_ns = 0;
};

// --- With a goodbye --------------------------------------------------------------------------------------------------

TEST_F(WaysOutTest, Return) {
  ASSERT_NO_FATAL_FAILURE(start("return"));
  expect_goodbye(0);
}

TEST_F(WaysOutTest, StopAndExit) {
  ASSERT_NO_FATAL_FAILURE(start("stop and exit"));
  expect_goodbye(0);
}

class WaysOutBySignalTest : public WaysOutTest, public testing::WithParamInterface<int> {};

TEST_P(WaysOutBySignalTest, Interrupted) {
  ASSERT_NO_FATAL_FAILURE(start("wait"));
  ASSERT_NO_FATAL_FAILURE(send(GetParam()));
  expect_goodbye(static_cast<int>(ExitCode::interrupted));
}

INSTANTIATE_TEST_SUITE_P(, WaysOutBySignalTest, testing::Values(SIGINT, SIGTERM, SIGHUP),
                         [](const auto& run) { return sigabbrev_np(run.param); });

// Without a beat of the window's heart: the process stays, and its motors do not.
TEST_F(WaysOutTest, TheWindowStalls) {
  ASSERT_NO_FATAL_FAILURE(start("stall"));
  const auto reason = program->next_line();
  ASSERT_TRUE(reason);
  EXPECT_NE(*reason, "none");
  const FalconChip::Told told = chip.told();
  EXPECT_EQ(told.motors, MotorNumbers{});
  RecordProperty("last_force_us_after", std::to_string((told.last_force_ns - event_ns) / 1000));
  EXPECT_EQ(program->wait_for_end(), 0);
}

// --- At once ---------------------------------------------------------------------------------------------------------

TEST_F(WaysOutTest, InterruptedTwiceBecauseItHangs) {
  ASSERT_NO_FATAL_FAILURE(start("hang"));
  program->send(SIGINT);
  // Two that come at once are one.
  const std::int64_t deadline_ns = now_ns() + patience / std::chrono::nanoseconds(1);
  while (is_pending(SIGINT) && now_ns() < deadline_ns) std::this_thread::sleep_for(milliseconds(1));
  event_ns = now_ns();
  program->send(SIGINT);
  expect_no_force(128 + SIGINT);
}

// Every signal that ends a process unless it is told otherwise, but for SIGKILL and those above. One handler is for all
// of them: ./check sends each while the program hangs, and a few elsewhere; .ci/long sends all everywhere.
class WaysOutByDeadlySignalTest : public WaysOutBySignalTest {};
class WaysOutInHealthTest : public WaysOutBySignalTest {};

using Signals = std::vector<int>;

Signals all_in_long_run(const Signals& few, const Signals& all) {
  return is_long_run() ? all : few;
}

const Signals& deadly_signals() {
  static const Signals all{SIGQUIT, SIGILL,  SIGTRAP, SIGABRT,   SIGBUS,       SIGFPE,       SIGUSR1,   SIGSEGV,
                           SIGUSR2, SIGPIPE, SIGALRM, SIGSTKFLT, SIGXCPU,      SIGXFSZ,      SIGVTALRM, SIGPROF,
                           SIGPOLL, SIGPWR,  SIGSYS,  SIGRTMIN,  SIGRTMIN + 1, SIGRTMAX - 1, SIGRTMAX};
  return all;
}

TEST_P(WaysOutByDeadlySignalTest, WhileItHangs) {
  ASSERT_NO_FATAL_FAILURE(start("hang"));
  ASSERT_NO_FATAL_FAILURE(send(GetParam()));
  expect_no_force(128 + GetParam());
}

TEST_P(WaysOutInHealthTest, WhileItRuns) {
  ASSERT_NO_FATAL_FAILURE(start("wait"));
  ASSERT_NO_FATAL_FAILURE(send(GetParam()));
  expect_no_force(128 + GetParam());
}

std::string signal_name(const testing::TestParamInfo<int>& run) {
  if (run.param >= SIGRTMIN) return "RTMIN_" + std::to_string(run.param - SIGRTMIN);
  return sigabbrev_np(run.param);
}

INSTANTIATE_TEST_SUITE_P(, WaysOutByDeadlySignalTest, testing::ValuesIn(deadly_signals()), signal_name);
INSTANTIATE_TEST_SUITE_P(, WaysOutInHealthTest,
                         testing::ValuesIn(all_in_long_run({SIGQUIT, SIGSEGV, SIGUSR1, SIGRTMAX}, deadly_signals())),
                         signal_name);

// Those that go to the very thread that is at fault, or has used up its time.
class WaysOutByTheServosSignalTest : public WaysOutBySignalTest {};

TEST_P(WaysOutByTheServosSignalTest, OnItsThread) {
  ASSERT_NO_FATAL_FAILURE(start("signal on the servo's thread", std::to_string(GetParam())));
  expect_no_force(128 + GetParam());
}

INSTANTIATE_TEST_SUITE_P(, WaysOutByTheServosSignalTest,
                         testing::ValuesIn(all_in_long_run({SIGABRT, SIGSEGV, SIGXCPU},
                                                           {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTRAP, SIGSYS,
                                                            SIGXCPU})),
                         signal_name);

// The second must not end it before the first has turned motors off.
TEST_F(WaysOutTest, TwoSignalsAtOnce) {
  ASSERT_NO_FATAL_FAILURE(start("wait"));
  ASSERT_NO_FATAL_FAILURE(see_it_push());
  program->send(SIGSTOP);
  event_ns = now_ns();
  for (int i = 0; i < 2; ++i) program->send(SIGRTMIN);  // real-time signals are queued, each of them
  program->send(SIGCONT);
  expect_no_force(128 + SIGRTMIN);
}

// What the program does to itself.
struct WayOut {
  const char* way;
  const char* detail;
  int exit_code;
};
class WaysOutByItselfTest : public WaysOutTest, public testing::WithParamInterface<WayOut> {};

TEST_P(WaysOutByItselfTest, EndsInNoForce) {
  ASSERT_NO_FATAL_FAILURE(start(GetParam().way, GetParam().detail));
  expect_no_force(GetParam().exit_code);
}

INSTANTIATE_TEST_SUITE_P(, WaysOutByItselfTest,
                         testing::Values(WayOut{"segmentation faults on two threads", "", 128 + SIGSEGV},
                                         WayOut{"exit", "", 0},  // by a library
                                         WayOut{"abort", "", 128 + SIGABRT}, WayOut{"assertion", "", 128 + SIGABRT},
                                         WayOut{"exception", "", 128 + SIGABRT},  // that nobody catches
                                         WayOut{"segmentation fault", "", 128 + SIGSEGV},
                                         WayOut{"stack overflow", "", 128 + SIGSEGV},
                                         WayOut{"stack overflow on the servo's thread", "", 128 + SIGSEGV},
                                         WayOut{"stack overflow on another thread", "recorder", 128 + SIGSEGV},
                                         WayOut{"stack overflow on another thread", "spacemouse", 128 + SIGSEGV},
                                         WayOut{"abort on the servo's thread", "", 128 + SIGABRT},
                                         WayOut{"segmentation fault on the servo's thread", "", 128 + SIGSEGV}),
                         [](const auto& run) {
                           std::string name = fmt::format("{} {}", run.param.way, run.param.detail);
                           std::erase_if(name, [](char c) { return c == ' ' || c == '\''; });
                           return name;
                         });

// --- None of its code can run ----------------------------------------------------------------------------------------

// The guard is left.
class WaysOutWithAGuardTest : public WaysOutTest {
 protected:
  void wait_for_zero() {
    const std::int64_t deadline_ns = now_ns() + patience / std::chrono::nanoseconds(1);
    while (chip.told().motors != MotorNumbers{} && now_ns() < deadline_ns) std::this_thread::sleep_for(milliseconds(1));
    ASSERT_EQ(chip.told().motors, MotorNumbers{});
  }

  // It may just be started.
  pid_t some_guard() const {
    const std::int64_t deadline_ns = now_ns() + patience / std::chrono::nanoseconds(1);
    pid_t found = 0;
    while ((found = guard()) == 0 && now_ns() < deadline_ns) std::this_thread::sleep_for(milliseconds(1));
    return found;
  }

  // The one child that the program has.
  pid_t guard() const {
    const std::string process = std::to_string(program->pid());
    pid_t child = 0;
    std::ifstream("/proc/" + process + "/task/" + process + "/children") >> child;
    for (const auto& thread : std::filesystem::directory_iterator("/proc/" + process + "/task")) {
      if (child == 0) std::ifstream(thread.path() / "children") >> child;
    }
    return child;
  }
};

TEST_F(WaysOutWithAGuardTest, Killed) {
  ASSERT_NO_FATAL_FAILURE(start("wait"));
  ASSERT_NO_FATAL_FAILURE(send(SIGKILL));
  EXPECT_EQ(program->wait_for_end(), 128 + SIGKILL);
  wait_for_zero();
}

// The first zeros arrive as noise.
TEST_F(WaysOutWithAGuardTest, KilledWhenTheChipHasLostItsRate) {
  ASSERT_NO_FATAL_FAILURE(start("wait"));
  ASSERT_NO_FATAL_FAILURE(send(SIGSTOP));
  InjectedFault wrong;
  find_injected_fault("chip-resets")->add(wrong);
  chip.inject(wrong);
  program->send(SIGKILL);
  EXPECT_EQ(program->wait_for_end(), 128 + SIGKILL);
  wait_for_zero();
}

TEST_F(WaysOutWithAGuardTest, Stopped) {
  ASSERT_NO_FATAL_FAILURE(start("wait"));
  ASSERT_NO_FATAL_FAILURE(send(SIGSTOP));
  ASSERT_NO_FATAL_FAILURE(wait_for_zero());
  const std::uint64_t frames = chip.told().frames;
  program->send(SIGCONT);
  // It takes the device again, and nothing that it was about to say before comes through.
  const std::int64_t deadline_ns = now_ns() + patience / std::chrono::nanoseconds(1);
  while (chip.told().frames < frames + 100 && now_ns() < deadline_ns) {
    ASSERT_EQ(chip.told().motors, MotorNumbers{});
  }
  EXPECT_GE(chip.told().frames, frames + 100);
  program->send(SIGTERM);
  EXPECT_EQ(program->wait_for_end(), static_cast<int>(ExitCode::interrupted));
}

// The program turns motors off that nobody guards, and starts another guard.
TEST_F(WaysOutWithAGuardTest, TheGuardIsKilled) {
  ASSERT_NO_FATAL_FAILURE(start("wait"));
  const pid_t first = some_guard();
  ASSERT_GT(first, 0);
  kill(first, SIGKILL);
  ASSERT_NO_FATAL_FAILURE(wait_for_zero());
  const std::int64_t deadline_ns = now_ns() + patience / std::chrono::nanoseconds(1);
  pid_t next = 0;
  while ((next = guard()) == first || next == 0) {
    ASSERT_LT(now_ns(), deadline_ns);
    std::this_thread::sleep_for(milliseconds(1));
  }
}

TEST_F(WaysOutWithAGuardTest, TheGuardEndsWithItsProgram) {
  ASSERT_NO_FATAL_FAILURE(start("wait"));
  const pid_t first = some_guard();
  ASSERT_GT(first, 0);
  program->send(SIGTERM);
  EXPECT_EQ(program->wait_for_end(), static_cast<int>(ExitCode::interrupted));
  EXPECT_NE(kill(first, 0), 0);
}

// As `cmake --install` puts the two.
TEST_F(WaysOutWithAGuardTest, TheGuardIsFoundWhereItIsInstalled) {
  const std::filesystem::path prefix = folder.path();
  const std::filesystem::path built = std::filesystem::path(ARMED_PROGRAM).parent_path();
  std::filesystem::create_directories(prefix / "bin");
  std::filesystem::create_directories(prefix / "libexec/ghostforce");
  std::filesystem::copy_file(ARMED_PROGRAM, prefix / "bin/armed_program");
  std::filesystem::copy_file(built / "ghostforce-guard", prefix / "libexec/ghostforce/ghostforce-guard");
  armed_program = prefix / "bin/armed_program";
  ASSERT_NO_FATAL_FAILURE(start("wait"));
  ASSERT_NO_FATAL_FAILURE(send(SIGKILL));
  EXPECT_EQ(program->wait_for_end(), 128 + SIGKILL);
  wait_for_zero();
}

// As one may on a machine that is busy with other things.
TEST_F(WaysOutWithAGuardTest, TheGuardThatDoesNotStartIsStartedAgain) {
  const std::filesystem::path own = folder.path();
  const std::filesystem::path built = std::filesystem::path(ARMED_PROGRAM).parent_path();
  std::filesystem::copy_file(ARMED_PROGRAM, own / "armed_program");
  std::ofstream(own / "ghostforce-guard")
      << fmt::format("#!/bin/sh\nif mkdir {0}; then exit 1; fi\nexec {1} \"$@\"\n", (own / "has-failed").string(),
                     (built / "ghostforce-guard").string());
  std::filesystem::permissions(own / "ghostforce-guard", std::filesystem::perms::owner_all);
  armed_program = own / "armed_program";
  ASSERT_NO_FATAL_FAILURE(start("wait"));
  EXPECT_TRUE(std::filesystem::exists(own / "has-failed"));
}

// There is none beside this copy of the program.
TEST_F(WaysOutWithAGuardTest, WithoutAGuardTheMotorsStayOff) {
  const std::filesystem::path alone = std::filesystem::path(folder.path()) / "armed_program";
  std::filesystem::copy_file(ARMED_PROGRAM, alone);
  ProgramCall call;
  call.words = {"wait", ""};
  program = std::make_unique<RunningProgram>(alone, call);
  // It has tried to arm them, as long as it usually takes and longer, and tries once more.
  for (;;) {
    const auto line = program->next_line();
    ASSERT_TRUE(line);
    ASSERT_NE(*line, "pushing");
    lead_hand(chip, *line);
    if (*line == "aside") break;
  }
  const std::uint64_t frames = chip.told().frames;
  const std::int64_t deadline_ns = now_ns() + patience / std::chrono::nanoseconds(1);
  while (chip.told().frames < frames + 500 && now_ns() < deadline_ns) std::this_thread::sleep_for(milliseconds(1));
  EXPECT_GE(chip.told().frames, frames + 500) << "the device is in use";
  EXPECT_TRUE(chip.told().is_homed);
  EXPECT_EQ(chip.told().last_force_ns, 0);
}

}  // namespace
}  // namespace ghostforce::ways_out_test
