#include "app/tools/doctor/measure_command.h"

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <memory>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include "app/base/failure.h"
#include "app/base/interruption.h"
#include "app/base/quoted.h"
#include "app/base/words.h"
#include "app/files/falcon_calibration_file.h"
#include "app/files/output_file.h"
#include "app/tools/doctor/diagnosis.h"
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
constexpr std::string_view keys =
    "Enter: done, continue. s: skip this step. q: end, with or without a report. Ctrl+C: end at once and write "
    "nothing.\n";

std::string now_in_words() {
  return fmt::format("{:%Y-%m-%d %H:%M UTC}", fmt::gmtime(std::time(nullptr)));
}

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

void write_calibration(const MeasureCall& call, std::optional<OutputFile>& file, bool is_there,
                       const FalconCalibration& calibration, bool is_kept, Operator& person) {
  if (file) {
    const std::string shown = quoted_text(*call.calibration, longest_path);
    if (is_there &&
        !person.says_yes(fmt::format("{} already exists. Replace it with the new calibration? Type y or n.", shown))) {
      person.tell("It was not changed. The report also contains the calibration.");
      return;
    }
    file->write(falcon_calibration_text(calibration));
    file->commit();
    person.tell(fmt::format("The calibration is in {}.", shown));
    return;
  }
  if (call.is_virtual) {
    person.tell(
        "The calibration is in the report. It is not kept, because this device is simulated; --calibration FILE writes "
        "it to a file.");
    return;
  }
  const bool wants =
      person.says_yes(is_kept ? "There is already a calibration for this Falcon. Replace it with the new one, for "
                                "every later start? Type y or n."
                              : "Keep this calibration for this Falcon, for every later start? Type y or n.");
  if (!wants) {
    person.tell("It was not kept. The report contains it.");
    return;
  }
  const std::filesystem::path path = save_falcon_calibration(calibration);
  person.tell(fmt::format("The calibration is in {}.", quoted_text(path.string(), longest_path)));
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
  // Before anybody has worked for ten minutes.
  OutputFile report(call.report);
  std::optional<OutputFile> calibration_file;
  std::error_code error;
  const bool is_there = call.calibration && std::filesystem::exists(*call.calibration, error);
  if (call.calibration) calibration_file.emplace(*call.calibration);
  Falcon falcon(std::move(link), options);
  TerminalOperator person(simulated.get());
  person.tell(welcome);
  person.tell(safety);
  person.tell(keys);
  await_homed(falcon, person);

  const auto known = std::ranges::find(options.calibrations, falcon.report().serial, &FalconCalibration::serial);
  const bool is_kept = known != options.calibrations.end();
  const FalconMeasurement measurement = measure_falcon(falcon, person, is_kept ? *known : FalconCalibration{});
  falcon.shut_down();

  report.write(report_of(measurement,
                         {.version = std::string(version),
                          .when = now_in_words(),
                          .firmware = call.is_virtual ? "firmware: practice firmware" : firmware_words(call.firmware),
                          .is_virtual = call.is_virtual}));
  report.commit();
  if (call.report != "-") person.tell(fmt::format("The report is in {}.", quoted_text(call.report, longest_path)));
  if (!call.is_virtual)
    person.tell("Please open an issue with the report attached, at the place where you got this program.");
  write_calibration(call, calibration_file, is_there, measurement.calibration, is_kept, person);
  return static_cast<int>(measurement.has_all_answers() ? ExitCode::done : ExitCode::answer_is_no);
}

namespace {

constexpr std::size_t widest_line = 78;

// Broken between words; what begins with spaces goes on with as many.
std::string broken_for_terminal(std::string_view words) {
  const std::size_t begin = std::min(words.find_first_not_of("\n "), words.size());
  const std::string_view blanks = words.substr(0, begin);
  const std::string_view indent = blanks.substr(blanks.rfind('\n') + 1);  // after no line's end: npos + 1 is 0
  return fmt::format("{}{}", blanks, wrapped(words.substr(begin), widest_line - indent.size(), indent));
}

}  // namespace

void TerminalOperator::tell(std::string_view words) {
  say("{}\n", broken_for_terminal(words));
}

std::optional<std::string> TerminalOperator::ask(const OperatorAction& action, std::string_view words) {
  say("\n");
  tell(words);
  const std::string answer = simulated_ == nullptr ? "" : simulated_->act(action);
  if (!answer.empty()) {
    tell(fmt::format("(Rehearsal: press Enter to answer {}.)", answer));
  } else if (simulated_ != nullptr) {
    tell("(Rehearsal: the simulated hand does it.)");
  }
  say("> ");
  // What somebody has begun to type and never sent is no answer: motors may follow it.
  const InputLine line = read_line(STDIN_FILENO);
  if (!line.is_whole) return std::nullopt;
  return line.text.empty() ? answer : line.text;
}

void TerminalOperator::cue(const OperatorAction& action) {
  if (simulated_ != nullptr) simulated_->act(action);
}

}  // namespace ghostforce
