// A port over a pseudo terminal: what goes through it, and what it leaves behind.
#include "device/haply_serial/tty_port.h"

#include <signal.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <numeric>
#include <string>

#include <gtest/gtest.h>

#include "device/haply/hapi.h"
#include "device/motors/emergency_stop.h"
#include "tests/device/haply_serial/mock_system.h"
#include "tests/device/haply_serial/pseudo_terminal.h"
#include "tests/support/small_files.h"

namespace ghostforce::tty_port_test {
namespace {

constexpr std::int64_t never_ns = 1'000'000'000'000'000'000;

TtyPortOptions unguarded(const std::string& path) {
  return {.path = path, .is_guarded = false};
}

Bytes push() {
  return bytes_of(hapi::exchange({0.02, -0.05}));
}

Bytes stop() {
  return bytes_of(hapi::zero_exchange());
}

Bytes stops(std::size_t count) {
  Bytes all;
  for (std::size_t i = 0; i < count; ++i) {
    const Bytes one = stop();
    all.insert(all.end(), one.begin(), one.end());
  }
  return all;
}

// What a guard sends, and a port that closes while motors may push: zeros, and among them a set up, which ends the force
// of a board that has forgotten its address.
bool is_stopping(const Bytes& bytes, std::size_t least_stops) {
  const Bytes set_up = bytes_of(hapi::encode({.counts_per_turn = {4880.0F, 4880.0F}}));
  const auto found = std::ranges::search(bytes, set_up);
  if (found.empty()) return false;
  Bytes rest(bytes.begin(), found.begin());
  rest.insert(rest.end(), found.end(), bytes.end());
  const std::size_t count = rest.size() / stop().size();
  return count >= least_stops && rest == stops(count);
}

Bytes every_byte() {
  Bytes bytes(256);
  std::iota(bytes.begin(), bytes.end(), std::uint8_t{0});
  return bytes;
}

Bytes read_of(TtyPort& port, std::size_t count) {
  Bytes all;
  while (all.size() < count && port.fault() == LinkFault::none) {
    port.wait_until(never_ns);
    Bytes some(64);
    some.resize(port.read(some));
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

// --- Opening ---

TEST(TtyPort, MakesOfATerminalAWire) {
  const PseudoTerminal terminal;
  TtyPort port(unguarded(terminal.path()));
  EXPECT_EQ(port.fault(), LinkFault::absent);
  EXPECT_TRUE(port.waits_to_open());
  ASSERT_EQ(port.open(), LinkFault::none);
  termios line{};
  ASSERT_EQ(tcgetattr(terminal.far_end(), &line), 0);
  EXPECT_EQ(line.c_lflag & (ICANON | ECHO | ISIG | IEXTEN), 0U);
  EXPECT_EQ(line.c_oflag & OPOST, 0U);
  EXPECT_EQ(line.c_iflag & (IXON | IXOFF | IXANY | ICRNL | INLCR | IGNCR | ISTRIP | PARMRK | BRKINT), 0U);
  EXPECT_EQ(line.c_cflag & (CSIZE | PARENB | CSTOPB | CRTSCTS | HUPCL), tcflag_t{CS8});
  EXPECT_EQ(line.c_cflag & (CLOCAL | CREAD), tcflag_t{CLOCAL | CREAD});
  EXPECT_EQ(cfgetispeed(&line), speed_t{B115200});
  EXPECT_EQ(cfgetospeed(&line), speed_t{B115200});
}

TEST(TtyPort, FollowsLinksAndIsKnownByTheNameThatItWasGiven) {
  const PseudoTerminal terminal;
  const TemporaryFolder folder;
  std::filesystem::create_symlink(terminal.path(), folder / "board");
  TtyPort port(unguarded(folder / "board"));
  EXPECT_EQ(port.serial(), "");
  ASSERT_EQ(port.open(), LinkFault::none);
  // A board without a number that is plugged in again may get another terminal, which the link leads to.
  EXPECT_EQ(port.serial(), folder / "board");
  port.close();
  EXPECT_EQ(port.serial(), folder / "board");
}

TEST(TtyPort, IsKnownByTheSerialNumberOfItsUsbDevice) {
  const PseudoTerminal terminal;
  const MockSystem system;
  system.add("ttyACM0", {"1234", "5678", "ABC"}, terminal.path());
  for (const std::string& path : {system.node("ttyACM0"), system.add_by_id("usb-a-board", "ttyACM0")}) {
    TtyPort port({.path = path, .is_guarded = false, .places = system.places()});
    ASSERT_EQ(port.open(), LinkFault::none);
    EXPECT_EQ(port.serial(), "ABC");
  }
}

TEST(TtyPort, ForgetsWhatCameInBeforeItWasOpened) {
  const PseudoTerminal terminal;
  const int other = open(terminal.path().c_str(), O_RDWR | O_NOCTTY);  // keeps the near end there
  terminal.send(every_byte());
  TtyPort port(unguarded(terminal.path()));
  ASSERT_EQ(port.open(), LinkFault::none);
  terminal.send(stop());
  EXPECT_EQ(read_of(port, stop().size()), stop());
  close(other);
}

TEST(TtyPort, TakesTheOnlyBoardThatThereIs) {
  const PseudoTerminal board;
  const PseudoTerminal other;
  const MockSystem system;
  system.add("ttyACM0", {"1234", "5678", "OTHER"}, other.path());
  system.add("ttyACM1", {"2341", "804d", "BOARD"}, board.path());
  TtyPort port({.is_guarded = false, .places = system.places()});
  ASSERT_EQ(port.open(), LinkFault::none);
  EXPECT_EQ(port.serial(), "BOARD");
}

TEST(TtyPort, ChoosesNoneOfSeveralBoards) {
  const PseudoTerminal one;
  const PseudoTerminal two;
  const MockSystem system;
  TtyPort port({.is_guarded = false, .places = system.places()});
  EXPECT_EQ(port.open(), LinkFault::absent);
  system.add("ttyACM0", {"2341", "804d", "ONE"}, one.path());
  system.add("ttyACM1", {"2341", "003e", "TWO"}, two.path());
  EXPECT_EQ(port.open(), LinkFault::absent);
}

// A board that is plugged in beside it changes nothing.
TEST(TtyPort, GoesOnWithTheBoardThatWasInUse) {
  const PseudoTerminal one;
  const PseudoTerminal two;
  const MockSystem system;
  TtyPort port({.is_guarded = false, .places = system.places()});
  system.add("ttyACM1", {"2341", "003e", "TWO"}, two.path());
  ASSERT_EQ(port.open(), LinkFault::none);
  system.add("ttyACM0", {"2341", "804d", "ONE"}, one.path());
  ASSERT_EQ(port.open(), LinkFault::none);
  EXPECT_EQ(port.serial(), "TWO");
  // That one is opened only for what it is owed.
  StopDebts owed;
  owed.add(device_serial_of("ONE"));
  ASSERT_EQ(port.open_first(owed), LinkFault::none);
  EXPECT_EQ(port.serial(), "ONE");
  ASSERT_EQ(port.open(), LinkFault::none);
  EXPECT_EQ(port.serial(), "TWO");
}

// --- Debts ---

struct TwoPluggedIn {
  PseudoTerminal one;
  PseudoTerminal two;
  MockSystem system;

  TwoPluggedIn() {
    system.add("ttyACM0", {"2341", "804d", "ONE"}, one.path());
    system.add("ttyACM1", {"2341", "003e", "TWO"}, two.path());
  }
};

TEST(TtyPort, ABoardThatIsOwedAStopComesFirst) {
  const TwoPluggedIn boards;
  const auto& [one, two, system] = boards;
  StopDebts owed;
  owed.add(device_serial_of("GONE"));
  TtyPort any({.is_guarded = false, .places = system.places()});
  EXPECT_FALSE(any.is_any_plugged_in(owed));
  owed.add(device_serial_of("TWO"));
  EXPECT_TRUE(any.is_any_plugged_in(owed));
  ASSERT_EQ(any.open_first(owed), LinkFault::none);
  EXPECT_EQ(any.serial(), "TWO");
  any.close();
  EXPECT_TRUE(is_stopping(two.receive_all(), 2));  // it may have been pushing all the time

  TtyPort chosen({.path = system.node("ttyACM0"), .is_guarded = false, .places = system.places()});
  ASSERT_EQ(chosen.open_first(owed), LinkFault::none);
  EXPECT_EQ(chosen.serial(), "TWO");
  ASSERT_EQ(chosen.open(), LinkFault::none);
  EXPECT_EQ(chosen.serial(), "ONE");
}

TEST(TtyPort, ABoardThatIsOwedAStopAndCannotBeHadKeepsNoOtherFromIt) {
  const TwoPluggedIn boards;
  const auto& [one, two, system] = boards;
  StopDebts owed;
  owed.add(device_serial_of("ONE"));
  TtyPort other({.path = one.path(), .is_guarded = false});
  ASSERT_EQ(other.open(), LinkFault::none);
  TtyPort port({.is_guarded = false, .places = system.places()});
  EXPECT_EQ(port.open_first(owed), LinkFault::busy) << "one that is owed nothing is not used";
  owed.add(device_serial_of("TWO"));
  ASSERT_EQ(port.open_first(owed), LinkFault::none);
  EXPECT_EQ(port.serial(), "TWO");
}

// Many boards have no serial number, and what is plugged in where one was gets its path.
TEST(TtyPort, ABoardWithoutANumberIsKnownByItsMakeAndItsSocket) {
  const PseudoTerminal terminal;
  const auto identity = [&](const std::string& name, const MockUsbDevice& device) {
    const MockSystem system;
    system.add(name, device, terminal.path());
    TtyPort port({.path = system.node(name), .is_guarded = false, .places = system.places()});
    EXPECT_EQ(port.open(), LinkFault::none);
    return std::string(port.serial());
  };
  const std::string board = identity("ttyACM0", {"2341", "003e"});
  EXPECT_EQ(board, "2341:003e in socket 1-ttyACM0");
  StopDebts owed;
  owed.add(device_serial_of(board));
  const auto is_owed = [&](const std::string& name, const MockUsbDevice& device) {
    const MockSystem system;
    system.add(name, device, terminal.path());
    TtyPort port({.is_guarded = false, .places = system.places()});
    const bool is_there = port.is_any_plugged_in(owed);
    EXPECT_EQ(port.open_first(owed) == LinkFault::none && port.serial() == board, is_there);
    return is_there;
  };
  EXPECT_TRUE(is_owed("ttyACM0", {"2341", "003e"}));
  EXPECT_FALSE(is_owed("ttyACM0", {"0403", "6001"})) << "a modem gets no zeros";
  EXPECT_FALSE(is_owed("ttyACM1", {"2341", "003e"})) << "another such board does not pay for it";
  EXPECT_FALSE(is_owed("ttyACM0", {"2341", "003e", "ABC"}));
}

TEST(TtyPort, KnowsADebtByThePathToo) {
  const PseudoTerminal terminal;
  StopDebts owed;
  owed.add(device_serial_of(terminal.path()));
  const TtyPort port(unguarded(terminal.path()));
  EXPECT_TRUE(port.is_any_plugged_in(owed));
  EXPECT_FALSE(port.is_any_plugged_in({}));
}

// --- Bytes ---

TEST(TtyPort, PassesEveryByteBothWays) {
  const PseudoTerminal terminal;
  TtyPort port(unguarded(terminal.path()));
  ASSERT_EQ(port.open(), LinkFault::none);
  const Bytes bytes = every_byte();
  for (std::size_t first = 0; first < bytes.size(); first += 64) {
    ASSERT_TRUE(port.write(std::span(bytes).subspan(first, 64)));
  }
  EXPECT_EQ(terminal.receive(bytes.size()), bytes);
  terminal.send(bytes);
  EXPECT_EQ(read_of(port, bytes.size()), bytes);
  EXPECT_EQ(port.fault(), LinkFault::none);
}

TEST(TtyPort, SendsAPacketInOnePiece) {
  const PseudoTerminal terminal;
  TtyPort port(unguarded(terminal.path()));
  ASSERT_EQ(port.open(), LinkFault::none);
  for (const Bytes& packet : {push(), bytes_of(hapi::encode(hapi::SetUp{}))}) {
    ASSERT_TRUE(port.write(packet));
    EXPECT_EQ(terminal.receive(), packet);
  }
}

TEST(TtyPort, SendsNothingThatIsNoPacket) {
  const PseudoTerminal terminal;
  TtyPort port(unguarded(terminal.path()));
  EXPECT_FALSE(port.write(push()));
  ASSERT_EQ(port.open(), LinkFault::none);
  EXPECT_FALSE(port.write({}));
  EXPECT_FALSE(port.write(Bytes(65)));
  port.close();
  EXPECT_FALSE(port.write(push()));
  EXPECT_EQ(terminal.receive_all(), Bytes{});
}

TEST(TtyPort, ReadsNothingWhereNothingIs) {
  const PseudoTerminal terminal;
  TtyPort port(unguarded(terminal.path()));
  Bytes into(9);
  EXPECT_EQ(port.read(into), 0U);
  ASSERT_EQ(port.open(), LinkFault::none);
  EXPECT_EQ(port.read(into), 0U);
  port.wait_until(port.now_ns() - 1);
  EXPECT_EQ(port.fault(), LinkFault::none);
}

TEST(TtyPort, ForgetsInputThatIsNotTaken) {
  const PseudoTerminal terminal;
  TtyPort port(unguarded(terminal.path()));
  ASSERT_EQ(port.open(), LinkFault::none);
  terminal.send(every_byte());
  port.wait_until(never_ns);
  port.discard_input();
  terminal.send(stop());
  EXPECT_EQ(read_of(port, stop().size()), stop());
}

// --- Stops ---

TEST(TtyPort, ClosesWithZerosWhereMotorsMayPush) {
  const PseudoTerminal terminal;
  TtyPort port(unguarded(terminal.path()));
  ASSERT_EQ(port.open(), LinkFault::none);
  port.set_may_push(true);
  port.close();
  EXPECT_TRUE(is_stopping(terminal.receive_all(), 2));
}

// The published firmwares allocate at each set up and free nothing.
TEST(TtyPort, SetsABoardUpInVainOnce) {
  const PseudoTerminal terminal;
  TtyPort port(unguarded(terminal.path()));
  StopDebts owed;
  owed.add(device_serial_of(terminal.path()));
  const auto close_and_hear = [&] {
    EXPECT_EQ(port.open_first(owed), LinkFault::none);
    port.set_may_push(true);
    port.close();
    return terminal.receive_all();
  };
  EXPECT_TRUE(is_stopping(close_and_hear(), 2));
  EXPECT_EQ(close_and_hear(), stops(2));
  ASSERT_EQ(port.open_first(owed), LinkFault::none);
  port.set_may_push(false);
  port.close();
  EXPECT_TRUE(is_stopping(close_and_hear(), 2)) << "it had answered";
}

TEST(TtyPort, ClosesWithoutAWordWhereMotorsAreOff) {
  const PseudoTerminal terminal;
  TtyPort port(unguarded(terminal.path()));
  ASSERT_EQ(port.open(), LinkFault::none);
  port.set_may_push(true);
  port.set_may_push(false);
  port.close();
  ASSERT_EQ(port.open(), LinkFault::none);
  port.close();
  EXPECT_EQ(terminal.receive_all(), Bytes{});
}

TEST(TtyPort, StopsAtOnce) {
  const PseudoTerminal terminal;
  TtyPort port(unguarded(terminal.path()));
  port.stop_at_once();
  ASSERT_EQ(port.open(), LinkFault::none);
  errno = ERANGE;
  port.stop_at_once();
  EXPECT_EQ(errno, ERANGE);
  port.write_at_once(push());
  Bytes expected = stop();
  const Bytes second = push();
  expected.insert(expected.end(), second.begin(), second.end());
  EXPECT_EQ(terminal.receive(expected.size()), expected);
  port.close();
  port.stop_at_once();
  EXPECT_EQ(terminal.receive_all(), Bytes{});
}

// In a process of its own, since it cannot be taken back.
TEST(TtyPort, SendsNothingThatPushesAfterTheEmergencyStop) {
  const PseudoTerminal terminal;
  const auto stop_and_go_on = [&terminal] {
    TtyPort port(unguarded(terminal.path()));
    if (port.open() != LinkFault::none) _exit(1);
    emergency_stop::watch(&port);
    emergency_stop::stop_motors();
    if (port.write(push())) _exit(2);
    // A board that has forgotten its address takes no zeros.
    const bool is_set_up = port.write(bytes_of(hapi::encode({.counts_per_turn = {4880.0F, 4880.0F}})));
    _exit(is_set_up && port.write(stop()) ? 0 : 3);
  };
  EXPECT_EXIT(stop_and_go_on(), testing::ExitedWithCode(0), "");
  EXPECT_TRUE(is_stopping(terminal.receive_all(), 2));
}

// --- The guard ---

// A guard that a busy machine does not let begin in time is done without; another attempt has another one.
bool open_with_guard(TtyPort& port) {
  for (int attempt = 0; attempt < 20; ++attempt) {
    if (port.open() != LinkFault::none) return false;
    if (port.is_guarded()) return true;
    port.close();
  }
  return false;
}

TEST(TtyPort, HasAGuard) {
  const PseudoTerminal terminal;
  TtyPort port({.path = terminal.path()});
  EXPECT_FALSE(port.is_guarded());
  ASSERT_TRUE(open_with_guard(port));
  EXPECT_TRUE(port.write(stop()));
  EXPECT_EQ(terminal.receive(), stop());
  port.close();
  EXPECT_FALSE(port.is_guarded());
  EXPECT_EQ(terminal.receive_all(), Bytes{});  // it has let go of the port as well
  EXPECT_EQ(port.open(), LinkFault::none);
  EXPECT_TRUE(TtyPort(unguarded(terminal.path())).is_guarded());  // needs none
}

// It has told once that it lives, and then stands still until the guard has acted.
TEST(TtyPort, TheGuardOverrulesAProgramThatStandsStill) {
  const PseudoTerminal terminal;
  TtyPort port({.path = terminal.path()});
  ASSERT_TRUE(open_with_guard(port));
  port.set_may_push(true);
  EXPECT_TRUE(is_stopping(terminal.receive(stops(10).size() + hapi::SetUpPacket{}.size()), 10));
  EXPECT_FALSE(port.write(push()));
  EXPECT_EQ(port.fault(), LinkFault::overruled);
  EXPECT_FALSE(port.is_guarded());
  EXPECT_TRUE(port.write(stop()));
  port.close();
  EXPECT_TRUE(is_stopping(terminal.receive_all(), 1));
  EXPECT_TRUE(open_with_guard(port));
}

TEST(TtyPort, AGuardThatIsGoneIsNoticedAtOnce) {
  const PseudoTerminal terminal;
  TtyPort port({.path = terminal.path()});
  ASSERT_TRUE(open_with_guard(port));
  siginfo_t ended{};
  const std::string children = read_whole("/proc/self/task/" + std::to_string(gettid()) + "/children");
  const pid_t guard = std::stoi(children);
  kill(guard, SIGKILL);
  ASSERT_EQ(waitid(P_PID, static_cast<id_t>(guard), &ended, WEXITED | WNOWAIT), 0);
  port.wait_until(port.now_ns());  // looks
  EXPECT_FALSE(port.is_guarded());
  EXPECT_FALSE(port.write(push()));
  EXPECT_EQ(port.fault(), LinkFault::unguarded);
}

TEST(TtyPort, TheGuardStopsMotorsOfAProgramThatWasKilled) {
  const PseudoTerminal terminal;
  const pid_t program = fork();
  if (program == 0) {
    TtyPort port({.path = terminal.path()});
    if (!open_with_guard(port)) _exit(1);
    port.set_may_push(true);
    port.write(push());
    for (;;) port.wait_until(never_ns);
  }
  EXPECT_EQ(terminal.receive(push().size()), push());
  kill(program, SIGKILL);
  waitpid(program, nullptr, 0);
  const Bytes after = terminal.receive_all();
  EXPECT_TRUE(is_stopping(after, 10));
}

}  // namespace
}  // namespace ghostforce::tty_port_test
