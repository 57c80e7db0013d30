#include "app/tools/doctor/haply_measurement.h"

#include <array>
#include <span>

#include <fmt/format.h>

#include "app/base/failure.h"
#include "app/base/interruption.h"
#include "app/files/calibration_folder.h"
#include "app/files/haply_calibration_file.h"
#include "app/tools/doctor/haply_steps.h"
#include "app/tools/doctor/readiness.h"

namespace ghostforce {
namespace {

constexpr std::array haply_measure_steps{
    HaplyStep{"Port", "The board answers a thousand questions. The motors stay off.", measure_haply_port},
    HaplyStep{"Zero pose", "You hold the zero pose, three times. The motors stay off.", measure_haply_zero_pose,
              HaplyStep::Needs::nothing, HaplyStep::Needs::zero_pose},
    HaplyStep{"Encoders", "You turn each driven link by a right angle. The motors stay off.", measure_haply_encoders,
              HaplyStep::Needs::zero_pose, HaplyStep::Needs::encoders},
    HaplyStep{"Motors' directions", "Each motor pushes gently for a moment.", measure_haply_motor_signs,
              HaplyStep::Needs::encoders, HaplyStep::Needs::motors},
    HaplyStep{"Friction", "The motors carry the handle slowly to and fro, while you let go of it.",
              measure_haply_friction, HaplyStep::Needs::motors, HaplyStep::Needs::friction},
    HaplyStep{"Motors' strength", "The motors carry the handle against a weight that you know.", measure_haply_strength,
              HaplyStep::Needs::friction},
    HaplyStep{"Force without commands",
              "The motors push gently, and the program is silent for a moment: does the board drop the force?",
              measure_haply_silence, HaplyStep::Needs::motors},
    HaplyStep{"Stiffness", "You press lightly against a wall that becomes harder.", measure_haply_stiffness,
              HaplyStep::Needs::motors},
};

}  // namespace

void await_haply(Haply& haply) {
  constexpr double absent_patience_s = 1.2;
  constexpr double patience_s = 10.0;
  const std::int64_t began_ns = haply.port().now_ns();
  for (;;) {
    stop_if_interrupted();
    haply.update();
    const HaplyReport& report = haply.report();
    if (report.state == HaplyState::zero_pose || report.is_readable()) {
      if (!report.is_guarded) throw Failure(ExitCode::device_failed, std::string(no_guard()));
      if (!haply.is_waiting_for_reply() && report.exchanges > 0) return;
    }
    const double waited_s = static_cast<double>(haply.port().now_ns() - began_ns) * 1e-9;
    if (report.state == HaplyState::fault) {
      throw Failure(exit_code_of(readiness_of(report, nullptr), true),
                    fmt::format("{} {}", sentence_of(report.fault), remedy_of(report.fault)));
    }
    if (report.has_looked && report.state == HaplyState::absent && waited_s > absent_patience_s) {
      throw Failure(ExitCode::device_absent,
                    "No board is plugged in. Plug in its power supply, then its USB cable; where several serial ports "
                    "are there, name one with --haply-port.");
    }
    if (waited_s > patience_s) throw Failure(ExitCode::device_failed, "The board does not answer.");
    haply.wait_until(haply.port().now_ns() + 1'000'000);
  }
}

HaplyMeasurement measure_haply(Haply& haply, HaplyOperator& person, const HaplyCalibration& before, StopDebts* debts) {
  HaplyCalibration begin = before;
  // A board without a serial number is known by its make and its socket, where the next one may be: what is measured is
  // then kept for any board.
  begin.serial = is_serial(haply.report().serial.text()) ? haply.report().serial : DeviceSerial();
  HaplyMeasurement measurement;
  HaplyRig rig(person, haply, begin, debts);
  measurement.is_complete = take_steps(std::span<const HaplyStep>(haply_measure_steps), rig, measurement.steps);
  measurement.calibration = rig.calibration();
  return measurement;
}

std::string report_of(const HaplyMeasurement& measurement, const HaplyOrigin& origin) {
  const std::string_view serial = measurement.calibration.serial.text();
  std::string text = fmt::format(
      "# Measurement of a Haply 2DIY\n\n- Program: ghostforce {}\n- When: {}\n- Device: {}{}, variant {}\n- Port: {}\n",
      origin.version, origin.when, serial.empty() ? "without a serial number" : serial,
      origin.is_virtual ? " (a rehearsal: this device is simulated)" : "", measurement.calibration.variant,
      origin.port);
  if (!measurement.is_complete) text += "- The person ended it before the last step.\n";
  text +=
      "\nThe program that took this was written from the published firmware; not tried on a device. What the column "
      "\"Settles\" names only a device could tell. Please open an issue with this file attached, at the place where "
      "you got this program.\n\n";
  text += results_of(measurement.steps);
  text += fmt::format("\n## Calibration file\n\n```toml\n{}```\n", haply_calibration_text(measurement.calibration));
  return text;
}

}  // namespace ghostforce
