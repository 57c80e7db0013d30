// What the command line says about a Haply, and which calibration is then used for which board.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>

#include <CLI/CLI.hpp>

#include "app/cli/command.h"
#include "app/cli/desktop_inputs.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::haply_options_test {
namespace {

constexpr std::string_view of_any = "format = 1\nvariant = \"v2\"\n[arm1]\nmotor_reversed = true\n";
constexpr std::string_view of_one = "format = 1\nvariant = \"v3\"\nserial = \"A1\"\n";

class HaplyOptionsTest : public testing::Test {
 protected:
  HaplyOptionsTest() {
    setenv("XDG_CONFIG_HOME", folder_.path().c_str(), 1);
    std::filesystem::create_directories(folder_ / "ghostforce/haply");
    set_up_.attach(app_, files_);
  }

  void keep(const std::string& name, std::string_view text) {
    write_whole(folder_ / ("ghostforce/haply/" + name), std::string(text));
  }
  // Of the board with this serial number, or at this path.
  HaplyCalibration used_for(std::string_view serial) const {
    const HaplyOptions options = set_up_.input_options({}).haply;
    return calibration_of(device_serial_of(serial), options.calibrations, options.usual);
  }

  TemporaryFolder folder_;
  CLI::App app_;
  FileOptions files_;
  DeviceSetUp set_up_;
};

TEST_F(HaplyOptionsTest, WithoutAFileTheUsualVariantIsUsed) {
  for (const std::string_view serial : {"", "A1", "/dev/ttyACM0"}) {
    EXPECT_EQ(used_for(serial), usual_haply_variant().calibration) << serial;
  }
}

TEST_F(HaplyOptionsTest, AFileForAnyBoardIsForThoseThatHaveNone) {
  keep("any.toml", of_any);
  keep("one.toml", of_one);
  for (const std::string_view serial : {"", "B2", "/dev/ttyACM0"}) {
    EXPECT_EQ(used_for(serial).variant, "v2") << serial;
    EXPECT_TRUE(used_for(serial).arms[0].is_motor_reversed) << serial;
  }
  EXPECT_EQ(used_for("A1").variant, "v3");
}

TEST_F(HaplyOptionsTest, AVariantThatIsNamedIsForBoardsWithoutAFileOfTheirOwn) {
  keep("any.toml", of_any);
  keep("one.toml", of_one);
  app_.parse("--haply-variant 2017");
  for (const std::string_view serial : {"", "B2", "/dev/ttyACM0"})
    EXPECT_EQ(used_for(serial).variant, "2017") << serial;
  EXPECT_EQ(used_for("A1").variant, "v3");
}

}  // namespace
}  // namespace ghostforce::haply_options_test
