// What is told of a port that cannot be had, is lost, or takes half a packet.
#include <fcntl.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <filesystem>
#include <functional>
#include <string>
#include <system_error>

#include <gtest/gtest.h>

#include "device/haply/hapi.h"
#include "device/haply_serial/tty_port.h"
#include "tests/device/haply_serial/pseudo_terminal.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::tty_port_faults_test {
namespace {

constexpr std::int64_t never_ns = 1'000'000'000'000'000'000;

LinkFault fault_at(const std::string& path) {
  return TtyPort({.path = path, .is_guarded = false}).open();
}

void become_ordinary() {
  constexpr uid_t nobody = 65534;
  if (geteuid() == 0 && setuid(nobody) != 0) _exit(9);
}

// --- Opening ---

TEST(TtyPortFaults, NothingIsThere) {
  const TemporaryFolder folder;
  EXPECT_EQ(fault_at(folder / "ttyACM0"), LinkFault::absent);
  EXPECT_EQ(fault_at(folder / "no/ttyACM0"), LinkFault::absent);
  std::filesystem::create_symlink("gone", folder / "link");
  EXPECT_EQ(fault_at(folder / "link"), LinkFault::absent);
}

TEST(TtyPortFaults, ItIsNoTerminal) {
  const TemporaryFolder folder;
  write_whole(folder / "file", "as it was");
  EXPECT_EQ(fault_at(folder / "file"), LinkFault::unsupported);
  EXPECT_EQ(read_whole(folder / "file"), "as it was");
  EXPECT_EQ(fault_at(folder.path()), LinkFault::unsupported);
  EXPECT_EQ(fault_at("/dev/null"), LinkFault::unsupported);
}

TEST(TtyPortFaults, ThisUserMayNotOpenIt) {
  const PseudoTerminal terminal;
  ASSERT_EQ(chmod(terminal.path().c_str(), 0), 0);
  const auto look = [&terminal] {
    become_ordinary();
    _exit(fault_at(terminal.path()) == LinkFault::not_allowed ? 0 : 1);
  };
  EXPECT_EXIT(look(), testing::ExitedWithCode(0), "");
}

TEST(TtyPortFaults, AnotherProgramHasIt) {
  const PseudoTerminal terminal;
  TtyPort first({.path = terminal.path(), .is_guarded = false});
  ASSERT_EQ(first.open(), LinkFault::none);
  TtyPort second({.path = terminal.path(), .is_guarded = false});
  EXPECT_EQ(second.open(), LinkFault::busy);
  // It has not taken away anything.
  EXPECT_EQ(second.open(), LinkFault::busy);
  first.close();
  EXPECT_EQ(second.open(), LinkFault::none);
}

TEST(TtyPortFaults, TheGuardOfAnotherProgramStillHasIt) {
  const PseudoTerminal terminal;
  TtyPort first({.path = terminal.path()});
  ASSERT_EQ(first.open(), LinkFault::none);
  EXPECT_EQ(fault_at(terminal.path()), LinkFault::busy);
  first.close();
  EXPECT_EQ(fault_at(terminal.path()), LinkFault::none);
}

TEST(TtyPortFaults, LocksOutProgramsThatNeverAskForALock) {
  const PseudoTerminal terminal;
  ASSERT_EQ(chmod(terminal.path().c_str(), 0666), 0);
  const auto look = [&terminal] {
    become_ordinary();
    TtyPort port({.path = terminal.path(), .is_guarded = false});
    if (port.open() != LinkFault::none) _exit(1);
    if (open(terminal.path().c_str(), O_RDWR | O_NOCTTY) >= 0 || errno != EBUSY) _exit(2);
    if (fault_at(terminal.path()) != LinkFault::busy) _exit(3);
    port.close();
    _exit(open(terminal.path().c_str(), O_RDWR | O_NOCTTY) >= 0 ? 0 : 4);
  };
  EXPECT_EXIT(look(), testing::ExitedWithCode(0), "");
}

TEST(TtyPortFaults, LeavesALockAloneThatIsNotItsOwn) {
  const PseudoTerminal terminal;
  const int other = open(terminal.path().c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
  ASSERT_EQ(flock(other, LOCK_EX), 0);
  ASSERT_EQ(ioctl(other, TIOCEXCL), 0);
  // Root may open it all the same, and learns of the lock.
  EXPECT_EQ(fault_at(terminal.path()), LinkFault::busy);
  int is_exclusive = 0;
  EXPECT_EQ(ioctl(other, TIOCGEXCL, &is_exclusive), 0);
  EXPECT_NE(is_exclusive, 0);
  close(other);
}

// --- Losing it ---

// By whatever is asked of it first.
TEST(TtyPortFaults, ItWasUnplugged) {
  const auto notices = [](const std::function<void(TtyPort&)>& ask) {
    const TemporaryFolder folder;
    PseudoTerminal terminal;
    std::filesystem::create_symlink(terminal.path(), folder / "board");  // its own name may be another's at once
    TtyPort port({.path = folder / "board", .is_guarded = false});
    EXPECT_EQ(port.open(), LinkFault::none);
    port.set_may_push(true);
    std::filesystem::remove(folder / "board");
    terminal.hang_up();
    ask(port);
    const LinkFault fault = port.fault();
    Bytes into(9);
    EXPECT_FALSE(port.write(hapi::zero_exchange()));
    EXPECT_EQ(port.read(into), 0U);
    port.wait_until(0);
    port.stop_at_once();
    port.close();
    EXPECT_EQ(port.open(), LinkFault::absent);
    return fault;
  };
  EXPECT_EQ(notices([](TtyPort& port) { port.wait_until(never_ns); }), LinkFault::unplugged);
  EXPECT_EQ(notices([](TtyPort& port) { port.wait_until(0); }), LinkFault::unplugged);
  EXPECT_EQ(notices([](TtyPort& port) { port.discard_input(); }), LinkFault::unplugged);
  EXPECT_EQ(notices([](TtyPort& port) { EXPECT_FALSE(port.write(hapi::zero_exchange())); }), LinkFault::unplugged);
}

TEST(TtyPortFaults, OpensAgainWhatIsBack) {
  const TemporaryFolder folder;
  const std::string link = folder / "board";
  PseudoTerminal first;
  std::filesystem::create_symlink(first.path(), link);
  TtyPort port({.path = link, .is_guarded = false});
  ASSERT_EQ(port.open(), LinkFault::none);
  PseudoTerminal second;
  first.hang_up();
  port.wait_until(never_ns);
  EXPECT_EQ(port.fault(), LinkFault::unplugged);
  std::filesystem::remove(link);
  std::filesystem::create_symlink(second.path(), link);
  ASSERT_EQ(port.open(), LinkFault::none);
  EXPECT_TRUE(port.write(hapi::zero_exchange()));
  EXPECT_EQ(second.receive(), bytes_of(hapi::zero_exchange()));
}

// --- A full port ---

struct Torn {
  bool is_so = false;
  std::size_t whole_packets = 0;
  Bytes received;  // in all
};

// Packets of this size until the port takes no more, then `ask`.
Torn fill(std::size_t size, const std::function<void(TtyPort&)>& ask) {
  const PseudoTerminal terminal;
  TtyPort port({.path = terminal.path(), .is_guarded = false});
  EXPECT_EQ(port.open(), LinkFault::none);
  Torn torn;
  const Bytes packet(size, 0x11);
  while (port.write(packet)) ++torn.whole_packets;
  torn.is_so = port.fault() == LinkFault::broken;
  EXPECT_TRUE(torn.is_so || port.fault() == LinkFault::none);
  ask(port);
  port.close();
  torn.received = terminal.receive_all();
  return torn;
}

// Sizes, of which one at least does not fill it to the last byte.
constexpr std::array<std::size_t, 4> sizes{7, 11, 13, 17};

TEST(TtyPortFaults, NothingFollowsATornPacket) {
  bool was_any_torn = false;
  for (const std::size_t size : sizes) {
    const Torn torn = fill(size, [size](TtyPort& port) { EXPECT_FALSE(port.write(Bytes(size, 0x22))); });
    was_any_torn = was_any_torn || torn.is_so;
    EXPECT_EQ(torn.received.size() % size != 0, torn.is_so);
    EXPECT_EQ(torn.received.size() / size, torn.whole_packets);
    EXPECT_EQ(torn.received, Bytes(torn.received.size(), 0x11));
  }
  EXPECT_TRUE(was_any_torn);
}

// It does not take a stop either; the attempt ends.
TEST(TtyPortFaults, AFullPortIsStillClosed) {
  const Torn torn = fill(10, [](TtyPort& port) {
    port.set_may_push(true);
    port.stop_at_once();
  });
  EXPECT_GT(torn.whole_packets, 0U);
}

// As where a library closes the same number twice, and somebody's file gets it.
TEST(TtyPortFaults, WhatHasGotItsNumberIsLeftAlone) {
  const PseudoTerminal terminal;
  TtyPort port({.path = terminal.path(), .is_guarded = false});
  ASSERT_EQ(port.open(), LinkFault::none);
  port.set_may_push(true);
  std::array<int, 2> ends{};
  ASSERT_EQ(socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0, ends.data()), 0);
  int number = -1;
  for (const auto& file : std::filesystem::directory_iterator("/proc/self/fd")) {
    std::error_code gone;
    const bool is_port = std::filesystem::read_symlink(file.path(), gone) == terminal.path();
    if (is_port) number = std::stoi(file.path().filename());
  }
  ASSERT_GE(number, 0);
  ASSERT_EQ(dup3(ends[0], number, O_CLOEXEC), number);
  ASSERT_EQ(::write(ends[1], "theirs", 6), 6);

  port.stop_at_once();
  Bytes into(64);
  EXPECT_EQ(port.read(into), 0U);
  EXPECT_EQ(port.fault(), LinkFault::broken);
  EXPECT_FALSE(port.write(bytes_of(hapi::zero_exchange())));
  port.close();

  std::array<char, 16> read{};
  EXPECT_EQ(::read(ends[0], read.data(), read.size()), 6) << "what is theirs is still there";
  EXPECT_EQ(::read(ends[1], read.data(), read.size()), -1) << "and nothing else has come";
  for (const int each : {ends[0], ends[1], number}) EXPECT_EQ(::close(each), 0);
}

TEST(TtyPortFaults, ZerosGoOutAfterATornPacket) {
  const PseudoTerminal terminal;
  TtyPort port({.path = terminal.path(), .is_guarded = false});
  ASSERT_EQ(port.open(), LinkFault::none);
  std::size_t written = 0;
  for (const std::size_t size : sizes) {
    while (port.fault() == LinkFault::none && port.write(Bytes(size, 0x11))) written += size;
  }
  ASSERT_EQ(port.fault(), LinkFault::broken);
  terminal.receive(written);
  const Bytes stop = bytes_of(hapi::zero_exchange());
  EXPECT_FALSE(port.write(Bytes(10, 0x22)));
  ASSERT_TRUE(port.write(stop));
  port.close();
  const Bytes after = terminal.receive_all();
  ASSERT_GE(after.size(), stop.size());
  EXPECT_TRUE(std::equal(stop.rbegin(), stop.rend(), after.rbegin()));
}

}  // namespace
}  // namespace ghostforce::tty_port_faults_test
