#include "app/tools/doctor/haply_measure_command.h"

#include <algorithm>
#include <utility>

#include <unistd.h>

#include "app/base/failure.h"
#include "app/files/haply_calibration_file.h"
#include "app/tools/doctor/haply_measurement.h"
#include "app/tools/doctor/measure_output.h"
#include "device/motors/emergency_stop.h"
#include "device/servo/realtime.h"
#include "device/virtual_haply/virtual_port.h"
#include "ghostforce_version.h"

namespace ghostforce {
namespace {

constexpr std::string_view haply_welcome =
    "This measures a Haply 2DIY and takes about ten minutes. You need: a level table with a smooth, round edge for the "
    "device, a set square, a weight of 30 to 60 g that you know to within a gram, and half a metre of thread to hang "
    "it by, or a spring balance. Sit opposite the base, and type with one hand.\n";
constexpr std::string_view haply_safety =
    "The motors push with less than 1.5 N, after Enter and for a few seconds at a time. They go off when the handle "
    "moves faster than 0.5 m/s or farther than 40 mm, and on Ctrl+C. No published firmware stops them by itself: keep "
    "the plug of the power supply within reach, and your face and fingers away from the arms.\n";

VirtualPort::Options haply_rehearsal(const HaplyMeasureCall& call) {
  VirtualPort::Options rehearsal;
  // Where nobody watches, time need not pass.
  rehearsal.clock = isatty(STDIN_FILENO) != 0 ? VirtualPort::Clock::monotonic : VirtualPort::Clock::stepped;
  rehearsal.device.variant = call.haply.usual.variant;
  rehearsal.device.fault = call.injected_fault;
  return rehearsal;
}

}  // namespace

int measure_haply_with_doctor(HaplyMeasureCall call) {
  emergency_stop::refuse_to_be_stopped();
  const bool is_virtual = call.port == nullptr;
  std::unique_ptr<MeasuredHaplyPerson> simulated;
  HaplyOptions options = call.haply;
  if (is_virtual) {
    auto there = std::make_unique<VirtualPort>(haply_rehearsal(call));
    simulated = std::make_unique<MeasuredHaplyPerson>(*there, MeasuredHaplyPerson::Habits{});
    call.port = std::move(there);
    call.port_words = "none";
    options.is_virtual = true;
    options.debts.reset();  // of real ones
  }
  if (!options.debts) options.debts = std::make_shared<StopDebts>();
  request_realtime();
  MeasureOutput output(call.report, call.calibration);
  Haply haply(std::move(call.port), options);
  TerminalHaplyOperator person(simulated.get());
  person.tell(haply_welcome);
  person.tell(haply_safety);
  person.tell(measuring_keys);
  await_haply(haply);

  const HaplyMeasurement measurement = measure_haply(haply, person, haply.calibration(), options.debts.get());
  haply.shut_down();
  const bool is_kept = std::ranges::find(options.calibrations, measurement.calibration.serial,
                                         &HaplyCalibration::serial) != options.calibrations.end();

  output.write({.device = "Haply",
                .is_virtual = is_virtual,
                .is_kept = is_kept,
                .report = report_of(measurement, {.version = std::string(version),
                                                  .when = now_in_words(),
                                                  .port = call.port_words,
                                                  .is_virtual = is_virtual}),
                .calibration = haply_calibration_text(measurement.calibration),
                .keep = [&] { return save_haply_calibration(measurement.calibration); },
                .tell = [&](std::string_view words) { person.tell(words); },
                .says_yes = [&](std::string_view question) { return person.says_yes(question); }});
  return static_cast<int>(measurement.has_all_answers() ? ExitCode::done : ExitCode::answer_is_no);
}

}  // namespace ghostforce
