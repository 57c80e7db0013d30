#include "device/spacemouse/spacemouse_products.h"

#include <gtest/gtest.h>

namespace ghostforce::spacemouse_products_test {
namespace {

TEST(SpaceMouseProducts, TellWhatADeviceIsUsedFor) {
  EXPECT_TRUE(is_spacemouse({connexion_vendor, 0xC635, 1, 8}));
  EXPECT_TRUE(is_spacemouse({logitech_vendor, 0xC626, 1, 8}));
  // One that came out after this list was made.
  EXPECT_TRUE(is_spacemouse({connexion_vendor, 0xFFFF, 1, 8}));
}

TEST(SpaceMouseProducts, AReceiverIsAKeyboardToo) {
  EXPECT_FALSE(is_spacemouse({connexion_vendor, 0xC652, 1, 6}));
  EXPECT_FALSE(is_spacemouse({connexion_vendor, 0xC652, 0xFF00, 8}));
}

TEST(SpaceMouseProducts, OthersAreNone) {
  EXPECT_FALSE(is_spacemouse({}));
  EXPECT_FALSE(is_spacemouse({0x054C, 0xC635, 1, 8}));
  EXPECT_FALSE(is_spacemouse({logitech_vendor, 0xC077, 1, 2}));
}

TEST(SpaceMouseProducts, AreKnownByNumberWhereTheSystemTellsNoUse) {
  EXPECT_TRUE(is_spacemouse({logitech_vendor, 0xC626, 0, 0}));
  EXPECT_TRUE(is_spacemouse({connexion_vendor, 0xC652, 0, 0}));
  EXPECT_FALSE(is_spacemouse({logitech_vendor, 0xC635, 0, 0}));
  EXPECT_FALSE(is_spacemouse({connexion_vendor, 0xC626, 0, 0}));
}

}  // namespace
}  // namespace ghostforce::spacemouse_products_test
