// What is promised, and how it was broken.
#include "tests/emulation/fault_trial.h"

namespace ghostforce {
namespace {

constexpr std::int64_t ms = 1'000'000;
constexpr std::int64_t zero_limit_ns = 25 * ms;
constexpr std::int64_t finding_limit_ns = 100 * ms;
constexpr std::int64_t fade_limit_ns = 200 * ms + zero_limit_ns;
constexpr std::int64_t stall_limit_ns = 500 * ms + fade_limit_ns;
// Where no times count, so that a machine that does other things breaks no promise.
constexpr std::int64_t untimed_false_off_ns = 10'000 * ms;

}  // namespace

std::string FaultOutcome::words() const {
  const std::string motors(entry_of(reason).title);
  const std::string device(entry_of(device_fault).title);
  if (reason == OffReason::none) return device_fault == FalconFault::none ? "" : device;
  if (device_fault == FalconFault::none || motors == device) return motors;
  return reason == OffReason::fault ? device : motors + ", then " + device;
}

std::string broken_promise(const Fault& fault, const FaultOutcome& outcome, bool timed) {
  const auto over = [&](std::optional<std::int64_t> time_ns, std::int64_t limit_ns) {
    return timed && time_ns && *time_ns > limit_ns;
  };
  // What goes wrong with cable, device or window ends no program.
  const bool is_to_end = fault.signal != 0 || fault.way != "obey" || fault.other_falcon == OtherFalcon::taken_and_left;
  if (!is_to_end && outcome.exit_code) return "the program ended, with " + std::to_string(*outcome.exit_code);
  switch (fault.promise) {
    case Promise::fast:
      return outcome.fast_ns ? "" : "the device stays too slow";
    case Promise::zero_or_onward:
      if (outcome.went_on) {
        if (timed && outcome.longest_hold_ns > zero_limit_ns) return "held a force for longer than 25 ms";
        break;
      }
      if (over(outcome.zero_ns, zero_limit_ns) && outcome.longest_hold_ns > zero_limit_ns) {
        return "zero came later than 25 ms, after a force that was held for longer";
      }
      [[fallthrough]];
    case Promise::zero:
      if (outcome.went_on) return "the motors stayed on";
      if (!outcome.zero_ns) return "the force stayed";
      if (outcome.was_taken_anew) return "the force ended only when the device was opened anew";
      if (fault.promise == Promise::zero && over(outcome.zero_ns, zero_limit_ns)) return "zero came later than 25 ms";
      break;
    case Promise::last_try:
      if (!outcome.zero_try_ns) return "the last thing tried was a force";
      if (over(outcome.zero_try_ns, zero_limit_ns)) return "a zero was tried later than 25 ms";
      if (!outcome.zero_ns) return "the force stayed when the wire was well again";
      break;
    case Promise::zero_and_why:
      if (outcome.went_on) return "the motors stayed on";
      if (!outcome.zero_ns) return "the force stayed";
      if (outcome.reason == OffReason::none) return "the program said no reason";
      if (over(outcome.zero_ns, finding_limit_ns)) return "zero came later than 100 ms";
      break;
    case Promise::fade:
    case Promise::stall_and_fade:
      if (!outcome.zero_ns) return "the force stayed";
      if (over(outcome.zero_ns, fault.promise == Promise::fade ? fade_limit_ns : stall_limit_ns)) {
        return "the force faded too late";
      }
      break;
  }
  if (outcome.forces_after_hold > 0) return "the force came back when the program could run again";
  if (outcome.longest_false_off_ns > (timed ? zero_limit_ns : untimed_false_off_ns)) {
    return "the program said that the motors are off while they pushed";
  }
  if (over(outcome.plug_to_zero_ns, fault.plug_to_zero_ms * ms))
    return "the force stayed after it was plugged in again";
  if (outcome.other_was_taken_first) return "the other Falcon was taken while this one still pushed";
  if (outcome.lost_home && !fault.forgets_home) return "the device was taken for one without firmware";
  if (outcome.stays_slow) return "the device stays too slow";
  if (!is_to_end && !outcome.came_back) return "the device does not come back by itself";
  return "";
}

}  // namespace ghostforce
