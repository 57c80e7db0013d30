// Servo: the loop that ticks the model, by default 1000 times a second, on a thread of its own.
//
// It and the window exchange whole values, each with one writer and one reader: the newest command goes in, the newest
// report and every tick's sample come out. On its thread our code never allocates, locks, logs, throws, opens files or
// frees. It starts only when start() is called; tests call step() by hand instead, so that no time has to pass. With
// real-time priority it spins through what is left before a deadline (hybrid_sleep.h); a device paces it instead. SI
// units. Functions without a word about threads belong to the UI thread.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <thread>
#include <type_traits>

#include "core/force_limiter.h"
#include "core/latest_value.h"
#include "core/motor_report.h"
#include "core/ring.h"
#include "core/safety.h"
#include "core/settings.h"
#include "core/snapshot.h"
#include "core/tick.h"
#include "device/input/input.h"
#include "device/servo/latency_histogram.h"
#include "device/servo/realtime.h"

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

  // For devices with motors. A person wants them on, wants them off, or has read why they went off.
  std::uint32_t arms_asked = 0;
  std::uint32_t offs_asked = 0;
  std::uint32_t acknowledgements = 0;
  std::uint32_t departures = 0;  // of visitors: another number turns the motors off
  SafetyOptions safety;
  bool has_focus = true;         // keys reach the window
  std::uint32_t heartbeats = 0;  // another number: the window is alive
};
static_assert(std::is_trivially_copyable_v<ServoCommand>);

// How well the thread keeps its deadlines.
struct LoopHealth {
  double rate_hz = 0.0;               // ticks per second of real time, over the last half second; 0 while paused [Hz]
  std::uint64_t late_ticks = 0;       // deadlines skipped, because the thread came more than a period late
  double worst_late_s = 0.0;          // behind a deadline, since start() [s]
  std::uint64_t dropped_samples = 0;  // that take_sample() was too slow for
  std::uint64_t dropped_records = 0;  // that take_record() was too slow for
};

struct ServoReport {
  Snapshot snapshot;                      // of the newest tick, under the settings in use
  std::uint32_t settings_generation = 0;  // of the settings in use
  std::uint32_t restarts = 0;             // the restarts_asked that this run came from
  // Commands with settings, a speed or a restart state out of range: that part of them had no effect.
  std::uint32_t refused_commands = 0;
  // The settings are unstable: stopped at the last tick before it ran away (core/divergence.h) until a restart or other
  // settings.
  bool diverged = false;
  LoopHealth loop;
  MotorReport motors;
  RealtimeStatus realtime;
};
static_assert(std::is_trivially_copyable_v<ServoReport>);

// One per tick, the state that a run starts from included: all that is needed to continue from it exactly.
struct Sample {
  Snapshot snapshot;
  PerStrategy<Vector<2>> velocity{};  // v of each device [m/s]
  Settings settings;                  // in use; on motors k_r may be lower than asked for
  std::uint64_t serial = 0;           // one more for each sample, so that a gap shows
  std::uint32_t restarts = 0;
  std::uint32_t recording = 0;  // ServoCommand's
  double loop_s = 0.0;          // real time since the sample before; 0 when stepped by hand, or the first
  Vector<2> sent{0.0};          // force for the motors, after every limit [N]
  bool is_saturated = false;    // the limit has shortened it
};
static_assert(std::is_trivially_copyable_v<Sample>);

class Servo {
 public:
  // Samples that wait for take_sample() or take_record() at most; over 8 s at 1 kHz.
  static constexpr std::size_t sample_capacity = 8192;
  // `speed` is held between these.
  static constexpr double slowest = 0.001;
  static constexpr double fastest = 10.0;
  // Ticks never come faster than this [s]; a speed that asks for more gets this.
  static constexpr double shortest_period_s = 1.0 / rate_range.greatest;
  // However slow the ticks, and while paused, commands are read this often [s].
  static constexpr double command_period_s = 0.005;

  // The first run starts from initial.restart_state. Throws std::invalid_argument if `initial` is out of range.
  Servo(std::unique_ptr<Input> input, const ServoCommand& initial);
  Servo(const Servo&) = delete;
  Servo& operator=(const Servo&) = delete;
  ~Servo();

  // Starts the thread, which asks for real-time conditions first (ServoReport::realtime). Throws std::system_error.
  void start();
  // Returns when the thread has ended, within command_period_s. start() may follow.
  void stop() noexcept;

  void send(const ServoCommand& command) noexcept { commands_.publish(command); }
  // The reference stays valid until the next call.
  const ServoReport& newest() noexcept { return reports_.latest(); }
  // The oldest sample not yet taken; false when there is none.
  bool take_sample(Sample& sample) noexcept { return samples_.take(sample); }
  // The same for what is to be recorded. One thread at a time, and it need not be the UI's.
  bool take_record(Sample& sample) noexcept { return records_.take(sample); }

  // How late the ticks came since start(). While the thread is stopped.
  const LatencyHistogram& latency_histogram() const noexcept { return latency_histogram_; }

  Input& input() noexcept { return *input_; }

  // Servo thread, or whoever steps a servo that was not started: what happens at each deadline. Takes the newest
  // command; then records the state that a new run starts from, or else reads the input and ticks (when paused: only if
  // a step was asked for); then publishes. With new settings of another rate the tick number changes so that model time
  // continues.
  //
  // An input with motors: its handle is read, and the motors get what the active strategy wants and the safety chain
  // leaves of it. While they are armed the handle is the device, and neither pause nor slow motion stops its time.
  void step() noexcept;

 private:
  using SampleRing = Ring<Sample, sample_capacity>;

  void run() noexcept;
  void update(bool tick_is_due) noexcept;
  void watch_handle() noexcept;
  void limit_force() noexcept;
  void drive_motors() noexcept;
  void apply_operator(const ServoCommand& command) noexcept;
  void update_coefficients() noexcept;
  void apply_command(const ServoCommand& command) noexcept;
  void restart_from(const TickState<2>& state, std::uint32_t restarts) noexcept;
  void publish_sample() noexcept;
  bool put_sample(double loop_s, SampleRing& ring) const noexcept;
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

  // The UI thread's.
  std::thread thread_;
  std::atomic<bool> stopping_{false};

  // The servo thread's.
  Settings settings_;
  Settings limited_settings_;  // what the coefficients are worked out from: on motors k_r may be held lower
  TickCoefficients<2> coefficients_{};
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
  std::int64_t woken_ns_ = 0;    // when the thread woke; 0: stepped by hand
  std::int64_t sampled_ns_ = 0;  // when it was awake for the newest sample
  LatencyHistogram latency_histogram_;
  ServoReport report_;

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
