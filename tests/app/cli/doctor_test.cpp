// The doctor: its exit codes, its JSON, how it examines a Falcon in virtual time, and the udev rule.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/base/failure.h"
#include "app/tools/doctor/diagnosis.h"
#include "app/tools/doctor/readiness.h"
#include "app/tools/doctor/udev_rule.h"
#include "core/scene.h"
#include "device/report/motor_report.h"
#include "device/virtual_falcon/virtual_falcon_input.h"
#include "tests/support/no_opengl.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::doctor_test {
namespace {

Outcome doctor(std::vector<std::string> words) {
  TemporaryFolder home;
  ProgramCall call;
  call.words = std::move(words);
  call.words.insert(call.words.begin(), "doctor");
  call.environment = {"XDG_CONFIG_HOME=" + home.path(), "GHOSTFORCE_FIRMWARE="};
  return run_ghostforce(call);
}

nlohmann::json json_of(const Outcome& outcome) {
  return nlohmann::json::parse(outcome.out, nullptr, false);
}

// --- As scripts see it ---

// An id that no device has, so that a Falcon on this desk does not matter.
TEST(Doctor, TellsThatThereIsNone) {
  const Outcome outcome = doctor({"--falcon-usb-id", "0000:0000"});
  EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
  EXPECT_TRUE(outcome.out.starts_with("✗ Not plugged in")) << outcome.out;
  EXPECT_NE(outcome.out.find("– Fast enough"), std::string::npos) << outcome.out;
  for (const std::string_view words : {"udev rule: ", "firmware: ", "calibration: ", "SpaceMouse: ", "real time: "}) {
    EXPECT_NE(outcome.out.find(words), std::string::npos) << words;
  }
}

TEST(Doctor, RefusedIsFour) {
  for (const std::string fault : {"not-allowed", "busy"}) {
    const Outcome outcome = doctor({"--input", "virtual-falcon", "--misbehave", fault, "--json"});
    EXPECT_EQ(outcome.exit_code, 4) << outcome.err;
    EXPECT_EQ(json_of(outcome)["exit_code"], 4);
  }
}

TEST(Doctor, TakesEveryStepWithAHandThatHomes) {
  const Outcome outcome = doctor({"--input", "virtual-falcon", "--wait", "30", "--json"});
  const nlohmann::json json = json_of(outcome);
  ASSERT_FALSE(json.is_discarded()) << outcome.out << outcome.err;
  EXPECT_EQ(outcome.err, "");
  ASSERT_EQ(json["ladder"].size(), 7U);
  for (const auto& step : json["ladder"]) {
    // How fast it is depends on what else this machine does.
    if (step["rung"] == "fast_enough") continue;
    EXPECT_TRUE(step["reached"]) << step;
  }
  EXPECT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 1) << outcome.exit_code;
  EXPECT_GT(json["exchange_hz"], 0.0);
  EXPECT_EQ(json["serial"], "VIRTUAL1");
  EXPECT_EQ(json["is_virtual"], true);
  EXPECT_EQ(json["firmware"]["is_running"], true);
}

TEST(Doctor, JsonHasEveryKeyEvenWithoutADevice) {
  const nlohmann::json json = json_of(doctor({"--falcon-usb-id", "0000:0000", "--json"}));
  for (const char* key :
       {"ladder",    "state",          "fault",           "serial",      "is_virtual",      "firmware",
        "has_homed", "has_moved",      "encoders",        "exchange_hz", "exchange_s",      "worst_exchange_s",
        "exchanges", "lost_exchanges", "discarded_bytes", "line_errors", "has_calibration", "has_usb",
        "devices",   "spacemouse",     "udev_rule",       "real_time",   "renderers",       "exit_code"}) {
    EXPECT_TRUE(json.contains(key)) << key;
  }
  for (const char* key : {"file", "sha256", "known_as", "is_running"})
    EXPECT_TRUE(json["firmware"].contains(key)) << key;
  for (const char* key : {"rung", "title", "reached", "current", "words"}) {
    EXPECT_TRUE(json["ladder"][0].contains(key)) << key;
  }
}

TEST(Doctor, SaysWhatDrawsPictures) {
  const nlohmann::json json = json_of(doctor({"--falcon-usb-id", "0000:0000", "--json"}));
  ASSERT_EQ(json["renderers"].size(), 3U);
  for (const auto& renderer : json["renderers"]) {
    const std::string name = renderer["name"];
    EXPECT_EQ(renderer["is_default"], name == "egl") << renderer;
    if (name == "gpu") continue;  // as this machine is
    EXPECT_EQ(renderer["is_there"], true) << renderer;
    EXPECT_NE(renderer["words"].get<std::string>().find(", OpenGL "), std::string::npos) << renderer;
  }
}

TEST(Doctor, SaysWhatIsMissingForPicturesAndEndsAsWithoutThem) {
  const NoOpenGl no_opengl;
  ProgramCall call;
  call.words = {"doctor", "--falcon-usb-id", "0000:0000"};
  call.environment = {no_opengl.variable()};
  const Outcome outcome = run_ghostforce(call);
  EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
  for (const std::string_view words : {"pictures by egl: ", "libegl1", "pictures by osmesa: ", "libosmesa6"}) {
    EXPECT_NE(outcome.out.find(words), std::string::npos) << words << " in " << outcome.out;
  }
  EXPECT_EQ(outcome.out.find("the default"), std::string::npos) << outcome.out;
}

// A port that is no USB device, so that no board on this desk matters: what is said then is about any board.
TEST(Doctor, TurnsRoundTheSignOfAMotorInTheCalibrationFile) {
  const TemporaryFolder home;
  const auto flip = [&](std::vector<std::string> words) {
    ProgramCall call;
    call.words = {"doctor", "haply", "--haply-port", "/dev/null", "--flip-motor"};
    call.words.insert(call.words.end(), words.begin(), words.end());
    call.environment = {"XDG_CONFIG_HOME=" + home.path()};
    return run_ghostforce(call);
  };
  const Outcome unknown = flip({"2"});
  EXPECT_EQ(unknown.exit_code, 2) << unknown.out;
  EXPECT_NE(unknown.err.find("--haply-variant"), std::string::npos) << unknown.err;
  const Outcome first = flip({"2", "--haply-variant", "v2"});
  EXPECT_EQ(first.exit_code, 0) << first.err;
  EXPECT_NE(first.out.find("motor_reversed = true under [arm2]"), std::string::npos) << first.out;
  const Outcome second = flip({"2"});
  EXPECT_EQ(second.exit_code, 0) << second.err;
  EXPECT_NE(second.out.find("motor_reversed = false under [arm2]"), std::string::npos) << second.out;
}

TEST(Doctor, RefusesWrongWords) {
  for (const std::vector<std::string>& words : {std::vector<std::string>{"--input", "mouse"},
                                                {"--wait", "soon"},
                                                {"--wait", "-1"},
                                                {"--misbehave", "nicely"},
                                                {"--misbehave", "silence"},  // of which device?
                                                {"--install-udev", "--input", "virtual-falcon"},
                                                {"--falcon-usb-id", "falcon"},
                                                {"--firmware", "/nowhere/firmware.bin"},
                                                {"--flip-motor", "1"},  // a Falcon's
                                                {"haply", "--flip-motor", "3"},
                                                {"haply", "--flip-motor", "1", "--measure"},
                                                {"virtual-haply", "--flip-motor", "1"},
                                                {"wall45"}}) {
    const Outcome outcome = doctor(words);
    EXPECT_EQ(outcome.exit_code, 2) << words.front() << outcome.err;
    EXPECT_EQ(outcome.out, "");
  }
}

// --- In virtual time ---

FalconReport examined(const InjectedFault& wrong, double wait_s, const FalconOptions& options = {}) {
  Scene scene;
  scene.settings.stiffnesses.k_u = 100.0;
  VirtualFalconInput falcon(options, wrong, scene, VirtualLink::Clock::stepped);
  return examine(falcon, wait_s,
                 [&](const FalconReport& report) { EXPECT_EQ(report.motors, (std::array<std::int16_t, 3>{})); });
}

InjectedFault fault_named(std::string_view name) {
  InjectedFault wrong;
  find_injected_fault(name)->add(wrong);
  return wrong;
}

TEST(Doctor, VerdictOnAWellDevice) {
  const FalconReport waited = examined({}, 60.0);
  for (const ReadinessStepState& state : readiness_of(waited, nullptr)) EXPECT_TRUE(state.is_reached) << state.name;
  EXPECT_EQ(exit_code_of(waited, true), ExitCode::done);
  const FalconReport alone = examined({}, 0.0);
  EXPECT_EQ(alone.state, FalconState::homing);
  EXPECT_EQ(exit_code_of(alone, false), ExitCode::done);
}

TEST(Doctor, VerdictsOnFaults) {
  const auto verdict = [](std::string_view name, double wait_s) {
    return exit_code_of(examined(fault_named(name), wait_s), wait_s > 0.0);
  };
  EXPECT_EQ(verdict("absent", 0.0), ExitCode::device_absent);
  EXPECT_EQ(verdict("not-allowed", 0.0), ExitCode::device_refused);
  EXPECT_EQ(verdict("busy", 0.0), ExitCode::device_refused);
  EXPECT_EQ(verdict("always-corrupted-echo", 0.0), ExitCode::device_failed);
  EXPECT_EQ(verdict("upload-stops", 0.0), ExitCode::device_failed);
  EXPECT_EQ(verdict("power-lost", 0.0), ExitCode::device_failed);
  EXPECT_EQ(verdict("never-homes", 5.0), ExitCode::device_failed);
  EXPECT_EQ(verdict("never-homes", 0.0), ExitCode::done);
  EXPECT_EQ(verdict("late-5ms", 0.0), ExitCode::answer_is_no);
  EXPECT_EQ(verdict("corrupted-echo", 0.0), ExitCode::done) << "the second attempt succeeds";
}

TEST(Doctor, WithoutAFirmwareFileIsAFailedDevice) {
  FalconReport report;
  report.state = FalconState::fault;
  report.fault = FalconFault::no_firmware;
  EXPECT_EQ(exit_code_of(report, false), ExitCode::device_failed);
}

// --- The udev rule ---

TEST(Doctor, RuleIsWrittenWholeAndForAllToRead) {
  TemporaryFolder folder;
  const std::string place = folder / "etc/udev/rules.d";
  const std::vector<std::string_view> places{place};
  EXPECT_TRUE(installed_udev_rule(places).empty());
  const mode_t usual = umask(077);
  const std::filesystem::path rule = write_udev_rule(place);
  umask(usual);
  EXPECT_EQ(rule, std::filesystem::path(place) / udev_rule_name);
  EXPECT_EQ(installed_udev_rule(places), rule);
  EXPECT_EQ(read_whole(rule.string()), udev_rule_text());
  EXPECT_EQ(static_cast<unsigned>(std::filesystem::status(rule).permissions()), 0644U);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(place), {}), 1);
  write_udev_rule(place);  // again, over itself
  EXPECT_EQ(read_whole(rule.string()), udev_rule_text());
  EXPECT_NE(udev_rule_text().find("ATTR{idProduct}==\"cb48\""), std::string_view::npos);
}

TEST(Doctor, RuleThatCannotBeWrittenIsTold) {
  TemporaryFolder folder;
  write_whole(folder / "file", "");
  try {
    write_udev_rule(folder / "file/rules.d");
    FAIL() << "wrote below a file";
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.code(), ExitCode::file_trouble);
  }
}

}  // namespace
}  // namespace ghostforce::doctor_test
