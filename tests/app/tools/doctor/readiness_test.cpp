// Readiness tells of every state of a device how far it has come, and never more.
#include "app/tools/doctor/readiness.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "device/falcon/falcon_report.h"
#include "device/haply/haply_report.h"
#include "device/report/motor_report.h"

namespace ghostforce::readiness_test {
namespace {

FalconReport in_state(FalconState state, FalconFault fault = FalconFault::none) {
  FalconReport report;
  report.state = state;
  report.fault = fault;
  return report;
}

FalconReport well() {
  FalconReport report = in_state(FalconState::idle);
  report.has_firmware = true;
  report.has_homed = report.has_moved = {true, true, true};
  report.exchange_hz = 975.0;
  report.exchange_s = 0.00102;
  report.worst_exchange_s = 0.0031;
  report.is_guarded = true;
  return report;
}

// The name of the step that is next; empty: none is left.
std::string_view current_of(const std::vector<ReadinessStepState>& readiness) {
  const auto current = std::ranges::find(readiness, true, &ReadinessStepState::is_current);
  return current == readiness.end() ? std::string_view{} : current->name;
}

const ReadinessStepState& step_in(const std::vector<ReadinessStepState>& readiness, ReadinessStep step) {
  return readiness.at(static_cast<std::size_t>(step));
}

TEST(Readiness, CatalogIsInOrderAndComplete) {
  EXPECT_EQ(readiness_catalog().size(), static_cast<std::size_t>(ReadinessStep::armed) + 1);
  for (std::size_t i = 0; i < readiness_catalog().size(); ++i) {
    const ReadinessEntry& entry = readiness_catalog()[i];
    EXPECT_EQ(static_cast<std::size_t>(entry.id), i);
    EXPECT_FALSE(entry.name.empty());
    EXPECT_FALSE(entry.title.empty());
    EXPECT_TRUE(entry.remedy.ends_with(".")) << entry.name;
  }
}

TEST(Readiness, EveryFaultIsOneStepsAndTellsItsRemedyThere) {
  for (const FalconFaultEntry& fault : falcon_fault_catalog()) {
    if (fault.id == FalconFault::none) continue;
    const auto readiness = readiness_of(in_state(FalconState::fault, fault.id), nullptr);
    const auto current = std::ranges::find(readiness, true, &ReadinessStepState::is_current);
    ASSERT_NE(current, readiness.end()) << fault.name;
    EXPECT_NE(current->words.find(sentence_of(fault.id)), std::string::npos) << current->words;
    EXPECT_TRUE(remedy_of(fault.id).ends_with(".")) << fault.name;
    EXPECT_NE(current->words.find(remedy_of(fault.id)), std::string::npos) << current->words;
    // All below is reached, nothing above.
    for (const ReadinessStepState& state : readiness)
      EXPECT_EQ(state.is_reached, state.step < current->step) << fault.name;
  }
  const auto step_of = [](FalconFault fault) {
    return current_of(readiness_of(in_state(FalconState::fault, fault), nullptr));
  };
  EXPECT_EQ(step_of(FalconFault::unplugged), "seen");
  EXPECT_EQ(step_of(FalconFault::not_allowed), "allowed");
  EXPECT_EQ(step_of(FalconFault::busy), "free");
  EXPECT_EQ(step_of(FalconFault::no_firmware), "firmware");
  EXPECT_EQ(step_of(FalconFault::kinematics), "homed");
}

// What nobody can reach any more has to be said where everybody looks, and which device it is.
TEST(Readiness, SaysThatTheMotorsMayStillPush) {
  FalconReport report = in_state(FalconState::fault, FalconFault::broken);
  EXPECT_EQ(readiness_of(report, nullptr)[3].words.find("unplug the device's power supply"), std::string::npos);
  report.may_still_push = true;
  EXPECT_NE(readiness_of(report, nullptr)[3].words.find("unplug the device's power supply"), std::string::npos);
  report.owed_serial = *DeviceSerial::from("12PZ657E");
  EXPECT_NE(readiness_of(report, nullptr)[3].words.find("12PZ657E"), std::string::npos);
}

// "Unplug it" and "plug it in" side by side leave nobody wiser.
TEST(Readiness, SaysNothingElseToDoWhileTheMotorsMayStillPush) {
  FalconReport report = in_state(FalconState::fault, FalconFault::unplugged);
  EXPECT_NE(readiness_of(report, nullptr)[0].words.find(remedy_of(FalconFault::unplugged)), std::string::npos);
  report.may_still_push = true;
  const std::string words = readiness_of(report, nullptr)[0].words;
  EXPECT_TRUE(words.ends_with("The device was unplugged.")) << words;
  EXPECT_NE(words.find("unplug the device's power supply"), std::string::npos);
  const MotorReport motors{.has_motors = true, .reason = OffReason::unplugged};
  EXPECT_EQ(readiness_of(report, &motors).back().words, "The motors were told to stop: unplugged.")
      << "whether they obey is what nobody knows";
}

TEST(Readiness, ClaimsNothingOfMotorsThatMayStillPush) {
  FalconReport report = well();  // another device than the one that may push
  report.may_still_push = true;
  const MotorReport motors{.has_motors = true,
                           .reason = OffReason::unplugged,
                           .is_handle_known = true,
                           .is_ready = true,
                           .is_outside_wall = true};
  const std::string words = readiness_of(report, &motors).back().words;
  EXPECT_TRUE(words.ends_with("The motors were told to stop: unplugged.")) << words;
}

TEST(Readiness, SaysThatADeviceIsWellAgainInPlaceOfWhatToDoForIt) {
  MotorReport motors{.has_motors = true,
                     .reason = OffReason::not_homed,
                     .is_handle_known = true,
                     .is_ready = true,
                     .is_outside_wall = true};
  const std::string words = readiness_of(well(), &motors).back().words;
  EXPECT_NE(words.find("not homed"), std::string::npos);
  EXPECT_NE(words.find("works again"), std::string::npos);
  EXPECT_EQ(words.find("Home it"), std::string::npos) << words;
  motors.is_outside_wall = false;
  EXPECT_EQ(readiness_of(well(), &motors).back().words, "The motors went off: not homed.")
      << "first the handle must leave the wall";
}

TEST(Readiness, SaysThatAnotherDeviceMayStillPushWhileThisOneIsWell) {
  FalconReport report = well();
  report.may_still_push = true;
  report.owed_serial = *DeviceSerial::from("12PZ657E");
  EXPECT_NE(readiness_of(report, nullptr).back().words.find("12PZ657E may still push"), std::string::npos);
  const MotorReport motors{.has_motors = true, .state = SafetyState::on, .is_handle_known = true, .is_ready = true};
  EXPECT_NE(readiness_of(report, &motors).back().words.find("12PZ657E may still push"), std::string::npos);
}

TEST(Readiness, GrowsWithTheDevice) {
  EXPECT_EQ(current_of(readiness_of(in_state(FalconState::absent), nullptr)), "seen");
  FalconReport report = in_state(FalconState::loading_firmware, FalconFault::echo_differs);
  report.attempt = 2;
  report.attempts = 10;
  report.bytes_echoed = 3100;
  report.firmware_size = 8492;
  const auto loading = readiness_of(report, nullptr);
  EXPECT_EQ(current_of(loading), "firmware");
  EXPECT_EQ(
      step_in(loading, ReadinessStep::firmware).words,
      "It is being loaded, attempt 2 of 10: 3100 of 8492 bytes are done. The previous attempt: upload was garbled.");

  report = in_state(FalconState::homing);
  report.has_homed = {true, false, true};
  const auto homing = readiness_of(report, nullptr);
  EXPECT_EQ(current_of(homing), "homed");
  EXPECT_TRUE(step_in(homing, ReadinessStep::homed)
                  .words.starts_with(
                      "Motor 1 and motor 3 have found their zero, motor 2 has not. The encoders read 0, 0 and 0."));

  report = well();
  report.has_moved = {false, true, false};
  const auto moving = readiness_of(report, nullptr);
  EXPECT_EQ(current_of(moving), "encoders_move");
  EXPECT_TRUE(
      step_in(moving, ReadinessStep::encoders_move).words.starts_with("Motor 1 and motor 3 have not moved yet."));

  const auto all = readiness_of(well(), nullptr);
  EXPECT_EQ(current_of(all), "");
  EXPECT_EQ(all.back().step, ReadinessStep::fast_enough);
  EXPECT_EQ(all.back().words, "The device answers 975 times a second, after 1.02 ms on average and 3.1 ms at worst.");
}

// While it is homed the driver asks about 250 times a second, by its own choice.
TEST(Readiness, SpeedDuringHomingIsThatOfOneAnswer) {
  FalconReport report = well();
  report.state = FalconState::homing;
  report.exchange_hz = 250.0;
  EXPECT_NEAR(attainable_exchange_hz(report), 980.0, 1.0);
  EXPECT_TRUE(is_fast_and_even(report));
  report.exchange_s = 0.005;
  EXPECT_FALSE(is_fast_and_even(report));
  EXPECT_NE(readiness_of(report, nullptr).back().words, "") << "it has failed, though its turn has not come";
  report = well();
  report.worst_exchange_s = 0.020;
  EXPECT_FALSE(is_fast_and_even(report)) << "would end every push as late";
  report = well();
  report.exchange_hz = 250.0;
  EXPECT_FALSE(is_fast_and_even(report)) << "homed: nothing holds it back";
}

TEST(Readiness, EndsWithThePersonsWill) {
  MotorReport motors;
  motors.has_motors = true;
  const auto current = [&] { return current_of(readiness_of(well(), &motors)); };
  const auto words = [&] { return readiness_of(well(), &motors).back().words; };
  EXPECT_EQ(current(), "outside_wall");
  motors.is_handle_known = motors.is_outside_wall = true;
  EXPECT_EQ(current(), "armed");
  EXPECT_EQ(words(), entry_of(ReadinessStep::armed).remedy);
  motors.state = SafetyState::arming;
  motors.obstacle = ArmingObstacle::focus;
  EXPECT_EQ(words(),
            "The motors are not on yet: click on this window, or close the menu or program that has the keyboard.");
  motors.state = SafetyState::ramp;
  motors.is_checking = true;
  EXPECT_EQ(words(), "The motors are being checked: hold the handle still.");
  motors.is_checking = false;
  motors.state = SafetyState::on;
  motors.is_outside_wall = false;  // in contact
  motors.limit = 6.0;
  EXPECT_EQ(current(), "");
  EXPECT_EQ(words(), "The motors are on and push with 6.0 N at most.");
  motors.state = SafetyState::off;
  motors.is_outside_wall = true;
  motors.reason = OffReason::too_fast;
  EXPECT_EQ(current(), "armed");
  EXPECT_NE(words().find(entry_of(OffReason::too_fast).remedy), std::string::npos);
}

TEST(Readiness, SaysWhyTheMotorsWentOffThoughTheHandleIsInTheWall) {
  MotorReport motors;
  motors.has_motors = motors.is_handle_known = true;
  motors.reason = motors.last_reason = OffReason::calibration;
  const std::vector<ReadinessStepState> readiness = readiness_of(well(), &motors);
  EXPECT_EQ(current_of(readiness), "outside_wall");
  EXPECT_EQ(readiness.back().title, "Not armed");
  EXPECT_TRUE(readiness.back().words.starts_with("The motors went off: motor check failed.")) << readiness.back().words;
}

TEST(Readiness, NamesTheMotorOfAHaplyAndWhatToDoAboutIt) {
  HaplyReport haply;
  haply.state = HaplyState::idle;
  haply.has_moved = {true, true};
  haply.exchange_hz = 1000.0;
  haply.variant = "v2";
  MotorReport motors;
  motors.has_motors = motors.is_handle_known = motors.is_outside_wall = true;
  motors.reason = motors.last_reason = OffReason::calibration;
  const auto words = [&] { return readiness_of(haply, &motors).back().words; };
  motors.finding = {MotorVerdict::wrong_way, 1};
  EXPECT_NE(words().find("Motor 2 pushes the wrong way. "), std::string::npos) << words();
  EXPECT_NE(words().find("'ghostforce doctor haply --haply-variant v2 --flip-motor 2'"), std::string::npos) << words();
  motors.finding = {MotorVerdict::silent, 0};
  EXPECT_NE(words().find("Motor 1 does not push. Check the power supply"), std::string::npos) << words();
  motors.finding = {MotorVerdict::crossed, 0};
  EXPECT_NE(words().find("--measure"), std::string::npos) << words();
  motors.finding = {MotorVerdict::undecided, 0};
  EXPECT_NE(words().find("Hold the handle loosely"), std::string::npos) << words();
  // Read, and not forgotten; of other reasons it says nothing.
  motors.reason = OffReason::none;
  motors.finding = {MotorVerdict::wrong_way, 0};
  EXPECT_NE(words().find("Motor 1 pushes the wrong way. "), std::string::npos) << words();
  motors.last_reason = OffReason::too_fast;
  EXPECT_EQ(words().find("Motor 1"), std::string::npos) << words();
  motors.finding = {};
  motors.last_reason = OffReason::calibration;
  EXPECT_NE(words().find("did not move the handle as they were told"), std::string::npos) << words();
}

TEST(Readiness, RemembersAProblemOnceItIsAcknowledged) {
  MotorReport motors;
  motors.has_motors = motors.is_handle_known = motors.is_outside_wall = true;
  const auto words = [&] { return readiness_of(well(), &motors).back().words; };
  motors.last_reason = OffReason::calibration;
  EXPECT_NE(words().find("The last time, the motors went off: motor check failed."), std::string::npos) << words();
  motors.last_reason = OffReason::key;
  EXPECT_EQ(words(), entry_of(ReadinessStep::armed).remedy) << "a person's own wish is no problem";
}

TEST(Readiness, DoesNotSayThatMotorsWentOffWhichMayStillPush) {
  MotorReport motors;
  motors.has_motors = motors.is_handle_known = motors.is_outside_wall = true;
  motors.last_reason = OffReason::unplugged;  // acknowledged
  FalconReport report = well();
  report.may_still_push = true;
  const std::string words = readiness_of(report, &motors).back().words;
  EXPECT_TRUE(words.ends_with("The motors were told to stop: unplugged.")) << words;
}

TEST(Readiness, DoesNotClaimThatAHandleThatPushesIsOutside) {
  MotorReport motors;
  motors.has_motors = motors.is_handle_known = true;
  motors.state = SafetyState::on;
  const ReadinessStepState step = step_in(readiness_of(well(), &motors), ReadinessStep::outside_wall);
  EXPECT_TRUE(step.is_reached);
  EXPECT_EQ(step.title, "Outside when armed");
}

// Where everything else is ready, and until a newer reason stands there.
TEST(Readiness, SaysThatNobodyGuardsTheMotors) {
  MotorReport motors;
  motors.has_motors = motors.is_handle_known = motors.is_outside_wall = true;
  FalconReport report = well();
  report.is_guarded = false;
  EXPECT_NE(readiness_of(report, &motors).back().words.find("ghostforce-guard"), std::string::npos);
  motors.reason = OffReason::too_fast;
  EXPECT_EQ(readiness_of(report, &motors).back().words.find("ghostforce-guard"), std::string::npos);
}

// ---- Every step in each of its states ---------------------------------------------------------------------------------

// Begins with a capital letter, ends with a full stop, and so does each sentence in it.
void expect_whole_sentences(std::string_view words) {
  SCOPED_TRACE(std::string(words));
  ASSERT_FALSE(words.empty());
  EXPECT_TRUE(std::isupper(static_cast<unsigned char>(words.front())));
  EXPECT_TRUE(words.ends_with('.'));
  EXPECT_EQ(words.find("  "), std::string_view::npos);
  EXPECT_EQ(words.find(".."), std::string_view::npos);
  EXPECT_EQ(words.find(" ."), std::string_view::npos);
  for (std::size_t at = words.find(". "); at != std::string_view::npos; at = words.find(". ", at + 1)) {
    EXPECT_TRUE(std::isupper(static_cast<unsigned char>(words[at + 2])));
  }
}

// All that a report, with or without motors, can be made of.
std::vector<FalconReport> all_reports() {
  std::vector<FalconReport> reports;
  for (const FalconState state : {FalconState::absent, FalconState::opening, FalconState::loading_firmware,
                                  FalconState::homing, FalconState::idle, FalconState::active, FalconState::fault}) {
    for (const FalconFaultEntry& fault : falcon_fault_catalog()) {
      for (int motors = 0; motors < 8; ++motors) {
        for (const double hz : {0.0, 250.0, 975.0}) {
          FalconReport report = in_state(state, fault.id);
          for (std::size_t i = 0; i < 3; ++i) report.has_homed[i] = report.has_moved[i] = ((motors >> i) & 1) != 0;
          report.encoders = {-120, 0, 7};
          report.exchange_hz = hz;
          report.exchange_s = hz > 0.0 ? 1.0 / hz : 0.0;
          report.may_still_push = motors == 3;
          if (motors == 5) report.serial = *DeviceSerial::from("12PZ657E");
          reports.push_back(report);
        }
      }
    }
  }
  return reports;
}

std::vector<MotorReport> all_motor_reports() {
  std::vector<MotorReport> reports;
  for (const SafetyState state :
       {SafetyState::off, SafetyState::arming, SafetyState::ramp, SafetyState::on, SafetyState::fade}) {
    for (const OffReasonEntry& reason : off_reason_catalog()) {
      for (int obstacle = 0; obstacle <= static_cast<int>(ArmingObstacle::focus); ++obstacle) {
        for (const bool is_known : {false, true}) {
          for (const bool is_outside : {false, true}) {
            reports.push_back({.has_motors = true,
                               .state = state,
                               .reason = reason.id,
                               .obstacle = static_cast<ArmingObstacle>(obstacle),
                               .is_handle_known = is_known,
                               .is_ready = true,
                               .is_outside_wall = is_outside,
                               .limit = 3.2});
          }
        }
      }
    }
  }
  return reports;
}

TEST(Readiness, EveryStepReadsAsWholeSentencesInEveryState) {
  std::set<std::pair<std::string_view, std::string>> seen;
  const auto expect_whole = [&](const std::vector<ReadinessStepState>& readiness) {
    for (const ReadinessStepState& state : readiness) {
      const ReadinessEntry& entry = entry_of(state.step);
      const bool is_lost = state.title == "Handle not found yet";
      EXPECT_TRUE(!is_lost || state.step == ReadinessStep::outside_wall);
      EXPECT_EQ(state.title, state.is_current && !is_lost ? entry.open_title : state.title);
      if (state.is_reached && state.title != entry.title) {
        EXPECT_EQ(state.step, ReadinessStep::outside_wall);
        EXPECT_EQ(state.title, "Outside when armed");
      }
      EXPECT_TRUE(state.words.empty() ? !state.is_reached && !state.is_current : true) << state.title;
      if (!state.words.empty() && seen.emplace(state.name, state.words).second) expect_whole_sentences(state.words);
    }
  };
  for (const FalconReport& report : all_reports()) expect_whole(readiness_of(report, nullptr));
  for (const MotorReport& motors : all_motor_reports()) expect_whole(readiness_of(well(), &motors));
  EXPECT_GT(seen.size(), 90U) << "not only the same few again and again";
}

TEST(Readiness, SaysWhichEncodersDoNotMove) {
  struct Case {
    std::array<bool, 3> has_moved;
    std::string_view words;
  };
  for (const Case& c :
       {Case{{false, false, false}, "No motor has moved yet."}, Case{{false, true, true}, "Motor 1 has not moved yet."},
        Case{{true, false, false}, "Motor 2 and motor 3 have not moved yet."}}) {
    FalconReport report = well();
    report.has_moved = c.has_moved;
    const ReadinessStepState step = step_in(readiness_of(report, nullptr), ReadinessStep::encoders_move);
    EXPECT_EQ(step.title, "Encoders not moved yet");
    EXPECT_TRUE(step.words.starts_with(c.words)) << step.words;
  }
}

}  // namespace
}  // namespace ghostforce::readiness_test
