// A measurement finds what is wrong with a Falcon: on virtual ones that are wrong in one way each, and in all.
#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <string>
#include <string_view>

#include "app/base/failure.h"
#include "app/base/interruption.h"
#include "app/files/falcon_calibration_file.h"
#include "app/tools/doctor/encoder_wiring.h"
#include "core/conventions.h"
#include "device/motors/emergency_stop.h"
#include "tests/app/tools/doctor/measured_rehearsal.h"

namespace ghostforce::falcon_measurement_test {
namespace {

using State = Finding::State;

constexpr std::string_view encoders = "Which encoder is which, and which way it counts";
constexpr std::string_view offsets = "Where the encoders stand at the stop";
constexpr std::string_view angle = "Angle of the arms at count zero";
constexpr std::string_view gear = "Gear ratio";
constexpr std::string_view motors = "Which motor is which, and which way it pushes";
constexpr std::string_view constant = "Counts per N·m of the motors";
constexpr std::string_view alike = "Whether the motors are alike";
constexpr std::string_view firmware = "Does the firmware drop a force by itself";

// The two numbers of "12.3 ± 0.4" at the beginning of a sentence.
struct Measured {
  double value = 0.0;
  double uncertainty = 0.0;
};
Measured measured_in(const Finding& finding) {
  Measured measured;
  EXPECT_EQ(std::sscanf(finding.sentence.c_str(), "%lf ± %lf", &measured.value, &measured.uncertainty), 2)
      << finding.sentence;
  return measured;
}

// The handle is where the driver says, and is pushed as the driver is asked to: with this calibration, read back from
// its file, on a device that is homed.
void expect_right(const SimulatedArm::Options& arm, const FalconCalibration& calibration, double reach, double share) {
  FalconOptions options;
  options.calibrations = {read_falcon_calibration(falcon_calibration_text(calibration), "f.toml")};
  VirtualLink::Options link_options{.clock = VirtualLink::Clock::stepped};
  link_options.arm = arm;
  link_options.device.starts_with_firmware = true;
  link_options.device.starts_homed = true;
  auto made = std::make_unique<VirtualLink>(link_options);
  VirtualLink& link = *made;
  Falcon falcon(std::move(made), options);
  const auto go_on = [&](double seconds, const Vector<3>& force, bool is_armed) {
    for (const std::int64_t end_ns = link.now_ns() + static_cast<std::int64_t>(seconds * 1e9);
         link.now_ns() < end_ns;) {
      falcon.update();
      falcon.set_force(force, is_armed);
      link.wait_until(link.now_ns() + 1'000'000);
    }
  };
  for (const Vector<3>& place :
       {Vector<3>{0.0, 0.0, 0.125}, Vector<3>{0.03, -0.02, 0.11}, Vector<3>{-0.02, 0.03, 0.14}}) {
    link.lead_hand(hand_at(place, 0.3));
    go_on(1.5, Vector<3>(0.0), false);
    ASSERT_EQ(falcon.report().state, FalconState::idle) << entry_of(falcon.report().fault).title;
    // Distances are what a ruler tells: from here on, how far it has gone.
    EXPECT_LT(glm::distance(falcon.report().position, link.arm().position()), reach);
    for (const Vector<3>& force : {Vector<3>{0.6, 0.0, 0.0}, Vector<3>{0.0, 0.6, 0.0}, Vector<3>{0.0, 0.0, -0.6}}) {
      go_on(0.5, force, true);
      EXPECT_LT(glm::distance(link.arm().force(), force), share * 0.6)
          << link.arm().force().x << ' ' << link.arm().force().y << ' ' << link.arm().force().z;
    }
  }
}

// --- A good one ---

TEST(FalconMeasurement, OfAGoodDeviceIsAsAssumed) {
  MeasuredRehearsal rehearsal({}, 0, false);
  const FalconMeasurement measurement = rehearsal.measure();
  EXPECT_TRUE(measurement.is_complete);
  EXPECT_TRUE(measurement.has_all_answers());
  for (const FalconMeasurement::Step& step : measurement.steps) {
    for (const Finding& finding : step.findings) {
      EXPECT_TRUE(finding.state == State::as_assumed || finding.state == State::measured)
          << finding.title << ": " << finding.sentence;
      EXPECT_FALSE(finding.readings.empty() && finding.title != gear && finding.title != alike &&
                   finding.title != "Friction and weight of the handle")
          << finding.title;
    }
  }
  FalconCalibration expected;
  expected.serial = *DeviceSerial::from(VirtualLink::serial_number);
  EXPECT_EQ(measurement.calibration, expected);
  EXPECT_NEAR(measured_in(finding_of(measurement, constant)).value, 6600.0, 150.0);
  EXPECT_NE(finding_of(measurement, firmware).sentence.find("still there after 1000 ms"), std::string::npos);
  EXPECT_GT(rehearsal.link->drives, 10);
  EXPECT_GT(rehearsal.link->greatest_force, 0.8) << "motors that hardly push measure nothing";
}

// --- One thing wrong ---

TEST(FalconMeasurement, FindsAnEncoderThatCountsTheOtherWay) {
  SimulatedArm::Options arm;
  arm.encoder_of_leg = {1, -2, 3};
  MeasuredRehearsal rehearsal(arm, 0, false);
  const FalconMeasurement measurement = rehearsal.measure({"Encoders", "Lengths"});
  EXPECT_EQ(finding_of(measurement, encoders).state, State::differs);
  EXPECT_EQ(finding_of(measurement, offsets).state, State::differs);
  EXPECT_EQ(finding_of(measurement, angle).state, State::as_assumed) << finding_of(measurement, angle).sentence;
  EXPECT_EQ(measurement.calibration.encoder_of_leg, arm.encoder_of_leg);
  const SimulatedArm pushed_in({.start = {0.0, 0.0, SimulatedArm::nearest}});
  EXPECT_NEAR(measurement.calibration.encoder_offset[1], -2 * pushed_in.encoders()[1], crooked_counts);
  expect_right(arm, measurement.calibration, 0.001, 0.03);
}

// Then the stop tells nothing, and the angle at count zero is where they begin.
TEST(FalconMeasurement, FindsEncodersThatAllCountTheOtherWay) {
  SimulatedArm::Options arm;
  arm.encoder_of_leg = {-1, -2, -3};
  MeasuredRehearsal rehearsal(arm);
  const FalconMeasurement measurement = rehearsal.measure({"Encoders", "Lengths"});
  EXPECT_EQ(measurement.calibration.encoder_of_leg, arm.encoder_of_leg);
  EXPECT_EQ(finding_of(measurement, angle).state, State::differs) << finding_of(measurement, angle).sentence;
  expect_right(arm, measurement.calibration, 0.003, 0.06);
}

TEST(FalconMeasurement, FindsEncodersInAnotherOrder) {
  SimulatedArm::Options arm;
  arm.encoder_of_leg = {3, 1, 2};
  MeasuredRehearsal rehearsal(arm);
  const FalconMeasurement measurement = rehearsal.measure({"Encoders"});
  EXPECT_EQ(finding_of(measurement, encoders).state, State::differs);
  EXPECT_EQ(measurement.calibration.encoder_of_leg, arm.encoder_of_leg);
  expect_right(arm, measurement.calibration, 0.0002, 0.02);
}

TEST(FalconMeasurement, FindsMotorsThatPushTheOtherWayOrAreInAnotherOrder) {
  for (const LegNumbers& wiring :
       {LegNumbers{1, 2, -3}, LegNumbers{-1, -2, -3}, LegNumbers{2, 1, 3}, LegNumbers{-3, 1, 2}}) {
    SimulatedArm::Options arm;
    arm.motor_of_leg = wiring;
    MeasuredRehearsal rehearsal(arm);
    const FalconMeasurement measurement = rehearsal.measure({"Encoders", "Motors' directions"});
    EXPECT_EQ(finding_of(measurement, motors).state, State::differs);
    EXPECT_EQ(measurement.calibration.motor_of_leg, wiring);
    expect_right(arm, measurement.calibration, 0.0002, 0.02);
  }
}

TEST(FalconMeasurement, FindsAGearThatIsWrong) {
  for (const double factor : {0.95, 1.03, 1.05}) {
    SimulatedArm::Options arm;
    arm.geometry.gear_ratio *= factor;
    MeasuredRehearsal rehearsal(arm);
    const FalconMeasurement measurement = rehearsal.measure({"Encoders", "Lengths"});
    const Finding& finding = finding_of(measurement, gear);
    EXPECT_EQ(finding.state, State::differs) << finding.sentence;
    const Measured measured = measured_in(finding);
    EXPECT_NEAR(measured.value, arm.geometry.gear_ratio, measured.uncertainty);
    EXPECT_LT(measured.uncertainty, 0.02 * arm.geometry.gear_ratio);
    // A ruler that is read to a millimetre tells where the handle is to about that.
    expect_right(arm, measurement.calibration, 0.003, 0.06);
  }
}

TEST(FalconMeasurement, FindsAnotherAngleAtCountZero) {
  for (const double degrees : {40.0, 43.0, 50.0}) {
    SimulatedArm::Options arm;
    arm.geometry.angle_at_zero_count = degrees * radians_per_degree;
    MeasuredRehearsal rehearsal(arm);
    const FalconMeasurement measurement = rehearsal.measure({"Encoders", "Lengths"});
    const Finding& finding = finding_of(measurement, angle);
    EXPECT_EQ(finding.state, State::differs) << finding.sentence;
    const Measured measured = measured_in(finding);
    EXPECT_NEAR(measured.value, degrees, measured.uncertainty);
    EXPECT_LT(measured.uncertainty, 2.0);
    EXPECT_EQ(finding.sentence.find("none of the published") != std::string::npos, degrees == 43.0) << finding.sentence;
    expect_right(arm, measurement.calibration, 0.003, 0.06);
  }
}

TEST(FalconMeasurement, FindsAWeakMotor) {
  for (glm::length_t weak = 0; weak < 3; ++weak) {
    SimulatedArm::Options arm;
    arm.motor_strengths[weak] = 0.6;
    arm.weight = 0.15;  // on a rubber band: a weak motor carries little of it
    MeasuredRehearsal rehearsal(arm);
    rehearsal.person->answers[OperatorAction::Kind::say_weight] = {"25"};
    const FalconMeasurement measurement = rehearsal.measure({"Encoders", "Motors' directions", "Motors' strength"});
    const Finding& finding = finding_of(measurement, alike);
    EXPECT_EQ(finding.state, State::differs) << finding.sentence;
    Vector<3> value;
    Vector<3> off;
    ASSERT_EQ(std::sscanf(finding.sentence.c_str(),
                          "Legs 1, 2, 3 relative to the strongest motor: %lf ± %lf, %lf ± %lf, %lf ± %lf", &value.x,
                          &off.x, &value.y, &off.y, &value.z, &off.z),
              6)
        << finding.sentence;
    for (glm::length_t leg = 0; leg < 3; ++leg) {
      EXPECT_NEAR(value[leg], arm.motor_strengths[leg], off[leg]);
      EXPECT_LT(off[leg], 0.2);
    }
    const Measured measured = measured_in(finding_of(measurement, constant));
    EXPECT_NEAR(measured.value, 6600.0, measured.uncertainty);
    arm.weight = 0.0;
    expect_right(arm, measurement.calibration, 0.0002, 0.1);
  }
}

TEST(FalconMeasurement, FindsWhatACountIsWorth) {
  for (const double truth : {3530.0, 5000.0, 6000.0}) {
    SimulatedArm::Options arm;
    arm.counts_per_newton_metre = truth;
    MeasuredRehearsal rehearsal(arm);
    const FalconMeasurement measurement = rehearsal.measure({"Encoders", "Motors' directions", "Motors' strength"});
    const Finding& finding = finding_of(measurement, constant);
    EXPECT_EQ(finding.state, State::differs) << finding.sentence;
    const Measured measured = measured_in(finding);
    EXPECT_NEAR(measured.value, truth, measured.uncertainty);
    EXPECT_LT(measured.uncertainty, 0.06 * truth);
    EXPECT_EQ(finding_of(measurement, alike).state, State::as_assumed);
    expect_right(arm, measurement.calibration, 0.0002, 0.05);
  }
}

// With 10000 counts per N·m two newtons of the strongest motors are 0.6 N: half a newton and the handle are too much.
TEST(FalconMeasurement, AsksForALighterWeightWhereTheMotorsAreTooWeak) {
  SimulatedArm::Options arm;
  for (const double truth : {7500.0, 10000.0}) {
    arm.counts_per_newton_metre = truth;
    MeasuredRehearsal rehearsal(arm);
    const FalconMeasurement measurement = rehearsal.measure({"Encoders", "Motors' directions", "Motors' strength"});
    EXPECT_EQ(finding_of(measurement, constant).state, State::not_measured);
    EXPECT_EQ(rehearsal.person->asked[OperatorAction::Kind::say_weight], 3);
    EXPECT_EQ(measurement.calibration.counts_per_newton_metre, measured_motor_constant);
  }
  MeasuredRehearsal rehearsal(arm);
  rehearsal.person->answers[OperatorAction::Kind::say_weight] = {"50", "20"};
  const FalconMeasurement measurement = rehearsal.measure({"Encoders", "Motors' directions", "Motors' strength"});
  EXPECT_TRUE(rehearsal.person->has_heard("Take a lighter one"));
  const Measured measured = measured_in(finding_of(measurement, constant));
  EXPECT_NEAR(measured.value, 10000.0, measured.uncertainty);
}

TEST(FalconMeasurement, FindsWhenTheFirmwareDropsAForce) {
  MeasuredRehearsal rehearsal({}, 60);
  const FalconMeasurement measurement = rehearsal.measure({"Encoders", "Motors' directions", "Force without commands"});
  const Finding& finding = finding_of(measurement, firmware);
  EXPECT_EQ(finding.state, State::measured);
  double there_ms = 0.0;
  double gone_ms = 0.0;
  ASSERT_EQ(std::sscanf(finding.sentence.c_str(),
                        "Yes: it was still there after %lf ms without a command, and gone after %lf ms.", &there_ms,
                        &gone_ms),
            2)
      << finding.sentence;
  EXPECT_LE(there_ms, 60.0);
  EXPECT_GE(gone_ms, 60.0);
  EXPECT_LE(gone_ms, 200.0);
}

// --- Everything wrong ---

TEST(FalconMeasurement, MakesADeviceRightThatIsWrongInEveryWay) {
  SimulatedArm::Options arm;
  arm.encoder_of_leg = {2, -1, 3};
  arm.motor_of_leg = {1, 3, -2};
  arm.geometry.angle_at_zero_count = 44.0 * radians_per_degree;
  arm.geometry.gear_ratio *= 1.04;
  arm.motor_strengths = {1.0, 0.7, 1.0};
  arm.counts_per_newton_metre = 5200.0;
  MeasuredRehearsal rehearsal(arm, 0, false);
  const FalconMeasurement measurement = rehearsal.measure();
  for (const FalconMeasurement::Step& step : measurement.steps) {
    for (const Finding& finding : step.findings) {
      EXPECT_TRUE(finding.is_answer()) << finding.title << ": " << finding.sentence;
    }
  }
  EXPECT_EQ(measurement.calibration.encoder_of_leg, arm.encoder_of_leg);
  EXPECT_EQ(measurement.calibration.motor_of_leg, arm.motor_of_leg);
  expect_right(arm, measurement.calibration, 0.004, 0.15);
}

// --- The person ---

TEST(FalconMeasurement, AsksAgainForADistanceThatIsNone) {
  MeasuredRehearsal rehearsal;
  rehearsal.person->answers[OperatorAction::Kind::say_distance] = {"about so much", "-60",  "1e9", "",
                                                                   "nan",           "60,0", "60 "};
  const FalconMeasurement measurement = rehearsal.measure({"Encoders", "Lengths"});
  EXPECT_EQ(finding_of(measurement, angle).state, State::as_assumed);
  EXPECT_EQ(rehearsal.person->asked[OperatorAction::Kind::say_distance], 5 + 5)
      << "five are no numbers, five distances there are";
  EXPECT_TRUE(rehearsal.person->has_heard("'about so much' is not a number from 20 to 110 mm"));
}

TEST(FalconMeasurement, SaysThatDistancesContradictEachOther) {
  MeasuredRehearsal rehearsal;
  rehearsal.person->answers[OperatorAction::Kind::say_distance] = {"60", "35"};
  const FalconMeasurement measurement = rehearsal.measure({"Encoders", "Lengths"});
  EXPECT_EQ(finding_of(measurement, angle).state, State::contradicts);
  EXPECT_FALSE(measurement.has_all_answers());
  EXPECT_EQ(measurement.calibration.geometry, FalconGeometry{});
}

TEST(FalconMeasurement, TurnsMotorsOffWhenTheButtonIsLetGoAndBeginsTheStepAgain) {
  MeasuredRehearsal rehearsal;
  int held = 0;
  rehearsal.person->hook = [&](const OperatorAction& action, VirtualLink& link) {
    if (action.kind != OperatorAction::Kind::hold_button || ++held != 2) return;
    HandPlan plan = link.hand().goal() == action.place ? hand_at(action.place) : hand_at(action.place, 0.0);
    plan.waypoints[0].buttons = ReplyFrame::button_centre;
    plan.add({.time = 0.6, .goal = action.place, .buttons = 0});
    link.lead_hand(plan);
  };
  const FalconMeasurement measurement = rehearsal.measure({"Encoders", "Motors' directions"});
  EXPECT_EQ(finding_of(measurement, motors).state, State::as_assumed);
  EXPECT_EQ(rehearsal.person->asked[OperatorAction::Kind::hold_button], 4) << "three motors, one of them twice";
  EXPECT_TRUE(rehearsal.person->has_heard("The button was released"));
}

TEST(FalconMeasurement, GivesUpAStepThatIsLetGoOfAgainAndAgain) {
  MeasuredRehearsal rehearsal;
  rehearsal.person->hook = [](const OperatorAction& action, VirtualLink& link) {
    if (action.kind == OperatorAction::Kind::hold_button) link.lead_hand(hand_at(action.place));  // no button
  };
  const FalconMeasurement measurement = rehearsal.measure({"Encoders", "Motors' directions", "Motors' strength"});
  EXPECT_EQ(finding_of(measurement, motors).state, State::not_measured);
  EXPECT_EQ(rehearsal.link->drives, 0);
  EXPECT_EQ(finding_of(measurement, "Motors' strength").sentence,
            "It needs the result of an earlier step that has none.");
}

TEST(FalconMeasurement, EndsWhereTheHandleIsTooFastOrPulledOutOfItsWorkspaceEachTime) {
  struct Jerk {
    Vector<3> goal;
    double time;  // that it takes [s]
    std::string_view words;
  };
  for (const Jerk& jerk : {Jerk{{0.03, 0.0, 0.125}, 0.01, "moved faster than 0.3 m/s"},
                           Jerk{{0.0, 0.0, 0.2}, 0.6, "left its workspace"}}) {
    MeasuredRehearsal rehearsal;
    rehearsal.person->hook = [&](const OperatorAction& action, VirtualLink& link) {
      if (action.kind != OperatorAction::Kind::hold_button) return;
      HandPlan plan = hand_at(action.place, 0.0);
      plan.waypoints[0].buttons = ReplyFrame::button_centre;
      plan.add({.time = 1.2, .goal = action.place, .buttons = ReplyFrame::button_centre});
      plan.add({.time = 1.2 + jerk.time, .goal = jerk.goal, .buttons = ReplyFrame::button_centre});
      plan.stiffness = 600.0;
      link.lead_hand(plan);
    };
    try {
      rehearsal.measure({"Encoders", "Motors' directions"});
      FAIL();
    } catch (const Failure& failure) {
      EXPECT_EQ(failure.code(), ExitCode::safety_stop) << failure.what();
      EXPECT_NE(std::string_view(failure.what()).find(jerk.words), std::string_view::npos) << failure.what();
    }
    EXPECT_GE(rehearsal.link->drives, 3);
    EXPECT_EQ(rehearsal.link->link.motors(), MotorNumbers{});
    EXPECT_LT(rehearsal.link->greatest_force, 2.0);
  }
}

// Ctrl+C while a motor pushes. What remembers it is for a whole process, and so is this one.
TEST(FalconMeasurementDeathTest, InterruptedMotorsAreOff) {
  const auto interrupted = [] {
    remember_interruptions(emergency_stop::stop_motors);
    MeasuredRehearsal rehearsal;
    rehearsal.link->on_drive = [] { std::raise(SIGINT); };
    try {
      rehearsal.measure({"Encoders", "Motors' directions"});
    } catch (const Failure& failure) {
      const bool is_well = rehearsal.link->link.motors() == MotorNumbers{} && rehearsal.link->drives == 1;
      std::exit(is_well ? static_cast<int>(failure.code()) : 1);
    }
    std::exit(2);
  };
  EXPECT_EXIT(interrupted(), testing::ExitedWithCode(130), "");
}

TEST(FalconMeasurement, LeavesWithOrWithoutAReport) {
  MeasuredRehearsal rehearsal;
  rehearsal.person->answers[OperatorAction::Kind::say_distance] = {"60", "q"};
  const FalconMeasurement measurement = rehearsal.measure({"Encoders", "Lengths"});
  EXPECT_FALSE(measurement.is_complete);
  ASSERT_EQ(measurement.steps.size(), 1U);
  EXPECT_NE(report_of(measurement, {}).find("The person ended it"), std::string::npos);
  MeasuredRehearsal second;
  second.person->answers[OperatorAction::Kind::say_distance] = {"q"};
  second.person->answers[OperatorAction::Kind::say_yes_or_no] = {"n"};
  EXPECT_THROW(second.measure({"Encoders", "Lengths"}), Failure);
  MeasuredRehearsal third;
  third.person->answers[OperatorAction::Kind::say_distance] = {std::nullopt};  // nobody is there any more
  EXPECT_THROW(third.measure({"Encoders", "Lengths"}), Failure);
}

TEST(FalconMeasurement, EndsWhereTheDeviceGoes) {
  MeasuredRehearsal rehearsal;
  rehearsal.person->hook = [](const OperatorAction& action, VirtualLink& link) {
    if (action.kind == OperatorAction::Kind::say_distance) link.inject({.link = LinkFault::unplugged});
  };
  try {
    rehearsal.measure({"Encoders", "Lengths"});
    FAIL();
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.code(), ExitCode::device_absent) << failure.what();
  }
}

// Its motors have a supply of their own.
TEST(FalconMeasurement, SaysThatAMotorMayStillPushWhereTheDeviceGoesDuringAPush) {
  for (const bool is_pushing : {true, false}) {
    MeasuredRehearsal rehearsal;
    VirtualLink& link = rehearsal.link->link;
    const InjectedFault unplugged{.link = LinkFault::unplugged};
    if (is_pushing) {
      rehearsal.link->on_drive = [&] { link.inject(unplugged); };
    } else {
      rehearsal.person->hook = [&](const OperatorAction& action, VirtualLink&) {
        if (action.kind == OperatorAction::Kind::say_distance) link.inject(unplugged);
      };
    }
    try {
      rehearsal.measure({"Encoders", "Lengths", "Motors' directions"});
      FAIL();
    } catch (const Failure& failure) {
      EXPECT_EQ(failure.code(), ExitCode::device_absent);
      const std::string words = failure.what();
      EXPECT_EQ(words.find("may still push") != std::string::npos, is_pushing) << words;
      EXPECT_EQ(words.find("unplug its power supply") != std::string::npos, is_pushing) << words;
    }
  }
}

TEST(FalconMeasurement, LeavesHowTheWallLies) {
  MeasuredRehearsal rehearsal;
  rehearsal.person->only = {"Encoders"};
  FalconCalibration before;
  before.up_axis = FalconAxis::minus_z;
  before.scale = 2.0;
  before.center = {0.0, 0.01, 0.12};
  before.counts_per_newton_metre = 5000.0;
  before.motor_of_leg = {3, 2, 1};
  await_homed(*rehearsal.falcon, *rehearsal.person);
  FalconCalibration expected = before;
  expected.serial = *DeviceSerial::from(VirtualLink::serial_number);
  expected.counts_per_newton_metre = measured_motor_constant;
  expected.motor_of_leg = legs_in_order;
  EXPECT_EQ(measure_falcon(*rehearsal.falcon, *rehearsal.person, before).calibration, expected);
}

TEST(FalconMeasurement, ReportHasEveryReadingAndTheCalibration) {
  MeasuredRehearsal rehearsal;
  const FalconMeasurement measurement = rehearsal.measure({"Encoders", "Exchanges", "Lights", "Buttons"});
  const std::string report =
      report_of(measurement, {.version = "1.2.3", .when = "2026-01-02", .firmware = "firmware: f.bin, SHA-256 00ff"});
  for (const std::string_view words : {"ghostforce 1.2.3", "VIRTUAL1", "SHA-256 00ff", "open an issue", "```toml"}) {
    EXPECT_NE(report.find(words), std::string::npos) << words;
  }
  for (const FalconMeasurement::Step& step : measurement.steps) {
    for (const Finding& finding : step.findings) {
      EXPECT_NE(report.find(finding.sentence), std::string::npos) << finding.title;
      for (const std::string& reading : finding.readings) EXPECT_NE(report.find(reading), std::string::npos) << reading;
    }
  }
  const std::size_t begin = report.find("```toml\n") + 8;
  EXPECT_EQ(read_falcon_calibration(report.substr(begin, report.find("```", begin) - begin), "f.toml").serial.text(),
            "VIRTUAL1");
}

}  // namespace
}  // namespace ghostforce::falcon_measurement_test
