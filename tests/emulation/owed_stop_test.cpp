// The complete driver over the real libusb with two Falcons, whose chips forget their settings with the cable or are
// reset while it is in: no force outlives the moment at which its device can be told again.
#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "device/falcon/falcon_input.h"
#include "device/falcon/link_setup.h"
#include "device/falcon_usb/ftdi_link.h"
#include "tests/emulation/emulated_usb_device.h"
#include "tests/emulation/falcon_chip.h"
#include "tests/support/becomes.h"

namespace ghostforce::owed_stop_test {
namespace {

constexpr std::int64_t ms = 1'000'000;
constexpr int most_attempts = 50;

// A Falcon that runs its firmware and is homed. While its chip is at its own rate, all that it passes on is noise.
class ForgetfulChip final : public EmulatedChip {
 public:
  void forget() { is_set_up_ = false; }

  void power_up(std::int64_t now_ns) override {
    forget();
    falcon_.power_up(now_ns);
  }
  void control(const VendorRequest& request, std::int64_t now_ns) override {
    if (request.request == ftdi::running_rate.request) is_set_up_ = request == ftdi::running_rate;
    falcon_.control(request, now_ns);
  }
  std::size_t room() const override { return falcon_.room(); }
  void receive(std::span<const std::uint8_t> bytes, std::int64_t now_ns) override {
    if (is_set_up_) return falcon_.receive(bytes, now_ns);
    noise_bytes_ += bytes.size();
  }
  std::size_t take_packet(std::span<std::uint8_t, packet_size> into, std::int64_t now_ns) override {
    return falcon_.take_packet(into, now_ns);
  }
  std::int64_t next_due_ns() const override { return falcon_.next_due_ns(); }

  bool pushes() { return falcon_.told().motors != MotorNumbers{}; }
  std::size_t noise_bytes() const { return noise_bytes_; }

 private:
  FalconChip falcon_{FalconDsp::Options{.starts_with_firmware = true, .starts_homed = true}};
  std::atomic<bool> is_set_up_ = false;
  std::atomic<std::size_t> noise_bytes_ = 0;
};

std::vector<std::string> left_pushing;

class OwedStopTest : public testing::Test {
 protected:
  OwedStopTest() { begin_driver(); }

  void begin_driver() {
    left_pushing.clear();
    FalconOptions options;
    options.when_left_pushing = [](const DeviceSerial& serial) noexcept { left_pushing.emplace_back(serial.text()); };
    input = std::make_unique<FalconInput>(std::make_unique<FtdiLink>(), options, Vector<2>{0.0, 0.0});
    input->restart({0.0, 0.0});
  }

  // Ticks as the servo does, until something is so.
  bool tick_until(const std::function<bool()>& condition) {
    const std::int64_t end_ns = input->now_ns() + 60'000 * ms;
    while (!condition()) {
      if (input->now_ns() > end_ns) return false;
      input->wait_until(input->now_ns() + ms);
      const HandleReading reading = input->read();
      input->set_force({0.0, is_armed ? 1.0 : 0.0}, is_armed && reading.is_known);
    }
    return true;
  }
  bool pushes_with(ForgetfulChip& chip) {
    return tick_until([&] { return chip.pushes(); });
  }

  TestBed bed;
  ForgetfulChip chip_a;
  ForgetfulChip chip_b;
  EmulatedUsbDevice a{bed, chip_a, "12PZ657E"};
  EmulatedUsbDevice b{bed, chip_b, "FTPNM0FB"};
  std::unique_ptr<FalconInput> input;
  bool is_armed = true;
};

// Once more where this machine came so late that the guard took the device: it says zero before it sets anything up.
TEST_F(OwedStopTest, ADeviceThatWasPluggedInAgainIsSetUpAndThenStopped) {
  a.plug();
  bool was_late = true;
  for (int attempt = 0; was_late && attempt < most_attempts; ++attempt) {
    is_armed = true;
    ASSERT_TRUE(pushes_with(chip_a));
    const std::size_t noise_before = chip_a.noise_bytes();
    a.unplug();
    ASSERT_TRUE(tick_until([&] { return input->report().fault == FalconFault::unplugged; }));
    EXPECT_TRUE(input->report().may_still_push);
    is_armed = false;
    const std::uint64_t faults = input->report().faults;
    a.plug();
    ASSERT_TRUE(tick_until([&] { return !chip_a.pushes(); }));
    was_late = input->report().faults != faults;
    EXPECT_TRUE(was_late || chip_a.noise_bytes() == noise_before);
    EXPECT_TRUE(tick_until([&] { return !input->report().may_still_push; }));
  }
  EXPECT_FALSE(was_late);
}

TEST_F(OwedStopTest, TheFirstOneIsStoppedWhenItIsBackThoughTheSecondPushes) {
  a.plug();
  b.plug();
  ASSERT_TRUE(pushes_with(chip_a));
  a.unplug();
  ASSERT_TRUE(pushes_with(chip_b));
  EXPECT_TRUE(input->report().may_still_push);
  EXPECT_EQ(input->report().owed_serial.text(), "12PZ657E");
  a.plug();
  ASSERT_TRUE(tick_until([&] { return !chip_a.pushes(); }));
  is_armed = false;
  EXPECT_TRUE(tick_until([&] { return !input->report().may_still_push; }));
  EXPECT_FALSE(chip_a.pushes());
  EXPECT_FALSE(chip_b.pushes());
}

TEST_F(OwedStopTest, BothAreStoppedThoughBothWereAway) {
  a.plug();
  b.plug();
  ASSERT_TRUE(pushes_with(chip_a));
  a.unplug();
  ASSERT_TRUE(pushes_with(chip_b));
  b.unplug();
  is_armed = false;
  b.plug();
  ASSERT_TRUE(tick_until([&] { return !chip_b.pushes(); }));
  EXPECT_TRUE(input->report().may_still_push);
  a.plug();
  ASSERT_TRUE(tick_until([&] { return !chip_a.pushes(); }));
  EXPECT_TRUE(tick_until([&] { return !input->report().may_still_push; }));
}

// Once more where this machine took longer than the driver waits (stop_debts_test.cpp has the times), and it was said.
TEST_F(OwedStopTest, AtTheEndOfTheProgramTheOwedOneIsStoppedAndNotOnlyTheOneInUse) {
  a.plug();
  b.plug();
  for (int attempt = 0; attempt < most_attempts; ++attempt) {
    is_armed = false;
    ASSERT_TRUE(tick_until([&] { return !chip_a.pushes(); })) << "of the attempt before";
    is_armed = true;
    ASSERT_TRUE(pushes_with(chip_a));
    a.unplug();
    ASSERT_TRUE(pushes_with(chip_b));
    a.plug();
    input->shut_down();
    input.reset();
    EXPECT_FALSE(chip_b.pushes());
    if (left_pushing.empty()) break;
    begin_driver();
  }
  EXPECT_TRUE(left_pushing.empty());
  EXPECT_FALSE(chip_a.pushes());
}

// The program goes no further than to open it: from the first moment the guard knows what it has to do.
TEST_F(OwedStopTest, TheGuardOfADeviceThatIsOwedAStopGivesIt) {
  a.plug();
  ASSERT_TRUE(pushes_with(chip_a));
  a.unplug();
  ASSERT_TRUE(tick_until([&] { return input->report().fault == FalconFault::unplugged; }));
  input.reset();
  ASSERT_TRUE(chip_a.pushes());
  a.plug();
  StopDebts owed;
  owed.add(device_serial_of("12PZ657E"));
  FtdiLink link;
  ASSERT_TRUE(becomes([&] { return link.open_first(owed) == LinkFault::none; }));
  EXPECT_TRUE(becomes([&] { return !chip_a.pushes(); }));
}

// Once more where this machine came so late that the guard took the device meanwhile, of which the driver may see
// nothing. A driver that opens it anew does so each time.
TEST_F(OwedStopTest, AChipThatIsResetWhileItsCableIsInIsSetUpAgainAndStopped) {
  a.plug();
  bool was_late = true;
  for (int attempt = 0; was_late && attempt < most_attempts; ++attempt) {
    is_armed = true;
    ASSERT_TRUE(pushes_with(chip_a));
    const std::uint64_t times_taken = a.times_taken();
    const std::uint64_t faults = input->report().faults;
    chip_a.forget();
    ASSERT_TRUE(tick_until([&] { return !chip_a.pushes(); }));
    is_armed = false;
    EXPECT_TRUE(tick_until([&] { return !input->report().may_still_push; }));
    EXPECT_TRUE(tick_until([&] { return input->report().is_readable(); }));
    was_late = input->report().faults != faults || a.times_taken() != times_taken;
  }
  EXPECT_FALSE(was_late) << "it is not opened anew";
}

}  // namespace
}  // namespace ghostforce::owed_stop_test
