#include "app/files/xdg_folders.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "tests/support/temporary_folder.h"

namespace ghostforce::xdg_folders_test {
namespace {

class FirmwarePathTest : public testing::Test {
 protected:
  FirmwarePathTest() {
    setenv("XDG_CONFIG_HOME", (folder_ / "config").c_str(), 1);
    setenv("HOME", (folder_ / "home").c_str(), 1);
    unsetenv("GHOSTFORCE_FIRMWARE");
  }

  TemporaryFolder folder_;
};

TEST_F(FirmwarePathTest, IsWhereThePersonSays) {
  EXPECT_FALSE(firmware_path({}));
  std::filesystem::create_directories(folder_ / "home/.config/ghostforce/falcon");
  write_whole(folder_ / "home/.config/ghostforce/falcon/firmware.bin", "x");
  EXPECT_FALSE(firmware_path({}));
  setenv("XDG_CONFIG_HOME", "relative", 1);
  EXPECT_EQ(firmware_path({}), folder_ / "home/.config/ghostforce/falcon/firmware.bin");
  setenv("XDG_CONFIG_HOME", (folder_ / "config").c_str(), 1);
  std::filesystem::create_directories(folder_ / "config/ghostforce/falcon");
  write_whole(folder_ / "config/ghostforce/falcon/firmware.bin", "x");
  EXPECT_EQ(firmware_path({}), folder_ / "config/ghostforce/falcon/firmware.bin");
  setenv("GHOSTFORCE_FIRMWARE", "", 1);
  EXPECT_EQ(firmware_path({}), folder_ / "config/ghostforce/falcon/firmware.bin");
  setenv("GHOSTFORCE_FIRMWARE", "/nowhere/a.bin", 1);
  EXPECT_EQ(firmware_path({}), "/nowhere/a.bin");
  EXPECT_EQ(firmware_path("b.bin"), "b.bin");
}

}  // namespace
}  // namespace ghostforce::xdg_folders_test
