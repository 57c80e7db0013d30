// A measurement finds what is wrong with a Haply 2DIY: on virtual ones that are wrong in one way each, and in all. And
// however it ends, no motor is on.
#include <gtest/gtest.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "app/base/failure.h"
#include "app/base/interruption.h"
#include "app/files/haply_calibration_file.h"
#include "device/motors/emergency_stop.h"
#include "tests/app/tools/doctor/haply_rehearsal.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::haply_measurement_test {
namespace {

using State = Finding::State;
using Kind = HaplyAction::Kind;

constexpr std::array<double, 2> off{};
constexpr std::string_view encoders = "Encoders: which, which way, how many counts";
constexpr std::string_view motors = "Motors: which, and which way they push";
constexpr std::string_view torque = "Torque of the motors";
constexpr std::string_view friction = "Friction of the arms";
constexpr std::string_view silence = "Does the board drop a force by itself";
constexpr std::string_view stiffness = "Highest stable k_r";

const Finding& finding_of(const HaplyMeasurement& measurement, std::string_view title) {
  static const Finding none{};
  for (const MeasuredStep& step : measurement.steps) {
    for (const Finding& finding : step.findings) {
      if (finding.title == title) return finding;
    }
  }
  ADD_FAILURE() << "no finding is called " << title;
  return none;
}

Vector<2> counts_of_variant(double factor) {
  const VirtualHaplyVariant& variant = *find_virtual_haply_variant("v3.1");
  return factor * HaplyBench::right_counts_per_turn(variant, HaplyBoard::Kind::m3);
}

// Half the counts, one motor the other way round, torque a fifth less than nominal, and friction.
HaplyBench::Options wrong_device() {
  HaplyBench::Options device;
  device.counts_per_turn = counts_of_variant(0.5);
  device.wiring_signs = {-1.0, 1.0};
  device.full_torques = Vector<2>{0.8 * 0.123};
  device.arms.friction = Vector<2>{1e-3};
  return device;
}

// With this calibration, read back from its file, the driver knows where the handle is, and pushes as it is asked to.
void expect_right(const HaplyBench::Options& device, const HaplyCalibration& calibration) {
  HaplyOptions options;
  options.calibrations = {read_haply_calibration(haply_calibration_text(calibration), "h.toml")};
  VirtualPort::Options port_options{.clock = VirtualPort::Clock::stepped, .device = device};
  port_options.device.starts_in_zero_pose = true;
  auto made = std::make_unique<VirtualPort>(port_options);
  VirtualPort& port = *made;
  Haply haply(std::move(made), options);
  const auto go_on = [&](double seconds, const Vector<2>& force, bool is_armed) {
    for (const std::int64_t end_ns = port.now_ns() + static_cast<std::int64_t>(seconds * 1e9);
         port.now_ns() < end_ns;) {
      haply.update();
      haply.set_force(force, is_armed);
      port.wait_until(port.now_ns() + 1'000'000);
    }
  };
  go_on(1.0, {}, false);
  haply.confirm_zero_pose();
  go_on(0.5, {}, false);
  ASSERT_EQ(haply.report().zero_pose, ZeroPose::confirmed);
  port.hold_zero_pose(false);
  for (const Vector<2>& place : {Vector<2>{0.019, 0.09}, Vector<2>{0.04, 0.08}, Vector<2>{0.0, 0.1}}) {
    port.lead_hand(haply_hand_at(place, 0.3));
    go_on(1.5, {}, false);
    ASSERT_EQ(haply.report().state, HaplyState::idle);
    for (std::size_t arm = 0; arm < 2; ++arm) {
      const double truth = port.angles()[static_cast<glm::length_t>(arm)];
      EXPECT_NEAR(haply.report().angles[arm], truth, 0.01 * std::abs(truth) + 0.002);
    }
    for (const Vector<2>& force : {Vector<2>{0.5, 0.0}, Vector<2>{0.0, 0.5}, Vector<2>{0.0, -0.5}}) {
      go_on(0.3, force, true);
      EXPECT_LT(glm::distance(port.force(), force), 0.1 * 0.5) << port.force().x << ' ' << port.force().y;
    }
  }
}

std::string all_findings(const HaplyMeasurement& measurement) {
  std::string text;
  for (const MeasuredStep& step : measurement.steps) {
    for (const Finding& finding : step.findings) {
      text += fmt::format("{}: {}. {}\n", finding.title, words_of(finding.state), finding.sentence);
      for (const std::string& reading : finding.readings) text += "    " + reading + "\n";
    }
  }
  return text;
}

// --- Devices ---

TEST(HaplyMeasurement, OfAGoodDeviceIsAsAssumed) {
  HaplyRehearsal rehearsal;
  const HaplyMeasurement measurement = rehearsal.measure();
  EXPECT_TRUE(measurement.has_all_answers()) << all_findings(measurement);
  for (const std::string_view title : {encoders, motors, torque}) {
    EXPECT_EQ(finding_of(measurement, title).state, State::as_assumed) << all_findings(measurement);
  }
  for (const HaplyArm& arm : measurement.calibration.arms) EXPECT_NEAR(arm.torque_scale, 1.0, 0.05);
  EXPECT_NE(finding_of(measurement, silence).sentence.find("still there after 200 ms"), std::string::npos);
  EXPECT_NE(finding_of(measurement, stiffness).sentence.find("800 N/m or more"), std::string::npos)
      << finding_of(measurement, stiffness).sentence;
  double rubs[2]{};
  ASSERT_EQ(std::sscanf(finding_of(measurement, friction).sentence.c_str(), "Arm 1 %lf N·m, arm 2 %lf N·m", &rubs[0],
                        &rubs[1]),
            2);
  for (const double rub : rubs) EXPECT_NEAR(rub, 5e-4, 2e-4);
  EXPECT_TRUE(rehearsal.debts->empty());
  EXPECT_GT(rehearsal.port->drives, 8);
  EXPECT_GT(rehearsal.port->greatest_force, 0.4) << "motors that hardly push measure nothing";
}

TEST(HaplyMeasurement, MakesADeviceRightThatIsWrongInEveryWay) {
  HaplyRehearsal rehearsal(wrong_device());
  const HaplyMeasurement measurement = rehearsal.measure();
  EXPECT_TRUE(measurement.has_all_answers()) << all_findings(measurement);
  EXPECT_NE(finding_of(measurement, encoders).sentence.find("the counts per turn are halved"), std::string::npos);
  EXPECT_EQ(finding_of(measurement, motors).state, State::differs);
  EXPECT_TRUE(measurement.calibration.arms[0].is_motor_reversed);
  EXPECT_FALSE(measurement.calibration.arms[1].is_motor_reversed);
  for (const HaplyArm& arm : measurement.calibration.arms) {
    EXPECT_DOUBLE_EQ(arm.counts_per_turn, 2440.0);
    EXPECT_NEAR(arm.torque_scale, 0.8, 0.08) << all_findings(measurement);
  }
  expect_right(wrong_device(), measurement.calibration);
}

// Nobody knows before what a motor gives: 1.5 N is not passed even so.
TEST(HaplyMeasurement, StaysBelowItsLimitWhereMotorsGiveHalfAsMuchAgain) {
  HaplyBench::Options device;
  device.full_torques = Vector<2>{1.45 * 0.123};
  HaplyRehearsal rehearsal(device, {.weight = 100.0});
  const HaplyMeasurement measurement = rehearsal.measure();
  for (const HaplyArm& arm : measurement.calibration.arms) EXPECT_NEAR(arm.torque_scale, 1.45, 0.1);
  EXPECT_GT(rehearsal.port->greatest_force, 0.9);
}

TEST(HaplyMeasurement, FindsThatAnM0ReadsTwice) {
  HaplyBench::Options device;
  device.board.kind = HaplyBoard::Kind::m0;
  HaplyRehearsal rehearsal(device);
  const HaplyMeasurement measurement = rehearsal.measure({"Zero pose", "Encoders", "Motors' directions"});
  EXPECT_NE(finding_of(measurement, encoders).sentence.find("the counts per turn are doubled"), std::string::npos)
      << all_findings(measurement);
  EXPECT_EQ(finding_of(measurement, motors).state, State::as_assumed) << all_findings(measurement);
  expect_right(device, measurement.calibration);
}

// Plugs that are exchanged, and an encoder that counts the other way: as assumed of another device.
TEST(HaplyMeasurement, FindsPlugsThatAreExchanged) {
  HaplyRehearsal rehearsal;
  std::swap(rehearsal.before.arms[0].encoder_port, rehearsal.before.arms[1].encoder_port);
  std::swap(rehearsal.before.arms[0].motor_port, rehearsal.before.arms[1].motor_port);
  rehearsal.before.arms[0].encoder_direction = 0;
  const HaplyMeasurement measurement = rehearsal.measure({"Zero pose", "Encoders", "Motors' directions"});
  HaplyCalibration expected = usual_haply_variant().calibration;
  expected.serial = *DeviceSerial::from(VirtualPort::serial_number);
  EXPECT_EQ(measurement.calibration, expected) << all_findings(measurement);
}

TEST(HaplyMeasurement, OfEveryVariantIsAsAssumed) {
  for (const HaplyVariant& variant : haply_variant_catalog()) {
    HaplyBench::Options device;
    device.variant = variant.name;
    HaplyRehearsal rehearsal(device);
    const HaplyMeasurement measurement = rehearsal.measure();
    EXPECT_TRUE(measurement.has_all_answers()) << variant.name << '\n' << all_findings(measurement);
    EXPECT_EQ(finding_of(measurement, encoders).state, State::as_assumed) << variant.name;
    EXPECT_EQ(finding_of(measurement, motors).state, State::as_assumed) << variant.name;
  }
}

TEST(HaplyMeasurement, FindsAWatchdog) {
  HaplyBench::Options device;
  device.board.watchdog_ns = 20'000'000;
  HaplyRehearsal rehearsal(device);
  const HaplyMeasurement measurement =
      rehearsal.measure({"Zero pose", "Encoders", "Motors' directions", "Force without commands"});
  EXPECT_EQ(finding_of(measurement, silence).sentence.find("Yes: it was gone after"), 0U) << all_findings(measurement);
}

// A hand that damps little, on a board that answers late: the wall hums, and motors go off at once.
TEST(HaplyMeasurement, FindsWhereAWallBeginsToSwing) {
  HaplyBench::Options device;
  device.board.kind = HaplyBoard::Kind::m0;
  device.fault.reply_delay_ns = 3'000'000;
  device.counts_per_turn = counts_of_variant(1.0);
  HaplyRehearsal rehearsal(device, {.grip = 40.0, .damping = 0.2});
  rehearsal.before.arms[0].counts_per_turn = rehearsal.before.arms[1].counts_per_turn = 4880.0;
  const HaplyMeasurement measurement = rehearsal.measure({"Zero pose", "Encoders", "Motors' directions", "Stiffness"});
  double stable = 0.0;
  double unstable = 0.0;
  double recommended = 0.0;
  ASSERT_EQ(std::sscanf(finding_of(measurement, stiffness).sentence.c_str(),
                        "%lf N/m; at %lf N/m the handle oscillated, held lightly. Half of it, %lf N/m", &stable,
                        &unstable, &recommended),
            3)
      << all_findings(measurement);
  EXPECT_EQ(unstable, stable + 50.0);
  EXPECT_EQ(recommended, 0.5 * stable);
}

// --- The person ---

// Its port may be another board's tomorrow.
TEST(HaplyMeasurement, OfABoardWithoutASerialNumberIsKeptForAnyBoard) {
  const TemporaryFolder folder;
  setenv("XDG_CONFIG_HOME", folder.path().c_str(), 1);
  HaplyRehearsal rehearsal;
  rehearsal.port->path = "/dev/ttyACM0";
  const HaplyMeasurement measurement = rehearsal.measure({std::string(motors)});
  EXPECT_EQ(save_haply_calibration(measurement.calibration), folder / "ghostforce/haply/any.toml");
}

TEST(HaplyMeasurement, LeavesAReversedMotorAloneWhereThePersonWantsThat) {
  HaplyRehearsal rehearsal(wrong_device());
  rehearsal.person->answers[Kind::say_yes_or_no] = {"n"};
  const HaplyMeasurement measurement = rehearsal.measure();
  EXPECT_EQ(finding_of(measurement, motors).state, State::not_measured);
  EXPECT_FALSE(measurement.calibration.arms[0].is_motor_reversed);
  EXPECT_EQ(finding_of(measurement, "Friction").sentence, "It needs the result of an earlier step that has none.");
}

TEST(HaplyMeasurement, DoesNotPushWhereAStepBeforeIsSkipped) {
  HaplyRehearsal rehearsal;
  const HaplyMeasurement measurement = rehearsal.measure({"Port", "Zero pose", "Stiffness"});
  EXPECT_EQ(rehearsal.port->drives, 0);
  EXPECT_FALSE(measurement.has_all_answers());
  EXPECT_EQ(measurement.calibration.arms, rehearsal.before.arms);
}

TEST(HaplyMeasurement, TurnsMotorsOffWhereTheHandleIsTooFastOrTooFar) {
  struct Jerk {
    Vector<2> goal;
    double time;
    std::string_view words;
  };
  for (const Jerk& jerk :
       {Jerk{{0.06, 0.11}, 0.01, "faster than 0.5 m/s"}, Jerk{{0.019, 0.04}, 0.2, "more than 40 mm"}}) {
    HaplyRehearsal rehearsal;
    rehearsal.port->on_drive = [&] {
      HaplyHandPlan plan = haply_hand_at(jerk.goal, jerk.time);
      plan.stiffness = 600.0;
      rehearsal.port->port.lead_hand(plan);
    };
    rehearsal.person->only = {"Zero pose", "Encoders", "Motors' directions"};
    await_haply(*rehearsal.haply);
    const HaplyMeasurement measurement =
        measure_haply(*rehearsal.haply, *rehearsal.person, rehearsal.before, rehearsal.debts.get());
    EXPECT_EQ(rehearsal.port->port.duties(), off);
    EXPECT_EQ(finding_of(measurement, motors).state, State::not_measured);
    EXPECT_NE(finding_of(measurement, motors).sentence.find(jerk.words), std::string::npos)
        << finding_of(measurement, motors).sentence;
    EXPECT_EQ(rehearsal.port->drives, 3) << "it is begun again twice";
    EXPECT_LT(rehearsal.port->greatest_force, 1.5);
  }
}

TEST(HaplyMeasurement, LeavesWithOrWithoutAReport) {
  HaplyRehearsal rehearsal;
  rehearsal.person->answers[Kind::turn_arm] = {"q"};
  const HaplyMeasurement measurement = rehearsal.measure();
  EXPECT_FALSE(measurement.is_complete);
  EXPECT_EQ(measurement.steps.size(), 2U);
  const std::string report = report_of(measurement, {.version = "1.2.3", .when = "today", .port = "/dev/ttyACM0"});
  for (const std::string_view words : {"The person ended it", "not tried on a device", "/dev/ttyACM0", "1.2.3",
                                       "zero pose 3:", "variant = \"v3.1\"", "round-trip"}) {
    EXPECT_NE(report.find(words), std::string::npos) << words;
  }
  HaplyRehearsal second;
  second.person->answers[Kind::turn_arm] = {"q"};
  second.person->answers[Kind::say_yes_or_no] = {"n"};
  EXPECT_THROW(second.measure(), Failure);
}

// --- Every way out ---

constexpr std::array pushing_steps{"Motors' directions", "Friction", "Motors' strength", "Force without commands",
                                   "Stiffness"};
constexpr std::array all_steps{
    "Port",     "Zero pose", "Encoders", "Motors' directions", "Friction", "Motors' strength", "Force without commands",
    "Stiffness"};

// Measures until that step's motors have been on for so long; then this happens. Returns how it ended.
std::optional<ExitCode> end_while_pushing(HaplyRehearsal& rehearsal, std::string_view step,
                                          const std::function<void()>& happens) {
  rehearsal.port->on_drive = [&] {
    if (rehearsal.person->title == step) happens();
  };
  try {
    await_haply(*rehearsal.haply);
    measure_haply(*rehearsal.haply, *rehearsal.person, rehearsal.before, rehearsal.debts.get());
  } catch (const Failure& failure) {
    return failure.code();
  }
  return std::nullopt;
}

// What remembers an interruption is for a whole process, and so is this one.
TEST(HaplyMeasurementDeathTest, InterruptedMotorsAreOff) {
  for (const std::string_view step : pushing_steps) {
    const auto interrupted_while_pushing = [&] {
      remember_interruptions(emergency_stop::stop_motors);
      HaplyRehearsal rehearsal;
      const auto code = end_while_pushing(rehearsal, step, [] { std::raise(SIGINT); });
      std::exit(code && rehearsal.port->port.duties() == off ? static_cast<int>(*code) : 1);
    };
    EXPECT_EXIT(interrupted_while_pushing(), testing::ExitedWithCode(130), "") << step;
  }
}

TEST(HaplyMeasurementDeathTest, InterruptedAtAPromptOfAnyStepMotorsAreOff) {
  for (const std::string_view step : all_steps) {
    const auto interrupted_at_prompt = [&] {
      remember_interruptions(emergency_stop::stop_motors);
      HaplyRehearsal rehearsal;
      rehearsal.person->hook = [&](const HaplyAction&) {
        if (rehearsal.person->title == step) std::raise(SIGINT);
      };
      const auto code = end_while_pushing(rehearsal, "", [] {});
      std::exit(code && rehearsal.port->port.duties() == off ? static_cast<int>(*code) : 1);
    };
    EXPECT_EXIT(interrupted_at_prompt(), testing::ExitedWithCode(130), "") << step;
  }
}

TEST(HaplyMeasurement, EndsWhereNobodyIsThereAnyMore) {
  for (const std::string_view step : all_steps) {
    HaplyRehearsal rehearsal;
    rehearsal.person->hook = [&](const HaplyAction& action) {
      if (rehearsal.person->title == step) rehearsal.person->answers[action.kind] = {std::nullopt};
    };
    EXPECT_EQ(end_while_pushing(rehearsal, "", [] {}), ExitCode::answer_is_no) << step;
    EXPECT_EQ(rehearsal.port->port.duties(), off) << step;
  }
}

// Off the cable a board keeps what it has: the person is told so, and the driver goes on trying to stop it.
TEST(HaplyMeasurement, SaysThatAMotorMayStillPushWhereTheCableIsPulledOut) {
  for (const std::string_view step : pushing_steps) {
    HaplyRehearsal rehearsal;
    VirtualPort& port = rehearsal.port->port;
    std::string words;
    rehearsal.port->on_drive = [&] {
      if (rehearsal.person->title == step) port.inject({.link = LinkFault::unplugged});
    };
    try {
      await_haply(*rehearsal.haply);
      measure_haply(*rehearsal.haply, *rehearsal.person, rehearsal.before, rehearsal.debts.get());
      ADD_FAILURE() << step;
    } catch (const Failure& failure) {
      EXPECT_EQ(failure.code(), ExitCode::device_absent);
      words = failure.what();
    }
    EXPECT_NE(words.find("may still push"), std::string::npos) << words;
    EXPECT_TRUE(rehearsal.debts->has(*DeviceSerial::from(VirtualPort::serial_number))) << step;
    port.inject({});  // plugged in again: the driver's last act stops it
    rehearsal.haply->update();
    for (const std::int64_t end_ns = port.now_ns() + 3'000'000'000; port.now_ns() < end_ns;) {
      rehearsal.haply->update();
      rehearsal.haply->wait_until(port.now_ns() + 1'000'000);
    }
    EXPECT_EQ(port.duties(), off) << step;
    EXPECT_TRUE(rehearsal.debts->empty()) << step;
  }
}

// It would be believed.
TEST(HaplyMeasurement, DoesNotSayThatMotorsWereStoppedWhereTheBoardTakesNoSetUp) {
  for (const bool takes_set_ups : {true, false}) {
    HaplyRehearsal rehearsal;
    InjectedHaplyFault forgets;
    forgets.is_another_programs = true;  // with a force
    forgets.refuses_set_ups = !takes_set_ups;
    rehearsal.port->on_drive = [&] {
      if (rehearsal.person->title == "Friction") rehearsal.port->port.inject(forgets);
    };
    await_haply(*rehearsal.haply);
    try {
      measure_haply(*rehearsal.haply, *rehearsal.person, rehearsal.before, rehearsal.debts.get());
      ADD_FAILURE() << "the board is well";
    } catch (const Failure& failure) {
      const std::string words = failure.what();
      EXPECT_EQ(words.find("Its motors were stopped.") != std::string::npos, takes_set_ups) << words;
      EXPECT_EQ(rehearsal.port->port.duties() == off, takes_set_ups) << words;
    }
  }
}

TEST(HaplyMeasurement, EndsWhereTheBoardForgetsOrFallsSilent) {
  InjectedHaplyFault restarts;
  restarts.restarts = true;
  InjectedHaplyFault silent;
  silent.reply = HaplyReplyFault::lost;
  for (const InjectedHaplyFault& fault : {restarts, silent}) {
    for (const std::string_view step : pushing_steps) {
      HaplyRehearsal rehearsal;
      EXPECT_EQ(end_while_pushing(rehearsal, step, [&] { rehearsal.port->port.inject(fault); }),
                ExitCode::device_failed)
          << step;
      EXPECT_EQ(rehearsal.port->port.duties(), off) << step;
    }
  }
}

}  // namespace
}  // namespace ghostforce::haply_measurement_test
