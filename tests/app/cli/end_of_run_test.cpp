// Each way in which a device lets a script down has its number and its sentence.
#include "app/cli/desktop_inputs.h"

#include <gtest/gtest.h>

#include "app/shell/spacemouse_input_link.h"
#include "app/tools/doctor/readiness.h"
#include "core/safety.h"
#include "device/falcon/falcon_report.h"

namespace ghostforce::end_of_run_test {
namespace {

FalconReport with_fault(FalconFault fault) {
  FalconReport report;
  report.state = FalconState::fault;
  report.fault = fault;
  return report;
}

void expect_end(const EndOfRun& end, ExitCode code, const std::string& words) {
  EXPECT_EQ(end.code, code) << end.words;
  EXPECT_NE(end.words.find(words), std::string::npos) << end.words;
}

// At a device with motors, as the window shows it.
EndOfRun end_at(const FalconReport& falcon, const MotorReport& motors = {}) {
  return end_of_run(motors, readiness_of(falcon, &motors), {});
}

EndOfRun end_at(const SpaceMouseReading& spacemouse) {
  return end_of_run({}, {}, end_with(spacemouse.trouble));
}

TEST(EndOfRun, SaysNothingWhereAllWentWell) {
  EXPECT_EQ(end_of_run({}, {}, {}).code, ExitCode::done);
  SpaceMouseReading spacemouse;
  spacemouse.trouble = SpaceMouseReading::Trouble::none;
  EXPECT_EQ(end_at(spacemouse).code, ExitCode::done);
  FalconReport falcon;
  falcon.state = FalconState::idle;
  falcon.has_homed = {true, true, true};
  ASSERT_TRUE(falcon.is_readable());
  const EndOfRun end = end_at(falcon);
  EXPECT_EQ(end.code, ExitCode::done);
  EXPECT_EQ(end.words, "");
}

TEST(EndOfRun, SaysWhatKeepsTheFalcon) {
  const FalconReport absent;
  expect_end(end_at(absent), ExitCode::device_absent, "No device is plugged in. Plug in the Falcon's power supply");
  for (const FalconFaultEntry& fault : falcon_fault_catalog()) {
    if (fault.id == FalconFault::none) continue;
    const FalconReport report = with_fault(fault.id);
    const EndOfRun end = end_at(report);
    EXPECT_GE(static_cast<int>(end.code), static_cast<int>(ExitCode::device_absent)) << fault.name;
    EXPECT_LE(static_cast<int>(end.code), static_cast<int>(ExitCode::device_failed)) << fault.name;
    EXPECT_NE(end.words.find(remedy_of(fault.id)), std::string::npos) << end.words;
  }
  const FalconReport busy = with_fault(FalconFault::busy);
  expect_end(end_at(busy), ExitCode::device_refused, "The device is not ready. Another program is using the device.");
}

TEST(EndOfRun, SaysWhatKeepsTheSpaceMouse) {
  SpaceMouseReading reading;
  expect_end(end_at(reading), ExitCode::device_absent, "No SpaceMouse is plugged in");
  reading.trouble = SpaceMouseReading::Trouble::not_allowed;
  expect_end(end_at(reading), ExitCode::device_refused, "--install-udev");
  reading.trouble = SpaceMouseReading::Trouble::not_opened;
  expect_end(end_at(reading), ExitCode::device_refused, "cannot be opened");
}

TEST(EndOfRun, ASafetyLimitComesFirst) {
  const FalconReport absent;
  for (const OffReasonEntry& reason : off_reason_catalog()) {
    MotorReport motors;
    motors.reason = reason.id;
    const EndOfRun end = end_at(absent, motors);
    EXPECT_EQ(end.code, reason.is_safety_limit ? ExitCode::safety_stop : ExitCode::device_absent) << reason.name;
    if (reason.is_safety_limit) expect_end(end, ExitCode::safety_stop, std::string(reason.remedy));
  }
}

}  // namespace
}  // namespace ghostforce::end_of_run_test
