#include "app/tools/doctor/readiness.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <cstdlib>

#include <fmt/format.h>

#include "core/safety.h"
#include "device/falcon/falcon_report.h"

namespace ghostforce {
namespace {

// In the order of ReadinessStep.
constexpr std::array steps{
    ReadinessEntry{ReadinessStep::seen, ExitCode::device_absent, "seen", "Plugged in", "Not plugged in",
                   "Plug in the Falcon's power supply, then its USB cable.", "The computer sees the device."},
    ReadinessEntry{ReadinessStep::allowed, ExitCode::device_refused, "allowed", "Allowed", "Not allowed",
                   "Run 'ghostforce doctor --install-udev' once, then plug it in again.", "This user may open it."},
    ReadinessEntry{ReadinessStep::free, ExitCode::device_refused, "free", "Free", "Not free",
                   "Close the other program that is using the device.", "No other program is using it."},
    ReadinessEntry{ReadinessStep::firmware, ExitCode::device_failed, "firmware", "Firmware answers",
                   "Firmware does not answer", "Give it a firmware file: --firmware FILE, see docs/falcon.md.",
                   "The firmware is loaded and running."},
    ReadinessEntry{ReadinessStep::homed, ExitCode::device_failed, "homed", "Homed", "Not homed",
                   "Pull the handle all the way out, then push it straight in until it stops.",
                   "All three motors have found their zero."},
    ReadinessEntry{ReadinessStep::encoders_move, ExitCode::device_failed, "encoders_move", "Encoders move",
                   "Encoders not moved yet",
                   "Move the handle up and down, left and right, out and in. If that changes nothing, unplug both "
                   "cables, wait 5 s, and plug them in again. An encoder that still does not move is broken.",
                   "All three motors have moved."},
    ReadinessEntry{ReadinessStep::fast_enough, ExitCode::answer_is_no, "fast_enough", "Fast enough", "Not fast enough",
                   "Use a USB port on the computer itself, without a hub, and close programs that keep it busy.", ""},
    ReadinessEntry{ReadinessStep::outside_wall, ExitCode::done, "outside_wall", "Outside the wall", "In the wall",
                   "Move the handle out of the wall.", "Nothing pushes on the handle yet."},
    ReadinessEntry{ReadinessStep::armed, ExitCode::done, "armed", "Armed", "Not armed",
                   "Hold the handle and press the button “Arm the motors”.", ""},
};

struct FaultEntry {
  FalconFault id;
  // At which it keeps the device. The link tells what is wrong before it tells anything else, so all below has been
  // reached.
  ReadinessStep step;
  std::string_view sentence;  // what is wrong
  std::string_view remedy;
};
// In the order of FalconFault.
constexpr std::array faults{
    FaultEntry{FalconFault::none, ReadinessStep::seen, "", ""},
    FaultEntry{FalconFault::not_allowed, ReadinessStep::allowed, "This user may not open the device.",
               "Run 'ghostforce doctor --install-udev' once, then plug the device in again."},
    FaultEntry{FalconFault::busy, ReadinessStep::free, "Another program is using the device.", "Close that program."},
    FaultEntry{FalconFault::unsupported, ReadinessStep::free,
               "The device that is plugged in lacks the USB interface with two bulk endpoints that a Falcon has.",
               "Plug in another Falcon."},
    FaultEntry{FalconFault::unplugged, ReadinessStep::seen, "The device was unplugged.",
               "Plug it in again: the program keeps looking for it. The motors stay off until you arm them."},
    FaultEntry{FalconFault::broken, ReadinessStep::firmware, "The USB transfers fail.",
               "Use another cable or another USB port, one on the computer itself."},
    FaultEntry{FalconFault::no_firmware, ReadinessStep::firmware,
               "The device has no firmware, and there is no file to give it.",
               "Name one with --firmware FILE, or see docs/falcon.md for where to put it."},
    FaultEntry{FalconFault::no_handshake, ReadinessStep::firmware, "The boot loader of the device does not answer.",
               "Unplug both its cables, wait 5 s, and plug power in first. If that does not help, use another USB "
               "port."},
    FaultEntry{FalconFault::no_baud_answer, ReadinessStep::firmware,
               "The boot loader stopped answering at the data rate of the upload.",
               "Unplug both its cables, wait 5 s, and plug them in again."},
    FaultEntry{FalconFault::echo_missing, ReadinessStep::firmware,
               "The upload of the firmware broke off: a byte was not echoed.",
               "Use another cable or USB port. If it happens again, unplug both cables for 5 s."},
    FaultEntry{FalconFault::echo_differs, ReadinessStep::firmware,
               "The upload of the firmware was garbled: a byte came back changed.",
               "Use another cable or USB port, without a hub."},
    FaultEntry{FalconFault::firmware_silent, ReadinessStep::firmware, "The firmware is loaded but does not answer.",
               "Check that the file is for this device: compare its SHA-256 with docs/falcon.md."},
    FaultEntry{FalconFault::no_replies, ReadinessStep::firmware, "The device has stopped answering.",
               "Check that its power supply is plugged in. The program opens the device again by itself."},
    FaultEntry{FalconFault::kinematics, ReadinessStep::homed,
               "The encoders report a position that the arms cannot reach.",
               "Home the device again (F2), and check the geometry in its calibration file."},
    FaultEntry{FalconFault::overruled, ReadinessStep::free,
               "The program did not run for 20 ms, so its guard turned the motors off.",
               "Close other busy programs. The program opens the device again by itself."},
    FaultEntry{FalconFault::unguarded, ReadinessStep::free, "The guard of the motors has ended.",
               "The program opens the device again by itself, with a new guard."},
    FaultEntry{FalconFault::stop_owed, ReadinessStep::firmware,
               "Another Falcon, whose motors may still push, was plugged in again.",
               "Wait a moment: the program stops that one first, and then continues with this one."},
};
static_assert(faults.size() == static_cast<std::size_t>(FalconFault::stop_owed) + 1);

// What a device was told last was a force, or it has not answered since it was told to stop.
std::string still_pushing(const FalconReport& report) {
  return left_pushing_words(report.owed_serial) + " The program stops them as soon as the device answers again.";
}

// The motors of which `is_so` is `wanted`: "motor 1 and motor 3".
std::string motors_where(const std::array<bool, 3>& is_so, bool wanted) {
  std::string names;
  for (std::size_t i = 0; i < is_so.size(); ++i) {
    if (is_so[i] == wanted) names += fmt::format("{}motor {}", names.empty() ? "" : " and ", i + 1);
  }
  return names;
}

std::string sentence_from(std::string words) {
  words.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(words.front())));
  return words;
}

std::string_view have(std::ptrdiff_t count) {
  return count == 1 ? "has" : "have";
}

std::string homed_words(const std::array<bool, 3>& has_homed) {
  const std::ptrdiff_t count = std::ranges::count(has_homed, true);
  if (count == 0) return "No motor has found its zero yet.";
  if (count == 3) return "All three motors have found their zero.";
  return sentence_from(fmt::format("{} {} found {} zero, {} {} not.", motors_where(has_homed, true), have(count),
                                   count == 1 ? "its" : "their", motors_where(has_homed, false), have(3 - count)));
}

std::string moved_words(const std::array<bool, 3>& has_moved) {
  const std::ptrdiff_t count = std::ranges::count(has_moved, false);
  if (count == 3) return "No motor has moved yet.";
  return sentence_from(fmt::format("{} {} not moved yet.", motors_where(has_moved, false), have(count)));
}

std::string count_words(int count) {
  return fmt::format("{}{}", count < 0 ? "−" : "", std::abs(count));
}

const FaultEntry& readiness_fault(FalconFault fault) noexcept {
  return faults[static_cast<std::size_t>(fault)];
}

// How far the device has come by itself, up to being homed: the first step that is not reached.
ReadinessStep way_of(const FalconReport& report) noexcept {
  switch (report.state) {
    case FalconState::absent:
      return ReadinessStep::seen;
    case FalconState::fault:
      return readiness_fault(report.fault).step;
    case FalconState::opening:
    case FalconState::loading_firmware:
      return ReadinessStep::firmware;
    case FalconState::homing:
      return ReadinessStep::homed;
    case FalconState::idle:
    case FalconState::active:
      return ReadinessStep::encoders_move;
  }
  return ReadinessStep::seen;
}

std::string firmware_words(const FalconReport& report) {
  const std::string before =
      report.fault == FalconFault::none ? "" : fmt::format(" The previous attempt: {}.", entry_of(report.fault).title);
  if (report.state == FalconState::opening) return "The program is asking it whether it has firmware." + before;
  return fmt::format("It is being loaded, attempt {} of {}: {} of {} bytes are done.{}", report.attempt,
                     report.attempts, report.bytes_echoed, report.firmware_size, before);
}

DeviceSteps steps_of(const FalconReport& report) {
  DeviceSteps device{.catalog = steps,
                     .way = way_of(report),
                     .is_readable = report.is_readable(),
                     .encoders_move = report.is_readable() && report.encoders_move(),
                     .is_guarded = report.is_guarded,
                     .is_fast_and_even = is_fast_and_even(report),
                     .may_still_push = report.may_still_push,
                     .exchange_hz = attainable_exchange_hz(report),
                     .exchange_s = report.exchange_s,
                     .worst_exchange_s = report.worst_exchange_s,
                     .still_pushing = still_pushing(report),
                     .firmware_words = firmware_words(report),
                     .homed_words = fmt::format("{} The encoders read {}, {} and {}.", homed_words(report.has_homed),
                                                count_words(report.encoders[0]), count_words(report.encoders[1]),
                                                count_words(report.encoders[2])),
                     .moved_words = moved_words(report.has_moved)};
  if (!report.serial.text().empty()) device.seen_words = fmt::format("Its serial number is {}.", report.serial.text());
  if (report.state == FalconState::fault && report.fault != FalconFault::none) {
    device.fault_sentence = readiness_fault(report.fault).sentence;
    device.fault_remedy = readiness_fault(report.fault).remedy;
  }
  return device;
}

}  // namespace

std::span<const ReadinessEntry> readiness_catalog() noexcept {
  return steps;
}

const ReadinessEntry& entry_of(ReadinessStep step) noexcept {
  return steps[static_cast<std::size_t>(step)];
}

std::string left_pushing_words(const DeviceSerial& serial) {
  const std::string_view number = serial.text();
  return fmt::format("The motors{}{} may still push: unplug the device's power supply now, then its USB cable.",
                     number.empty() ? "" : " of the Falcon with the serial number ", number);
}

std::string_view sentence_of(FalconFault fault) noexcept {
  return readiness_fault(fault).sentence;
}

std::string_view remedy_of(FalconFault fault) noexcept {
  return readiness_fault(fault).remedy;
}

double attainable_exchange_hz(const FalconReport& report) noexcept {
  if (report.state != FalconState::homing) return report.exchange_hz;
  return report.exchange_s > 0.0 && report.exchange_hz > 0.0 ? 1.0 / report.exchange_s : 0.0;
}

bool is_fast_and_even(const FalconReport& report) noexcept {
  if (report.state != FalconState::homing && !report.is_readable()) return false;
  return attainable_exchange_hz(report) >= FalconReport::fast_enough_hz &&
         report.worst_exchange_s < Safety::longest_exchange_s;
}

std::vector<ReadinessStepState> readiness_of(const FalconReport& report, const MotorReport* motors) {
  return readiness_of(steps_of(report), motors);
}

ExitCode exit_code_of(const FalconReport& report, bool needs_homing) {
  return exit_code_of(readiness_of(report, nullptr), needs_homing);
}

}  // namespace ghostforce
