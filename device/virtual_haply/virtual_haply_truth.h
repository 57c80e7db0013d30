// HaplyTruth: how things really are behind the cable of a simulated board, for those who compare it with what a driver
// makes of it. A plain value, any thread. m, N, N·m, rad; times in ns of the clock by which the board lives.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/conventions.h"

namespace ghostforce {

struct HaplyTruth {
  std::int64_t time_ns = 0;  // up to when all of this has been lived

  // By arm, from 0. A duty is the signed share of what the motor gives in full, as the board's pins say; without power
  // it is 0. Its sign is that of the pins: what an arm feels is its torque, positive if it increases the angle.
  std::array<double, 2> duties{};
  Vector<2> torques{0.0};
  Vector<2> angles{0.0};    // of the driven links, counter-clockwise from the way from motor 1 to motor 2
  Vector<2> handle{0.0};    // where it is
  Vector<2> velocity{0.0};  // of the handle [m/s]
  Vector<2> force{0.0};     // the motors', on the handle

  bool is_configured = false;       // all motors and encoders of the arms, for one address
  std::uint8_t address = 0;         // theirs, if so
  std::uint64_t packets = 0;        // of the host's that reached the board
  std::int64_t last_packet_ns = 0;  // 0: there was none
  std::uint64_t exchanges = 0;      // that the board has answered, or would have
  std::uint64_t set_ups = 0;
  std::uint64_t resets = 0;

  std::int64_t silence_ns() const noexcept { return time_ns - last_packet_ns; }
};

}  // namespace ghostforce
