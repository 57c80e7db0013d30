// GuardMemory: the page of memory that a program with motors shares with its guard (guard/motor_guard.h), and how
// the guard is called. The program tells that it lives and what its motors may be doing; the guard tells what it has
// done about it. All of it is plain atomic memory: neither side ever makes a system call for the other. Times in ns of
// CLOCK_MONOTONIC.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace ghostforce {

// A vendor request of a USB device, to the device and without data.
struct LineRequest {
  std::uint8_t request = 0;
  std::uint16_t value = 0;
  std::uint16_t index = 0;
};

// How a guard stops motors: what it sends, and where. Written once, before the guard starts.
struct GuardOrders {
  enum class Wire : std::uint8_t {
    usb,     // the file is that of a USB device
    serial,  // it is that of a serial port, which takes the stop as it is
  };

  static constexpr std::size_t most_requests = 8;
  static constexpr std::size_t most_bytes = 64;

  Wire wire = Wire::usb;
  // Of a USB device.
  std::uint8_t interface = 0;
  std::uint8_t out_endpoint = 0;
  // Of the line to the motors, in case it was lost.
  std::array<LineRequest, most_requests> set_up{};
  std::uint8_t set_up_count = 0;
  // Zero force.
  std::array<std::uint8_t, most_bytes> stop{};
  std::uint8_t stop_size = 0;
  // Once, after that: what ends a force of a device that no longer knows the program's address.
  std::array<std::uint8_t, most_bytes> last{};
  std::uint8_t last_size = 0;
};

enum class GuardState : std::uint8_t {
  none,      // has not begun to watch
  watching,  // over a program that lives
  stopping,  // overrules the program: from here on that may not ask for a force
  stopped,   // the device has taken the stop, several times
  failing,   // the device takes nothing; the guard keeps trying
};

struct GuardMemory {
  GuardOrders orders;

  // The program's.
  std::atomic<std::int64_t> beat_ns{0};
  // A force was sent, by whomever, or is about to be, and no zero has been answered since.
  std::atomic<bool> may_push{false};
  std::atomic<bool> has_ended{false};  // the guard is needed no more

  // The guard's.
  std::atomic<std::int64_t> guard_beat_ns{0};
  std::atomic<GuardState> state{GuardState::none};
};
static_assert(std::atomic<std::int64_t>::is_always_lock_free && std::atomic<bool>::is_always_lock_free &&
              std::atomic<GuardState>::is_always_lock_free);

// Without a beat for this long a program that may push is taken for dead: with the time to send, less than 25 ms [ns].
inline constexpr std::int64_t longest_beat_gap_ns = 18'000'000;

enum class GuardAction : std::uint8_t { watch, stop_motors, end };

// What a guard is to do now. `program_is_gone`: its process.
GuardAction guard_action(bool has_ended, bool may_push, std::int64_t beat_ns, bool program_is_gone,
                         std::int64_t now_ns) noexcept;

// How a program calls its guard: ghostforce-guard NODE, with three files open.
namespace guard_call {

inline constexpr int device_descriptor = 3;    // the device's file; of USB, with its interface claimed
inline constexpr int page_descriptor = 4;      // a GuardMemory
inline constexpr int lifeline_descriptor = 5;  // a pipe that ends when the program does

}  // namespace guard_call

}  // namespace ghostforce
