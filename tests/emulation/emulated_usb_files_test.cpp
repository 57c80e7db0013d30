// Several programs that have the emulated device's file open at once: who has the interface, who may take it away, and
// what becomes of the transfers under way. What is expected here is what the kernel does in drivers/usb/core/devio.c,
// whose functions the comments name.
#include <fcntl.h>
#include <linux/usbdevice_fs.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "device/input/monotonic_clock.h"
#include "tests/emulation/emulated_usb_device.h"
#include "tests/emulation/recording_chip.h"

namespace ghostforce::emulated_usb_files_test {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::int64_t ms = 1'000'000;
constexpr std::int64_t patience_ns = 20'000 * ms;  // with a machine that is busy with other things

// The device's file, as one program has it open. What a call returns: 0, or an errno.
class OpenNode {
 public:
  explicit OpenNode(const std::string& node) : file_(::open(node.c_str(), O_RDWR | O_CLOEXEC)) {}
  OpenNode(const OpenNode&) = delete;
  OpenNode& operator=(const OpenNode&) = delete;
  ~OpenNode() { close(); }
  void close() {
    if (file_ >= 0) ::close(file_);
    file_ = -1;
  }

  template <typename Argument>
  int call(unsigned long request, Argument* argument) {
    return ioctl(file_, request, argument) < 0 ? errno : 0;
  }
  int claim(unsigned int interface = 0) { return call(USBDEVFS_CLAIMINTERFACE, &interface); }
  int release(unsigned int interface = 0) { return call(USBDEVFS_RELEASEINTERFACE, &interface); }
  int clear_halt(unsigned int endpoint) { return call(USBDEVFS_CLEAR_HALT, &endpoint); }

  int disconnect_and_claim(unsigned int flags = 0, const char* driver = "") {
    usbdevfs_disconnect_claim order{};
    order.flags = flags;
    std::strncpy(order.driver, driver, sizeof order.driver - 1);
    return call(USBDEVFS_DISCONNECT_CLAIM, &order);
  }
  int order_driver(int code) {
    usbdevfs_ioctl order{0, code, nullptr};
    return call(USBDEVFS_IOCTL, &order);
  }
  // Of the interface; empty: none.
  std::string driver() {
    usbdevfs_getdriver answer{};
    return call(USBDEVFS_GETDRIVER, &answer) == 0 ? answer.driver : "";
  }

  int send_now(Bytes bytes, unsigned int timeout_ms = 2000) {
    usbdevfs_bulktransfer transfer{0x02, static_cast<unsigned int>(bytes.size()), timeout_ms, bytes.data()};
    return call(USBDEVFS_BULK, &transfer);
  }
  // Empty: nothing, within two seconds.
  Bytes listen_now() {
    Bytes bytes(64);
    usbdevfs_bulktransfer transfer{0x81, static_cast<unsigned int>(bytes.size()), 2000, bytes.data()};
    bytes.resize(static_cast<std::size_t>(std::max(ioctl(file_, USBDEVFS_BULK, &transfer), 0)));
    return bytes;
  }
  // How many bytes, or -1 and errno.
  int control(std::uint8_t type, std::uint8_t request, std::uint16_t value, Bytes& bytes, unsigned int timeout_ms = 0) {
    usbdevfs_ctrltransfer transfer{type,       request,     value, 0, static_cast<std::uint16_t>(bytes.size()),
                                   timeout_ms, bytes.data()};
    return ioctl(file_, USBDEVFS_CONTROL, &transfer);
  }
  int ask_vendor(std::uint8_t request, unsigned int timeout_ms = 2000) {
    Bytes none;
    return control(0x40, request, 1, none, timeout_ms) < 0 ? errno : 0;
  }

  // A URB that is not over yet.
  int submit(unsigned char endpoint, const Bytes& bytes) {
    bytes_ = bytes;
    std::memset(urb_.get(), 0, sizeof *urb_);
    urb_->type = USBDEVFS_URB_TYPE_BULK;
    urb_->endpoint = endpoint;
    urb_->buffer = bytes_.data();
    urb_->buffer_length = static_cast<int>(bytes_.size());
    return call(USBDEVFS_SUBMITURB, urb_.get());
  }
  int listen() { return submit(0x81, Bytes(64)); }
  int discard(const OpenNode& of) { return call(USBDEVFS_DISCARDURB, of.urb_.get()); }
  // How it ended.
  int status() {
    for (const std::int64_t end_ns = monotonic_ns() + patience_ns; monotonic_ns() < end_ns;) {
      void* over = nullptr;
      const int error = call(USBDEVFS_REAPURBNDELAY, &over);
      if (error == 0) return -urb_->status;
      if (error != EAGAIN) return error;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    ADD_FAILURE() << "no transfer gets to its end";
    return -1;
  }

 private:
  int file_;
  Bytes bytes_;
  std::unique_ptr<usbdevfs_urb> urb_ = std::make_unique<usbdevfs_urb>();  // ends in an array without a length
};

class EmulatedUsbFilesTest : public testing::Test {
 protected:
  EmulatedUsbFilesTest() {
    falcon.plug();
    mine = std::make_unique<OpenNode>(falcon.node());
    other = std::make_unique<OpenNode>(falcon.node());
  }
  // A transfer of mine that does not end by itself.
  void wait_with_mine() {
    falcon.inject(usb_fault("in-nak"));
    ASSERT_EQ(mine->claim(), 0);
    ASSERT_EQ(mine->listen(), 0);
  }

  TestBed bed;
  RecordingChip chip{1 * ms};
  EmulatedUsbDevice falcon{bed, chip, "12PZ657E"};
  std::unique_ptr<OpenNode> mine;
  std::unique_ptr<OpenNode> other;
};

// claimintf(), usb_driver_claim_interface()
TEST_F(EmulatedUsbFilesTest, AClaimBelongsToAnOpenFile) {
  EXPECT_EQ(mine->driver(), "");
  EXPECT_EQ(mine->claim(), 0);
  EXPECT_EQ(mine->claim(), 0) << "it has it";
  EXPECT_EQ(other->driver(), "usbfs");
  EXPECT_EQ(other->claim(), EBUSY);
  EXPECT_EQ(other->release(), EINVAL);
  EXPECT_EQ(mine->claim(1), ENOENT) << "there is no other interface";
  EXPECT_EQ(mine->release(), 0);
  EXPECT_EQ(mine->release(), EINVAL);
  EXPECT_EQ(other->claim(), 0);
  EXPECT_EQ(falcon.times_taken_by(getpid()), 2U);
  EXPECT_EQ(falcon.times_taken_by(1), 0U);
}

// checkintf()
TEST_F(EmulatedUsbFilesTest, ATransferClaimsWhatNobodyHas) {
  EXPECT_EQ(other->send_now({1}), 0);
  EXPECT_EQ(mine->send_now({2}), EBUSY);
  EXPECT_EQ(mine->listen(), EBUSY);
  EXPECT_EQ(mine->submit(0x02, {3}), EBUSY);
  EXPECT_EQ(mine->clear_halt(0x81), EBUSY);
  EXPECT_EQ(other->release(), 0) << "it had claimed it";
  EXPECT_EQ(mine->clear_halt(0x81), 0);
  EXPECT_EQ(other->claim(), EBUSY);
  EXPECT_EQ(chip.received(), Bytes{1});
}

// usbdev_release()
TEST_F(EmulatedUsbFilesTest, ClosingReleasesAndCancels) {
  wait_with_mine();
  EXPECT_EQ(other->claim(), EBUSY);
  mine->close();
  EXPECT_EQ(other->claim(), 0);
  EXPECT_EQ(falcon.transfers_pending(), 0U);
}

// proc_disconnect_claim(), usb_unbind_interface(), which disables the endpoints first
TEST_F(EmulatedUsbFilesTest, TheInterfaceIsTakenAwayFromWhoeverHasIt) {
  wait_with_mine();
  EXPECT_EQ(other->disconnect_and_claim(), 0);
  EXPECT_EQ(mine->status(), ESHUTDOWN);
  EXPECT_EQ(mine->listen(), EBUSY);
  EXPECT_EQ(mine->send_now({1}), EBUSY);
  EXPECT_EQ(mine->claim(), EBUSY);
  EXPECT_EQ(mine->release(), EINVAL) << "it is no longer its own";
  EXPECT_EQ(other->send_now({2}), 0);
  EXPECT_EQ(chip.received(), Bytes{2});
  other->close();
  EXPECT_EQ(mine->send_now({3}), 0) << "claimed anew, unasked, once nobody has it";
  EXPECT_EQ(chip.received(), (Bytes{2, 3}));
}

TEST_F(EmulatedUsbFilesTest, TheInterfaceIsSparedByTheNameOfItsDriver) {
  EXPECT_EQ(other->disconnect_and_claim(USBDEVFS_DISCONNECT_CLAIM_IF_DRIVER, "ftdi_sio"), 0) << "there is none";
  EXPECT_EQ(mine->disconnect_and_claim(USBDEVFS_DISCONNECT_CLAIM_IF_DRIVER, "ftdi_sio"), EBUSY);
  EXPECT_EQ(mine->disconnect_and_claim(USBDEVFS_DISCONNECT_CLAIM_EXCEPT_DRIVER, "usbfs"), EBUSY);
  EXPECT_EQ(other->send_now({1}), 0);
  EXPECT_EQ(mine->disconnect_and_claim(USBDEVFS_DISCONNECT_CLAIM_IF_DRIVER, "usbfs"), 0);
  EXPECT_EQ(other->send_now({2}), EBUSY);
}

// proc_ioctl()
TEST_F(EmulatedUsbFilesTest, TheDriverIsDisconnectedWhicheverItIs) {
  EXPECT_EQ(other->order_driver(USBDEVFS_DISCONNECT), ENODATA);
  EXPECT_EQ(other->order_driver(USBDEVFS_CONNECT), 0);
  wait_with_mine();
  EXPECT_EQ(other->order_driver(USBDEVFS_CONNECT), EBUSY);
  EXPECT_EQ(other->order_driver(USBDEVFS_DISCONNECT), 0);
  EXPECT_EQ(mine->status(), ESHUTDOWN);
  EXPECT_EQ(other->driver(), "");
  EXPECT_EQ(other->claim(), 0);
}

// check_ctrlrecip(), proc_control()
TEST_F(EmulatedUsbFilesTest, RequestsToTheDeviceNeedNoClaim) {
  ASSERT_EQ(mine->claim(), 0);
  EXPECT_EQ(other->ask_vendor(3), 0);
  ASSERT_EQ(chip.requests().size(), 1U);
  EXPECT_EQ(chip.requests()[0], (VendorRequest{3, 1, 0}));
  Bytes text(255);
  EXPECT_EQ(other->control(0x80, 6, 0x0303, text), 18) << "the serial number";
  EXPECT_EQ(text[2], '1');
  Bytes none;
  EXPECT_EQ(other->control(0x01, 11, 0, none), -1);
  EXPECT_EQ(errno, EBUSY) << "one to an interface does";
  falcon.inject(usb_fault("latency-refused"));
  EXPECT_EQ(other->ask_vendor(9), EPIPE);
  EXPECT_EQ(other->ask_vendor(9), 0);
  falcon.inject(usb_fault("control-nak"));
  EXPECT_EQ(other->ask_vendor(3, 20), ETIMEDOUT);
  EXPECT_EQ(falcon.transfers_pending(), 0U);
  falcon.inject(usb_fault("unplugged"));
  EXPECT_EQ(other->ask_vendor(3), ENODEV);
}

// proc_bulk(): a transfer of its own, in its turn at the endpoint
TEST_F(EmulatedUsbFilesTest, ACallThatWaitsHasItsTurn) {
  chip.set_echo(false);
  chip.set_stuck(true);
  EXPECT_EQ(mine->submit(0x02, {1}), 0);
  EXPECT_EQ(mine->send_now({2}, 20), ETIMEDOUT);
  EXPECT_EQ(falcon.transfers_pending(), 1U) << "it has been cancelled";
  EXPECT_EQ(mine->discard(*mine), 0);
  chip.set_stuck(false);
  EXPECT_EQ(mine->send_now({3}), 0);
  EXPECT_EQ(chip.received(), Bytes{3});
  chip.queue({0x01, 0x60, 7});
  Bytes heard;
  while ((heard = mine->listen_now()).size() == 2) {
  }
  EXPECT_EQ(heard, (Bytes{0x01, 0x60, 7}));
}

TEST_F(EmulatedUsbFilesTest, ACallThatWaitsEndsWhenTheInterfaceIsTakenAway) {
  falcon.inject(usb_fault("out-nak"));
  ASSERT_EQ(mine->claim(), 0);
  int error = -1;
  std::thread waits([&] { error = mine->send_now({1}, 10'000); });
  while (falcon.transfers_pending() == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_EQ(other->disconnect_and_claim(), 0);
  waits.join();
  EXPECT_EQ(error, ESHUTDOWN);
}

// async_getpending()
TEST_F(EmulatedUsbFilesTest, ATransferIsCancelledOnlyByItsOwnFile) {
  wait_with_mine();
  EXPECT_EQ(other->discard(*mine), EINVAL);
  EXPECT_EQ(mine->discard(*mine), 0);
  EXPECT_EQ(mine->status(), ENOENT);
}

// usb_reset_device(): usbfs is unbound
TEST_F(EmulatedUsbFilesTest, AResetLeavesTheInterfaceToNobodyAndTheChipAsNew) {
  wait_with_mine();
  EXPECT_EQ(chip.power_ups(), 1) << "when it was plugged in";
  EXPECT_EQ(other->call(USBDEVFS_RESET, static_cast<int*>(nullptr)), 0);
  EXPECT_EQ(mine->status(), ESHUTDOWN);
  EXPECT_EQ(other->driver(), "");
  EXPECT_EQ(chip.power_ups(), 2);
  falcon.unplug();
  falcon.plug();
  EXPECT_EQ(chip.power_ups(), 3);
}

// proc_setconfig()
TEST_F(EmulatedUsbFilesTest, NobodySetsTheConfigurationOfADeviceInUse) {
  int configuration = 1;
  EXPECT_EQ(other->call(USBDEVFS_SETCONFIGURATION, &configuration), 0);
  ASSERT_EQ(mine->claim(), 0);
  EXPECT_EQ(other->call(USBDEVFS_SETCONFIGURATION, &configuration), EBUSY);
  usbdevfs_setinterface order{0, 0};
  EXPECT_EQ(other->call(USBDEVFS_SETINTERFACE, &order), EBUSY);
  EXPECT_EQ(mine->call(USBDEVFS_SETINTERFACE, &order), 0);
}

}  // namespace
}  // namespace ghostforce::emulated_usb_files_test
