// A program that holds an armed Haply dies, or cannot go on, while its motors push: no published firmware would turn
// them off. Both duties become zero and stay so, the board hears nothing but whole packets, and its next driver finds
// it well. How soon is no test's business on a machine that does other things as well: with
// GHOSTFORCE_PRINT_HAPLY_FAULTS in the environment each tells it as a row of a table, in ms by the clock of the board,
// and beside it how much of that may be the board's own being late.
#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cctype>
#include <cerrno>
#include <ostream>
#include <string>

#include "tests/device/haply_serial/dying_haply.h"
#include "tests/emulation/held_program.h"

namespace ghostforce::dying_haply_test {
namespace {

constexpr int interrupted = static_cast<int>(ExitCode::interrupted);

std::string without_spaces(std::string name) {
  std::erase_if(name, [](char c) { return c != '_' && std::isalnum(static_cast<unsigned char>(c)) == 0; });
  return name;
}

// --- By a signal -----------------------------------------------------------------------------------------------------

struct Signal {
  const char* title;
  int number;
  const char* way;
  int exit_code;

  friend void PrintTo(const Signal& signal, std::ostream* out) { *out << signal.title; }
};

class BySignal : public DyingHaplyTest, public testing::WithParamInterface<Signal> {};

TEST_P(BySignal, MotorsGoOff) {
  title = GetParam().title;
  ASSERT_NO_FATAL_FAILURE(start(GetParam().way));
  ASSERT_NO_FATAL_FAILURE(send(GetParam().number));
  EXPECT_EQ(program->wait_for_end(), GetParam().exit_code);
  expect_well();
}

INSTANTIATE_TEST_SUITE_P(, BySignal,
                         testing::Values(Signal{"SIGKILL", SIGKILL, "wait", 128 + SIGKILL},
                                         Signal{"SIGTERM", SIGTERM, "wait", interrupted},
                                         Signal{"SIGINT", SIGINT, "wait", interrupted},
                                         Signal{"SIGHUP", SIGHUP, "wait", interrupted},
                                         Signal{"SIGQUIT", SIGQUIT, "wait", 128 + SIGQUIT},
                                         Signal{"SIGQUIT while it hangs", SIGQUIT, "hang", 128 + SIGQUIT},
                                         Signal{"SIGTRAP, a breakpoint", SIGTRAP, "wait", 128 + SIGTRAP}),
                         [](const auto& run) { return without_spaces(run.param.title); });

class DyingHaply : public DyingHaplyTest {};

// Zeros do not reach it, and nobody waits until the program has noticed.
TEST_F(DyingHaply, IsToldToEndWhereTheBoardWasSetUpForAnotherAddress) {
  title = "SIGTERM, board set up by another program";
  has_noted = true;
  ASSERT_NO_FATAL_FAILURE(start("wait"));
  ASSERT_TRUE(becomes([&] { return board.heard().has_duty(); }));
  InjectedHaplyFault wrong;
  wrong.is_another_programs = true;
  board.inject(wrong);
  program->send(SIGTERM);
  EXPECT_EQ(program->wait_for_end(), interrupted);
  expect_port_is_free();
  expect_zero();
  expect_it_stays();
}

// The program's, and not that of this test. The guard is in none of its groups.
TEST_F(DyingHaply, TheWholeProcessGroupIsKilled) {
  title = "process group killed";
  ASSERT_NO_FATAL_FAILURE(start("wait in a group of its own"));
  ASSERT_TRUE(becomes([&] { return board.heard().has_duty(); }));
  ASSERT_EQ(getpgid(program->pid()), program->pid());
  event_ns = monotonic_ns();
  kill(-program->pid(), SIGKILL);
  EXPECT_EQ(program->wait_for_end(), 128 + SIGKILL);
  expect_well();
}

TEST_F(DyingHaply, ATerminalCannotSuspendIt) {
  title = "SIGTSTP, SIGTTIN, SIGTTOU";
  ASSERT_NO_FATAL_FAILURE(start("wait"));
  for (const int signal : {SIGTSTP, SIGTTIN, SIGTTOU}) program->send(signal);
  const std::uint64_t forces = board.heard().packets.forces;
  EXPECT_TRUE(becomes([&] { return board.heard().packets.forces > forces + 200; }));
  ASSERT_NO_FATAL_FAILURE(send(SIGTERM));
  EXPECT_EQ(program->wait_for_end(), interrupted);
  has_noted = true;
  expect_well();
}

// --- By itself -------------------------------------------------------------------------------------------------------

struct WayOut {
  const char* way;
  const char* detail;
  int exit_code;

  friend void PrintTo(const WayOut& out, std::ostream* text) { *text << out.way << ' ' << out.detail; }
};

class ByItself : public DyingHaplyTest, public testing::WithParamInterface<WayOut> {};

TEST_P(ByItself, MotorsGoOff) {
  title = fmt::format("{}{}{}", GetParam().way, *GetParam().detail == '\0' ? "" : ", number ", GetParam().detail);
  ASSERT_NO_FATAL_FAILURE(start(GetParam().way, GetParam().detail));
  EXPECT_EQ(program->wait_for_end(), GetParam().exit_code);
  EXPECT_GT(board.heard().packets.forces, 0U);
  expect_well();
}

INSTANTIATE_TEST_SUITE_P(, ByItself,
                         testing::Values(WayOut{"return", "", 0}, WayOut{"abort", "", 128 + SIGABRT},
                                         WayOut{"null pointer", "", 128 + SIGSEGV},
                                         WayOut{"stack overflow", "", 128 + SIGSEGV},
                                         WayOut{"exception", "", 128 + SIGABRT},  // std::terminate
                                         WayOut{"exit", "", 0}, WayOut{"exit on another thread", "", 0},
                                         WayOut{"_exit", "", 0}, WayOut{"_exit on the servo's thread", "", 0},
                                         WayOut{"null pointer on the servo's thread", "", 128 + SIGSEGV},
                                         WayOut{"stack overflow on the servo's thread", "", 128 + SIGSEGV},
                                         WayOut{"signal on the servo's thread", "6", 128 + SIGABRT},
                                         WayOut{"signal on the servo's thread", "24", 128 + SIGXCPU}),
                         [](const auto& run) { return without_spaces(std::string(run.param.way) + run.param.detail); });

// --- It stays, and does not go on ------------------------------------------------------------------------------------

class HangsHaply : public DyingHaplyTest, public testing::WithParamInterface<const char*> {};

TEST_P(HangsHaply, MotorsGoOffAndThePortIsFreeOnceItIsKilled) {
  title = GetParam();
  ASSERT_NO_FATAL_FAILURE(start(GetParam()));
  expect_zero();
  expect_it_stays();
  program->send(SIGKILL);
  EXPECT_EQ(program->wait_for_end(), 128 + SIGKILL);
  expect_well();
}

INSTANTIATE_TEST_SUITE_P(, HangsHaply,
                         testing::Values("endless loop on the servo's thread", "block on the servo's thread", "hang"),
                         [](const auto& run) { return without_spaces(run.param); });

// No thread of it runs; when all of them run again, what they were about to send must not push.
class HeldHaplyProgram : public DyingHaplyTest, public testing::WithParamInterface<ProcessHold> {};

TEST_P(HeldHaplyProgram, MotorsGoOffAndStayOffWhenItGoesOn) {
  title = GetParam() == ProcessHold::stopped ? "SIGSTOP, then SIGCONT" : "a debugger's stop";
  ASSERT_NO_FATAL_FAILURE(start("wait"));
  ASSERT_TRUE(becomes([&] { return board.heard().has_duty(); }));
  std::uint64_t forces = 0;
  {
    event_ns = monotonic_ns();
    const HeldProgram held(program->pid(), GetParam(), {});
    expect_zero();
    expect_it_stays();
    forces = board.heard().packets.forces;
  }
  // It takes the board again, and waits for a person.
  const std::uint64_t exchanges = board.heard().packets.exchanges;
  EXPECT_TRUE(becomes([&] { return board.heard().packets.exchanges > exchanges + 500; }));
  expect_it_stays();
  // One that it was just about to write may have come; the guard has ended that at once.
  EXPECT_LE(board.heard().packets.forces, forces + 1);
  program->send(SIGTERM);
  EXPECT_EQ(program->wait_for_end(), interrupted);
  expect_well();
}

INSTANTIATE_TEST_SUITE_P(, HeldHaplyProgram, testing::Values(ProcessHold::stopped, ProcessHold::debugged),
                         [](const auto& run) { return run.param == ProcessHold::stopped ? "Stopped" : "Debugged"; });

// It hears of that when it goes on: its handler comes before any of its threads.
TEST_F(DyingHaply, IsStoppedAndToldToEnd) {
  title = "SIGSTOP, SIGTERM, then SIGCONT";
  ASSERT_NO_FATAL_FAILURE(start("wait"));
  ASSERT_NO_FATAL_FAILURE(send(SIGSTOP));
  program->send(SIGTERM);
  expect_zero();
  const std::uint64_t forces = board.heard().packets.forces;
  program->send(SIGCONT);
  EXPECT_EQ(program->wait_for_end(), interrupted);
  EXPECT_LE(board.heard().packets.forces, forces + 1);
  expect_well();
}

// The first has its main thread wait for the servo's, which never comes.
TEST_F(DyingHaply, IsInterruptedTwiceBecauseItHangs) {
  title = "SIGTERM while the servo's thread is blocked";
  ASSERT_NO_FATAL_FAILURE(start("block on the servo's thread"));
  program->send(SIGTERM);
  has_noted = true;
  expect_zero();
  expect_it_stays();
  EXPECT_FALSE(program->has_ended());
  program->send(SIGTERM);
  EXPECT_EQ(program->wait_for_end(), 128 + SIGTERM);
  expect_well();
}

// Another program has its number now. Nothing of the port may stay with it.
TEST_F(DyingHaply, BecomesAnotherProgram) {
  title = "execve of another program";
  ASSERT_NO_FATAL_FAILURE(start("another program"));
  expect_zero();
  expect_port_is_free();
  expect_it_stays();
  expect_next_driver_is_owed_nothing();
  EXPECT_FALSE(program->has_ended());
  program->send(SIGKILL);
  EXPECT_EQ(program->wait_for_end(), 128 + SIGKILL);
  expect_well();
}

// A child of it has every file that it had. The guard does its work all the same.
TEST_F(DyingHaply, IsKilledAndLeavesAChildWithItsFiles) {
  title = "SIGKILL, a child has its files";
  ASSERT_NO_FATAL_FAILURE(start("child left"));
  const auto line = program->next_line();
  ASSERT_TRUE(line && line->starts_with("child "));
  const pid_t child = std::stoi(line->substr(6));
  ASSERT_NO_FATAL_FAILURE(send(SIGKILL));
  EXPECT_EQ(program->wait_for_end(), 128 + SIGKILL);
  expect_zero();
  expect_it_stays();
  kill(child, SIGKILL);
  expect_well();
}

// --- Its port is taken from it ---------------------------------------------------------------------------------------

class LosesPort : public DyingHaplyTest, public testing::WithParamInterface<const char*> {};

TEST_P(LosesPort, MotorsGoOffAndStayOff) {
  title = GetParam();
  ASSERT_NO_FATAL_FAILURE(start(GetParam()));
  expect_zero();
  const std::uint64_t forces = board.heard().packets.forces;
  const std::uint64_t exchanges = board.heard().packets.exchanges;
  // It takes the port again, and waits for a person.
  EXPECT_TRUE(becomes([&] { return board.heard().packets.exchanges > exchanges + 500; }));
  EXPECT_EQ(board.heard().packets.forces, forces);
  expect_it_stays();
  program->send(SIGTERM);
  EXPECT_EQ(program->wait_for_end(), interrupted);
  expect_well();
}

INSTANTIATE_TEST_SUITE_P(, LosesPort,
                         testing::Values("port closed", "port closed, its number taken", "all files closed"),
                         [](const auto& run) { return without_spaces(run.param); });

// --- The guard goes first --------------------------------------------------------------------------------------------

class LosesGuard : public DyingHaplyTest, public testing::WithParamInterface<int> {};

// Motors that nobody guards go off; there is another guard before they may come on again.
TEST_P(LosesGuard, MotorsGoOffAndStayOff) {
  title = GetParam() == SIGKILL ? "the guard is killed" : "the guard is stopped";
  ASSERT_NO_FATAL_FAILURE(start("wait"));
  const pid_t first = guard();
  ASSERT_GT(first, 0);
  ASSERT_TRUE(becomes([&] { return board.heard().has_duty(); }));
  event_ns = monotonic_ns();
  kill(first, GetParam());
  ASSERT_TRUE(becomes([&] { return guard() != first && guard() != 0; }));
  expect_zero();
  const std::uint64_t forces = board.heard().packets.forces;
  expect_it_stays();
  program->send(SIGKILL);
  EXPECT_EQ(program->wait_for_end(), 128 + SIGKILL);
  expect_it_stays();
  EXPECT_EQ(board.heard().packets.forces, forces);
  expect_well();
}

INSTANTIATE_TEST_SUITE_P(, LosesGuard, testing::Values(SIGKILL, SIGSTOP),
                         [](const auto& run) { return run.param == SIGKILL ? "Killed" : "Stopped"; });

// Nobody is left who could do anything. The first packet of whoever comes next does.
TEST_F(DyingHaply, IsKilledTogetherWithItsGuard) {
  title = "program and guard killed, to the next start";
  ASSERT_NO_FATAL_FAILURE(start("wait"));
  const pid_t its_guard = guard();
  ASSERT_GT(its_guard, 0);
  ASSERT_NO_FATAL_FAILURE(send(SIGSTOP));  // neither sees the other go
  kill(its_guard, SIGKILL);
  program->send(SIGKILL);
  EXPECT_EQ(program->wait_for_end(), 128 + SIGKILL);
  expect_port_is_free();
  expect_next_driver_is_owed_nothing();
  expect_it_stays();
  expect_whole_packets();
}

// --- The port afterwards ---------------------------------------------------------------------------------------------

// A pseudo terminal outlives those who have it open, and so does what they have asked of it.
TEST_F(DyingHaply, LeavesThePortToPeopleWhoAreNotRoot) {
  title = "SIGKILL";
  has_noted = true;
  ASSERT_NO_FATAL_FAILURE(start("wait"));
  ASSERT_NO_FATAL_FAILURE(send(SIGKILL));
  EXPECT_EQ(program->wait_for_end(), 128 + SIGKILL);
  expect_port_is_free();
  ASSERT_EQ(chmod(board.port().c_str(), 0666), 0);
  const auto look = [this] {
    constexpr uid_t nobody = 65534;
    if (geteuid() == 0 && setuid(nobody) != 0) _exit(2);
    _exit(open(board.port().c_str(), O_RDWR | O_NOCTTY) >= 0 ? 0 : errno);
  };
  EXPECT_EXIT(look(), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace ghostforce::dying_haply_test
