// The emulated device with each of its faults, through the calls of usbfs alone, without any library or driver: what is
// expected here is what the kernel's documentation and the USB specification say.
#include "tests/emulation/emulated_usb_device.h"

#include <fcntl.h>
#include <linux/usbdevice_fs.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "device/input/monotonic_clock.h"
#include "tests/emulation/recording_chip.h"

namespace ghostforce::emulated_usb_device_test {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::int64_t ms = 1'000'000;
constexpr std::int64_t patience_ns = 20'000 * ms;  // with a machine that is busy with other things

// A URB and its bytes.
struct Transfer {
  Bytes bytes;
  std::unique_ptr<usbdevfs_urb> urb = std::make_unique<usbdevfs_urb>();  // ends in an array without a length

  Transfer(unsigned char type, unsigned char endpoint, Bytes content) : bytes(std::move(content)) {
    urb->type = type;
    urb->endpoint = endpoint;
    urb->buffer = bytes.data();
    urb->buffer_length = static_cast<int>(bytes.size());
  }
};

class EmulatedUsbDeviceTest : public testing::Test {
 protected:
  EmulatedUsbDeviceTest() {
    falcon.plug();
    reopen();
  }
  ~EmulatedUsbDeviceTest() override { ::close(file); }

  void reopen() {
    if (file >= 0) ::close(file);
    file = ::open(falcon.node().c_str(), O_RDWR | O_CLOEXEC);
    unsigned int interface = 0;
    EXPECT_EQ(call(USBDEVFS_CLAIMINTERFACE, &interface), 0);
  }

  // 0, or an errno.
  template <typename Argument>
  int call(unsigned long request, Argument* argument) {
    return ioctl(file, request, argument) < 0 ? errno : 0;
  }

  Transfer& submit(unsigned char type, unsigned char endpoint, const Bytes& bytes) {
    transfers.push_back(std::make_unique<Transfer>(type, endpoint, bytes));
    EXPECT_EQ(call(USBDEVFS_SUBMITURB, transfers.back()->urb.get()), 0);
    return *transfers.back();
  }
  Transfer& send(const Bytes& bytes) { return submit(USBDEVFS_URB_TYPE_BULK, 0x02, bytes); }
  Transfer& listen() { return submit(USBDEVFS_URB_TYPE_BULK, 0x81, Bytes(64)); }
  Transfer& ask(std::uint8_t request) {
    return submit(USBDEVFS_URB_TYPE_CONTROL, 0, {0x40, request, 1, 0, 0, 0, 0, 0});
  }

  // The status of this transfer, which is the next that is over.
  int status_of(const Transfer& transfer) {
    const std::int64_t end_ns = monotonic_ns() + patience_ns;
    while (monotonic_ns() < end_ns) {
      void* over = nullptr;
      const int error = call(USBDEVFS_REAPURBNDELAY, &over);
      if (error == EAGAIN) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        continue;
      }
      EXPECT_EQ(error, 0);
      EXPECT_EQ(over, transfer.urb.get());
      return -transfer.urb->status;
    }
    ADD_FAILURE() << "no transfer gets to its end";
    return -1;
  }
  bool is_any_over() {
    void* over = nullptr;
    return call(USBDEVFS_REAPURBNDELAY, &over) == 0;
  }

  int send_now(Bytes bytes, unsigned int timeout_ms = 20) {
    usbdevfs_bulktransfer transfer{0x02, static_cast<unsigned int>(bytes.size()), timeout_ms, bytes.data()};
    return call(USBDEVFS_BULK, &transfer);
  }
  int clear_halt(unsigned int endpoint) { return call(USBDEVFS_CLEAR_HALT, &endpoint); }

  TestBed bed;
  RecordingChip chip{1 * ms};
  EmulatedUsbDevice falcon{bed, chip, "12PZ657E"};
  int file = -1;
  std::vector<std::unique_ptr<Transfer>> transfers;
};

TEST(UsbFault, HasOneNameEachAndDoesSomething) {
  for (const UsbFaultKind& kind : usb_fault_catalog()) {
    EXPECT_NE(usb_fault(kind.name), UsbFault{}) << kind.name;
    EXPECT_EQ(std::ranges::count(usb_fault_catalog(), kind.name, &UsbFaultKind::name), 1) << kind.name;
    EXPECT_TRUE(kind.sentence.ends_with('.')) << kind.name;
  }
  EXPECT_THROW(usb_fault("nonsense"), std::invalid_argument);
}

// As a program leaves it that ends, or opens its device anew, in the moment in which it is told of a device.
TEST(TestBedTest, AListenerThatHasJustGoneIsToldNothing) {
  const TestBed bed;
  std::array<int, 2> ends{};
  ASSERT_EQ(socketpair(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0, ends.data()), 0);
  ::close(ends[1]);
  std::string words = "add";
  iovec piece{words.data(), words.size()};
  msghdr message{};
  message.msg_iov = &piece;
  message.msg_iovlen = 1;
  EXPECT_EQ(sendmsg(ends[0], &message, 0), 3) << "umockdev would abort";
  ::close(ends[0]);
}

TEST_F(EmulatedUsbDeviceTest, OneTransferFailsAndTheNextIsWell) {
  struct Case {
    std::string_view fault;
    int error;
  };
  for (const Case& one : {Case{"in-stall", EPIPE}, Case{"in-error", EPROTO}, Case{"in-babble", EOVERFLOW}}) {
    falcon.inject(usb_fault(one.fault));
    EXPECT_EQ(status_of(listen()), one.error) << one.fault;
    EXPECT_EQ(status_of(listen()), 0) << one.fault;
  }
  for (const Case& one : {Case{"out-stall", EPIPE}, Case{"out-error", EPROTO}}) {
    falcon.inject(usb_fault(one.fault));
    EXPECT_EQ(status_of(send({1})), one.error) << one.fault;
    EXPECT_EQ(status_of(send({2})), 0) << one.fault;
  }
  EXPECT_EQ(chip.received(), (Bytes{2, 2})) << "what failed has not arrived";
}

TEST_F(EmulatedUsbDeviceTest, BurstsAreAsLongAsTheySay) {
  falcon.inject(usb_fault("in-errors-40"));
  for (int i = 0; i < 40; ++i) ASSERT_EQ(status_of(listen()), EPROTO) << i;
  EXPECT_EQ(status_of(listen()), 0);
  falcon.inject(usb_fault("out-errors-40"));
  for (int i = 0; i < 39; ++i) ASSERT_EQ(status_of(send({1})), EPROTO) << i;
  EXPECT_EQ(send_now({1}), EPROTO) << "past the queue as well";
  EXPECT_EQ(send_now({2}), 0);
  EXPECT_EQ(chip.received(), Bytes{2});
  falcon.inject(usb_fault("in-errors-200"));
  EXPECT_EQ(status_of(listen()), EILSEQ);
  falcon.inject({});
  EXPECT_EQ(status_of(listen()), 0) << "taken away";
}

TEST_F(EmulatedUsbDeviceTest, AHaltStaysUntilItIsCleared) {
  falcon.inject(usb_fault("both-halt"));
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(status_of(send({1})), EPIPE);
    EXPECT_EQ(status_of(listen()), EPIPE);
    EXPECT_EQ(send_now({1}), EPIPE);
  }
  falcon.inject({});
  EXPECT_EQ(status_of(listen()), EPIPE) << "what caused it has gone, and the halt has not";
  reopen();
  EXPECT_EQ(status_of(listen()), EPIPE) << "another program finds it so";
  EXPECT_EQ(clear_halt(0x81), 0);
  EXPECT_EQ(status_of(listen()), 0);
  EXPECT_EQ(status_of(send({1})), EPIPE) << "each endpoint has its own";
  EXPECT_EQ(clear_halt(0x02), 0);
  EXPECT_EQ(status_of(send({2})), 0);
  EXPECT_EQ(chip.received(), Bytes{2});
  EXPECT_EQ(falcon.halts_cleared(), 2U);
  EXPECT_EQ(clear_halt(0x05), ENOENT);
}

TEST_F(EmulatedUsbDeviceTest, AnEndpointHaltsAgainAndAgain) {
  falcon.inject(usb_fault("in-halts-again"));
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(clear_halt(0x81), 0);
    EXPECT_EQ(status_of(listen()), EPIPE);
  }
  falcon.inject({});
  EXPECT_EQ(status_of(listen()), EPIPE);
  EXPECT_EQ(clear_halt(0x81), 0);
  EXPECT_EQ(status_of(listen()), 0);
}

TEST_F(EmulatedUsbDeviceTest, AHaltEndsWithTheCableOrAReset) {
  falcon.inject(usb_fault("in-halt"));
  falcon.unplug();
  falcon.plug();
  reopen();
  EXPECT_EQ(status_of(listen()), 0);
  falcon.inject({});
  falcon.inject(usb_fault("in-halt"));
  EXPECT_EQ(ioctl(file, USBDEVFS_RESET, nullptr), 0);
  EXPECT_EQ(status_of(listen()), 0);
}

TEST_F(EmulatedUsbDeviceTest, TransfersThatWaitStallTooWhenTheEndpointHalts) {
  falcon.inject(usb_fault("in-nak"));
  const Transfer& first = listen();
  const Transfer& second = listen();
  falcon.inject(usb_fault("in-halt"));
  EXPECT_EQ(status_of(first), EPIPE);
  EXPECT_EQ(status_of(second), EPIPE);
}

TEST_F(EmulatedUsbDeviceTest, NothingComesWhileItAnswersNak) {
  falcon.inject(usb_fault("in-nak"));
  Transfer& waits = listen();
  const Transfer& sent = send({1, 2});
  EXPECT_EQ(status_of(sent), 0) << "the other endpoint is well";
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_FALSE(is_any_over());
  EXPECT_EQ(call(USBDEVFS_DISCARDURB, waits.urb.get()), 0);
  EXPECT_EQ(status_of(waits), ENOENT);
  const Transfer& next = listen();
  falcon.inject({});
  EXPECT_EQ(status_of(next), 0);
}

TEST_F(EmulatedUsbDeviceTest, NothingGoesWhileItAnswersNak) {
  falcon.inject(usb_fault("out-nak"));
  const Transfer& waits = send({1});
  EXPECT_EQ(status_of(listen()), 0) << "the other endpoint is well";
  const std::int64_t start_ns = monotonic_ns();
  EXPECT_EQ(send_now({2}, 20), ETIMEDOUT);
  EXPECT_GE(monotonic_ns() - start_ns, 20 * ms);
  EXPECT_TRUE(chip.received().empty());
  EXPECT_EQ(falcon.last_out().bytes, Bytes{2}) << "tried, at least";
  falcon.inject({});
  EXPECT_EQ(status_of(waits), 0);
  EXPECT_EQ(chip.received(), Bytes{1});
}

TEST_F(EmulatedUsbDeviceTest, ANakEndsByItself) {
  const std::int64_t start_ns = monotonic_ns();
  falcon.inject(usb_fault("out-nak-100ms"));
  const Transfer& waits = send({1});
  EXPECT_EQ(send_now({2}, 10'000), 0);
  EXPECT_GE(monotonic_ns() - start_ns, 100 * ms);
  EXPECT_EQ(status_of(waits), 0);
  EXPECT_EQ(chip.received(), (Bytes{1, 2})) << "in the order in which they were sent";
  falcon.inject(usb_fault("in-nak-100ms"));
  EXPECT_EQ(status_of(listen()), 0);
}

TEST_F(EmulatedUsbDeviceTest, TheControlEndpointIsSilent) {
  UsbFault silent;
  silent.control_nak_ms = EndpointFaults::for_ever;
  falcon.inject(silent);
  Transfer& given_up = ask(9);
  const Transfer& waits = ask(3);
  EXPECT_EQ(status_of(send({1})), 0) << "the other endpoints are well";
  EXPECT_EQ(call(USBDEVFS_DISCARDURB, given_up.urb.get()), 0);
  EXPECT_EQ(status_of(given_up), ENOENT);
  EXPECT_FALSE(is_any_over());
  falcon.inject({});
  EXPECT_EQ(status_of(waits), 0);
  ASSERT_EQ(chip.requests().size(), 1U);
  EXPECT_EQ(chip.requests()[0].request, 3);
}

TEST_F(EmulatedUsbDeviceTest, TheControlEndpointIsSilentForAWhile) {
  UsbFault silent;
  silent.control_nak_ms = 200;
  const std::int64_t start_ns = monotonic_ns();
  falcon.inject(silent);
  EXPECT_EQ(status_of(ask(3)), 0);
  EXPECT_GE(monotonic_ns() - start_ns, 200 * ms);
}

TEST_F(EmulatedUsbDeviceTest, TheControlEndpointIsSilentForAWhileAfterItIsTaken) {
  UsbFault silent;
  silent.control_nak_ms_when_taken = 200;
  falcon.inject(silent);
  EXPECT_EQ(status_of(ask(9)), 0) << "not yet";
  const std::uint64_t times_taken = falcon.times_taken();
  const std::int64_t start_ns = monotonic_ns();
  reopen();
  EXPECT_EQ(falcon.times_taken(), times_taken + 1);
  EXPECT_EQ(status_of(ask(9)), 0);
  EXPECT_GE(monotonic_ns() - start_ns, 200 * ms);
}

TEST_F(EmulatedUsbDeviceTest, ARequestIsRefused) {
  falcon.inject(usb_fault("latency-refused"));
  EXPECT_EQ(status_of(ask(3)), 0);
  EXPECT_EQ(status_of(ask(9)), EPIPE);
  EXPECT_EQ(status_of(ask(9)), 0) << "a stall of the control endpoint ends by itself";
  falcon.inject(usb_fault("latency-always-refused"));
  for (int i = 0; i < 5; ++i) EXPECT_EQ(status_of(ask(9)), EPIPE);
  EXPECT_EQ(status_of(ask(3)), 0);
}

// As usb_clear_halt() waits for the device.
TEST_F(EmulatedUsbDeviceTest, ClearingAHaltWaitsForTheControlEndpoint) {
  falcon.inject(usb_fault("in-halt"));
  UsbFault slow;
  slow.clear_halt_ms = 200;
  falcon.inject(slow);
  const std::int64_t start_ns = monotonic_ns();
  EXPECT_EQ(clear_halt(0x81), 0);
  EXPECT_GE(monotonic_ns() - start_ns, 200 * ms);
  EXPECT_EQ(status_of(listen()), 0);

  falcon.inject(usb_fault("in-halt"));
  UsbFault silent;
  silent.control_nak_ms = EndpointFaults::for_ever;
  falcon.inject(silent);
  EXPECT_EQ(clear_halt(0x81), ETIMEDOUT) << "after 5 s";
  EXPECT_EQ(status_of(listen()), EPIPE) << "and it has not been cleared";
}

TEST_F(EmulatedUsbDeviceTest, TransfersEndWithTheInterface) {
  falcon.inject(usb_fault("in-nak"));
  const Transfer& waits = listen();
  unsigned int interface = 0;
  EXPECT_EQ(call(USBDEVFS_RELEASEINTERFACE, &interface), 0);
  EXPECT_EQ(status_of(waits), ESHUTDOWN) << "the kernel disables its endpoints";
  EXPECT_EQ(falcon.transfers_pending(), 0U);
}

TEST_F(EmulatedUsbDeviceTest, IsUnpluggedAndPluggedIn) {
  UsbFault silent;
  silent.in.nak_ms = EndpointFaults::for_ever;
  falcon.inject(silent);
  const Transfer& waits = listen();
  falcon.inject(usb_fault("unplugged"));
  EXPECT_EQ(status_of(waits), ESHUTDOWN);
  Transfer refused(USBDEVFS_URB_TYPE_BULK, 0x02, {7});
  EXPECT_EQ(call(USBDEVFS_SUBMITURB, refused.urb.get()), ENODEV);
  EXPECT_EQ(falcon.last_out().bytes, Bytes{7}) << "tried, at least";
  EXPECT_EQ(send_now({8}), ENODEV);
  EXPECT_EQ(falcon.last_out().bytes, Bytes{8});
  EXPECT_EQ(clear_halt(0x81), ENODEV);
  falcon.inject({});
  reopen();
  EXPECT_EQ(status_of(send({9})), 0);
}

}  // namespace
}  // namespace ghostforce::emulated_usb_device_test
