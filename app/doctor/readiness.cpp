#include "app/doctor/readiness.h"

#include <array>
#include <cstddef>

#include <fmt/format.h>

#include "core/motor_report.h"
#include "core/safety.h"
#include "device/falcon/falcon_report.h"

namespace ghostforce {
namespace {

// In the order of ReadinessStep.
constexpr std::array steps{
    ReadinessEntry{ReadinessStep::seen, ExitCode::device_absent, "seen", "Plugged in",
                   "Plug in the Falcon's power supply, then its USB cable."},
    ReadinessEntry{ReadinessStep::allowed, ExitCode::device_refused, "allowed", "Allowed",
                   "Run 'ghostforce doctor --install-udev' once, then plug it in again.", "this user may open it"},
    ReadinessEntry{ReadinessStep::free, ExitCode::device_refused, "free", "Free",
                   "Close the other program that has the device.", "no other program has it"},
    ReadinessEntry{ReadinessStep::firmware, ExitCode::device_failed, "firmware", "Firmware",
                   "Give it a firmware file: --firmware FILE, see docs/falcon.md.", "it answers"},
    ReadinessEntry{ReadinessStep::homed, ExitCode::device_failed, "homed", "Homed",
                   "Pull the handle all the way out, then push it straight in until it stops.",
                   "all three motors have found their zero"},
    ReadinessEntry{ReadinessStep::encoders_move, ExitCode::device_failed, "encoders_move", "Encoders move",
                   "Move the handle up and down, left and right, out and in.", "all three"},
    ReadinessEntry{ReadinessStep::fast_enough, ExitCode::answer_is_no, "fast_enough", "Fast enough",
                   "Use a USB port of the machine itself, without a hub, and close what keeps the machine busy."},
    ReadinessEntry{ReadinessStep::outside_wall, ExitCode::done, "outside_wall", "Outside the wall",
                   "Move the handle out of the wall."},
    ReadinessEntry{ReadinessStep::armed, ExitCode::done, "armed", "Armed",
                   "Hold the handle and press the safety button."},
};

struct FaultEntry {
  FalconFault id;
  // At which it keeps the device. The link tells what is wrong before it tells anything else, so all below has been
  // reached.
  ReadinessStep step;
  std::string_view remedy;
};
// In the order of FalconFault.
constexpr std::array faults{
    FaultEntry{FalconFault::none, ReadinessStep::seen, ""},
    FaultEntry{FalconFault::not_allowed, ReadinessStep::allowed,
               "This user may not open the device. Run 'ghostforce doctor --install-udev' once, then plug the device "
               "in again."},
    FaultEntry{FalconFault::busy, ReadinessStep::free, "Close the other program that has the device."},
    FaultEntry{FalconFault::unsupported, ReadinessStep::free,
               "What is plugged in has not the one interface with two bulk endpoints that a Falcon has."},
    FaultEntry{FalconFault::unplugged, ReadinessStep::seen,
               "Plug it in again: it is looked for all the time. Motors stay off until you arm them."},
    FaultEntry{FalconFault::broken, ReadinessStep::firmware,
               "Use another cable or another USB port, one of the machine itself."},
    FaultEntry{FalconFault::no_firmware, ReadinessStep::firmware,
               "The device has no firmware and there is no file to give it: name one with --firmware FILE, or see "
               "docs/falcon.md for where to put it."},
    FaultEntry{FalconFault::no_handshake, ReadinessStep::firmware,
               "The device does not answer its boot loader's call. Unplug both its cables, wait 5 s, plug power in "
               "first; then another USB port."},
    FaultEntry{
        FalconFault::no_baud_answer, ReadinessStep::firmware,
        "The device does not follow to the upload's rate. Unplug both its cables, wait 5 s, and plug them in again."},
    FaultEntry{FalconFault::echo_missing, ReadinessStep::firmware,
               "A byte of the firmware was not echoed. Use another cable or USB port; if it stays, unplug both cables "
               "for 5 s."},
    FaultEntry{FalconFault::echo_differs, ReadinessStep::firmware,
               "A byte of the firmware came back as another. Use another cable or USB port, without a hub."},
    FaultEntry{FalconFault::firmware_silent, ReadinessStep::firmware,
               "The firmware is loaded and answers nothing: is it the file for this device? Compare its SHA-256 with "
               "docs/falcon.md."},
    FaultEntry{FalconFault::no_replies, ReadinessStep::firmware,
               "Is the device's power supply plugged in? It is being opened again by itself."},
    FaultEntry{FalconFault::kinematics, ReadinessStep::homed,
               "The encoders tell a position that the arms cannot have: home the device again (F2), and check the "
               "geometry in its calibration file."},
};
static_assert(faults.size() == static_cast<std::size_t>(FalconFault::kinematics) + 1);

// The wire to the device is dead, and what it was told last was a force.
constexpr std::string_view still_pushing =
    "The motors may still push, and nothing from here reaches them: pull the plug of the device's power supply. ";

constexpr std::array<std::string_view, 3> motor_names{"motor 1", "motor 2", "motor 3"};

// The motors of which `is_so` is `wanted`: "motor 1, motor 3".
std::string motors_where(const std::array<bool, 3>& is_so, bool wanted) {
  std::string names;
  for (std::size_t i = 0; i < is_so.size(); ++i) {
    if (is_so[i] != wanted) continue;
    names += names.empty() ? "" : ", ";
    names += motor_names[i];
  }
  return names.empty() ? "none" : names;
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

bool are_on(const MotorReport& motors) noexcept {
  return motors.state == SafetyState::ramp || motors.state == SafetyState::on;
}

class ReadinessCheck {
 public:
  ReadinessCheck(const FalconReport& report, const MotorReport* motors)
      : report_(report), motors_(motors), way_(way_of(report)) {}

  std::vector<ReadinessStepState> states() const {
    std::vector<ReadinessStepState> states;
    bool is_below_current = true;
    for (const ReadinessEntry& entry : steps) {
      if (motors_ == nullptr && entry.id > ReadinessStep::fast_enough) break;
      ReadinessStepState state{.step = entry.id, .name = entry.name, .title = entry.title, .words = {}};
      state.is_reached = is_reached(entry.id);
      state.is_current = is_below_current && !state.is_reached;
      is_below_current = is_below_current && state.is_reached;
      if (state.is_current && report_.state == FalconState::fault && report_.fault != FalconFault::none) {
        const FalconFaultEntry& fault = entry_of(report_.fault);
        state.words =
            fmt::format("{}{}: {}", report_.may_still_push ? still_pushing : "", fault.title, remedy_of(fault.id));
      } else if (state.is_reached || state.is_current || is_measured_too_slow(entry.id)) {
        state.words = words(entry, state.is_reached);
      }
      states.push_back(std::move(state));
    }
    return states;
  }

 private:
  bool is_reached(ReadinessStep step) const noexcept {
    switch (step) {
      case ReadinessStep::encoders_move:
        return report_.is_readable() && report_.encoders_move();
      case ReadinessStep::fast_enough:
        return is_fast_and_even(report_);
      case ReadinessStep::outside_wall:
        // Who has armed was outside then, and may go in.
        return motors_ != nullptr && motors_->is_handle_known && (motors_->is_outside_wall || are_on(*motors_));
      case ReadinessStep::armed:
        return motors_ != nullptr && are_on(*motors_);
      default:
        return step < way_;
    }
  }

  // Needs no hand, so it may fail before its turn.
  bool is_measured_too_slow(ReadinessStep step) const noexcept {
    return step == ReadinessStep::fast_enough && attainable_exchange_hz(report_) > 0.0 && !is_fast_and_even(report_);
  }

  std::string words(const ReadinessEntry& entry, bool reached) const {
    switch (entry.id) {
      case ReadinessStep::seen:
        if (!reached || report_.serial.text().empty()) break;
        return fmt::format("serial number {}", report_.serial.text());
      case ReadinessStep::firmware:
        if (reached) break;
        return firmware_words();
      case ReadinessStep::homed:
        if (reached) break;
        return fmt::format("homed: {}; counts {}, {}, {}. {}", motors_where(report_.has_homed, true),
                           report_.encoders[0], report_.encoders[1], report_.encoders[2], entry.remedy);
      case ReadinessStep::encoders_move:
        if (reached) break;
        return fmt::format("not moved yet: {}. {}", motors_where(report_.has_moved, false), entry.remedy);
      case ReadinessStep::fast_enough:
        return speed_words(entry, reached);
      case ReadinessStep::armed:
        return armed_words(entry);
      default:
        break;
    }
    return std::string(reached ? entry.reached : entry.remedy);
  }

  std::string firmware_words() const {
    const std::string before =
        report_.fault == FalconFault::none ? "" : fmt::format("; before: {}", entry_of(report_.fault).title);
    if (report_.state == FalconState::opening) return "it is asked whether it has firmware" + before;
    return fmt::format("loading, attempt {} of {}, {} of {} bytes{}", report_.attempt, report_.attempts,
                       report_.bytes_echoed, report_.firmware_size, before);
  }

  std::string speed_words(const ReadinessEntry& entry, bool reached) const {
    if (report_.exchange_hz == 0.0) return "being measured";
    const std::string measured =
        fmt::format("{:.0f} exchanges/s, {:.2f} ms each, worst {:.1f} ms", attainable_exchange_hz(report_),
                    1e3 * report_.exchange_s, 1e3 * report_.worst_exchange_s);
    return reached ? measured : fmt::format("{}. {}", measured, entry.remedy);
  }

  std::string armed_words(const ReadinessEntry& entry) const {
    switch (motors_->state) {
      case SafetyState::off:
      case SafetyState::fade: {
        if (motors_->reason == OffReason::none) break;
        const OffReasonEntry& reason = entry_of(motors_->reason);
        return fmt::format("{}: {}", reason.title, reason.remedy);
      }
      case SafetyState::arming:
        return std::string(entry_of(motors_->obstacle).sentence);
      case SafetyState::ramp:
      case SafetyState::on:
        return fmt::format("motors on, {:.1f} N at most", motors_->limit);
    }
    return std::string(entry.remedy);
  }

  const FalconReport& report_;
  const MotorReport* motors_;
  ReadinessStep way_;
};

}  // namespace

std::span<const ReadinessEntry> readiness_catalog() noexcept {
  return steps;
}

const ReadinessEntry& entry_of(ReadinessStep step) noexcept {
  return steps[static_cast<std::size_t>(step)];
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
  return ReadinessCheck(report, motors).states();
}

ExitCode exit_code_of(std::span<const ReadinessStepState> readiness, bool needs_homing) {
  for (const ReadinessStepState& state : readiness) {
    const bool is_left_out =
        !needs_homing && (state.step == ReadinessStep::homed || state.step == ReadinessStep::encoders_move);
    const ExitCode code = entry_of(state.step).exit_code;
    if (!state.is_reached && !is_left_out && code != ExitCode::done) return code;
  }
  return ExitCode::done;
}

ExitCode exit_code_of(const FalconReport& report, bool needs_homing) {
  return exit_code_of(readiness_of(report, nullptr), needs_homing);
}

}  // namespace ghostforce
