// The complete driver of the Falcon, from the servo's view of it down to the real libusb, against a Falcon that exists
// only at the kernel's boundary.
#include <functional>
#include <memory>
#include <string>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "device/falcon/falcon_input.h"
#include "device/falcon_usb/ftdi_link.h"
#include "device/virtual_falcon/practice_firmware.h"
#include "tests/emulation/emulated_usb_device.h"
#include "tests/emulation/falcon_chip.h"

namespace ghostforce::falcon_over_usb_test {
namespace {

constexpr std::int64_t ms = 1'000'000;

class FalconOverUsbTest : public testing::Test {
 protected:
  FalconOverUsbTest() {
    FalconOptions options;
    options.firmware = practice_firmware();
    input = std::make_unique<FalconInput>(std::make_unique<FtdiLink>(), options, Vector<2>{0.0, 0.0});
    input->restart({0.0, 0.0});
  }

  // Ticks as the servo does, until something is so.
  bool tick_until(const std::function<bool()>& condition, double longest_s = 60.0) {
    const std::int64_t end_ns = input->now_ns() + static_cast<std::int64_t>(longest_s * 1e9);
    while (!condition()) {
      if (input->now_ns() > end_ns) return false;
      input->wait_until(input->now_ns() + ms);
      reading = input->read();
      input->goal(0, 1000.0);
      input->set_force(force, reading.is_known);
    }
    return true;
  }

  TestBed bed;
  FalconChip chip;
  EmulatedUsbDevice falcon{bed, chip, "12PZ657E"};
  std::unique_ptr<FalconInput> input;
  HandleReading reading;
  Vector<2> force{0.0};
};

TEST_F(FalconOverUsbTest, IsFoundLoadedHomedAndReadAndFoundAgain) {
  EXPECT_FALSE(tick_until([&] { return input->report().state != FalconState::absent; }, 0.05));
  falcon.plug();
  ASSERT_TRUE(tick_until([&] { return reading.is_known; })) << "state " << name_of(input->report().state);
  EXPECT_EQ(input->report().serial.text(), "12PZ657E");
  EXPECT_TRUE(input->report().is_homed());
  EXPECT_EQ(reading.trouble, OffReason::none);
  const std::uint64_t exchanges = input->report().exchanges;
  ASSERT_TRUE(tick_until([&] { return input->report().exchanges >= exchanges + 300; }));
  // A handle that moves is not where it was read.
  EXPECT_TRUE(tick_until([&] { return glm::distance(input->report().position, chip.position()) < 1e-3; }));

  // Pushed up, it goes up against the hand; with the plug pulled, that is what is said.
  force = {0.0, 1.0};
  const double before = chip.position().y;
  EXPECT_TRUE(tick_until([&] { return chip.position().y > before + 0.005; }));
  falcon.unplug();
  EXPECT_TRUE(tick_until([&] { return reading.trouble == OffReason::unplugged; }));
  EXPECT_FALSE(reading.is_known);
  falcon.plug();
  force = {0.0, 0.0};
  EXPECT_TRUE(tick_until([&] { return reading.is_known; })) << "state " << name_of(input->report().state);
  input->shut_down();
  EXPECT_EQ(chip.motors(), (std::array<std::int16_t, 3>{}));
}

}  // namespace
}  // namespace ghostforce::falcon_over_usb_test
