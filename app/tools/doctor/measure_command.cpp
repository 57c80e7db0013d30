#include "app/tools/doctor/measure_command.h"

#include <algorithm>
#include <memory>

#include <unistd.h>

#include "app/base/failure.h"
#include "app/files/falcon_calibration_file.h"
#include "app/tools/doctor/diagnosis.h"
#include "app/tools/doctor/measure_output.h"
#include "app/tools/doctor/measurement.h"
#include "device/motors/emergency_stop.h"
#include "device/servo/realtime.h"
#include "device/virtual_falcon/practice_firmware.h"
#include "device/virtual_falcon/virtual_link.h"
#include "ghostforce_version.h"

namespace ghostforce {
namespace {

constexpr unsigned practice_words = 4000;

constexpr std::string_view welcome =
    "This measures a Falcon and takes about ten minutes. You need: a table for the device, a ruler of 10 cm or more, a "
    "weight of 20 to 50 g that you know to within a gram, half a metre of thread to hang it by, and a long, soft "
    "rubber band. Hold the handle with one hand and type with the other.\n";
constexpr std::string_view safety =
    "The motors push with less than 2 N, and only while you hold down a button of the grip. They go off when you "
    "release it, when the handle moves faster than 0.3 m/s, and when it leaves the middle of its workspace. Keep the "
    "power plug within reach, and your face and fingers away from the arms.\n";
// A handle that has a weight, and joints that rub: as a real one.
VirtualLink::Options rehearsal(const InjectedFault& fault) {
  VirtualLink::Options rehearsal;
  // Where nobody watches, time need not pass.
  rehearsal.clock = isatty(STDIN_FILENO) != 0 ? VirtualLink::Clock::monotonic : VirtualLink::Clock::stepped;
  rehearsal.arm.weight = 0.3;
  rehearsal.arm.friction = 0.04;
  rehearsal.hand.homes_when_asked = true;
  rehearsal.injected_fault = fault;
  return rehearsal;
}

}  // namespace

int measure_with_doctor(const MeasureCall& call) {
  emergency_stop::refuse_to_be_stopped();
  FalconOptions options = call.falcon;
  std::unique_ptr<FalconLink> link;
  std::unique_ptr<MeasuredPerson> simulated;
  if (call.is_virtual) {
    auto there = std::make_unique<VirtualLink>(rehearsal(call.injected_fault));
    simulated = std::make_unique<MeasuredPerson>(*there, MeasuredPerson::Habits{});
    link = std::move(there);
    if (options.firmware.empty()) options.firmware = practice_firmware(practice_words);
    options.is_virtual = true;
  } else {
    link = std::make_unique<FtdiLink>(call.cable);
  }
  request_realtime();
  MeasureOutput output(call.report, call.calibration);
  Falcon falcon(std::move(link), options);
  TerminalOperator person(simulated.get());
  person.tell(welcome);
  person.tell(safety);
  person.tell(measuring_keys);
  await_homed(falcon, person);

  const auto known = std::ranges::find(options.calibrations, falcon.report().serial, &FalconCalibration::serial);
  const bool is_kept = known != options.calibrations.end();
  const FalconMeasurement measurement = measure_falcon(falcon, person, is_kept ? *known : FalconCalibration{});
  falcon.shut_down();

  output.write({.device = "Falcon",
                .is_virtual = call.is_virtual,
                .is_kept = is_kept,
                .report = report_of(measurement, {.version = std::string(version),
                                                  .when = now_in_words(),
                                                  .firmware = call.is_virtual ? "firmware: practice firmware"
                                                                              : firmware_words(call.firmware),
                                                  .is_virtual = call.is_virtual}),
                .calibration = falcon_calibration_text(measurement.calibration),
                .keep = [&] { return save_falcon_calibration(measurement.calibration); },
                .tell = [&](std::string_view words) { person.tell(words); },
                .says_yes = [&](std::string_view question) { return person.says_yes(question); }});
  return static_cast<int>(measurement.has_all_answers() ? ExitCode::done : ExitCode::answer_is_no);
}

}  // namespace ghostforce
