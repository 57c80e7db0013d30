// The ways out of a program whose motors push: in each of them nothing pushes at the end. A process for each test: an
// emergency stop is for good.
#include <gtest/gtest.h>

#include <unistd.h>

#include <csignal>
#include <memory>

#include "device/motors/emergency_stop.h"
#include "tests/device/haply/held_haply.h"

namespace ghostforce::haply_ways_out_test {
namespace {

using Bytes = std::vector<std::uint8_t>;
const Bytes zeros{2, 5, 0, 0, 0, 0, 0, 0, 0, 0};

TEST(HaplyWaysOut, StopKey) {
  HeldHaply haply;
  ASSERT_TRUE(haply.press());
  haply.disarm();
  PushWatch watch(haply);
  haply.run(1.0);
  EXPECT_EQ(haply.motors().reason, OffReason::key);
  EXPECT_LE(watch.ms_pushing(), 1e3 * Safety::fade_s + 10.0)
      << "it fades, so that the hand does not fall into the wall";
  EXPECT_FALSE(haply.pushes());
}

TEST(HaplyWaysOut, ShutDown) {
  HeldHaply haply;
  ASSERT_TRUE(haply.press());
  haply.port().keeps_packets = true;
  const std::int64_t began_ns = haply.port().now_ns();
  haply.servo().shut_down();
  EXPECT_FALSE(haply.pushes());
  EXPECT_LE(haply.port().now_ns() - began_ns, 100'000'000) << "within 0.1 s, says HapticDevice";
  int sent = 0;
  for (const WatchedPort::Packet& packet : haply.port().packets) sent += packet.bytes == zeros ? 1 : 0;
  EXPECT_GE(sent, 2) << "zeros at least twice";
  EXPECT_FALSE(haply.haply().may_still_push);
  EXPECT_EQ(haply.port().fault(), LinkFault::none);
}

// It may come before a zero pose, while a board is opened, or twice.
TEST(HaplyWaysOut, ShutDownWheneverItComes) {
  for (int ms = 0; ms < 400; ms += 13) {
    HeldHaply haply;
    haply.run(0.001 * ms);
    haply.servo().shut_down();
    haply.servo().shut_down();
    EXPECT_FALSE(haply.pushes()) << ms;
  }
}

TEST(HaplyWaysOut, ShutDownOfABoardThatDoesNotAnswer) {
  for (const char* name : {"mute", "no-dtr", "late-50ms"}) {
    HeldHaply haply;
    ASSERT_TRUE(haply.press());
    haply.inject(name);
    const std::int64_t began_ns = haply.port().now_ns();
    haply.servo().shut_down();
    EXPECT_FALSE(haply.pushes()) << name << ": it obeys";
    EXPECT_LE(haply.port().now_ns() - began_ns, 300'000'000) << name;
  }
}

// The board's port outlives the driver here, so that one can look at it.
class LentPort final : public SerialPort {
 public:
  explicit LentPort(WatchedPort& port) : port_(port) {}
  bool waits_to_open() const noexcept override { return false; }
  LinkFault open() noexcept override { return port_.open(); }
  void close() noexcept override { port_.close(); }
  LinkFault fault() const noexcept override { return port_.fault(); }
  std::string_view serial() const noexcept override { return port_.serial(); }
  void set_may_push(bool may_push) noexcept override { port_.set_may_push(may_push); }
  std::int64_t now_ns() const noexcept override { return port_.now_ns(); }
  void wait_until(std::int64_t deadline_ns) noexcept override { port_.wait_until(deadline_ns); }
  bool write(std::span<const std::uint8_t> packet) noexcept override { return port_.write(packet); }
  std::size_t read(std::span<std::uint8_t> into) noexcept override { return port_.read(into); }
  void discard_input() noexcept override { port_.discard_input(); }
  void write_at_once(std::span<const std::uint8_t> packet) noexcept override { port_.write_at_once(packet); }

 private:
  WatchedPort& port_;
};

struct LentHaply {
  explicit LentHaply(void (*when_left_pushing)(const DeviceSerial&) noexcept = nullptr, bool is_virtual = true) {
    HaplyOptions options;
    options.is_virtual = is_virtual;
    options.when_left_pushing = when_left_pushing;
    driver = std::make_unique<Haply>(std::make_unique<LentPort>(port), options);
    port.board().hold_zero_pose(true);
    run(1.5, Vector<2>(0.0), false);
    driver->confirm_zero_pose();
    run(0.2, Vector<2>(0.0), false);
    port.board().hold_zero_pose(false);
    run(1.0, Vector<2>(0.0), false);
    run(0.1, {0.5, 0.5}, true);
  }
  void run(double seconds, const Vector<2>& force, bool is_armed) {
    for (double t = 0.0; t < seconds; t += 0.001) {
      const std::int64_t end_ns = port.now_ns() + 1'000'000;
      while (port.now_ns() < end_ns) {
        driver->update();
        driver->wait_until(end_ns);
      }
      driver->update();
      driver->set_force(force, is_armed);
    }
  }
  bool pushes() const { return port.board().duties() != std::array{0.0, 0.0}; }

  WatchedPort port{VirtualPort::Options{.clock = VirtualPort::Clock::stepped}};
  std::unique_ptr<Haply> driver;
};

TEST(HaplyWaysOut, Destruction) {
  LentHaply haply;
  ASSERT_TRUE(haply.pushes());
  const std::int64_t began_ns = haply.port.now_ns();
  haply.driver.reset();
  EXPECT_FALSE(haply.pushes());
  EXPECT_LE(haply.port.now_ns() - began_ns, 100'000'000);
}

TEST(HaplyWaysOut, DestructionWhileTheCableIsOut) {
  static int left = 0;
  left = 0;
  LentHaply haply([](const DeviceSerial&) noexcept { ++left; }, false);
  ASSERT_TRUE(haply.pushes());
  haply.port.board().inject(haply_fault_named("unplugged"));
  const std::int64_t began_ns = haply.port.now_ns();
  haply.driver.reset();
  EXPECT_TRUE(haply.pushes()) << "nothing reaches it";
  EXPECT_EQ(left, 1) << "a person is told";
  EXPECT_LE(haply.port.now_ns() - began_ns, 4'000'000'000);
}

// Another driver of the same program, with the same debts, stops what the first one left.
TEST(HaplyWaysOut, TheNextDriverPaysTheDebt) {
  auto debts = std::make_shared<StopDebts>();
  HeldHaply::Options options;
  options.debts = debts;
  HeldHaply haply(options);
  ASSERT_TRUE(haply.press());
  haply.inject("unplugged");
  haply.run(0.2);
  EXPECT_TRUE(debts->has(*DeviceSerial::from(VirtualPort::serial_number)));
  haply.mend();
  ASSERT_TRUE(haply.run_until(1.0, [&] { return debts->empty(); }));
  EXPECT_FALSE(haply.pushes());
}

TEST(HaplyWaysOut, EmergencyStop) {
  HeldHaply haply;
  ASSERT_TRUE(haply.press());
  emergency_stop::stop_motors();
  EXPECT_FALSE(haply.pushes()) << "at once, and nobody has waited";
  ASSERT_EQ(haply.port().at_once.size(), 2U);
  for (const WatchedPort::Packet& packet : haply.port().at_once) EXPECT_EQ(packet.bytes, zeros);
  haply.port().on_write = [](std::span<const std::uint8_t> packet) {
    EXPECT_TRUE(!is_exchange(packet) || (torque_in(packet, 0) == 0.0F && torque_in(packet, 1) == 0.0F));
  };
  haply.run(1.0);
  EXPECT_FALSE(haply.pushes()) << "nor does the driver ask for a force after it";
}

// By a signal that ends the process, in the handler itself.
TEST(HaplyWaysOut, ADeadlySignalStopsTheMotorsFirst) {
  const auto end = [] {
    static HeldHaply haply;
    if (!haply.press()) _exit(1);
    haply.port().on_at_once = [] {
      const std::string_view word = haply.pushes() ? "pushes " : "stopped ";
      if (write(STDERR_FILENO, word.data(), word.size()) < 0) _exit(3);
    };
    emergency_stop::install_handlers();
    std::raise(SIGUSR1);
  };
  EXPECT_EXIT(end(), testing::KilledBySignal(SIGUSR1), "^stopped stopped $");
  const auto look = [] {
    static HeldHaply haply;
    if (!haply.press() || !haply.pushes()) _exit(1);
    emergency_stop::stop_motors();
    _exit(haply.pushes() ? 2 : 0);
  };
  EXPECT_EXIT(look(), testing::ExitedWithCode(0), "");
}

// A port that is not open, or has never been: nothing is written to it.
TEST(HaplyWaysOut, AnEmergencyBeforeThereIsABoard) {
  HeldHaply::Options options;
  options.device.fault.link = LinkFault::absent;
  HeldHaply haply(options);
  haply.run(0.5);
  emergency_stop::stop_motors();
  EXPECT_TRUE(haply.port().at_once.empty());
  haply.mend();
  haply.port().keeps_packets = true;
  haply.run(2.0);
  for (const WatchedPort::Packet& packet : haply.port().packets) {
    EXPECT_TRUE(!is_exchange(packet.bytes) || packet.bytes == zeros);
  }
}

}  // namespace
}  // namespace ghostforce::haply_ways_out_test
