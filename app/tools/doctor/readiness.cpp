#include "app/tools/doctor/readiness.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/safety.h"

namespace ghostforce {
namespace {

// Its words are for a terminal, and for the desktop's window.
constexpr std::string_view device_status_key = "F2";

bool are_on(const MotorReport& motors) noexcept {
  return motors.state == SafetyState::ramp || motors.state == SafetyState::on;
}

class ReadinessCheck {
 public:
  ReadinessCheck(const DeviceSteps& device, const MotorReport* motors) : device_(device), motors_(motors) {}

  std::vector<ReadinessStepState> states() const {
    std::vector<ReadinessStepState> states;
    bool is_below_current = true;
    for (const ReadinessEntry& entry : device_.catalog) {
      if (motors_ == nullptr && entry.id > ReadinessStep::fast_enough) break;
      ReadinessStepState state{.step = entry.id, .name = entry.name, .title = entry.title, .words = {}};
      state.is_reached = is_reached(entry.id);
      state.is_current = is_below_current && !state.is_reached;
      is_below_current = is_below_current && state.is_reached;
      const bool has_failed = state.is_current || is_measured_too_slow(entry.id) || has_turned_off(entry.id);
      if (has_failed) state.title = entry.open_title;
      if (entry.id == ReadinessStep::outside_wall && state.is_reached && are_on(*motors_)) {
        state.title = "Outside when armed";
      }
      if (entry.id == ReadinessStep::outside_wall && has_failed && !motors_->is_handle_known) {
        state.title = "Handle not found yet";
      }
      if (state.is_current && !device_.fault_sentence.empty()) {
        // What to do about motors that may push comes first, and nothing against it beside it.
        state.words = device_.fault_sentence;
        if (!device_.may_still_push) state.words.append(" ").append(device_.fault_remedy);
      } else if (state.is_reached || has_failed) {
        state.words = words(entry, state);
      }
      states.push_back(std::move(state));
    }
    // Where everybody looks, whatever else is so: it may be another device than the one that is in use.
    const auto current = std::ranges::find(states, true, &ReadinessStepState::is_current);
    ReadinessStepState& shown = current == states.end() ? states.back() : *current;
    if (device_.may_still_push) {
      shown.words = device_.still_pushing + (shown.words.empty() ? "" : " ") + shown.words;
    }
    return states;
  }

 private:
  bool is_reached(ReadinessStep step) const noexcept {
    switch (step) {
      case ReadinessStep::encoders_move:
        return device_.encoders_move;
      case ReadinessStep::fast_enough:
        return device_.is_fast_and_even;
      case ReadinessStep::outside_wall:
        // Who has armed was outside then, and may go in.
        return motors_ != nullptr && motors_->is_handle_known && (motors_->is_outside_wall || are_on(*motors_));
      case ReadinessStep::armed:
        return motors_ != nullptr && are_on(*motors_);
      default:
        return step < device_.way;
    }
  }

  // Needs no hand, so it may fail before its turn.
  bool is_measured_too_slow(ReadinessStep step) const noexcept {
    return step == ReadinessStep::fast_enough && device_.exchange_hz > 0.0 && !device_.is_fast_and_even;
  }

  // Why the motors went off is told until a person has acknowledged it, wherever the handle is.
  bool has_turned_off(ReadinessStep step) const noexcept {
    return step == ReadinessStep::armed && !are_on(*motors_) && motors_->reason != OffReason::none;
  }

  std::string words(const ReadinessEntry& entry, const ReadinessStepState& state) const {
    const bool reached = state.is_reached;
    switch (entry.id) {
      case ReadinessStep::seen:
        if (!reached || device_.seen_words.empty()) break;
        return device_.seen_words;
      case ReadinessStep::firmware:
        if (reached || device_.firmware_words.empty()) break;
        return device_.firmware_words;
      case ReadinessStep::homed:
        if (reached) break;
        return fmt::format("{} {}", device_.homed_words, entry.remedy);
      case ReadinessStep::encoders_move:
        if (reached) break;
        return fmt::format("{} {}", device_.moved_words, entry.remedy);
      case ReadinessStep::fast_enough:
        return speed_words(entry, reached);
      case ReadinessStep::outside_wall:
        if (!reached && !motors_->is_handle_known) return "The position of the handle is not known yet.";
        if (are_on(*motors_)) return "The handle was outside when the motors were armed.";
        break;
      case ReadinessStep::armed:
        return armed_words(entry, state.is_current);
      default:
        break;
    }
    return std::string(reached ? entry.reached : entry.remedy);
  }

  std::string speed_words(const ReadinessEntry& entry, bool reached) const {
    if (device_.exchange_hz == 0.0) return "The speed is being measured.";
    const std::string measured =
        fmt::format("The device answers {:.0f} times a second, after {:.2f} ms on average and {:.1f} ms at worst.",
                    device_.exchange_hz, 1e3 * device_.exchange_s, 1e3 * device_.worst_exchange_s);
    return reached ? measured : fmt::format("{} {}", measured, entry.remedy);
  }

  std::string armed_words(const ReadinessEntry& entry, bool is_current) const {
    switch (motors_->state) {
      case SafetyState::off:
      case SafetyState::fade: {
        const OffReason why = motors_->reason != OffReason::none ? motors_->reason : motors_->last_reason;
        // What may still push is not said to be off, and nobody is asked to arm it, read or not.
        if (device_.may_still_push && why != OffReason::none) {
          return fmt::format("The motors were told to stop: {}.", entry_of(why).title);
        }
        if (motors_->reason == OffReason::none) {
          if (device_.is_readable && !device_.is_guarded) return std::string(no_guard());
          const OffReasonEntry& last = entry_of(motors_->last_reason);
          if (!last.at_once && !last.is_safety_limit) break;
          return fmt::format("{} {}", entry.remedy, turned_off_words("The last time, the motors went off", last));
        }
        if (device_.is_readable && is_of_device(motors_->reason)) {
          // Where a step before is still to come, that one says what to do.
          return fmt::format("The motors went off: {}.{}", entry_of(motors_->reason).title,
                             is_current ? " The device works again: arm the motors." : "");
        }
        return turned_off_words("The motors went off", entry_of(motors_->reason));
      }
      case SafetyState::arming:
        if (motors_->obstacle == ArmingObstacle::none) return "The motors are being armed.";
        return fmt::format("The motors are not on yet: {}.",
                           fmt::format(fmt::runtime(entry_of(motors_->obstacle).sentence), device_status_key));
      case SafetyState::ramp:
      case SafetyState::on:
        if (motors_->is_checking) return "The motors are being checked: hold the handle still.";
        return fmt::format("The motors are on and push with {:.1f} N at most.", motors_->limit);
    }
    return std::string(entry.remedy);
  }

  // What its steps say as long as it is so.
  static bool is_of_device(OffReason reason) noexcept {
    return reason == OffReason::unplugged || reason == OffReason::not_homed || reason == OffReason::fault;
  }

  std::string turned_off_words(std::string_view what, const OffReasonEntry& reason) const {
    const bool has_finding = reason.id == OffReason::calibration && !device_.finding_words.empty();
    return fmt::format(
        "{}: {}. {}", what, reason.title,
        has_finding ? device_.finding_words : fmt::format(fmt::runtime(reason.remedy), device_status_key));
  }

  const DeviceSteps& device_;
  const MotorReport* motors_;
};

}  // namespace

std::string_view no_guard() noexcept {
  return "The guard that turns the motors off if this program cannot has not started. The motors stay off. Install "
         "ghostforce again: the program ghostforce-guard belongs to it.";
}

std::vector<ReadinessStepState> readiness_of(const DeviceSteps& device, const MotorReport* motors) {
  return ReadinessCheck(device, motors).states();
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

}  // namespace ghostforce
