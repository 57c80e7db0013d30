// Each way in which a device lets a script down has its number and its sentence.
#include "app/cli/end_of_visit.h"

#include <gtest/gtest.h>

#include "core/safety.h"

namespace ghostforce {
namespace {

FalconReport with_fault(FalconFault fault) {
  FalconReport report;
  report.state = FalconState::fault;
  report.fault = fault;
  return report;
}

void expect_end(const EndOfVisit& end, ExitCode code, const std::string& words) {
  EXPECT_EQ(end.code, code) << end.words;
  EXPECT_NE(end.words.find(words), std::string::npos) << end.words;
}

TEST(EndOfVisit, SaysNothingWhereAllWentWell) {
  EXPECT_EQ(end_of_visit({}, nullptr, nullptr).code, ExitCode::done);
  SpaceMouseReading spacemouse;
  spacemouse.trouble = SpaceMouseReading::Trouble::none;
  EXPECT_EQ(end_of_visit({}, nullptr, &spacemouse).code, ExitCode::done);
  FalconReport falcon;
  falcon.state = FalconState::idle;
  falcon.has_homed = {true, true, true};
  ASSERT_TRUE(falcon.is_readable());
  const EndOfVisit end = end_of_visit({}, &falcon, nullptr);
  EXPECT_EQ(end.code, ExitCode::done);
  EXPECT_EQ(end.words, "");
}

TEST(EndOfVisit, SaysWhatKeepsTheFalcon) {
  const FalconReport absent;
  expect_end(end_of_visit({}, &absent, nullptr), ExitCode::device_absent,
             "No Falcon is plugged in. Plug in the Falcon's power supply");
  for (const FalconFaultEntry& fault : falcon_fault_catalog()) {
    if (fault.id == FalconFault::none) continue;
    const FalconReport report = with_fault(fault.id);
    const EndOfVisit end = end_of_visit({}, &report, nullptr);
    EXPECT_GE(static_cast<int>(end.code), static_cast<int>(ExitCode::device_absent)) << fault.name;
    EXPECT_LE(static_cast<int>(end.code), static_cast<int>(ExitCode::device_failed)) << fault.name;
    EXPECT_NE(end.words.find(fault.remedy), std::string::npos) << end.words;
  }
  const FalconReport busy = with_fault(FalconFault::busy);
  expect_end(end_of_visit({}, &busy, nullptr), ExitCode::device_refused, "The Falcon is not ready. in use");
}

TEST(EndOfVisit, SaysWhatKeepsTheSpaceMouse) {
  SpaceMouseReading reading;
  expect_end(end_of_visit({}, nullptr, &reading), ExitCode::device_absent, "No SpaceMouse is plugged in");
  reading.trouble = SpaceMouseReading::Trouble::not_allowed;
  expect_end(end_of_visit({}, nullptr, &reading), ExitCode::device_refused, "--install-udev");
  reading.trouble = SpaceMouseReading::Trouble::not_opened;
  expect_end(end_of_visit({}, nullptr, &reading), ExitCode::device_refused, "cannot be opened");
}

TEST(EndOfVisit, ASafetyLimitComesFirst) {
  const FalconReport absent;
  for (const OffReasonEntry& reason : off_reason_catalog()) {
    MotorReport motors;
    motors.reason = reason.id;
    const EndOfVisit end = end_of_visit(motors, &absent, nullptr);
    EXPECT_EQ(end.code, reason.is_safety_limit ? ExitCode::safety_stop : ExitCode::device_absent) << reason.name;
    if (reason.is_safety_limit) expect_end(end, ExitCode::safety_stop, std::string(reason.remedy));
  }
}

}  // namespace
}  // namespace ghostforce
