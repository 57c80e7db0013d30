#include "app/tools/doctor/measurement.h"

#include <array>
#include <utility>

#include <fmt/format.h>

#include "app/base/failure.h"
#include "app/base/interruption.h"
#include "app/files/falcon_calibration_file.h"
#include "app/tools/doctor/readiness.h"

namespace ghostforce {
namespace {

constexpr double homing_patience_s = 300.0;
// A device is looked for twice a second.
constexpr double absent_patience_s = 1.2;

}  // namespace

void await_homed(Falcon& falcon, Operator& person) {
  constexpr std::int64_t tick_ns = 1'000'000;
  const auto now_ns = [&falcon] { return falcon.link().now_ns(); };
  const std::int64_t began_ns = now_ns();
  FalconState told = FalconState::absent;
  for (;;) {
    stop_if_interrupted();
    falcon.update();
    const FalconReport& report = falcon.report();
    if (report.is_readable()) {
      if (!report.is_guarded) throw Failure(ExitCode::device_failed, std::string(no_guard()));
      return;
    }
    const double waited_s = static_cast<double>(now_ns() - began_ns) * 1e-9;
    if (report.has_looked && report.state == FalconState::absent && waited_s > absent_patience_s) {
      throw Failure(ExitCode::device_absent, "No Falcon is plugged in. Plug in its power supply, then its USB cable.");
    }
    if (report.state == FalconState::fault) {
      throw Failure(exit_code_of(report, true),
                    fmt::format("{} {}", sentence_of(report.fault), remedy_of(report.fault)));
    }
    if (std::exchange(told, report.state) != report.state) {
      if (told == FalconState::loading_firmware) person.tell("The firmware is being loaded; this takes a few seconds.");
      if (told == FalconState::homing) {
        person.tell(
            "Home the device: pull the handle all the way out, then push it straight in until it stops. The program "
            "then continues by itself.");
      }
    }
    if (waited_s > homing_patience_s) {
      throw Failure(
          ExitCode::device_failed,
          "The Falcon was not homed within five minutes. Check that its power supply is plugged in, and start again.");
    }
    falcon.wait_until(now_ns() + tick_ns);
  }
}

FalconMeasurement measure_falcon(Falcon& falcon, Operator& person, const FalconCalibration& before) {
  FalconCalibration begin;
  begin.serial = falcon.report().serial;
  begin.center = before.center;
  begin.right_axis = before.right_axis;
  begin.up_axis = before.up_axis;
  begin.scale = before.scale;

  FalconMeasurement measurement;
  MeasuringRig rig(person, falcon.lend_link(), begin);
  measurement.is_complete = take_steps(measure_step_catalog(), rig, measurement.steps);
  measurement.calibration = rig.calibration();
  return measurement;
}

std::string report_of(const FalconMeasurement& measurement, const MeasurementOrigin& origin) {
  std::string text =
      fmt::format("# Measurement of a Novint Falcon\n\n- Program: ghostforce {}\n- When: {}\n- Device: {}{}\n- {}\n",
                  origin.version, origin.when, measurement.calibration.serial.text(),
                  origin.is_virtual ? " (a rehearsal: this device is simulated)" : "", origin.firmware);
  if (!measurement.is_complete) text += "- The person ended it before the last step.\n";
  text +=
      "\nUncertainties are two standard deviations. Please open an issue with this file attached, at the place where "
      "you got this program.\n\n";
  text += results_of(measurement.steps);
  text += fmt::format("\n## Calibration file\n\n```toml\n{}```\n", falcon_calibration_text(measurement.calibration));
  return text;
}

namespace {

using Needs = MeasureStep::Needs;

constexpr std::array measure_steps{
    MeasureStep{"Encoders", "You move the handle in three directions. The motors stay off.", measure_encoders,
                Needs::nothing, Needs::encoders},
    MeasureStep{"Lengths", "You move the handle along a ruler, five times. The motors stay off.", measure_lengths,
                Needs::encoders},
    MeasureStep{"Motors' directions", "Each motor pushes gently for a second while you hold down a button of the grip.",
                measure_motor_signs, Needs::encoders, Needs::motors},
    MeasureStep{
        "Motors' strength",
        "The motors carry the handle, with and without a weight on it, while one fingertip holds down a button.",
        measure_motor_constant, Needs::motors},
    MeasureStep{"Force without commands",
                "The motors push gently, and the program is silent for up to a second: does the device drop the force?",
                measure_silence, Needs::motors},
    MeasureStep{"Exchanges", "You hold the handle still. The motors stay off.", measure_exchanges},
    MeasureStep{"Lights", "You say what colour the device's light is. The motors stay off.", check_lights},
    MeasureStep{"Buttons", "You press the four buttons of the grip. The motors stay off.", check_buttons},
};

}  // namespace

std::span<const MeasureStep> measure_step_catalog() noexcept {
  return measure_steps;
}

}  // namespace ghostforce
