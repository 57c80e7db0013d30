// The simulated board as a terminal device, opened, written and read as any program would. Nothing here decides by a
// clock: what is waited for comes, or the test hangs for a while and fails.
#include "device/virtual_haply/pty_board.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/stat.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "device/input/monotonic_clock.h"
#include "tests/device/virtual_haply/hapi_bytes.h"

namespace ghostforce::pty_board_test {
namespace {

using namespace hapi_bytes;

constexpr int hang_ms = 20'000;

// Whether it becomes so.
template <typename Condition>
bool comes(Condition condition) {
  for (int i = 0; i < hang_ms; ++i) {
    if (condition()) return true;
    sleep_until_monotonic(monotonic_ns() + 1 * ms);
  }
  return false;
}

// A terminal device, set up as a host does.
struct Terminal {
  explicit Terminal(const std::string& path, speed_t speed = B115200)
      : file(open(path.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC | O_NONBLOCK)) {
    termios settings{};
    if (tcgetattr(file, &settings) != 0) return;
    cfmakeraw(&settings);
    settings.c_cflag |= CLOCAL;
    cfsetspeed(&settings, speed);
    tcsetattr(file, TCSANOW, &settings);
  }
  ~Terminal() { shut(); }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  void shut() {
    if (file >= 0) close(file);
    file = -1;
  }
  bool send(const Bytes& bytes) const {
    return write(file, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size());
  }
  Bytes hear(std::size_t size) const {
    Bytes heard;
    while (heard.size() < size) {
      pollfd ready{.fd = file, .events = POLLIN, .revents = 0};
      if (poll(&ready, 1, hang_ms) <= 0) break;
      std::array<std::uint8_t, 64> bytes{};
      const ssize_t count = read(file, bytes.data(), std::min(bytes.size(), size - heard.size()));
      if (count <= 0) break;
      heard.insert(heard.end(), bytes.begin(), bytes.begin() + count);
    }
    return heard;
  }

  int file;
};

const HaplyBench::Options held{.starts_in_zero_pose = true};

TEST(PtyBoard, IsSetUpAndExchangedWith) {
  PtyBoard board({.device = held});
  Terminal terminal(board.port());
  ASSERT_GE(terminal.file, 0);
  ASSERT_TRUE(terminal.send(set_up_v31));
  ASSERT_TRUE(terminal.send(exchange_at_port_2));
  // The arms are held; the push moves them by less than a count or two.
  const Bytes first = terminal.hear(9);
  ASSERT_EQ(first.size(), 9U);
  EXPECT_EQ(first, reply_v31);
  EXPECT_TRUE(comes([&] { return board.truth().duties[0] != 0.0; }));
  ASSERT_TRUE(terminal.send(exchange_of(0.0, 0.0)));
  EXPECT_EQ(terminal.hear(9).size(), 9U);
  EXPECT_TRUE(comes([&] { return board.truth().duties[0] == 0.0; }));
  const HaplyTruth truth = board.truth();
  EXPECT_TRUE(truth.is_configured);
  EXPECT_EQ(truth.exchanges, 2U);
  EXPECT_GE(truth.packets, 2U);
  EXPECT_NEAR(degrees_per_radian * truth.angles.x, 168.0, 0.5);
}

TEST(PtyBoard, TheForceStandsWhenTheHostIsGone) {
  PtyBoard board({.device = held});
  Terminal terminal(board.port());
  ASSERT_TRUE(terminal.send(set_up_v31));
  ASSERT_TRUE(terminal.send(exchange_at_port_2));
  ASSERT_EQ(terminal.hear(9).size(), 9U);
  EXPECT_TRUE(comes([&] { return board.is_open(); }));
  terminal.shut();
  EXPECT_TRUE(comes([&] { return !board.is_open() && board.truth().silence_ns() > 100 * ms; }));
  EXPECT_NE(board.truth().duties[0], 0.0);
  // The next host finds its set up.
  Terminal next(board.port());
  ASSERT_TRUE(next.send(exchange_of(0.0, 0.0)));
  EXPECT_EQ(next.hear(9).size(), 9U);
  EXPECT_TRUE(comes([&] { return board.truth().duties[0] == 0.0; }));
}

TEST(PtyBoard, IsPulledOutAndPutInAgainBehindItsLink) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "ghostforce-pty-board-test";
  std::filesystem::create_directories(folder);
  const std::string link = folder / ("haply" + std::to_string(getpid()));
  {
    PtyBoard board({.device = held, .link = link});
    EXPECT_EQ(board.port(), link);
    Terminal terminal(link);
    ASSERT_TRUE(terminal.send(set_up_v31));
    ASSERT_TRUE(terminal.send(exchange_at_port_2));
    ASSERT_EQ(terminal.hear(9).size(), 9U);
    board.inject(haply_fault("unplugged"));
    EXPECT_TRUE(comes([&] { return board.port().empty(); }));
    EXPECT_TRUE(comes([&] {
      std::uint8_t byte = 0;
      return read(terminal.file, &byte, 1) == 0 || errno == EIO;
    }));
    EXPECT_FALSE(std::filesystem::exists(link));
    EXPECT_NE(board.truth().duties[0], 0.0) << "the motors have power of their own";
    board.inject({});
    EXPECT_TRUE(comes([&] { return !board.port().empty(); }));
    Terminal again(link);
    ASSERT_TRUE(again.send(exchange_of(0.0, 0.0)));
    EXPECT_EQ(again.hear(9).size(), 9U);
  }
  EXPECT_FALSE(std::filesystem::is_symlink(link));
  // Somebody's file stays.
  std::filesystem::create_directories(link);
  EXPECT_THROW(PtyBoard({.link = link}), std::system_error);
  std::filesystem::remove_all(folder);
}

TEST(PtyBoard, VanishesWhenAPortAt1200BaudIsClosed) {
  PtyBoard board({});
  {
    const Terminal terminal(board.port(), B1200);
    ASSERT_TRUE(terminal.send(exchange_of(0.0, 0.0)));
    EXPECT_EQ(terminal.hear(1), Bytes{5});
    EXPECT_TRUE(comes([&] { return board.is_open(); }));
  }
  EXPECT_TRUE(comes([&] { return board.port().empty(); }));
  board.inject({});
  EXPECT_TRUE(comes([&] { return !board.port().empty(); }));
  // As the fault has it, another program has left the port like that; a host that sets its own speed is safe.
  board.inject(haply_fault("touched-1200-baud"));
  const std::string port = board.port();
  EXPECT_TRUE(comes([&] {
    const int file = open(port.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
    if (file < 0) return true;
    close(file);
    return board.port().empty();
  }));
}

TEST(PtyBoard, AtSpeedZeroItSaysNothing) {
  PtyBoard board({});
  const Terminal low(board.port(), B0);
  ASSERT_TRUE(low.send(exchange_of(0.0, 0.0)));
  EXPECT_TRUE(comes([&] { return board.truth().exchanges == 1; }));
  termios settings{};
  ASSERT_EQ(tcgetattr(low.file, &settings), 0);
  cfsetspeed(&settings, B115200);
  ASSERT_EQ(tcsetattr(low.file, TCSANOW, &settings), 0);
  ASSERT_TRUE(low.send(exchange_of(0.0, 0.0, 7)));
  const Bytes heard = low.hear(1);
  // If its reply was still under way when the speed rose, it comes first.
  EXPECT_TRUE(heard == Bytes{7} || heard == Bytes{5});
}

TEST(PtyBoard, IsNotAllowedOrBusy) {
  PtyBoard board({});
  const std::string port = board.port();
  board.inject(haply_fault("not-allowed"));
  const auto permissions = [&] {
    struct stat found {};
    stat(port.c_str(), &found);
    return found.st_mode & 0777U;
  };
  EXPECT_TRUE(comes([&] { return permissions() == 0; }));
  board.inject(haply_fault("busy"));
  EXPECT_TRUE(comes([&] { return permissions() != 0; }));
  if (geteuid() != 0) {  // root gets in all the same
    EXPECT_TRUE(comes([&] {
      const Terminal terminal(port);
      return terminal.file < 0 && errno == EBUSY;
    }));
  }
  board.inject({});
  EXPECT_TRUE(comes([&] {
    const Terminal terminal(port);
    return terminal.file >= 0;
  }));
}

TEST(PtyBoard, TheHandIsLed) {
  PtyBoard board({.device = held});
  board.hold_zero_pose(false);
  board.lead_hand(haply_hand_at({0.03, 0.1}));
  EXPECT_TRUE(comes([&] { return std::abs(board.truth().handle.x - 0.03) < 2e-3; }));
}

}  // namespace
}  // namespace ghostforce::pty_board_test
