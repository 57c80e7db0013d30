// Servo: what ticks the model, by default 1000 times a second.
//
// It and the window exchange whole values, each with one writer and one reader: the newest command goes in, the newest
// report and every tick's sample come out. It ticks only when somebody drives it (servo_driver.h): a thread of its own,
// called the servo thread here, or whoever draws, before each frame. Tests call step() by hand instead, so that no time
// has to pass. While it ticks our code never allocates, locks, logs, throws, opens files or frees. SI units. Functions
// without a word about threads belong to the UI thread.
//
// Of a device whose motor pushes along a line that turns with the handle (HandleReading::motor_angle), each tick takes the
// line as it is then: with a hand and a rendering that are the same in all directions the paper's law holds for it. Tones
// do not measure the hand there.
//
// A general scene (general_tick.h) is ticked by its own loop, whatever moves the goal. Its forces go to no motors, and
// no tones measure its hand: a servo with a device refuses such settings.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <type_traits>

#include "core/belief.h"
#include "core/force_limiter.h"
#include "core/general_tick.h"
#include "core/hand_measurement.h"
#include "core/latest_value.h"
#include "core/measuring_tones.h"
#include "core/ring.h"
#include "core/safety.h"
#include "core/settings.h"
#include "core/snapshot.h"
#include "core/tick.h"
#include "device/input/input.h"
#include "device/report/loop_periods.h"
#include "device/report/motor_report.h"
#include "device/servo/pacer.h"
#include "device/servo/realtime_status.h"

namespace ghostforce {

// What the window wants, whole. The servo may see only the newest of several, so an event is a count of how often it
// was asked for since the program began.
struct ServoCommand {
  Settings settings;
  std::uint32_t settings_generation = 0;  // another number: the settings have changed
  bool paused = false;
  double speed = 1.0;                // of model time against real time [1]; changes ticks per second, never dt
  std::uint32_t steps_asked = 0;     // single ticks asked for while paused
  std::uint32_t restarts_asked = 0;  // another number: continue from restart_state
  TickState<2> restart_state{};
  std::uint32_t recording = 0;  // every sample goes to take_record() too, under this number; 0: none does

  // Tones along the motor measure the hand, in contact. Where the belief about it follows, they do too; the believed k_u
  // of the settings then counts only when that begins, and a chosen ratio not at all: the servo goes on from there alone.
  bool measures_hand = false;
  bool belief_follows_hand = false;
  double tone_force = usual_tone_force;  // [N]

  // For devices with motors. A person wants them on, wants them off, or has read why they went off.
  std::uint32_t arms_asked = 0;
  std::uint32_t offs_asked = 0;
  std::uint32_t acknowledgements = 0;
  std::uint32_t departures = 0;  // of visitors: another number turns the motors off
  SafetyOptions safety;
  bool has_focus = true;         // keys reach the window
  bool machine_sleeps = false;   // is about to: motors go off, and stay off until it has slept
  std::uint32_t heartbeats = 0;  // another number: the window is alive
};
static_assert(std::is_trivially_copyable_v<ServoCommand>);

// How well the deadlines are kept.
struct LoopHealth {
  double rate_hz = 0.0;               // ticks per second of real time, over the last half second; 0 while paused [Hz]
  std::uint64_t late_ticks = 0;       // deadlines skipped, because the driver came more than a period late
  double worst_late_s = 0.0;          // behind a deadline, since begin() [s]
  std::uint64_t dropped_samples = 0;  // that take_sample() was too slow for
  std::uint64_t dropped_records = 0;  // that take_record() was too slow for
  // Since the servo was made, by a thread, while model time runs as fast as real time; with a device, while its handle
  // is known: what comes late while it is opened says nothing about the loop.
  LoopPeriods periods;
};

struct ServoReport {
  Snapshot snapshot;                      // of the newest tick, under the settings in use
  std::uint32_t settings_generation = 0;  // of the settings in use
  std::uint32_t restarts = 0;             // the restarts_asked that this run came from
  // Commands with settings, a speed or a restart state out of range: that part of them had no effect.
  std::uint32_t refused_commands = 0;
  // The settings are unstable: stopped at the last tick before it ran away (core/tick.h) until a restart or other
  // settings.
  bool diverged = false;
  LoopHealth loop;
  MotorReport motors;
  HandReading hand;
  RealtimeStatus realtime;
  ContactReadings contacts;  // of the newest tick, in general scenes
};
static_assert(std::is_trivially_copyable_v<ServoReport>);

// One per tick, the state that a run starts from included: all that is needed to continue from it exactly.
struct Sample {
  Snapshot snapshot;
  PerStrategy<Vector<2>> velocity{};  // v of each device [m/s]
  std::uint64_t serial = 0;           // one more for each sample, so that a gap shows
  std::uint32_t restarts = 0;
  std::uint32_t recording = 0;  // ServoCommand's
  double loop_s = 0.0;          // real time since the sample before; 0 where none is measured, or the first
  Vector<2> sent{0.0};          // force for the motors, after every limit [N]
  bool is_saturated = false;    // the limit has shortened it
  // What measures the hand, on the active device [N]: part of `sent` where that is a real one, else beside the rendered
  // force of the simulated one.
  Vector<2> tone{0.0};
  HandReading hand;
  Settings settings;  // in use; on motors k_r may be lower than asked for
  // In general scenes; in others it means nothing. Last, after what of the settings means nothing either: a tick of the
  // paper's scenes leaves the end of a sample as it was.
  ContactReadings contacts;
};
static_assert(std::is_trivially_copyable_v<Sample>);

class Servo {
 public:
  // Samples that wait for take_sample() or take_record() at most; over 8 s at 1 kHz.
  static constexpr std::size_t sample_capacity = 8192;
  using SampleRing = Ring<Sample, sample_capacity>;
  // `speed` is held between these.
  static constexpr double slowest = 0.001;
  static constexpr double fastest = 10.0;
  // Ticks never come faster than this [s]; a speed that asks for more gets this.
  static constexpr double shortest_period_s = 1.0 / rate_range.greatest;
  // However slow the ticks, and while paused, commands are read this often [s].
  static constexpr double command_period_s = 0.005;
  // step_to() catches up with no more than this [s].
  static constexpr double longest_catch_up_s = 0.15;

  // The first run starts from initial.restart_state. Throws std::invalid_argument if `initial` is out of range.
  Servo(std::unique_ptr<Input> input, const ServoCommand& initial);
  Servo(const Servo&) = delete;
  Servo& operator=(const Servo&) = delete;
  ~Servo() = default;

  void send(const ServoCommand& command) noexcept { commands_.publish(command); }
  // The reference stays valid until the next call.
  const ServoReport& newest() noexcept { return reports_.latest(); }
  // The oldest sample not yet taken; false when there is none.
  bool take_sample(Sample& sample) noexcept { return samples_.try_pop(sample); }
  // The same for what is to be recorded. One thread at a time, and it need not be the UI's.
  bool take_record(Sample& sample) noexcept { return records_.try_pop(sample); }

  Input& input() noexcept { return *input_; }

  // From here on: the servo thread, or whoever drives or steps a servo that has none.

  // What happens at each deadline. Takes the newest command; then records the state that a new run starts from, or else
  // reads the input and ticks (when paused: only if a step was asked for); then publishes. With new settings of another
  // rate the tick number changes so that model time continues.
  //
  // An input with motors: its handle is read, and the motors get what the active strategy wants and the safety chain
  // leaves of it. While they are armed the handle is the device, and neither pause nor slow motion stops its time.
  void step() noexcept;

  // For a program without threads, before each frame: all that a thread would have done by `now_ns`, one after another.
  // The first call begins. Reads the newest command at least once; with a device, every command_period_s. Of a longer
  // pause than longest_catch_up_s, as when the page was hidden, only so much is made up for; the rest is left out, and
  // is no late tick. No real time is measured: Sample::loop_s is 0.
  //
  // A device must live by a clock that its wait_until() moves (VirtualLink::Clock::stepped). It then sees each tick
  // come a period after the one before, however many a frame takes, and the time that is left out has never been:
  // nothing that watches over motors takes a slow frame for a slow loop.
  void step_to(std::int64_t now_ns) noexcept;

  // For a driver that waits by itself: begin(), then, as often as next_wake() has come, wake(), and shut_down() at the
  // end. Times of CLOCK_MONOTONIC.
  struct Wake {
    std::int64_t time_ns;
    bool is_deadline;  // a tick is due then; else only commands are to be read
  };
  void begin(std::int64_t now_ns, const RealtimeStatus& realtime = {}) noexcept;
  Wake next_wake() const noexcept;
  // Returns how far behind its deadline a tick came [ns]; none: no tick was due.
  std::optional<std::int64_t> wake(std::int64_t now_ns) noexcept;
  std::int64_t period_ns() const noexcept { return pacer_.period_ns(); }
  // The motors go off, and the device is told. What comes next begins anew.
  void shut_down() noexcept;

 private:
  std::optional<std::int64_t> wake_at(std::int64_t now_ns) noexcept;
  void count_period(bool is_late) noexcept;
  void update(bool tick_is_due) noexcept;
  void watch_handle() noexcept;
  void follow_motor_line() noexcept;
  void limit_force(bool tick_is_due) noexcept;
  void drop_what_lags(const Vector<2>& probe, Vector<2>& force) const noexcept;
  Vector<2> sound_tones(bool are_allowed, bool in_contact) noexcept;
  bool measure_hand() noexcept;
  void end_measuring() noexcept;
  void begin_following() noexcept;
  void follow_hand() noexcept;
  void drive_motors() noexcept;
  void apply_operator(const ServoCommand& command) noexcept;
  enum class Change : std::uint8_t { leads_over, steps };
  void update_coefficients(Change change = Change::leads_over) noexcept;
  void apply_command(const ServoCommand& command) noexcept;
  void restart_from(const TickState<2>& state, std::uint32_t restarts) noexcept;
  void publish_sample() noexcept;
  bool put_sample(double loop_s, SampleRing& ring) const noexcept;
  bool may_use(const Settings& settings) const noexcept;
  void use(const Settings& settings, std::uint32_t generation) noexcept;
  bool takes_tick(bool tick_is_due) noexcept;
  bool advance() noexcept;
  bool is_idle() const noexcept { return device_ == nullptr && (paused_ || report_.diverged); }
  Vector<2> force_at(const Vector<2>& handle) const noexcept;
  double period_s() const noexcept;

  std::unique_ptr<Input> input_;
  HapticDevice* device_;  // the input's motors; may be null
  LatestValue<ServoCommand> commands_;
  LatestValue<ServoReport> reports_{ServoReport{}};
  SampleRing samples_;
  SampleRing records_;

  // The servo thread's.
  Settings settings_;
  Settings limited_settings_;  // what the coefficients are worked out from: on motors k_r may be held lower
  Vector<2> motor_axis_{0.0};  // worked out with them: a sine and a cosine take longer than a tick
  LoopCoefficients coefficients_{};
  bool coefficients_are_for_motors_ = false;  // made for motors that are on
  TickState<2> state_;
  bool is_at_start_ = true;  // the state has not been recorded yet
  bool paused_;
  double speed_ = 1.0;
  std::uint32_t steps_wanted_ = 0;
  std::uint32_t steps_taken_ = 0;
  std::uint32_t seen_generation_;  // whether in use or refused
  std::uint32_t seen_restarts_;
  std::uint32_t recording_;
  std::uint64_t samples_made_ = 0;
  Pacer pacer_{0, 1.0};              // of what has begun
  std::int64_t now_ns_ = 0;          // up to where that has come
  bool is_stepped_to_ = false;       // by step_to()
  std::int64_t device_lead_ns_ = 0;  // then: of the device's clock before that one
  std::int64_t woken_ns_ = 0;        // when a thread woke it; 0: no real time is measured
  std::int64_t sampled_ns_ = 0;      // when it was awake for the newest sample
  std::int64_t paced_ns_ = 0;        // and for the last tick whose period counts; 0: for none
  ServoReport report_;

  // Of the hand.
  HandMeasurement measurement_;
  bool wants_tones_ = false;
  double tone_force_ = usual_tone_force;
  Vector<2> tone_{0.0};  // on the active device, until the next tick [N]
  HandSource hand_source_;
  std::optional<BeliefFollower> follower_;  // empty: the belief is the command's

  // Of the motors.
  Safety safety_;
  SafetyOptions safety_options_;
  ForceLimiter limiter_;
  HandleReading handle_;
  bool has_focus_ = true;
  std::uint32_t seen_arms_;
  std::uint32_t seen_offs_;
  std::uint32_t seen_departures_;
  std::uint32_t seen_acknowledgements_;
  std::uint32_t seen_heartbeats_;
  std::int64_t heartbeat_ns_ = 0;
  std::int64_t updated_ns_ = 0;
  std::int64_t measured_ns_ = 0;  // of the newest reading that a tick has measured the device by
};

}  // namespace ghostforce
