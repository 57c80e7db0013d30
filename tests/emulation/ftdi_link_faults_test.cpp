// The Falcon's link with the real libusb, when endpoints halt, stall and do not listen: the motors' zero gets through,
// ahead of all that waits, or it is the last thing tried; and a device that is owed one comes first.
#include "device/falcon_usb/ftdi_link.h"

#include <cerrno>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

#include "tests/emulation/emulated_usb_device.h"
#include "tests/emulation/recording_chip.h"

namespace ghostforce::ftdi_link_faults_test {
namespace {

using Bytes = std::vector<std::uint8_t>;
constexpr std::int64_t ms = 1'000'000;

class FtdiLinkFaultsTest : public testing::Test {
 protected:
  void open() {
    falcon.plug();
    chip.set_echo(false);
    ASSERT_EQ(link.open(), LinkFault::none);
  }
  // False: it did not become so, however busy this machine may be.
  bool wait_for(const std::function<bool()>& condition) {
    const std::int64_t end_ns = link.now_ns() + 30'000 * ms;
    while (!condition()) {
      if (link.now_ns() > end_ns) return false;
      link.wait_until(link.now_ns() + 5 * ms);
    }
    return true;
  }
  Bytes arrived_since(std::size_t count) {
    Bytes bytes = chip.received();
    bytes.erase(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(count));
    return bytes;
  }
  bool wait_until_sent() {
    return wait_for([this] { return !link.is_sending(); });
  }

  TestBed bed;
  RecordingChip chip;
  EmulatedUsbDevice falcon{bed, chip, "12PZ657E"};
  FtdiLink link;
};

TEST_F(FtdiLinkFaultsTest, ClearsTheHaltsThatItFinds) {
  falcon.plug();
  for (const char* name : {"in-halt", "out-halt", "both-halt"}) {
    falcon.inject(usb_fault(name));
    chip.set_echo(true);
    ASSERT_EQ(link.open(), LinkFault::none) << name;
    ASSERT_TRUE(link.write(Bytes{1, 2, 3}));
    Bytes bytes(3);
    EXPECT_TRUE(wait_for([&] { return link.read(bytes) == 3; })) << name;
    EXPECT_EQ(link.fault(), LinkFault::none) << name;
    link.close();
  }
}

TEST_F(FtdiLinkFaultsTest, ACommandThatFailsIsSentTwiceMore) {
  open();
  UsbFault errors;
  errors.out.error = EPROTO;
  errors.out.failures = 2;
  falcon.inject(errors);
  ASSERT_TRUE(link.write(Bytes{1}));
  ASSERT_TRUE(wait_until_sent());
  EXPECT_EQ(chip.received(), (Bytes{1}));
  EXPECT_EQ(link.fault(), LinkFault::none);
  errors.out.failures = 3;
  falcon.inject(errors);
  ASSERT_TRUE(link.write(Bytes{2}));
  EXPECT_TRUE(wait_for([this] { return link.fault() == LinkFault::broken; }));
  EXPECT_EQ(chip.received(), (Bytes{1}));
}

TEST_F(FtdiLinkFaultsTest, AStopTakesThePlaceOfWhatWaits) {
  open();
  chip.set_stuck(true);
  ASSERT_TRUE(link.write(Bytes{1, 2, 3}));
  link.stop(Bytes{7, 8});
  EXPECT_TRUE(link.owes_stop());
  chip.set_stuck(false);
  ASSERT_TRUE(wait_until_sent());
  EXPECT_FALSE(link.owes_stop());
  EXPECT_EQ(chip.received(), (Bytes{7, 8}));
  EXPECT_EQ(link.fault(), LinkFault::none) << "and the link goes on";
  ASSERT_TRUE(link.write(Bytes{4}));
  ASSERT_TRUE(wait_until_sent());
  EXPECT_EQ(chip.received(), (Bytes{7, 8, 4}));
}

TEST_F(FtdiLinkFaultsTest, AStopGoesOutThroughALinkThatHearsNoMore) {
  for (const char* name : {"in-stall", "in-halt", "in-errors-200"}) {
    SCOPED_TRACE(name);
    open();
    const std::size_t before = chip.received().size();
    falcon.inject(usb_fault(name));
    ASSERT_TRUE(wait_for([this] { return link.fault() == LinkFault::broken; }));
    EXPECT_FALSE(link.write(Bytes{1}));
    link.stop(Bytes{7});
    link.close();
    EXPECT_EQ(arrived_since(before), (Bytes{7}));
    EXPECT_FALSE(link.owes_stop());
    falcon.inject({});
  }
}

TEST_F(FtdiLinkFaultsTest, ClosingInsistsOnTheStopThroughAHaltedEndpoint) {
  for (const char* name : {"out-stall", "out-halt", "both-halt", "out-errors-5"}) {
    SCOPED_TRACE(name);
    open();
    const std::size_t before = chip.received().size();
    falcon.inject(usb_fault(name));
    link.stop(Bytes{7});
    link.close();
    EXPECT_EQ(arrived_since(before), (Bytes{7}));
    EXPECT_FALSE(link.owes_stop());
    falcon.inject({});
  }
}

TEST_F(FtdiLinkFaultsTest, AStopThatCannotArriveIsTheLastThingTried) {
  open();
  falcon.inject(usb_fault("out-nak"));
  ASSERT_TRUE(link.write(Bytes{1, 2, 3}));
  link.wait_until(link.now_ns() + 5 * ms);
  link.stop(Bytes{7, 8});
  link.close();
  EXPECT_TRUE(link.owes_stop());
  EXPECT_EQ(falcon.last_out().bytes, (Bytes{7, 8}));
  EXPECT_TRUE(chip.received().empty());
  // The chip may have lost its settings by then, which are the driver's: bytes without them would be noise.
  falcon.inject({});
  ASSERT_EQ(link.open(), LinkFault::none);
  EXPECT_FALSE(link.owes_stop());
  EXPECT_TRUE(chip.received().empty());
}

// Its motors have a supply of their own.
TEST_F(FtdiLinkFaultsTest, ADeviceThatIsOwedAStopComesFirst) {
  RecordingChip other_chip;
  EmulatedUsbDevice other(bed, other_chip, "00FIRST0");
  other.plug();
  StopDebts owed;
  owed.add(*DeviceSerial::from("12PZ657E"));
  ASSERT_EQ(link.open_first(owed), LinkFault::none);
  EXPECT_EQ(link.serial(), "00FIRST0") << "the one that is owed is away";
  EXPECT_FALSE(link.is_any_plugged_in(owed));
  falcon.plug();
  EXPECT_TRUE(link.is_any_plugged_in(owed));
  EXPECT_EQ(link.fault(), LinkFault::none) << "it is looked for beside the one in use";
  ASSERT_EQ(link.open_first(owed), LinkFault::none);
  EXPECT_EQ(link.serial(), "12PZ657E");
  // Also where another serial number was asked for.
  FtdiLink chosen({falcon_usb_id, "00FIRST0"});
  EXPECT_EQ(chosen.open_first(owed), LinkFault::busy) << "the one that comes first is in use, and no other is taken";
  link.close();
  ASSERT_EQ(chosen.open_first(owed), LinkFault::none);
  EXPECT_EQ(chosen.serial(), "12PZ657E");
  ASSERT_EQ(chosen.open_first({}), LinkFault::none);
  EXPECT_EQ(chosen.serial(), "00FIRST0");
  EXPECT_TRUE(other_chip.received().empty());
}

TEST_F(FtdiLinkFaultsTest, TellsWhatBecameOfARequest) {
  open();
  const VendorRequest latency{0x09, 1, 0};
  falcon.inject(usb_fault("latency-refused"));
  ASSERT_TRUE(link.request(latency));
  ASSERT_TRUE(wait_until_sent());
  EXPECT_EQ(link.request_outcome(), RequestOutcome::refused);
  ASSERT_TRUE(link.request(latency)) << "a control endpoint that has refused one takes the next";
  ASSERT_TRUE(wait_until_sent());
  EXPECT_EQ(link.request_outcome(), RequestOutcome::done);
  EXPECT_EQ(chip.requests(), (std::vector{latency}));
  falcon.inject(usb_fault("control-nak"));
  ASSERT_TRUE(link.request(latency));
  ASSERT_TRUE(wait_until_sent());
  EXPECT_EQ(link.request_outcome(), RequestOutcome::unanswered);
  EXPECT_EQ(link.fault(), LinkFault::none);
}

// Its calibration goes by the serial number: a device that does not tell it now is not taken for one without.
TEST_F(FtdiLinkFaultsTest, WaitsForTheSerialNumber) {
  falcon.plug();
  falcon.inject(usb_fault("control-nak"));
  EXPECT_EQ(link.open(), LinkFault::broken);
  falcon.inject({});
  EXPECT_EQ(link.open(), LinkFault::none);
  EXPECT_EQ(link.serial(), "12PZ657E");
}

}  // namespace
}  // namespace ghostforce::ftdi_link_faults_test
