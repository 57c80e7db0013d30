// The sign of a Haply's motor, turned round in the calibration file of its board.
#include "app/tools/doctor/haply_motor_flip.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "app/base/failure.h"
#include "app/files/haply_calibration_file.h"
#include "tests/support/exit_code_of.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::haply_motor_flip_test {
namespace {

constexpr std::string_view number = "9A2D6C5150304D4B";

class HaplyMotorFlipped : public testing::Test {
 protected:
  HaplyMotorFlipped() { setenv("XDG_CONFIG_HOME", folder_.path().c_str(), 1); }

  SerialPortFound board(const std::string& name, const std::string& serial, bool is_known = true) const {
    const std::string path = folder_ / name;
    std::ofstream(path).put('x');
    SerialPortFound port;
    port.path = path;
    port.serial = serial;
    if (is_known) port.board = "M0 board";
    return port;
  }
  static std::string flip(HaplyMotorFlip what) {
    what.calibrations = load_haply_calibrations();
    return flip_haply_motor(what);
  }

  TemporaryFolder folder_;
};

TEST_F(HaplyMotorFlipped, WritesAFileForABoardThatHasNone) {
  const std::string words = flip({.motor = 1, .variant = "v2", .ports = {board("ttyACM0", std::string(number))}});
  EXPECT_NE(words.find("Motor 2"), std::string::npos) << words;
  EXPECT_NE(words.find("motor_reversed = true under [arm2]"), std::string::npos) << words;
  const std::vector<HaplyCalibration> kept = load_haply_calibrations();
  ASSERT_EQ(kept.size(), 1U);
  HaplyCalibration expected = find_haply_variant("v2")->calibration;
  expected.serial = *DeviceSerial::from(number);
  expected.arms[1].is_motor_reversed = true;
  EXPECT_EQ(haply_calibration_text(kept[0]), haply_calibration_text(expected));
}

TEST_F(HaplyMotorFlipped, ChangesNothingElseOfAFileAndTurnsItBack) {
  HaplyCalibration before = find_haply_variant("v3")->calibration;
  before.serial = *DeviceSerial::from(number);
  before.arms[0].torque_scale = 0.85;
  before.arms[1].is_motor_reversed = true;
  before.center = {0.02, 0.095};
  save_haply_calibration(before);
  // What the person calls it does not count where a file says it.
  const HaplyMotorFlip what{.motor = 0, .variant = "2017", .ports = {board("ttyACM0", std::string(number))}};
  flip(what);
  HaplyCalibration expected = before;
  expected.arms[0].is_motor_reversed = true;
  ASSERT_EQ(load_haply_calibrations().size(), 1U);
  EXPECT_EQ(haply_calibration_text(load_haply_calibrations()[0]), haply_calibration_text(expected));
  flip(what);
  EXPECT_EQ(haply_calibration_text(load_haply_calibrations()[0]), haply_calibration_text(before));
}

// What was measured of any board becomes the file of this one, and stays what it was for others.
TEST_F(HaplyMotorFlipped, TakesWhatIsKnownOfAnyBoard) {
  HaplyCalibration any = find_haply_variant("v2")->calibration;
  any.arms[0].torque_scale = 0.7;
  save_haply_calibration(any);
  flip({.motor = 1, .ports = {board("ttyACM0", std::string(number))}});
  const HaplyCalibration now =
      calibration_of(*DeviceSerial::from(number), load_haply_calibrations(), usual_haply_variant().calibration);
  EXPECT_EQ(now.variant, "v2");
  EXPECT_EQ(now.arms[0].torque_scale, 0.7);
  EXPECT_TRUE(now.arms[1].is_motor_reversed);
  EXPECT_EQ(load_haply_calibrations().size(), 2U);
}

TEST_F(HaplyMotorFlipped, GuessesNeitherTheVariantNorTheBoard) {
  const SerialPortFound one = board("ttyACM0", std::string(number));
  const SerialPortFound two = board("ttyACM1", "OTHER");
  EXPECT_EQ(exit_code_of([&] { flip({.motor = 0, .ports = {one}}); }), static_cast<int>(ExitCode::wrong_call));
  EXPECT_EQ(exit_code_of([&] { flip({.motor = 0, .variant = "v3.1"}); }), static_cast<int>(ExitCode::device_absent));
  EXPECT_EQ(exit_code_of([&] {
              flip({.motor = 0, .variant = "v3.1", .ports = {one, two}});
            }),
            static_cast<int>(ExitCode::device_absent));
  EXPECT_EQ(exit_code_of([&] { flip({.motor = 0, .port = folder_ / "ttyACM7", .variant = "v3.1", .ports = {one}}); }),
            static_cast<int>(ExitCode::device_absent));
  EXPECT_TRUE(load_haply_calibrations().empty());
  // One that is named, and one beside which there is no other that is known.
  EXPECT_EQ(serial_of_board(two.path, std::array{one, two}).text(), "OTHER");
  EXPECT_EQ(serial_of_board("", std::array{board("ttyUSB0", "X", false), two}).text(), "OTHER");
  EXPECT_EQ(serial_of_board(folder_ / "ttyACM0", std::array{two}).text(), "") << "over no USB: it has no number";
}

}  // namespace
}  // namespace ghostforce::haply_motor_flip_test
