// Calibrations of Haply 2DIYs as files: what they say, and what is told of those that say something wrong.
#include "app/files/haply_calibration_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>

#include "app/base/failure.h"
#include "core/conventions.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::haply_calibration_file_test {
namespace {

constexpr std::string_view least = "format = 1\nvariant = \"v3.1\"\n";

HaplyCalibration read(const std::string& text) {
  return read_haply_calibration(text, "f.toml");
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

// From the third line on.
std::string refusal_of(std::string_view lines) {
  return refusal(std::string(least) + std::string(lines) + "\n");
}

// With every value another one than any variant's.
HaplyCalibration unusual() {
  HaplyCalibration calibration = find_haply_variant("v2")->calibration;
  calibration.serial = *DeviceSerial::from("9A2D6C5150304D4B372E3120FF0A1D2B");
  calibration.geometry = {.driven_length = 0.0715, .distal_length = 0.0891, .base = 0.0205};
  calibration.arms[0] = {.motor_port = 1,
                         .motor_direction = 0,
                         .encoder_port = 1,
                         .encoder_direction = 0,
                         .offset_deg = -12.25,
                         .counts_per_turn = 4911.5,
                         .is_motor_reversed = true,
                         .torque_scale = 0.85};
  calibration.arms[1] = {.motor_port = 2,
                         .motor_direction = 1,
                         .encoder_port = 2,
                         .encoder_direction = 1,
                         .offset_deg = 191.5,
                         .counts_per_turn = 4822.75,
                         .is_motor_reversed = true,
                         .torque_scale = 1.2};
  calibration.center = {-0.0125, 0.1015};
  calibration.scale = 2.5;
  return calibration;
}

TEST(HaplyCalibrationFile, HasTheDefaultsOfItsVariant) {
  for (const HaplyVariant& variant : haply_variant_catalog()) {
    EXPECT_EQ(read("format = 1\nvariant = \"" + std::string(variant.name) + "\"\n"), variant.calibration);
  }
}

TEST(HaplyCalibrationFile, SaysEverything) {
  EXPECT_EQ(read("format = 1\nserial = \"9A2D6C5150304D4B372E3120FF0A1D2B\"\nvariant = \"v2\"\n"
                 "[arm2]\nmotor_port = 2\nmotor_direction = \"counter-clockwise\"\nencoder_port = 2\n"
                 "encoder_direction = \"counter-clockwise\"\noffset_deg = 191.5\ncounts_per_turn = 4822.75\n"
                 "motor_reversed = true\ntorque_scale = 1.2\n"
                 "[arm1]\nmotor_port = 1\nmotor_direction = \"clockwise\"\nencoder_port = 1\n"
                 "encoder_direction = \"clockwise\"\noffset_deg = -12.25\ncounts_per_turn = 4911.5\n"
                 "motor_reversed = true\ntorque_scale = 0.85\n"
                 "[plane]\ncenter_mm = [-12.5, 101.5]\nscale = 2.5\n"
                 "[geometry]\ndriven_mm = 71.5\ndistal_mm = 89.1\nbase_mm = 20.5\n"),
            unusual());
}

TEST(HaplyCalibrationFile, ReadsBackWhatItWrites) {
  EXPECT_EQ(read(haply_calibration_text(unusual())), unusual());
  for (const HaplyVariant& variant : haply_variant_catalog()) {
    EXPECT_EQ(read(haply_calibration_text(variant.calibration)), variant.calibration) << variant.name;
  }
}

TEST(HaplyCalibrationFile, ChangesOneArmAlone) {
  const HaplyCalibration calibration = read(std::string(least) + "[arm1]\ntorque_scale = 2\n");
  HaplyCalibration expected = find_haply_variant("v3.1")->calibration;
  expected.arms[0].torque_scale = 2.0;
  EXPECT_EQ(calibration, expected);
}

TEST(HaplyCalibrationFile, SaysWhereWhatIsWrongAndWhatToDo) {
  EXPECT_EQ(refusal_of("[plane]\nscal = 1.0"), "f.toml:4:1: the key plane.scal is unknown; did you mean 'scale'?");
  EXPECT_EQ(refusal_of("scale = 1.0"), "f.toml:3:1: the key scale is unknown; did you mean 'plane.scale'?");
  EXPECT_EQ(refusal_of("[arm3]\nmotor_port = 1"), "f.toml:3:2: the table [arm3] is unknown; did you mean 'arm1'?");
  EXPECT_EQ(refusal_of("arm1 = 1"),
            "f.toml:3:1: arm1 is a number, but must be a table; write [arm1] on a line of its own");
  EXPECT_EQ(refusal_of("[plane]\nscale = \"1\""), "f.toml:4:9: the key plane.scale: is a string; give 0.1 to 20");
  EXPECT_EQ(refusal_of("[plane]\nscale = 21"), "f.toml:4:9: the key plane.scale: 21 is out of range; give 0.1 to 20");
  EXPECT_EQ(refusal_of("[plane]\ncenter_mm = [0, 0, 1]"),
            "f.toml:4:13: the key plane.center_mm: is an array of 3; give two numbers, as in [0, 90]");
  EXPECT_EQ(refusal_of("[geometry]\nbase_mm = -1"),
            "f.toml:4:11: the key geometry.base_mm: -1 is out of range; give 0 to 500 mm");
  EXPECT_EQ(refusal_of("[arm1]\nmotor_port = 3"),
            "f.toml:4:14: the key arm1.motor_port: 3 is out of range; give a whole number, 1 to 2");
  EXPECT_EQ(refusal_of("[arm1]\nencoder_port = 1.0"),
            "f.toml:4:16: the key arm1.encoder_port: has a decimal point or an exponent; give a whole number, 1 to 2");
  EXPECT_EQ(refusal_of("[arm2]\nmotor_direction = \"clockwize\""),
            "f.toml:4:19: the key arm2.motor_direction: 'clockwize' is not one of clockwise, counter-clockwise; did "
            "you mean 'clockwise'?");
  EXPECT_EQ(refusal_of("[arm2]\nmotor_reversed = 1"),
            "f.toml:4:18: the key arm2.motor_reversed: is a number; give true or false");
  for (const std::string_view lines :
       {"[geometry]\ndriven_mm = 9",        "[geometry]\ndriven_mm = 501",     "[geometry]\ndistal_mm = nan",
        "[geometry]\ndistal_mm = 9.9",      "[geometry]\nbase_mm = 501",       "[plane]\ncenter_mm = [0, 501]",
        "[plane]\ncenter_mm = [\"a\", 0]",  "[plane]\ncenter_mm = 1",          "[plane]\nscale = 0",
        "[arm1]\noffset_deg = 361",         "[arm1]\noffset_deg = inf",        "[arm1]\ncounts_per_turn = 99",
        "[arm1]\ncounts_per_turn = 200001", "[arm1]\nmotor_reversed = \"no\"", "[arm1]\ntorque_scale = 0",
        "[arm1]\ntorque_scale = 11",        "[arm1]\nencoder_direction = 1",   "[arm1]\nencoder_direction = \"left\"",
        "[arm2]\nmotor_port = 0",           "[arm2]\nencoder_port = \"1\""}) {
    EXPECT_EQ(refusal_of(lines).find("f.toml:4:"), 0U) << lines;
  }
}

TEST(HaplyCalibrationFile, WantsAPortOfItsOwnForEachMotorAndEncoder) {
  EXPECT_EQ(refusal_of("[arm1]\nmotor_port = 1"),
            "f.toml:4:14: the key arm1.motor_port: the motors of both arms are at port 1; give each arm's motor a port "
            "of its own");
  EXPECT_EQ(refusal_of("[arm1]\nencoder_port = 2\n[arm2]\nencoder_port = 2"),
            "f.toml:6:16: the key arm2.encoder_port: the encoders of both arms are at port 2; give each arm's encoder "
            "a port of its own");
  EXPECT_EQ(refusal_of("[arm1]\nmotor_port = 1\n[arm2]\nmotor_port = 2"), "");
  // Nothing is told of what follows from another mistake alone.
  const std::string words = refusal_of("[arm1]\nmotor_port = 1\n[arm2]\nmotor_port = 3");
  EXPECT_EQ(words.find("both arms"), std::string::npos) << words;
  EXPECT_EQ(refusal("format = 1\nvariant = \"v4\"\n[arm1]\nmotor_port = 1\n").find("both arms"), std::string::npos);
}

TEST(HaplyCalibrationFile, RefusesWhatIsNoCalibration) {
  EXPECT_NE(refusal("").find("the key format is missing"), std::string::npos);
  EXPECT_NE(refusal("").find("the key variant is missing; give one of 2017, v2, v3, v3.1"), std::string::npos);
  EXPECT_EQ(refusal("format = 2\nvariant = 5\n").find("f.toml:1:10: the key format: is 2, but this program only knows"),
            0U);
  EXPECT_EQ(refusal("format = \n").find("f.toml:1:"), 0U);
  EXPECT_EQ(refusal("format = 1\nvariant = \"v3-1\"\n"),
            "f.toml:2:11: the key variant: 'v3-1' is not one of 2017, v2, v3, v3.1; did you mean 'v3.1'?");
  EXPECT_EQ(refusal("format = 1\nvariant = 2017\n").find("f.toml:2:11: the key variant: is a number"), 0U);
  for (const std::string& serial :
       {std::string(), std::string("/dev/ttyACM0"), std::string("a b"), std::string(DeviceSerial::longest + 1, 'A')}) {
    EXPECT_NE(refusal_of("serial = \"" + serial + "\"").find("is not a serial number"), std::string::npos);
  }
}

TEST(HaplyCalibrationFile, TellsEverythingAtOnceInTheOrderOfTheFile) {
  const std::string words =
      refusal("bogus = 1\nvariant = \"v2\"\n[plane]\nscale = 0\n[arm1]\nmotor_prt = 1\noffset_deg = true\n");
  EXPECT_EQ(std::count(words.begin(), words.end(), '\n'), 4) << words;
  EXPECT_LT(words.find("bogus"), words.find("scale"));
  EXPECT_LT(words.find("scale"), words.find("did you mean 'motor_port'"));
  EXPECT_LT(words.find("motor_prt"), words.find("offset_deg"));
}

class HaplyCalibrationFolderTest : public testing::Test {
 protected:
  void SetUp() override {
    setenv("XDG_CONFIG_HOME", folder_.path().c_str(), 1);
    setenv("HOME", (folder_ / "home").c_str(), 1);
  }

  void write(std::string_view name, std::string_view text) const {
    std::filesystem::create_directories(folder_ / "ghostforce/haply");
    write_whole(folder_ / ("ghostforce/haply/" + std::string(name)), text);
  }

  TemporaryFolder folder_;
};

TEST_F(HaplyCalibrationFolderTest, IsEmptyAtFirst) {
  EXPECT_TRUE(load_haply_calibrations().empty());
  EXPECT_EQ(folder_.count(), 0);
}

TEST_F(HaplyCalibrationFolderTest, ReadsBackWhatItWrote) {
  const HaplyCalibration of_any = haply_variant_catalog()[0].calibration;
  EXPECT_EQ(save_haply_calibration(unusual()), folder_ / "ghostforce/haply/9A2D6C5150304D4B372E3120FF0A1D2B.toml");
  EXPECT_EQ(save_haply_calibration(of_any), folder_ / "ghostforce/haply/any.toml");
  EXPECT_EQ(load_haply_calibrations(), (std::vector{unusual(), of_any}));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_ / "ghostforce/haply"), {}), 2);
}

TEST_F(HaplyCalibrationFolderTest, KeepsOneFilePerBoardUnderTheNameThatItHas) {
  write("mine.toml", std::string(least) + "serial = \"A1\"\n");
  write("usual.toml", least);
  write("notes.txt", "no calibration");
  HaplyCalibration changed = usual_haply_variant().calibration;
  changed.serial = *DeviceSerial::from("A1");
  changed.scale = 3.0;
  EXPECT_EQ(save_haply_calibration(changed), folder_ / "ghostforce/haply/mine.toml");
  changed.serial = {};
  changed.scale = 4.0;
  EXPECT_EQ(save_haply_calibration(changed), folder_ / "ghostforce/haply/usual.toml");
  const auto read = load_haply_calibrations();
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].scale, 3.0);
  EXPECT_EQ(read[1].scale, 4.0);
}

TEST_F(HaplyCalibrationFolderTest, TellsOfEveryFileThatIsWrong) {
  write("a.toml", least);
  write("b.toml", least);
  write("c.toml", std::string(least) + "serial = \"A1\"\n");
  write("d.toml", std::string(least) + "serial = \"A1\"\n");
  write("e.toml", "format = 1\n");
  try {
    load_haply_calibrations();
    FAIL();
  } catch (const ReadError& error) {
    const std::string words = error.what();
    EXPECT_EQ(error.kind(), ReadError::Kind::wrong);
    EXPECT_NE(words.find("b.toml is for any device, and so is "), std::string::npos) << words;
    EXPECT_NE(words.find("d.toml is for the same device as "), std::string::npos) << words;
    EXPECT_NE(words.find("e.toml:1:1: the key variant is missing"), std::string::npos) << words;
  }
}

TEST_F(HaplyCalibrationFolderTest, KeepsNothingThatHasNoName) {
  HaplyCalibration calibration = usual_haply_variant().calibration;
  calibration.serial = *DeviceSerial::from("/dev/ttyACM0");
  EXPECT_THROW(save_haply_calibration(calibration), Failure);
  calibration.serial = {};
  calibration.variant = "v4";
  EXPECT_THROW(save_haply_calibration(calibration), Failure);
  EXPECT_EQ(folder_.count(), 0);
}

}  // namespace
}  // namespace ghostforce::haply_calibration_file_test
