// VirtualHaplyVariant: what is known of each device that was sold with one of these boards: its arms, and which port
// each motor and each encoder is on. From the tables of published host programs.
//
// Immutable, any thread. m; degrees and counts per turn as they go over the cable.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "core/conventions.h"
#include "device/virtual_haply/arms_geometry.h"

namespace ghostforce {

struct VirtualHaplyVariant {
  // The direction is what the host must send, on an M0 or an M3, so that a positive torque increases the arm's angle
  // and an increasing angle counts upwards: with another one the wiring is the other way round. Ports from 0.
  struct Motor {
    std::uint8_t direction = 0;
    std::size_t port = 0;
  };
  struct Encoder {
    std::uint8_t direction = 0;
    double offset_degrees = 0.0;  // the arm's angle in the zero pose
    double counts_per_turn = 1.0;
    std::size_t port = 0;
  };

  std::string_view name;
  ArmsGeometry geometry;
  std::array<Motor, 2> motors;      // by arm
  std::array<Encoder, 2> encoders;  // by arm

  // In which a person puts the arms before the set up [rad].
  Vector<2> zero_pose() const noexcept {
    return radians_per_degree * Vector<2>{encoders[0].offset_degrees, encoders[1].offset_degrees};
  }
};

// "2017", "v2", "v3" and "v3.1".
std::span<const VirtualHaplyVariant> virtual_haply_variants() noexcept;

// Null when no variant has that name.
const VirtualHaplyVariant* find_virtual_haply_variant(std::string_view name) noexcept;

}  // namespace ghostforce
