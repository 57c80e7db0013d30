// The Falcon's link with the real libusb, against devices that exist only at the kernel's boundary.
#include "device/falcon/ftdi_link.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "tests/emulation/emulated_usb_device.h"
#include "tests/emulation/recording_chip.h"

namespace ghostforce {
namespace {

using Bytes = std::vector<std::uint8_t>;
constexpr std::int64_t ms = 1'000'000;
// On a machine that is busy with other things.
constexpr std::int64_t patience = 3000 * ms;

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
}

}  // namespace
}  // namespace ghostforce
