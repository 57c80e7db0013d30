#include "tests/emulation/fault_trial.h"

#include <algorithm>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <thread>

#include "device/input/monotonic_clock.h"
#include "tests/emulation/emulated_usb_device.h"
#include "tests/emulation/falcon_chip.h"
#include "tests/emulation/hand_in_scene.h"
#include "tests/emulation/machine_watch.h"
#include "tests/support/program.h"

namespace ghostforce {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds program_patience{60'000};  // with what must happen before the fault
constexpr milliseconds return_patience{240'000};
constexpr std::chrono::microseconds look_interval{250};

constexpr std::int64_t ms = 1'000'000;

// Without the device's being opened anew it is not the driver's reopening that has ended the force.
constexpr std::int64_t after_reopening_ns = 3'000 * ms;
// So many commands that push, after the fault: it was got over.
constexpr std::uint64_t frames_onward = 400;
// What ends for good has ended for so long.
constexpr std::int64_t for_good_ns = 60 * ms;
// Once a program can run again, what it does next shows within this.
constexpr std::int64_t after_hold_ns = 500 * ms;
constexpr std::int64_t fast_patience_ns = 60'000 * ms;

// As orders.h has it.
struct ToldByProgram {
  std::int64_t at_ns = 0;
  std::string motors;
  std::string reason;
  std::string device;
  std::string fault;
  std::string push;
  std::string speed;

  bool motors_are_off() const { return motors == name_of(SafetyState::off); }
  bool motors_push() const { return motors == name_of(SafetyState::ramp) || motors == name_of(SafetyState::on); }
  bool motors_are_on() const { return motors == name_of(SafetyState::on); }
  bool says_off() const { return motors_are_off() && push == "cannot push"; }
  bool is_fast() const { return speed == "fast"; }
  bool device_is_readable() const {
    return device == name_of(FalconState::idle) || device == name_of(FalconState::active);
  }
};

// What the motors are told; empty: the bytes are no command, but firmware, for one.
std::optional<MotorNumbers> motors_of(const std::vector<std::uint8_t>& bytes) {
  FrameReader<CommandFrame> reader;
  const auto frame = reader.take(bytes);
  return frame ? std::optional(frame->motors) : std::nullopt;
}

template <typename Entry, std::size_t Extent>
auto named(std::span<Entry, Extent> catalog, std::string_view name) {
  const auto found = std::ranges::find(catalog, name, [](const auto& entry) { return entry.name; });
  if (found == catalog.end()) throw std::runtime_error("armed_program says '" + std::string(name) + "'");
  return found->id;
}

// The trial itself keeps this machine busy. A servo of real-time priority that hangs takes a processor too.
bool is_crowded(const Fault& fault, int busy_processes) {
  return fault.busy_processes > 0 || busy_processes > 0 || fault.hold == ProcessHold::starved || fault.program_hangs;
}

class ProgramNotArmed : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class FaultTrial {
 public:
  FaultTrial(TestBed& bed, const Fault& fault, int busy_processes, const MachineWatch& watch)
      : cable_(bed, chip_, "12PZ657E"),
        other_cable_(bed, other_chip_, "12PZ657F"),
        fault_(fault),
        busy_count_(std::max(fault.busy_processes, busy_processes)),
        watch_(watch) {
    cable_.plug();
    if (has_other()) other_cable_.plug();
    if (!fault.usb_at_start.empty()) cable_.inject(usb_fault(fault.usb_at_start));
    if (!fault.device_at_start.empty()) inject_into_device(fault.device_at_start);
  }

  // None: the motors had gone off by themselves.
  std::optional<FaultOutcome> run(milliseconds patience) {
    if (fault_.promise == Promise::fast) {
      watch_the_speed();
      return outcome_;
    }
    if (!fault_.device_at_start.empty()) {
      watch_the_arming(patience);
      // A busy machine may be too uneven to arm at all: nothing has pushed, so nothing was tried.
      if (event_ns_ == 0) return std::nullopt;
      end_of_fault();
      watch_the_return();
      return outcome_;
    }
    start();
    if (is_by_order()) {
      // Not always at the same moment of a second, a frame or an exchange.
      look_for(milliseconds(5) + std::chrono::microseconds(monotonic_ns() / 1000 % 3000));
      // A force that has not grown to its full size fades sooner.
      while (fades() && told_.motors_push() && !told_.motors_are_on()) look();
      if (!told_.motors_push() || chip_.told().motors == MotorNumbers{}) return std::nullopt;
    }
    inject();
    watch_the_force(patience);
    if (told_at_off_ && told_at_off_->at_ns < event_ns_) return std::nullopt;
    if (fault_.other_falcon == OtherFalcon::pulled_out_too) pull_out_the_other();
    end_of_fault();
    watch_the_return();
    return outcome_;
  }

 private:
  bool is_by_order() const { return fault_.way == "obey"; }
  bool has_other() const { return fault_.other_falcon != OtherFalcon::none; }
  bool fades() const { return fault_.promise == Promise::fade || fault_.promise == Promise::stall_and_fade; }

  void start() {
    ProgramCall call;
    if (fault_.starts_with_signals_blocked) call.words = {"signals blocked"};
    call.words.emplace_back(fault_.way);
    call.takes_orders = true;
    program_.emplace(ARMED_PROGRAM, call);
    for (;;) {
      const auto line = program_->next_line(program_patience);
      if (!line || watch_.is_too_busy()) throw ProgramNotArmed("armed_program has ended, or has not got so far");
      lead_hand(chip_, *line);
      if (*line == "inside") begin_load();
      if (!line->starts_with("ends ")) continue;
      event_ns_ = std::stoll(line->substr(5));
      chip_.watch();
      if (!is_by_order()) return;
      break;
    }
    const std::int64_t end_ns = monotonic_ns() + program_patience / std::chrono::nanoseconds(1);
    while (told_.at_ns == 0 && monotonic_ns() < end_ns) look();
  }

  // From before it pushes: it may be about to end by itself.
  void begin_load() {
    if (is_crowded(fault_, busy_count_) && !urgent_) urgent_.emplace();
    if (busy_count_ > 0 && !busy_) busy_.emplace(busy_count_);
  }

  void inject_into_device(std::string_view name) {
    InjectedFault wrong;
    find_injected_fault(name)->add(wrong);
    chip_.inject(wrong);
  }

  void inject() {
    first_frame_ = chip_.told().frames;
    program_pid_ = program_->pid();
    times_taken_ = cable_.times_taken_by(program_pid_);
    if (!is_by_order()) return;
    chip_.watch();
    event_ns_ = monotonic_ns();
    if (fault_.hold != ProcessHold::none) {
      held_.emplace(program_->pid(), fault_.hold, milliseconds(fault_.lasts_ms));
      // Real-time processes gather first.
      if (fault_.hold == ProcessHold::starved) event_ns_ = monotonic_ns();
    }
    if (!fault_.usb.empty()) cable_.inject(usb_fault(fault_.usb));
    if (!fault_.device.empty()) inject_into_device(fault_.device);
    if (!fault_.order.empty()) program_->order(std::string(fault_.order));
    if (fault_.signal != 0) program_->send(fault_.signal);
    if (fault_.hand_is_torn_away) {
      HandPlan plan = hand_in_scene({0.03, 0.045}, 0.02);
      plan.stiffness = 1000.0;
      chip_.lead_hand(plan);
    }
    if (fault_.hand_goes_out) lead_hand(chip_, "outside");
  }

  void watch_the_force(milliseconds patience) {
    const std::int64_t end_ns = event_ns_ + patience / std::chrono::nanoseconds(1);
    for (;;) {
      look();
      const FalconChip::Told& told = chip_told_;
      end_hold();
      if (held_ || monotonic_ns() < hold_end_ns_ + after_hold_ns) continue;
      const bool is_over = program_has_ended_ || told_.motors_are_off() || fault_.program_hangs;
      if (is_over && told.motors == MotorNumbers{} && monotonic_ns() > told.last_force_ns + for_good_ns) {
        note_zero();
        break;
      }
      if (told_.motors_push() && told.frames >= first_frame_ + frames_onward && told.motors != MotorNumbers{} &&
          !fades() && fault_.promise != Promise::zero_and_why && monotonic_ns() > event_ns_ + fault_.lasts_ms * ms) {
        outcome_.went_on = true;
        break;
      }
      if (is_over && fault_.promise == Promise::last_try && zero_try_ns_ && monotonic_ns() > end_of_lasting_ns()) break;
      if (was_taken_anew_ && monotonic_ns() > event_ns_ + after_reopening_ns) break;
      if (monotonic_ns() > end_ns) break;
    }
    if (fault_.hold != ProcessHold::none) outcome_.forces_after_hold = chip_.told().force_frames - force_frames_;
    outcome_.longest_hold_ns = chip_.told().longest_hold_ns;
    outcome_.late_ns = late_ns_;
    // Until something is seen of the force again the wire may be dead.
    while (!program_has_ended_ && monotonic_ns() < end_of_lasting_ns()) look();
    outcome_.zero_try_ns = zero_try_ns_;
  }

  void note_zero() {
    if (outcome_.zero_ns) return;
    outcome_.zero_ns = chip_told_.last_force_ns - event_ns_;
    outcome_.was_taken_anew = was_taken_anew_;
  }

  // What comes afterwards is told apart from a zero that came before.
  void end_hold() {
    if (!held_ || monotonic_ns() < end_of_lasting_ns()) return;
    chip_told_ = chip_.told();
    if (chip_told_.motors == MotorNumbers{}) note_zero();
    force_frames_ = chip_told_.force_frames;
    held_.reset();
    hold_end_ns_ = monotonic_ns();
  }

  // It may be that the program does not take it, with a debt to the first.
  void pull_out_the_other() {
    led_chip_ = &other_chip_;
    program_->order("arm");
    const std::int64_t end_ns = monotonic_ns() + return_patience / std::chrono::nanoseconds(1);
    while (!pushes_again_ && monotonic_ns() < end_ns && !program_has_ended_) look();
    other_cable_.inject(usb_fault("unplugged"));
    is_other_out_ = true;
    look_for(milliseconds(fault_.lasts_ms));
  }

  // The program arms no motors until it is told to.
  void start_to_look() {
    ProgramCall call;
    call.words = {"look"};
    call.takes_orders = true;
    program_.emplace(ARMED_PROGRAM, call);
  }

  // From the first push by which the motors are checked.
  void watch_the_arming(milliseconds patience) {
    start_to_look();
    lead_hand(chip_, "outside");
    const std::int64_t end_ns = monotonic_ns() + (program_patience + patience) / std::chrono::nanoseconds(1);
    while (!told_.device_is_readable() && !program_has_ended_ && monotonic_ns() < end_ns) look();
    look_for(milliseconds(500));  // the handle comes to rest
    begin_load();
    program_->order("ask for motors");
    while (!program_has_ended_ && monotonic_ns() < end_ns) {
      look();
      if (event_ns_ == 0 && chip_told_.motors != MotorNumbers{}) event_ns_ = monotonic_ns();
      if (event_ns_ == 0 && watch_.is_too_busy()) return;
      if (event_ns_ == 0) continue;
      outcome_.went_on = told_.motors_are_on();  // they are checked while they ramp up
      const bool is_over = told_.motors_are_off() && told_.at_ns > event_ns_ && chip_told_.motors == MotorNumbers{};
      if (outcome_.went_on || (is_over && monotonic_ns() > chip_told_.last_force_ns + for_good_ns)) break;
    }
    if (!outcome_.went_on && event_ns_ > 0) note_zero();
    outcome_.late_ns = late_ns_;
  }

  void watch_the_speed() {
    start_to_look();
    event_ns_ = monotonic_ns();
    std::int64_t start_ns = 0;  // of what counts
    for (;;) {
      look();
      const std::int64_t now_ns = monotonic_ns();
      if (start_ns == 0 && told_.device_is_readable() && now_ns > end_of_lasting_ns()) {
        if (fault_.lasts_ms > 0) cable_.inject({});
        start_ns = now_ns;
      }
      if (program_has_ended_ || now_ns > end_of_lasting_ns() + fast_patience_ns) break;
      if (start_ns == 0 || !told_.is_fast()) continue;
      outcome_.fast_ns = now_ns - start_ns;
      break;
    }
    outcome_.came_back = outcome_.fast_ns.has_value();
    if (program_has_ended_) outcome_.exit_code = program_->wait_for_end();
  }

  std::int64_t end_of_lasting_ns() const { return event_ns_ + fault_.lasts_ms * ms; }

  void end_of_fault() {
    // The other one is taken by now, however busy this machine is.
    const std::int64_t end_ns = monotonic_ns() + return_patience / std::chrono::nanoseconds(1);
    while (has_other() && other_cable_.times_taken() == 0 && !program_has_ended_ && monotonic_ns() < end_ns) look();
    is_taken_away_ = true;
    chip_.inject({});
    cable_.inject(fault_.usb_afterwards.empty() ? UsbFault{} : usb_fault(fault_.usb_afterwards));
    if (is_other_out_) other_cable_.inject({});
    if (fault_.other_falcon == OtherFalcon::taken_and_left) program_->order("end");
    if (fault_.order == "focus lost") program_->order("focus");
    if (fault_.hand_is_torn_away) lead_hand(chip_, "outside");
  }

  void watch_the_return() {
    if (fault_.program_hangs) return;
    const std::int64_t start_ns = monotonic_ns();
    const std::int64_t end_ns = start_ns + return_patience / std::chrono::nanoseconds(1);
    const std::uint64_t other_taken = other_cable_.times_taken();
    std::int64_t back_ns = 0;
    while (monotonic_ns() < end_ns && !program_has_ended_) {
      look();
      if (has_other() && any_pushes() && !is_other_out_) {
        outcome_.other_was_taken_first |= other_taken_ > other_taken;
      }
      const bool is_back = told_.device_is_readable() && (outcome_.went_on || told_.motors_are_off()) &&
                           (outcome_.went_on || !any_pushes());
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
    if (program_has_ended_) {
      // What was on the way arrives.
      std::this_thread::sleep_for(std::chrono::nanoseconds(for_good_ns));
      chip_told_ = chip_.told();
      other_told_ = other_chip_.told();
    }
    if (!outcome_.went_on && !any_pushes()) {
      if (fault_.usb == "unplugged") {
        const std::int64_t last_ns =
            is_other_out_ ? std::max(chip_told_.last_force_ns, other_told_.last_force_ns) : chip_told_.last_force_ns;
        outcome_.plug_to_zero_ns = std::max<std::int64_t>(last_ns - start_ns, 0);
      }
      note_zero();
    }
    outcome_.lost_home = lost_home_;
    if (outcome_.came_back && fault_.is_fast_again) {
      const std::int64_t fast_end_ns = monotonic_ns() + fast_patience_ns;
      while (!told_.is_fast() && monotonic_ns() < fast_end_ns) look();
      outcome_.stays_slow = !told_.is_fast();
    }
    if (program_has_ended_) outcome_.exit_code = program_->wait_for_end();
  }

  // One of those that were pulled out.
  bool any_pushes() const {
    return chip_told_.motors != MotorNumbers{} || (is_other_out_ && other_told_.motors != MotorNumbers{});
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
    // Before what it pushes with: what is taken once it lets go is not taken too early.
    const std::uint64_t taken = cable_.times_taken_by(program_pid_);
    other_taken_ = other_cable_.times_taken();
    chip_told_ = chip_.told();
    other_told_ = other_chip_.told();
    lost_home_ |= !chip_told_.is_homed;
    const bool pushes = chip_told_.motors != MotorNumbers{};
    // By the program itself, that is: whoever else takes it does so to end the force.
    if (pushes && taken > times_taken_ && times_taken_ > 0) was_taken_anew_ = true;
    if (any_pushes() && told_.says_off() && !program_has_ended_ && event_ns_ > 0) {
      const std::int64_t since_ns = std::max(told_.at_ns, event_ns_);
      outcome_.longest_false_off_ns = std::max(outcome_.longest_false_off_ns, monotonic_ns() - since_ns);
    }
    if (!is_taken_away_) note_what_is_tried();
    if (pushes) late_ns_ = std::max(late_ns_, monotonic_ns() - before_ns);
  }

  // The first zero after the last force.
  void note_what_is_tried() {
    const EmulatedUsbDevice::OutAttempt attempt = cable_.last_out();
    const std::optional<MotorNumbers> motors = motors_of(attempt.bytes);
    if (attempt.at_ns < event_ns_ || (motors && *motors != MotorNumbers{})) {
      zero_try_ns_.reset();
    } else if (motors && !zero_try_ns_) {
      zero_try_ns_ = attempt.at_ns - event_ns_;
    }
  }

  void hear(const std::string& line) {
    std::istringstream words(line);
    std::string word;
    std::getline(words, word, '\t');
    if (led_chip_ != nullptr) lead_hand(*led_chip_, word);
    pushes_again_ |= word == "pushing";
    if (word != "state") return;
    std::getline(words, word, '\t');
    told_.at_ns = std::stoll(word);
    for (std::string* const field :
         {&told_.motors, &told_.reason, &told_.device, &told_.fault, &told_.push, &told_.speed}) {
      std::getline(words, *field, '\t');
    }
    if (!told_.motors_push() && !told_at_off_) told_at_off_ = told_;
    if (told_.at_ns < event_ns_) return;
    if (outcome_.reason == OffReason::none) outcome_.reason = named(off_reason_catalog(), told_.reason);
    if (outcome_.device_fault == FalconFault::none) outcome_.device_fault = named(falcon_fault_catalog(), told_.fault);
  }

  FalconChip chip_{{.starts_with_firmware = true, .starts_homed = true}};
  FalconChip other_chip_{{.starts_with_firmware = true, .starts_homed = true}};
  EmulatedUsbDevice cable_;
  EmulatedUsbDevice other_cable_;
  const Fault& fault_;
  const int busy_count_;
  const MachineWatch& watch_;
  std::optional<RunningProgram> program_;
  std::optional<HeldProgram> held_;
  std::optional<BusyProcesses> busy_;
  std::optional<UrgentHere> urgent_;

  std::int64_t event_ns_ = 0;
  std::uint64_t first_frame_ = 0;
  pid_t program_pid_ = 0;
  std::uint64_t times_taken_ = 0;   // before the fault
  std::uint64_t force_frames_ = 0;  // when the program could run again
  std::int64_t hold_end_ns_ = 0;
  FalconChip* led_chip_ = nullptr;  // whose hand does what the program wants, after the fault
  bool is_other_out_ = false;
  bool is_taken_away_ = false;

  // Seen so far.
  FalconChip::Told chip_told_;
  FalconChip::Told other_told_;
  std::uint64_t other_taken_ = 0;
  bool pushes_again_ = false;
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

FaultOutcome try_fault(TestBed& bed, const Fault& fault, milliseconds patience, int busy_processes) {
  constexpr int attempts = 20;
  constexpr int most_doubtful = 5;  // of a promise that was broken while the machine was late
  int doubtful = 0;
  for (int i = 0; i < attempts; ++i) {
    const MachineWatch watch;
    try {
      FaultTrial trial(bed, fault, busy_processes, watch);
      if (const auto outcome = trial.run(patience)) {
        const bool is_certain = !watch.was_late() || broken_promise(fault, *outcome, false).empty();
        if (is_certain || ++doubtful > most_doubtful) return *outcome;
      }
    } catch (const ProgramNotArmed&) {
      if (!watch.is_too_busy()) throw;
    }
    const bool is_own_load = doubtful > 0 && is_crowded(fault, busy_processes);
    if (watch.is_too_busy() && !is_own_load) {
      throw MachineTooBusy();
    }
  }
  throw std::runtime_error("the motors went off by themselves each time");
}

}  // namespace ghostforce
