#include "device/spacemouse/spacemouse_report.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <string_view>

namespace ghostforce::spacemouse_products_test {
namespace {

using namespace std::string_view_literals;

// As a SpaceMouse Wireless describes its first report: three axes of 16 bits.
constexpr std::string_view axes =
    "\x05\x01\x09\x08\xA1\x01\xA1\x00\x85\x01\x16\xA2\xFE\x26\x5E\x01\x36\x88\xFA\x46\x78\x05\x09\x30\x09\x31\x09\x32"
    "\x75\x10\x95\x03\x81\x02\xC0\xC0"sv;
constexpr std::string_view keyboard =
    "\x05\x01\x09\x06\xA1\x01\x05\x07\x19\xE0\x29\xE7\x15\x00\x25\x01\x75\x01\x95\x08\x81\x02\xC0"sv;

TEST(SpaceMouseProducts, TellWhatADeviceIsUsedFor) {
  EXPECT_TRUE(is_spacemouse(connexion_vendor, axes));
  EXPECT_TRUE(is_spacemouse(logitech_vendor, axes));
}

TEST(SpaceMouseProducts, AReceiverIsAKeyboardToo) {
  EXPECT_FALSE(is_spacemouse(connexion_vendor, keyboard));
  EXPECT_TRUE(is_spacemouse(connexion_vendor, std::string(keyboard) + std::string(axes)));
}

TEST(SpaceMouseProducts, OthersAreNone) {
  EXPECT_FALSE(is_spacemouse(0x054C, axes));
  EXPECT_FALSE(is_spacemouse(logitech_vendor, "\x05\x01\x09\x02\xA1\x01\xC0"sv)) << "a mouse";
  EXPECT_FALSE(is_spacemouse(connexion_vendor, "\x06\x00\xFF\x09\x08\xA1\x01\xC0"sv)) << "a page of the maker's";
  EXPECT_FALSE(is_spacemouse(connexion_vendor, "")) << "it does not tell";
}

TEST(SpaceMouseProducts, ItemsMayBeLongerAndFurtherApart) {
  EXPECT_TRUE(is_spacemouse(connexion_vendor, "\x07\x01\x00\x00\x00\x85\x01\x0A\x08\x00\xA1\x01"sv));
  // The page is that of an earlier collection, and the usage is for one item only.
  EXPECT_TRUE(is_spacemouse(connexion_vendor, "\x05\x01\x09\x06\xA1\x01\xC0\x09\x08\xA1\x01"sv));
  EXPECT_FALSE(is_spacemouse(connexion_vendor, "\x05\x01\x09\x08\x81\x02\xA1\x01"sv));
}

TEST(SpaceMouseProducts, ADescriptorMayBreakOffAnywhere) {
  for (std::size_t size = 0; size < axes.size(); ++size) {
    EXPECT_EQ(is_spacemouse(connexion_vendor, axes.substr(0, size)), size >= 6) << size;
  }
}

}  // namespace
}  // namespace ghostforce::spacemouse_products_test
