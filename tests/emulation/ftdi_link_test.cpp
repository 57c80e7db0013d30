// The Falcon's link with the real libusb, against devices that exist only at the kernel's boundary.
#include "device/falcon_usb/ftdi_link.h"

#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/emulation/emulated_usb_device.h"
#include "tests/emulation/ordinary_user.h"
#include "tests/emulation/recording_chip.h"
#include "tests/support/program.h"

namespace ghostforce::ftdi_link_test {
namespace {

using Bytes = std::vector<std::uint8_t>;
constexpr std::int64_t ms = 1'000'000;
// On a machine that is busy with other things.
constexpr std::int64_t patience = 60'000 * ms;

// Lets the link work until something is so; false if it did not become so.
bool wait_for(FtdiLink& link, const std::function<bool()>& condition) {
  const std::int64_t end_ns = link.now_ns() + patience;
  while (!condition()) {
    if (link.now_ns() > end_ns) return false;
    link.wait_until(link.now_ns() + 5 * ms);
    if (link.fault() != LinkFault::none) return condition();
  }
  return true;
}

void send(FtdiLink& link, const Bytes& bytes) {
  ASSERT_TRUE(wait_for(link, [&] { return !link.is_sending(); }));
  ASSERT_TRUE(link.write(bytes));
}

Bytes receive(FtdiLink& link, std::size_t count) {
  Bytes bytes;
  wait_for(link, [&] {
    Bytes piece(count - bytes.size());
    piece.resize(link.read(piece));
    bytes.insert(bytes.end(), piece.begin(), piece.end());
    return bytes.size() == count;
  });
  return bytes;
}

Bytes numbered(std::size_t count, int from = 0) {
  Bytes bytes(count);
  for (std::size_t i = 0; i < count; ++i) bytes[i] = static_cast<std::uint8_t>(static_cast<std::size_t>(from) + i);
  return bytes;
}

class FtdiLinkTest : public testing::Test {
 protected:
  TestBed bed;
  RecordingChip chip;
  EmulatedUsbDevice falcon{bed, chip, "12PZ657E"};
};

TEST_F(FtdiLinkTest, FindsNoneWhereThereIsNone) {
  FtdiLink link;
  EXPECT_EQ(link.open(), LinkFault::absent);
  EXPECT_FALSE(link.write(Bytes{1}));
}

TEST_F(FtdiLinkTest, OpensAndTellsTheSerialNumber) {
  falcon.plug();
  FtdiLink link;
  EXPECT_EQ(link.open(), LinkFault::none);
  EXPECT_EQ(link.serial(), "12PZ657E");
}

TEST_F(FtdiLinkTest, TellsApartOtherDevices) {
  falcon.plug();
  FtdiLink other_id({{0x0403, 0x6001}, {}});
  EXPECT_EQ(other_id.open(), LinkFault::absent);
  FtdiLink other_serial({falcon_usb_id, "FTPNM0FB"});
  EXPECT_EQ(other_serial.open(), LinkFault::absent);
  FtdiLink right({falcon_usb_id, "12PZ657E"});
  EXPECT_EQ(right.open(), LinkFault::none);
}

TEST_F(FtdiLinkTest, TakesAnotherChipWhenTold) {
  EmulatedUsbDevice stranger(bed, chip, "A1", {0x0403, 0x6001});
  stranger.plug();
  FtdiLink link({{0x0403, 0x6001}, {}});
  EXPECT_EQ(link.open(), LinkFault::none);
  EXPECT_EQ(link.serial(), "A1");
}

TEST_F(FtdiLinkTest, GoesByTheSerialNumberNotByThePort) {
  RecordingChip second_chip;
  EmulatedUsbDevice second(bed, second_chip, "00FIRST0");
  falcon.plug();
  second.plug();
  FtdiLink link;
  ASSERT_EQ(link.open(), LinkFault::none);
  EXPECT_EQ(link.serial(), "00FIRST0");
  // That one is taken: the next.
  FtdiLink next;
  ASSERT_EQ(next.open(), LinkFault::none);
  EXPECT_EQ(next.serial(), "12PZ657E");
}

TEST_F(FtdiLinkTest, RequestsArriveAsSent) {
  falcon.plug();
  FtdiLink link;
  ASSERT_EQ(link.open(), LinkFault::none);
  const std::vector<VendorRequest> all{{0x00, 0x0001, 0}, {0x09, 0x0010, 0},     {0x03, 0x4138, 0}, {0x04, 0x0008, 0},
                                       {0x02, 0x0000, 0}, {0x01, 0x0101, 0},     {0x03, 0x0015, 1}, {0x09, 0x0001, 0},
                                       {0x03, 0x0002, 0}, {0xFF, 0xABCD, 0x1234}};
  for (const VendorRequest& request : all) {
    ASSERT_TRUE(link.request(request));
    EXPECT_TRUE(link.is_sending());
    EXPECT_FALSE(link.request({})) << "one at a time";
    EXPECT_FALSE(link.write(Bytes{1})) << "one at a time";
    ASSERT_TRUE(wait_for(link, [&] { return !link.is_sending(); }));
  }
  EXPECT_EQ(chip.requests(), all);
  EXPECT_TRUE(chip.received().empty());
}

TEST_F(FtdiLinkTest, BytesArriveAsSent) {
  falcon.plug();
  FtdiLink link;
  ASSERT_EQ(link.open(), LinkFault::none);
  chip.set_echo(false);
  Bytes all;
  for (std::size_t size = 1; size <= 64; ++size) {
    const Bytes bytes = numbered(size, static_cast<int>(size));
    send(link, bytes);
    all.insert(all.end(), bytes.begin(), bytes.end());
  }
  ASSERT_TRUE(wait_for(link, [&] { return !link.is_sending(); }));
  EXPECT_EQ(chip.received(), all);
  EXPECT_EQ(link.counters().bytes_out, all.size());
  EXPECT_FALSE(link.write(numbered(65)));
}

TEST_F(FtdiLinkTest, SilenceIsNoData) {
  falcon.plug();
  FtdiLink link;
  ASSERT_EQ(link.open(), LinkFault::none);
  ASSERT_TRUE(wait_for(link, [&] { return link.counters().status_packets >= 5; }));
  Bytes some(10);
  EXPECT_EQ(link.read(some), 0U);
  EXPECT_EQ(link.counters().bytes_in, 0U);
  EXPECT_EQ(link.modem_status(), 0x01);
}

// What was sent in packets of every size comes out as one stream.
TEST_F(FtdiLinkTest, StatusBytesAreTakenOutOfEveryPacket) {
  falcon.plug();
  FtdiLink link;
  ASSERT_EQ(link.open(), LinkFault::none);
  chip.set_echo(false);
  Bytes all;
  std::uint8_t next = 0;
  for (const std::size_t payload :
       {62U, 62U, 62U, 5U, 0U, 1U, 62U, 0U, 61U, 62U, 62U, 62U, 62U, 62U, 62U, 62U, 62U, 3U}) {
    Bytes packet{0x11, 0x60};
    for (std::size_t i = 0; i < payload; ++i) packet.push_back(next++);
    all.insert(all.end(), packet.begin() + 2, packet.end());
    chip.queue(packet);
  }
  send(link, {0});
  EXPECT_EQ(receive(link, all.size()), all);
  EXPECT_GE(falcon.most_packets_in_a_transfer(), 4U);
  EXPECT_EQ(link.counters().bytes_in, all.size());
  EXPECT_EQ(link.counters().discarded_bytes, 0U);
}

TEST_F(FtdiLinkTest, TellsWhatTheChipSaysOfItsLines) {
  falcon.plug();
  FtdiLink link;
  ASSERT_EQ(link.open(), LinkFault::none);
  chip.set_echo(false);
  for (const std::uint8_t errors : Bytes{0x62, 0x64, 0x68, 0x60, 0x6E}) chip.queue({0x11, errors, 'x'});
  send(link, {0});
  EXPECT_EQ(receive(link, 5), Bytes(5, 'x'));
  EXPECT_EQ(link.counters().line_errors, 4U);
}

TEST_F(FtdiLinkTest, KeepsTheNewestOfWhatNobodyTakes) {
  falcon.plug();
  FtdiLink link;
  ASSERT_EQ(link.open(), LinkFault::none);
  chip.set_echo(false);
  for (int i = 0; i < 400; ++i) {
    Bytes packet(64, static_cast<std::uint8_t>(i < 399 ? 'o' : 'n'));
    packet[0] = 0x01;
    packet[1] = 0x60;
    chip.queue(packet);
  }
  send(link, {0});
  ASSERT_TRUE(wait_for(link, [&] { return link.counters().bytes_in == 400U * 62U; }));
  Bytes kept(400 * 62);
  kept.resize(link.read(kept));
  EXPECT_EQ(link.counters().discarded_bytes + kept.size(), 400U * 62U);
  EXPECT_GT(link.counters().discarded_bytes, 0U);
  EXPECT_EQ(Bytes(kept.end() - 62, kept.end()), Bytes(62, 'n'));
}

TEST_F(FtdiLinkTest, BytesComeBackInOrder) {
  falcon.plug();
  FtdiLink link;
  ASSERT_EQ(link.open(), LinkFault::none);
  const auto start = std::chrono::steady_clock::now();
  constexpr int exchanges = 2000;
  for (int i = 0; i < exchanges; ++i) {
    const Bytes frame = numbered(16, i);
    send(link, frame);
    ASSERT_EQ(receive(link, 16), frame) << "exchange " << i;
  }
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  RecordProperty("exchanges_per_second", std::to_string(exchanges / took.count()));
  EXPECT_EQ(link.counters().discarded_bytes, 0U);
}

TEST_F(FtdiLinkTest, WaitsUntilTheDeadlineAndNoLess) {
  falcon.plug();
  FtdiLink link;
  ASSERT_EQ(link.open(), LinkFault::none);
  const std::uint64_t calls_before = link.counters().library_calls;
  for (const std::int64_t wait_ns : {-1 * ms, 0 * ms, ms / 3, 30 * ms}) {
    const std::int64_t deadline_ns = link.now_ns() + wait_ns;
    link.wait_until(deadline_ns);
    EXPECT_GE(link.now_ns(), deadline_ns);
  }
  EXPECT_LT(link.counters().library_calls - calls_before, 60U) << "it ran in a circle";
}

// A driver that looks for a device now and then must not run in a circle meanwhile.
TEST_F(FtdiLinkTest, WaitsUntilTheDeadlineWithoutADeviceToo) {
  FtdiLink link;
  for (const bool was_open : {false, true}) {
    if (was_open) {
      falcon.plug();
      ASSERT_EQ(link.open(), LinkFault::none);
      falcon.unplug();
      wait_for(link, [&] { return link.fault() != LinkFault::none; });
    }
    const std::int64_t deadline_ns = link.now_ns() + 20 * ms;
    link.wait_until(deadline_ns);
    EXPECT_GE(link.now_ns(), deadline_ns);
  }
}

TEST_F(FtdiLinkTest, OnlyOneProgramHasIt) {
  falcon.plug();
  FtdiLink first;
  ASSERT_EQ(first.open(), LinkFault::none);
  FtdiLink second;
  EXPECT_EQ(second.open(), LinkFault::busy);
  first.close();
  EXPECT_EQ(second.open(), LinkFault::none);
  send(second, {1, 2, 3});
  EXPECT_EQ(receive(second, 3), (Bytes{1, 2, 3}));
}

TEST_F(FtdiLinkTest, SaysWhenItMayNotBeOpened) {
  falcon.plug();
  falcon.set_mode(0);
  FtdiLink link;
  {
    const OrdinaryUser without_root;
    EXPECT_EQ(link.open(), LinkFault::not_allowed);
    const UsbSearch search = list_falcons(falcon_usb_id);
    ASSERT_EQ(search.devices.size(), 1U);
    EXPECT_FALSE(search.devices[0].may_open);
    EXPECT_EQ(search.devices[0].open_error, EACCES);
    EXPECT_EQ(search.devices[0].serial, "");
  }
  falcon.set_mode(0600);
  EXPECT_EQ(link.open(), LinkFault::none);
}

TEST_F(FtdiLinkTest, ListsWhatIsOnTheBus) {
  EXPECT_TRUE(list_falcons(falcon_usb_id).has_usb);  // the hub
  EXPECT_TRUE(list_falcons(falcon_usb_id).devices.empty());
  falcon.plug();
  falcon.set_mode(0620);
  const UsbSearch search = list_falcons(falcon_usb_id);
  ASSERT_EQ(search.devices.size(), 1U);
  const UsbDeviceFound& found = search.devices[0];
  EXPECT_EQ(found.bus, 1);
  EXPECT_EQ(found.node, falcon.node());
  EXPECT_TRUE(found.may_open);
  EXPECT_EQ(found.open_error, 0);
  EXPECT_TRUE(found.has_node);
  EXPECT_EQ(found.owner, geteuid());
  EXPECT_EQ(found.mode & 0777U, 0620U);
  EXPECT_EQ(found.serial, "12PZ657E");
  EXPECT_TRUE(list_falcons({0x0403, 0x6001}).devices.empty());
}

TEST_F(FtdiLinkTest, WaitsForADeviceThatWasJustPluggedIn) {
  falcon.plug();
  falcon.delay_claims(3);
  FtdiLink link;
  EXPECT_EQ(link.open(), LinkFault::none);
}

TEST_F(FtdiLinkTest, GivesUpOnADeviceThatNeverGetsReady) {
  falcon.plug();
  falcon.delay_claims(1000);
  FtdiLink link;
  EXPECT_EQ(link.open(), LinkFault::broken);
}

TEST_F(FtdiLinkTest, GetsOverTransfersThatFail) {
  falcon.plug();
  FtdiLink link;
  ASSERT_EQ(link.open(), LinkFault::none);
  for (const int error : {EPROTO, EOVERFLOW}) {
    falcon.fail_in(4, error);
    send(link, {1, 2, 3});
    EXPECT_EQ(receive(link, 3), (Bytes{1, 2, 3})) << error;
    ASSERT_TRUE(wait_for(link, [&] { return falcon.transfers_pending() == 4; }));
  }
  EXPECT_EQ(link.fault(), LinkFault::none);
}

TEST_F(FtdiLinkTest, AnEndpointThatHaltsIsBrokenAndOpenedAnew) {
  falcon.plug();
  FtdiLink link;
  ASSERT_EQ(link.open(), LinkFault::none);
  falcon.fail_in(4, EPIPE);
  EXPECT_TRUE(wait_for(link, [&] { return link.fault() == LinkFault::broken; }));
  EXPECT_EQ(link.open(), LinkFault::none);
  send(link, {1, 2, 3});
  EXPECT_EQ(receive(link, 3), (Bytes{1, 2, 3}));
}

TEST_F(FtdiLinkTest, GivesUpWhenAllTransfersFail) {
  falcon.plug();
  FtdiLink link;
  ASSERT_EQ(link.open(), LinkFault::none);
  falcon.fail_in(1'000'000, EPIPE);
  wait_for(link, [&] { return link.fault() != LinkFault::none; });
  EXPECT_EQ(link.fault(), LinkFault::broken);
  link.close();
  EXPECT_EQ(link.fault(), LinkFault::broken) << "until it is opened again";
  falcon.fail_in(0, 0);
  EXPECT_EQ(link.open(), LinkFault::none);
}

TEST_F(FtdiLinkTest, ClosesWhileSomethingIsBeingSent) {
  falcon.plug();
  FtdiLink link;
  ASSERT_EQ(link.open(), LinkFault::none);
  chip.set_stuck(true);
  send(link, {1, 2, 3});
  EXPECT_TRUE(link.is_sending());
  link.close();
  EXPECT_FALSE(link.is_sending());
  EXPECT_TRUE(chip.received().empty());
}

TEST_F(FtdiLinkTest, DoesNotSendForEver) {
  falcon.plug();
  FtdiLink link;
  ASSERT_EQ(link.open(), LinkFault::none);
  chip.set_stuck(true);
  send(link, {1, 2, 3});
  EXPECT_TRUE(wait_for(link, [&] { return !link.is_sending(); }));
  chip.set_stuck(false);
  send(link, {4, 5});
  EXPECT_EQ(receive(link, 2), (Bytes{4, 5}));
}

TEST_F(FtdiLinkTest, NoticesThatItWasUnplugged) {
  falcon.plug();
  FtdiLink link;
  ASSERT_EQ(link.open(), LinkFault::none);
  chip.set_stuck(true);
  send(link, {1, 2, 3});
  ASSERT_TRUE(wait_for(link, [&] { return falcon.transfers_pending() == 5; }));
  falcon.unplug();
  wait_for(link, [&] { return link.fault() != LinkFault::none; });
  EXPECT_EQ(link.fault(), LinkFault::unplugged);
  EXPECT_FALSE(link.write(Bytes{1}));
  EXPECT_FALSE(link.request({}));
  link.close();
  EXPECT_EQ(link.fault(), LinkFault::unplugged);
  EXPECT_EQ(link.serial(), "12PZ657E");
  EXPECT_EQ(link.open(), LinkFault::absent);
}

TEST_F(FtdiLinkTest, ClosesAfterItWasUnpluggedUnseen) {
  falcon.plug();
  FtdiLink link;
  ASSERT_EQ(link.open(), LinkFault::none);
  falcon.unplug();
  link.close();
  EXPECT_EQ(link.open(), LinkFault::absent);
}

TEST_F(FtdiLinkTest, ComesBackEachTimeItIsPluggedIn) {
  FtdiLink link;
  for (int cycle = 0; cycle < 20; ++cycle) {
    falcon.plug();
    ASSERT_EQ(link.open(), LinkFault::none) << "cycle " << cycle;
    send(link, numbered(16, cycle));
    ASSERT_EQ(receive(link, 16), numbered(16, cycle)) << "cycle " << cycle;
    falcon.unplug();
    wait_for(link, [&] { return link.fault() != LinkFault::none; });
    ASSERT_EQ(link.fault(), LinkFault::unplugged) << "cycle " << cycle;
    if (cycle % 2 == 0) link.close();  // else open() does
  }
}

TEST_F(FtdiLinkTest, SendsAtOnceWithoutItsOwnThread) {
  falcon.plug();
  FtdiLink link;
  link.send_at_once(Bytes{9});  // not open: nothing
  ASSERT_EQ(link.open(), LinkFault::none);
  chip.set_stuck(true);
  send(link, {1, 2, 3});
  std::thread wire([this] {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    chip.set_stuck(false);
  });
  // It gives up after 20 ms, in which this machine may not get round to the rest.
  const std::int64_t end_ns = link.now_ns() + patience;
  while (chip.received().size() < 5 && link.now_ns() < end_ns) link.send_at_once(Bytes{7, 8});
  wire.join();
  // What the kernel has already goes first.
  EXPECT_EQ(chip.received(), (Bytes{1, 2, 3, 7, 8}));
}

// The number of a file that was closed may be another file's at once: the emulation ends a process that uses it.
TEST_F(FtdiLinkTest, IsNotClosedUnderSomebodyWhoSendsAtOnce) {
  falcon.plug();
  FtdiLink link;
  for (int round = 0; round < 30; ++round) {
    ASSERT_EQ(link.open(), LinkFault::none) << round;
    std::atomic<bool> has_begun = false;
    std::atomic<bool> is_over = false;
    std::thread emergency([&] {
      while (!is_over) {
        link.send_at_once(Bytes{7});
        has_begun = true;
      }
    });
    while (!has_begun) std::this_thread::yield();
    link.close();
    is_over = true;
    emergency.join();
  }
}

// A program that fails an assertion has no thread and no heap to rely on.
TEST_F(FtdiLinkTest, SendsFromTheHandlerOfADyingProgram) {
  falcon.plug();
  const Outcome outcome = run_program(DYING_PROGRAM, std::vector<std::string>{});
  EXPECT_EQ(outcome.exit_code, 128 + SIGABRT) << outcome.err;
  EXPECT_TRUE(chip.wait_for_bytes(16, std::chrono::minutes(2)));
  const std::string text = "<AAAAAAAAAAAAAA>";
  EXPECT_EQ(chip.received(), Bytes(text.begin(), text.end()));
  // And it has let go of the device.
  FtdiLink link;
  EXPECT_EQ(link.open(), LinkFault::none);
}

}  // namespace
}  // namespace ghostforce::ftdi_link_test
