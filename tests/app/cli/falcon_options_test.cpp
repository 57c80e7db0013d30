// What the command line says about a Falcon, and what is made of the files that it needs.
#include "app/cli/desktop_inputs.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include <CLI/CLI.hpp>

#include "app/base/failure.h"
#include "app/cli/command.h"
#include "app/tools/doctor/diagnosis.h"
#include "device/virtual_falcon/practice_firmware.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::falcon_options_test {
namespace {

class FalconSetUpTest : public testing::Test {
 protected:
  FalconSetUpTest() {
    setenv("XDG_CONFIG_HOME", folder_.path().c_str(), 1);
    unsetenv("GHOSTFORCE_FIRMWARE");
    std::filesystem::create_directories(folder_ / "ghostforce/falcon");
    set_up_.attach(app_, files_);
  }
  ~FalconSetUpTest() override { unsetenv("GHOSTFORCE_FIRMWARE"); }

  std::string usual_firmware() const { return folder_ / "ghostforce/falcon/firmware.bin"; }

  static void write_firmware(const std::string& path) {
    const auto bytes = practice_firmware();
    write_whole(path, std::string(bytes.begin(), bytes.end()));
  }

  // What is said of a call that is wrong; empty: nothing.
  std::string parse(const std::string& words) {
    try {
      app_.parse(words);
      return {};
    } catch (const CLI::ParseError& error) {
      return error.what();
    }
  }

  // Its exit code and its words.
  std::pair<ExitCode, std::string> trouble() const {
    try {
      set_up_.input_options(set_up_.read_firmware_file());
      return {ExitCode::done, ""};
    } catch (const Failure& failure) {
      return {failure.code(), failure.what()};
    } catch (const ReadError& error) {
      return {exit_code_of(error.kind()), error.what()};
    }
  }

  TemporaryFolder folder_;
  CLI::App app_;
  FileOptions files_;
  DeviceSetUp set_up_;
};

TEST_F(FalconSetUpTest, NothingAskedForAndNothingThere) {
  EXPECT_EQ(parse(""), "");
  EXPECT_FALSE(set_up_.read_firmware_file());
  const InputOptions options = set_up_.input_options({});
  EXPECT_EQ(set_up_.cables().falcon.id, falcon_usb_id);
  EXPECT_EQ(options.injected_fault, InjectedFault{});
  EXPECT_TRUE(options.falcon.firmware.empty());
  EXPECT_TRUE(options.falcon.calibrations.empty());
}

TEST_F(FalconSetUpTest, TakesAnIdAndInjectedFaults) {
  EXPECT_EQ(parse("--falcon-usb-id 1D50:60fc --misbehave busy,garbage --misbehave never-homes"), "");
  const InputOptions options = set_up_.input_options({});
  EXPECT_EQ(set_up_.cables().falcon.id, (UsbId{0x1D50, 0x60FC}));
  EXPECT_EQ(options.injected_fault.link, LinkFault::busy);
  EXPECT_TRUE(options.injected_fault.garbage);
  EXPECT_TRUE(options.injected_fault.never_homes);
}

TEST_F(FalconSetUpTest, RefusesWhatIsNoIdAndNoInjectedFault) {
  for (const std::string id :
       {"0403", "0403:", ":cb48", "403:cb48", "0403:cb4x", "0403:cb48:1", "0x03:cb48", "-403:cb48", "04030:cb48"}) {
    EXPECT_NE(parse("--falcon-usb-id=" + id).find("is not a USB ID"), std::string::npos) << id;
  }
  EXPECT_NE(parse("--misbehave busi").find("did you mean 'busy'?"), std::string::npos);
  EXPECT_NE(parse("--misbehave busy,garbig").find("did you mean 'garbage'?"), std::string::npos);
}

TEST_F(FalconSetUpTest, FindsTheFirmwareAndTellsWhichOne) {
  write_firmware(usual_firmware());
  const auto usual = set_up_.read_firmware_file();
  ASSERT_TRUE(usual);
  EXPECT_EQ(set_up_.input_options(usual).falcon.firmware, practice_firmware());
  EXPECT_EQ(firmware_words(usual),
            "firmware: " + usual_firmware() + ", SHA-256 " + usual->sha256 + ", not one of the published files");
  write_firmware(folder_ / "other.bin");
  setenv("GHOSTFORCE_FIRMWARE", (folder_ / "other.bin").c_str(), 1);
  EXPECT_EQ(set_up_.read_firmware_file()->path, folder_ / "other.bin");
  FirmwareImage known;
  known.sha256 = "1119e39c39fab1f37678ea62dfc715b23dd86ee7f13d78f88f707d9f09b896a1";
  EXPECT_TRUE(firmware_words(known).ends_with("known as nvent_firmware.bin"));
}

TEST_F(FalconSetUpTest, AFileThatIsNamedAndCannotBeTakenIsTold) {
  using Trouble = std::pair<ExitCode, std::string>;
  const auto says = [](const Trouble& trouble, const std::string& path) {
    return trouble.second.find(path) != std::string::npos;
  };
  set_up_.firmware = folder_ / "nowhere.bin";
  Trouble found = trouble();
  EXPECT_EQ(found.first, ExitCode::wrong_call);
  EXPECT_TRUE(says(found, "nowhere.bin")) << found.second;
  set_up_.firmware = folder_.path();
  EXPECT_EQ(trouble().first, ExitCode::file_trouble);
  set_up_.firmware.clear();
  write_whole(usual_firmware(), "no boot table");
  found = trouble();
  EXPECT_EQ(found.first, ExitCode::wrong_call);
  EXPECT_TRUE(says(found, usual_firmware())) << found.second;
}

TEST_F(FalconSetUpTest, TakesTheCalibrationsThatAreKept) {
  write_whole(folder_ / "ghostforce/falcon/one.toml", "format = 1\nserial = \"12PZ657E\"\nscale = 2.0\n");
  const InputOptions options = set_up_.input_options({});
  ASSERT_EQ(options.falcon.calibrations.size(), 1U);
  EXPECT_EQ(options.falcon.calibrations.front().scale, 2.0);
  write_whole(folder_ / "ghostforce/falcon/two.toml", "format = 1\n");
  EXPECT_EQ(trouble().first, ExitCode::wrong_call);
}

}  // namespace
}  // namespace ghostforce::falcon_options_test
