// Calibrations as files: what they say, and what is told of those that say something wrong.
#include "app/files/falcon_calibration_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>

#include "app/base/failure.h"
#include "core/conventions.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::falcon_calibration_file_test {
namespace {

constexpr std::string_view least = "format = 1\nserial = \"A1\"\n";

FalconCalibration read(const std::string& text) {
  return read_falcon_calibration(text, "f.toml");
}

// Its words; empty if it was taken.
std::string refusal(const std::string& text) {
  try {
    read(text);
    return {};
  } catch (const ReadError& error) {
    EXPECT_EQ(error.kind(), ReadError::Kind::wrong);
    return error.what();
  }
}

std::string refusal_of_line(std::string_view line) {
  return refusal(std::string(least) + std::string(line) + "\n");
}

TEST(FalconCalibrationFile, HasTheDefaultsForWhatItDoesNotSay) {
  FalconCalibration expected;
  expected.serial = *DeviceSerial::from("A1");
  EXPECT_EQ(read(std::string(least)), expected);
}

TEST(FalconCalibrationFile, SaysEverything) {
  const FalconCalibration calibration = read(
      "format = 1\nserial = \"12PZ657E\"\nmotor_constant_counts_per_N_m = 3530\ngeometry = \"martin-hillier\"\n"
      "angle_at_zero_count_deg = 50.0\nencoder_offset_counts = [1, -2, 3]\ncenter_mm = [1, -2.5, 110]\n"
      "right_axis = \"-z\"\nup_axis = \"-x\"\nscale = 2\ngear_ratio = 7.5\nmotor_strengths = [1, 0.6, 2]\n"
      "motor_of_leg = [1, -3, 2]\nencoder_of_leg = [-2, 1, 3]\n");
  FalconGeometry geometry = geometry_catalog()[2].geometry;
  geometry.angle_at_zero_count = 50.0 * radians_per_degree;
  geometry.gear_ratio = 7.5;
  EXPECT_EQ(calibration.serial.text(), "12PZ657E");
  EXPECT_EQ(calibration.geometry, geometry);
  EXPECT_EQ(calibration.counts_per_newton_metre, 3530.0);
  EXPECT_EQ(calibration.encoder_offset, (MotorNumbers{1, -2, 3}));
  EXPECT_EQ(calibration.center, Vector<3>(0.001, -0.0025, 0.110));
  EXPECT_EQ(calibration.right_axis, FalconAxis::minus_z);
  EXPECT_EQ(calibration.up_axis, FalconAxis::minus_x);
  EXPECT_EQ(calibration.scale, 2.0);
  EXPECT_EQ(calibration.motor_strengths, Vector<3>(1.0, 0.6, 2.0));
  EXPECT_EQ(calibration.motor_of_leg, (LegNumbers{1, -3, 2}));
  EXPECT_EQ(calibration.encoder_of_leg, (LegNumbers{-2, 1, 3}));
}

TEST(FalconCalibrationFile, SaysWhereWhatIsWrongAndWhatToDo) {
  EXPECT_EQ(refusal_of_line("scal = 1.0"), "f.toml:3:1: the key scal is unknown; did you mean 'scale'?");
  EXPECT_EQ(refusal_of_line("scale = \"1\""), "f.toml:3:9: the key scale: is a string; give 0.1 to 10");
  EXPECT_EQ(refusal_of_line("scale = 11"), "f.toml:3:9: the key scale: 11 is out of range; give 0.1 to 10");
  EXPECT_EQ(refusal_of_line("scale = nan"), "f.toml:3:9: the key scale: nan is out of range; give 0.1 to 10");
  EXPECT_EQ(
      refusal_of_line("geometry = \"libnifalcn\""),
      "f.toml:3:12: the key geometry: 'libnifalcn' is not one of libnifalcon, libnifalcon-2008, martin-hillier; did "
      "you mean 'libnifalcon'?");
  EXPECT_EQ(refusal_of_line("center_mm = [0, 1]"),
            "f.toml:3:13: the key center_mm: is an array of 2; give three numbers, as in [0, 0, 0]");
  EXPECT_EQ(refusal_of_line("encoder_offset_counts = [0, 1.5, 0]"),
            "f.toml:3:29: the key encoder_offset_counts: has a decimal point or an exponent; give whole numbers");
  EXPECT_EQ(refusal_of_line("up_axis = \"-x\""),
            "f.toml:3:11: the key up_axis: right_axis is 'x' and up_axis is '-x', but a plane needs two different "
            "axes; change one");
  EXPECT_EQ(refusal_of_line("motor_of_leg = [1, -1, 3]"),
            "f.toml:3:16: the key motor_of_leg: does not contain 1, 2 and 3 once each; give them in any order, with a "
            "minus where one counts the other way, as in [1, -3, 2]");
  EXPECT_NE(refusal_of_line("right_axis = \"w\"\nup_axis = \"x\""), "");
  for (const std::string_view line :
       {"motor_constant_counts_per_N_m = 0", "motor_constant_counts_per_N_m = inf", "angle_at_zero_count_deg = 91",
        "angle_at_zero_count_deg = [1]", "encoder_offset_counts = 1", "encoder_offset_counts = [0, 0, 5000]",
        "center_mm = [0, 0, 201]", "center_mm = [0, 0, \"a\"]", "right_axis = 1", "right_axis = \"y\"", "[scale]",
        "geometry = 1", "gear_ratio = 5.9", "gear_ratio = 11", "motor_strengths = [1, 1]",
        "motor_strengths = [1, 0.1, 1]", "motor_of_leg = [1, 2, 4]", "encoder_of_leg = [1, 2.0, 3]"}) {
    EXPECT_EQ(refusal_of_line(line).find("f.toml:3:"), 0U) << line;
  }
}

TEST(FalconCalibrationFile, RefusesWhatIsNoCalibration) {
  EXPECT_NE(refusal("").find("the key format is missing"), std::string::npos);
  EXPECT_NE(refusal("").find("the key serial is missing"), std::string::npos);
  EXPECT_EQ(refusal("format = 2\nserial = 5\n").find("f.toml:1:10: the key format: is 2, but this program only knows"),
            0U);
  EXPECT_EQ(refusal("format = \n").find("f.toml:1:"), 0U);
  const std::string too_long(DeviceSerial::longest + 1, 'A');
  for (const std::string& serial :
       {std::string(), std::string("a/b"), std::string(".."), std::string("a b"), too_long}) {
    EXPECT_NE(refusal("format = 1\nserial = \"" + serial + "\"\n").find("is not a serial number"), std::string::npos);
  }
}

TEST(FalconCalibrationFile, TellsEverythingAtOnceInTheOrderOfTheFile) {
  const std::string words = refusal("scale = 0\nserial = \"A1\"\nbogus = 1\nup_axis = 3\n");
  EXPECT_EQ(std::count(words.begin(), words.end(), '\n'), 3);
  EXPECT_LT(words.find("scale"), words.find("bogus"));
  EXPECT_LT(words.find("bogus"), words.find("up_axis"));
}

class FalconCalibrationFolderTest : public testing::Test {
 protected:
  void SetUp() override {
    setenv("XDG_CONFIG_HOME", folder_.path().c_str(), 1);
    setenv("HOME", (folder_ / "home").c_str(), 1);
  }

  void write(std::string_view name, std::string_view text) const {
    std::filesystem::create_directories(folder_ / "ghostforce/falcon");
    write_whole(folder_ / ("ghostforce/falcon/" + std::string(name)), text);
  }

  static FalconCalibration calibration_of(std::string_view serial) {
    FalconCalibration calibration;
    calibration.serial = *DeviceSerial::from(serial);
    return calibration;
  }

  TemporaryFolder folder_;
};

TEST_F(FalconCalibrationFolderTest, IsEmptyAtFirst) {
  EXPECT_TRUE(load_falcon_calibrations().empty());
  EXPECT_EQ(folder_.count(), 0);
}

TEST_F(FalconCalibrationFolderTest, ReadsBackWhatItWrote) {
  FalconCalibration written = calibration_of("FTPNM0FB");
  written.geometry = geometry_catalog()[1].geometry;
  written.geometry.angle_at_zero_count = 41.25 * radians_per_degree;
  written.geometry.gear_ratio = 7.9;
  written.motor_strengths = {1.0, 0.75, 0.5};
  written.motor_of_leg = {-1, 3, 2};
  written.encoder_of_leg = {2, 3, -1};
  written.counts_per_newton_metre = 10000.0;
  written.encoder_offset = {-7, 0, 4096};
  written.center = {0.001, 0.0, 0.1};
  written.right_axis = FalconAxis::minus_x;
  written.up_axis = FalconAxis::z;
  written.scale = 1.5;
  EXPECT_EQ(save_falcon_calibration(written), folder_ / "ghostforce/falcon/FTPNM0FB.toml");
  const auto read = load_falcon_calibrations();
  ASSERT_EQ(read.size(), 1U);
  EXPECT_EQ(read[0].serial, written.serial);
  EXPECT_EQ(read[0].counts_per_newton_metre, written.counts_per_newton_metre);
  EXPECT_EQ(read[0].encoder_offset, written.encoder_offset);
  EXPECT_EQ(read[0].motor_strengths, written.motor_strengths);
  EXPECT_EQ(read[0].motor_of_leg, written.motor_of_leg);
  EXPECT_EQ(read[0].encoder_of_leg, written.encoder_of_leg);
  EXPECT_EQ(read[0].right_axis, written.right_axis);
  EXPECT_EQ(read[0].up_axis, written.up_axis);
  EXPECT_EQ(read[0].scale, written.scale);
  // A degree or a millimetre is no whole number of SI units: the last digit may move.
  for (glm::length_t i = 0; i < 3; ++i) EXPECT_DOUBLE_EQ(read[0].center[i], written.center[i]);
  EXPECT_DOUBLE_EQ(read[0].geometry.angle_at_zero_count, written.geometry.angle_at_zero_count);
  FalconGeometry geometry = read[0].geometry;
  geometry.angle_at_zero_count = written.geometry.angle_at_zero_count;
  EXPECT_EQ(geometry, written.geometry);
}

TEST_F(FalconCalibrationFolderTest, KeepsOneFilePerDeviceUnderTheNameThatItHas) {
  write("mine.toml", least);
  write("notes.txt", "no calibration");
  FalconCalibration changed = calibration_of("A1");
  changed.scale = 3.0;
  EXPECT_EQ(save_falcon_calibration(changed), folder_ / "ghostforce/falcon/mine.toml");
  save_falcon_calibration(calibration_of("B2"));
  const auto read = load_falcon_calibrations();
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].serial.text(), "B2");  // B2.toml is before mine.toml
  EXPECT_EQ(read[1].scale, 3.0);
}

TEST_F(FalconCalibrationFolderTest, TellsOfEveryFileThatIsWrong) {
  write("a.toml", least);
  write("b.toml", least);
  write("c.toml", "format = 1\n");
  std::filesystem::create_directory(folder_ / "ghostforce/falcon/d.toml");
  try {
    load_falcon_calibrations();
    FAIL();
  } catch (const ReadError& error) {
    const std::string words = error.what();
    EXPECT_EQ(error.kind(), ReadError::Kind::wrong);
    EXPECT_NE(words.find("b.toml is for the same device as"), std::string::npos) << words;
    EXPECT_NE(words.find("c.toml:1:1: the key serial is missing"), std::string::npos) << words;
    EXPECT_NE(words.find("d.toml is a folder"), std::string::npos) << words;
  }
}

// Nothing lies at the beginning of a process's memory: a true error of reading, EIO.
TEST_F(FalconCalibrationFolderTest, TellsWhatCannotBeRead) {
  write("a.toml", least);
  std::filesystem::create_symlink("/proc/self/mem", folder_ / "ghostforce/falcon/b.toml");
  try {
    load_falcon_calibrations();
    FAIL();
  } catch (const ReadError& error) {
    EXPECT_EQ(error.kind(), ReadError::Kind::unreadable);
    EXPECT_NE(std::string(error.what()).find("b.toml cannot be read: "), std::string::npos) << error.what();
  }
}

TEST_F(FalconCalibrationFolderTest, KeepsNothingThatHasNoName) {
  EXPECT_THROW(save_falcon_calibration(calibration_of("")), Failure);
  EXPECT_THROW(save_falcon_calibration(calibration_of("../a")), Failure);
  FalconCalibration unnamed = calibration_of("A1");
  unnamed.geometry.upper_arm = 0.061;
  EXPECT_THROW(save_falcon_calibration(unnamed), Failure);
  EXPECT_EQ(folder_.count(), 0);
}

}  // namespace
}  // namespace ghostforce::falcon_calibration_file_test
