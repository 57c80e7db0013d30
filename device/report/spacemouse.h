// What a person sets about a SpaceMouse, and what is known of it: plain values, so that a panel may show them. SI
// units.
#pragma once

#include <array>
#include <cstdint>

namespace ghostforce {

// Trivially copyable: it crosses threads whole.
struct SpaceMouseSettings {
  enum class Mode : std::uint8_t { position, rate };
  enum class Up : std::uint8_t { lift, push_away };  // what moves the goal along +y

  Mode mode = Mode::position;
  Up up = Up::lift;
  double dead_zone = 0.05;   // share of full deflection
  double reach_m = 0.060;    // at full deflection, in position mode
  double speed_m_s = 0.150;  // at full deflection, in rate mode

  friend bool operator==(const SpaceMouseSettings&, const SpaceMouseSettings&) = default;
};

// Trivially copyable: it crosses threads whole.
struct SpaceMouseReading {
  enum class Trouble : std::uint8_t {
    none,
    absent,       // none is plugged in
    not_allowed,  // one is, and this user may not open it
    not_opened,   // one is, and cannot be opened for another reason
  };

  Trouble trouble = Trouble::absent;
  std::uint32_t connection = 0;  // a new number each time a device is opened; 0: there is none
  std::array<char, 64> name{};   // of the one that was seen last, ends in 0
  std::array<double, 6> axes{};  // -1 to 1: right, towards the user, down, turns about these
  std::uint32_t buttons = 0;     // bit 0: the first
  std::uint64_t reports = 0;     // that came in since the input was made

  bool connected() const noexcept { return connection != 0; }
};

}  // namespace ghostforce
