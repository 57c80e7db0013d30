#include "tests/emulation/fault_trial.h"

#include <algorithm>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <thread>

#include "core/safety.h"
#include "device/falcon/falcon_report.h"
#include "device/input/monotonic_clock.h"
#include "tests/emulation/emulated_usb_device.h"
#include "tests/emulation/falcon_chip.h"
#include "tests/emulation/hand_in_scene.h"
#include "tests/support/program.h"

namespace ghostforce {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds program_patience{60'000};  // with what must happen before the fault
constexpr milliseconds return_patience{30'000};
constexpr std::chrono::microseconds look_interval{250};

// What is promised.
constexpr std::int64_t ms = 1'000'000;
constexpr std::int64_t zero_limit_ns = 25 * ms;
constexpr std::int64_t fade_limit_ns = 200 * ms + zero_limit_ns;
constexpr std::int64_t stall_limit_ns = 500 * ms + fade_limit_ns;

// Without the device's being opened anew it is not the driver's reopening that has ended the force.
constexpr std::int64_t after_reopening_ns = 3'000 * ms;
// So many commands that push, after the fault: it was got over.
constexpr std::uint64_t frames_onward = 400;
// What ends for good has ended for so long.
constexpr std::int64_t for_good_ns = 60 * ms;

// As orders.h has it.
struct ToldByProgram {
  std::int64_t at_ns = 0;
  std::string motors;
  std::string reason;
  std::string device;
  std::string fault;

  bool motors_are_off() const { return motors == name_of(SafetyState::off); }
  bool motors_push() const { return motors == name_of(SafetyState::ramp) || motors == name_of(SafetyState::on); }
  bool device_is_readable() const {
    return device == name_of(FalconState::idle) || device == name_of(FalconState::active);
  }
};

bool is_zero(const std::vector<std::uint8_t>& bytes) {
  FrameReader<CommandFrame> reader;
  const auto frame = reader.take(bytes);
  return frame && frame->motors == MotorNumbers{};
}

template <typename Entry, std::size_t Extent>
auto named(std::span<Entry, Extent> catalog, std::string_view name) {
  const auto found = std::ranges::find(catalog, name, [](const auto& entry) { return entry.name; });
  if (found == catalog.end()) throw std::runtime_error("armed_program says '" + std::string(name) + "'");
  return found->id;
}

class FaultTrial {
 public:
  FaultTrial(TestBed& bed, const Fault& fault) : cable_(bed, chip_, "12PZ657E"), fault_(fault) { cable_.plug(); }

  // None: the motors had gone off by themselves.
  std::optional<FaultOutcome> run(milliseconds patience) {
    start();
    if (is_by_order()) {
      // Not always at the same moment of a second, a frame or an exchange.
      look_for(milliseconds(5) + std::chrono::microseconds(monotonic_ns() / 1000 % 3000));
      // A force that has not grown to its full size fades sooner.
      while (fades() && told_.motors_push() && told_.motors != name_of(SafetyState::on)) look();
      if (!told_.motors_push() || chip_.told().motors == MotorNumbers{}) return std::nullopt;
    }
    inject();
    watch_the_force(patience);
    if (told_at_off_ && told_at_off_->at_ns < event_ns_) return std::nullopt;
    end_of_fault();
    watch_the_return();
    return outcome_;
  }

 private:
  bool is_by_order() const { return fault_.way == "obey"; }
  bool fades() const { return fault_.promise == Promise::fade || fault_.promise == Promise::stall_and_fade; }

  void start() {
    ProgramCall call;
    call.words = {std::string(fault_.way)};
    call.takes_orders = true;
    program_.emplace(ARMED_PROGRAM, call);
    for (;;) {
      const auto line = program_->next_line(program_patience);
      if (!line) throw std::runtime_error("armed_program has ended, or has not got so far");
      lead_hand(chip_, *line);
      if (!line->starts_with("ends ")) continue;
      event_ns_ = std::stoll(line->substr(5));
      chip_.watch();
      if (!is_by_order()) return;
      break;
    }
    const std::int64_t end_ns = monotonic_ns() + program_patience / std::chrono::nanoseconds(1);
    while (told_.at_ns == 0 && monotonic_ns() < end_ns) look();
  }

  void inject() {
    first_frame_ = chip_.told().frames;
    times_taken_ = cable_.times_taken();
    if (!is_by_order()) return;
    chip_.watch();
    event_ns_ = monotonic_ns();
    if (!fault_.usb.empty()) cable_.inject(usb_fault(fault_.usb));
    if (!fault_.device.empty()) {
      InjectedFault wrong;
      find_injected_fault(fault_.device)->add(wrong);
      chip_.inject(wrong);
    }
    if (!fault_.order.empty()) program_->order(std::string(fault_.order));
    if (fault_.signal != 0) program_->send(fault_.signal);
    if (fault_.hand_is_torn_away) {
      HandPlan plan = hand_in_scene({0.03, 0.045}, 0.02);
      plan.stiffness = 1000.0;
      chip_.lead_hand(plan);
    }
  }

  void watch_the_force(milliseconds patience) {
    const std::int64_t end_ns = event_ns_ + patience / std::chrono::nanoseconds(1);
    for (;;) {
      look();
      const FalconChip::Told& told = chip_told_;
      const bool is_over = program_has_ended_ || told_.motors_are_off();
      if (is_over && told.motors == MotorNumbers{} && monotonic_ns() > told.last_force_ns + for_good_ns) {
        outcome_.zero_ns = told.last_force_ns - event_ns_;
        outcome_.was_taken_anew = was_taken_anew_;
        break;
      }
      if (told_.motors_push() && told.frames >= first_frame_ + frames_onward && told.motors != MotorNumbers{} &&
          !fades() && monotonic_ns() > event_ns_ + fault_.lasts_ms * ms) {
        outcome_.went_on = true;
        break;
      }
      if (is_over && fault_.promise == Promise::last_try && zero_try_ns_ && monotonic_ns() > end_of_lasting_ns()) break;
      if (was_taken_anew_ && monotonic_ns() > event_ns_ + after_reopening_ns) break;
      if (monotonic_ns() > end_ns) break;
    }
    outcome_.longest_hold_ns = chip_.told().longest_hold_ns;
    outcome_.late_ns = late_ns_;
    // Until something is seen of the force again the wire may be dead.
    while (!program_has_ended_ && monotonic_ns() < end_of_lasting_ns()) look();
    outcome_.zero_try_ns = zero_try_ns_;
  }

  std::int64_t end_of_lasting_ns() const { return event_ns_ + fault_.lasts_ms * ms; }

  void end_of_fault() {
    is_taken_away_ = true;
    chip_.inject({});
    cable_.inject(fault_.usb_afterwards.empty() ? UsbFault{} : usb_fault(fault_.usb_afterwards));
    if (fault_.order == "focus lost") program_->order("focus");
    if (fault_.hand_is_torn_away) lead_hand(chip_, "outside");
  }

  void watch_the_return() {
    const std::int64_t start_ns = monotonic_ns();
    const std::int64_t end_ns = start_ns + return_patience / std::chrono::nanoseconds(1);
    std::int64_t back_ns = 0;
    while (monotonic_ns() < end_ns && !program_has_ended_) {
      look();
      const bool is_back = told_.device_is_readable() && (outcome_.went_on || told_.motors_are_off()) &&
                           (outcome_.went_on || chip_told_.motors == MotorNumbers{});
      if (!is_back) {
        back_ns = 0;
      } else if (back_ns == 0) {
        back_ns = monotonic_ns();
      } else if (monotonic_ns() > back_ns + for_good_ns) {
        outcome_.came_back = true;
        outcome_.back_ns = back_ns - start_ns;
        break;
      }
    }
    if (!outcome_.zero_ns && !outcome_.went_on && chip_told_.motors == MotorNumbers{}) {
      outcome_.zero_ns = chip_told_.last_force_ns - event_ns_;
      outcome_.was_taken_anew = was_taken_anew_;
    }
    outcome_.lost_home = lost_home_;
    if (program_has_ended_) outcome_.exit_code = program_->wait_for_end();
  }

  void look_for(std::chrono::microseconds duration) {
    const std::int64_t end_ns = monotonic_ns() + duration / std::chrono::nanoseconds(1);
    while (monotonic_ns() < end_ns) look();
  }

  void look() {
    const std::int64_t before_ns = monotonic_ns();
    std::this_thread::sleep_for(look_interval);
    const bool had_ended = program_->has_ended();
    while (const auto line = program_->next_line(milliseconds(0))) hear(*line);
    program_has_ended_ = had_ended;
    chip_told_ = chip_.told();
    lost_home_ |= !chip_told_.is_homed;
    const bool pushes = chip_told_.motors != MotorNumbers{};
    if (pushes && cable_.times_taken() > times_taken_ && times_taken_ > 0) was_taken_anew_ = true;
    if (!is_taken_away_) note_what_is_tried();
    if (pushes) late_ns_ = std::max(late_ns_, monotonic_ns() - before_ns);
  }

  // The first zero after the last thing that was none.
  void note_what_is_tried() {
    const EmulatedUsbDevice::OutAttempt attempt = cable_.last_out();
    if (attempt.at_ns < event_ns_ || !is_zero(attempt.bytes)) {
      zero_try_ns_.reset();
    } else if (!zero_try_ns_) {
      zero_try_ns_ = attempt.at_ns - event_ns_;
    }
  }

  void hear(const std::string& line) {
    std::istringstream words(line);
    std::string word;
    std::getline(words, word, '\t');
    if (word != "state") return;
    std::getline(words, word, '\t');
    told_.at_ns = std::stoll(word);
    for (std::string* const field : {&told_.motors, &told_.reason, &told_.device, &told_.fault}) {
      std::getline(words, *field, '\t');
    }
    if (!told_.motors_push() && !told_at_off_) told_at_off_ = told_;
    if (told_.at_ns < event_ns_) return;
    if (outcome_.reason == OffReason::none) outcome_.reason = named(off_reason_catalog(), told_.reason);
    if (outcome_.device_fault == FalconFault::none) outcome_.device_fault = named(falcon_fault_catalog(), told_.fault);
  }

  FalconChip chip_{{.starts_with_firmware = true, .starts_homed = true}};
  EmulatedUsbDevice cable_;
  const Fault& fault_;
  std::optional<RunningProgram> program_;

  std::int64_t event_ns_ = 0;
  std::uint64_t first_frame_ = 0;
  std::uint64_t times_taken_ = 0;  // before the fault
  bool is_taken_away_ = false;

  // Seen so far.
  FalconChip::Told chip_told_;
  ToldByProgram told_;
  std::optional<ToldByProgram> told_at_off_;
  std::optional<std::int64_t> zero_try_ns_;
  bool program_has_ended_ = false;
  bool was_taken_anew_ = false;
  bool lost_home_ = false;
  std::int64_t late_ns_ = 0;
  FaultOutcome outcome_;
};

}  // namespace

std::string FaultOutcome::words() const {
  const std::string motors(entry_of(reason).title);
  const std::string device(entry_of(device_fault).title);
  if (reason == OffReason::none) return device_fault == FalconFault::none ? "" : device;
  if (device_fault == FalconFault::none || motors == device) return motors;
  return reason == OffReason::fault ? device : motors + ", then " + device;
}

FaultOutcome try_fault(TestBed& bed, const Fault& fault, milliseconds patience) {
  constexpr int attempts = 20;
  for (int i = 0; i < attempts; ++i) {
    FaultTrial trial(bed, fault);
    if (const auto outcome = trial.run(patience)) return *outcome;
  }
  throw std::runtime_error("the motors went off by themselves each time: the machine has too much else to do");
}

std::string broken_promise(const Fault& fault, const FaultOutcome& outcome, bool timed) {
  const auto over = [&](std::optional<std::int64_t> time_ns, std::int64_t limit_ns) {
    return timed && time_ns && *time_ns > limit_ns;
  };
  // What goes wrong with cable, device or window ends no program.
  const bool is_to_end = fault.signal != 0 || fault.way != "obey";
  if (!is_to_end && outcome.exit_code) return "the program ended, with " + std::to_string(*outcome.exit_code);
  switch (fault.promise) {
    case Promise::none:
      return "";
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
    case Promise::fade:
    case Promise::stall_and_fade:
      if (!outcome.zero_ns) return "the force stayed";
      if (over(outcome.zero_ns, fault.promise == Promise::fade ? fade_limit_ns : stall_limit_ns)) {
        return "the force faded too late";
      }
      break;
  }
  if (outcome.lost_home && !fault.forgets_home) return "the device was taken for one without firmware";
  if (!is_to_end && !outcome.came_back) return "the device does not come back by itself";
  return "";
}

}  // namespace ghostforce
