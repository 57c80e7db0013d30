// Ladder: what lies between a Falcon in its box and one that pushes, rung by rung in the order in which they are
// climbed, each with what is happening on it now and what to do. The window and `doctor` show the same one. Pure,
// allocates; not for the servo thread.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/console/failure.h"

namespace ghostforce {

// Of the device, of which what draws the ladder knows nothing else.
struct FalconReport;
struct MotorReport;

enum class Rung : std::uint8_t {
  seen,
  allowed,
  free,
  firmware,
  homed,
  encoders_move,
  fast_enough,
  outside_wall,
  armed,
};

struct RungEntry {
  Rung id;
  std::string_view name;    // in JSON
  std::string_view title;   // on screen
  std::string_view remedy;  // what to do to reach it, where no fault says it better
};

// In the order of Rung.
std::span<const RungEntry> rung_catalog() noexcept;
const RungEntry& entry_of(Rung rung) noexcept;

// Whether the device can exchange often enough, and answers none too late. Until it is homed the driver asks less often
// than it could; then the time of one answer tells.
bool is_fast_and_even(const FalconReport& report) noexcept;

// Exchanges that it makes, or could make while it is being homed [1/s]; 0: not measured yet.
double attainable_exchange_hz(const FalconReport& report) noexcept;

struct RungState {
  Rung rung = Rung::seen;
  std::string_view name;
  std::string_view title;
  bool is_reached = false;
  bool is_current = false;  // the first that is not reached
  std::string words;        // what is so, or what to do; empty: its turn has not come
};

// `motors` null: nobody means to arm, and the ladder ends at fast_enough.
std::vector<RungState> ladder_of(const FalconReport& report, const MotorReport* motors);

// How a program ends that was to use this device. `needs_homing`: somebody was there to do it.
ExitCode exit_code_of(const FalconReport& report, bool needs_homing);

}  // namespace ghostforce
