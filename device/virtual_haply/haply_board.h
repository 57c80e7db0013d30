// HaplyBoard: a microcontroller with one of the published firmwares that speak hAPI, from its end of the USB cable to
// the pins of motors and encoders. It reads no clock and has no thread: each call says what time it is, and what has
// happened up to then has happened. Bytes and encoder edges go in, replies and duties come out. Allocates and throws
// nothing; one thread. Times in ns, on any clock that does not go back.
//
// All that is awkward about the published firmwares is here. They look for a command every 50 µs. Command and address
// are read without waiting: what has not come yet is 255. What comes after them is waited for, up to 1 s, while nothing
// else runs; what has not come by then is what was in memory. What is no command is dropped, a byte each 50 µs. Nothing
// but an exchange, a set up or a restart changes a duty: a reset forgets the addresses, and a motor that pushes goes on
// pushing. Unused places have address 0, so that a host that calls itself 0 means them.
//
// Where those who have read the firmwares are silent, this board is strict or hostile: a reset forgets all addresses,
// whichever it names; a torque that is not a number gives the full duty; an encoder that nobody has set up says not a
// number; ports and pins that there are not have no bytes in a set up.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "core/fixed_queue.h"

namespace ghostforce {

class HaplyBoard {
 public:
  enum class Kind : std::uint8_t {
    m0,       // two ports, coarse duties, and half of the encoders' edges go unseen
    m3,       // four ports
    dev_kit,  // four ports; pushes the other way at ports 1 and 3
  };

  static constexpr std::size_t most_ports = 4;
  static constexpr std::int64_t pass_ns = 50'000;
  static constexpr std::int64_t patience_ns = 1'000'000'000;
  static constexpr float full_torque = 0.123F;  // that the firmware takes for the full duty [N·m]

  struct Options {
    Kind kind = Kind::m3;
    // A set up writes an offset into a counter. Whether a fraction of a count survives that is not known; if not, the
    // first angle after a set up is up to one count short of the offset.
    bool cuts_offsets = false;
    // No published firmware has one: after so long without an exchange all duties are zero. 0: it has none, either.
    std::int64_t watchdog_ns = 0;
  };

  struct Reply {
    static constexpr std::size_t most_bytes = 72;

    std::int64_t left_ns = 0;
    std::array<std::uint8_t, most_bytes> bytes{};
    std::size_t size = 0;
    std::uint8_t encoders = 0;      // whose angles are in it: bit 0 is the first port
    std::size_t encoders_from = 0;  // where they begin
  };

  explicit HaplyBoard(const Options& options) noexcept : options_(options) {}

  // Host → board, in order; `at_ns` may lie ahead. What there is no room for is lost.
  void receive(std::span<const std::uint8_t> bytes, std::int64_t at_ns) noexcept;
  std::size_t room() const noexcept { return received_.room(); }

  void run_until(std::int64_t now_ns) noexcept;
  // When something happens next, unless more is received.
  std::int64_t next_event_ns() const noexcept;

  // Board → host, oldest first. Those that nobody takes while there are many are lost.
  std::optional<Reply> take_reply() noexcept;

  // So many edges have passed the encoder at a port.
  void count(std::size_t port, std::int64_t edges) noexcept;

  // As the pins are: the share of the time, negative where the direction's pin is high. That is low, on an M0 and an
  // M3, for a positive torque in direction 0.
  double duty(std::size_t port) const noexcept { return motors_[port].duty; }

  // The processor starts anew, as when it gets power.
  void restart() noexcept;
  // What is in the cable's end is lost, the rest goes on.
  void lose_cable() noexcept;
  // Another program has sent a set up for itself, and has pushed.
  void take_over(std::uint8_t address, double duty) noexcept;
  // A firmware that reads a set up and takes nothing from it.
  void refuse_set_ups(bool refuses) noexcept;
  // Bytes become a number in memory that was not cleared: the next positive torque comes out negative.
  void spoil_next_torque() noexcept { spoils_torque_ = true; }

  std::size_t ports() const noexcept { return options_.kind == Kind::m0 ? 2 : most_ports; }
  // 0: nobody's.
  std::uint8_t motor_address(std::size_t port) const noexcept { return motors_[port].address; }
  std::uint8_t encoder_address(std::size_t port) const noexcept { return encoders_[port].address; }
  std::uint64_t exchanges() const noexcept { return exchanges_; }
  std::uint64_t set_ups() const noexcept { return set_ups_; }
  std::uint64_t resets() const noexcept { return resets_; }
  std::uint64_t dropped_bytes() const noexcept { return dropped_bytes_; }
  // It waits for bytes, and nothing else runs.
  bool is_waiting() const noexcept { return reading_ != Reading::nothing; }

 private:
  static constexpr std::size_t pwm_pins = 14;
  static constexpr std::size_t most_analogue = 12;

  struct Timed {
    std::int64_t at_ns = 0;
    std::uint8_t byte = 0;
  };

  // What it waits for. A set up is read piece by piece, because each says how long the next one is.
  enum class Reading : std::uint8_t {
    nothing,
    motor_mask,
    motor_directions,
    encoder_mask,
    encoder_directions,
    analogue_count,
    analogue_pins,
    pwm_count,
    pwm_numbers,
    encoder_numbers,
    torques,
  };

  struct Motor {
    std::uint8_t address = 0;
    bool direction = false;
    bool has_pins = false;  // since the first set up that has named it
    double duty = 0.0;
  };
  struct Encoder {
    std::uint8_t address = 0;
    bool direction = false;
    bool runs_backwards = false;   // the direction when it was made
    std::int64_t edges = 0;        // since then
    double start = 0.0;            // of the counter
    double counts_per_turn = 0.0;  // that the firmware reckons with
  };

  // What a set up has said so far.
  struct SetUp {
    std::uint8_t motors = 0;
    std::uint8_t encoders = 0;
    std::uint8_t pins = 0;
    std::array<bool, most_ports> motor_directions{};
    std::array<bool, most_ports> encoder_directions{};
  };

  void run_pass(std::int64_t at_ns) noexcept;
  void await(Reading what, std::size_t size, std::int64_t at_ns) noexcept;
  std::optional<std::int64_t> reading_ends_ns() const noexcept;
  void end_reading(std::int64_t at_ns) noexcept;
  void go_on(std::int64_t at_ns) noexcept;
  std::uint8_t next_byte(std::int64_t at_ns) noexcept;

  void reset() noexcept;
  void set_up() noexcept;
  void exchange(std::int64_t at_ns) noexcept;
  void drive(Motor& motor, float torque) noexcept;
  float torque_at(std::size_t place) noexcept;
  float number_at(std::size_t place) const noexcept;
  float degrees_of(const Encoder& encoder) const noexcept;
  void take_pins(std::span<std::uint8_t> addresses, int first_pin) noexcept;

  std::uint8_t port_mask() const noexcept { return static_cast<std::uint8_t>((1U << ports()) - 1U); }
  std::size_t analogue_inputs() const noexcept { return options_.kind == Kind::m0 ? 5 : most_analogue; }

  Options options_;
  FixedQueue<Timed, 1024> received_;
  FixedQueue<Reply, 8> replies_;
  std::int64_t last_pass_ns_ = -pass_ns;

  Reading reading_ = Reading::nothing;
  std::size_t wanted_ = 0;
  std::int64_t reading_since_ns_ = 0;
  std::array<std::uint8_t, 256> memory_{};  // what was read; what was read before, where less came than was wanted
  std::uint8_t address_ = 0;                // of the command
  SetUp new_set_up_;

  std::array<Motor, most_ports> motors_{};
  std::array<Encoder, most_ports> encoders_{};
  std::array<std::uint8_t, most_analogue> analogue_addresses_{};
  std::array<std::uint8_t, pwm_pins> pwm_addresses_{};

  std::int64_t exchanged_ns_ = 0;
  bool refuses_set_ups_ = false;
  bool spoils_torque_ = false;
  std::uint64_t exchanges_ = 0;
  std::uint64_t set_ups_ = 0;
  std::uint64_t resets_ = 0;
  std::uint64_t dropped_bytes_ = 0;
};

}  // namespace ghostforce
