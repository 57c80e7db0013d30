// What is known of a SpaceMouse: whether there is one, and how its cap is deflected.
#pragma once

#include <array>
#include <cstdint>

namespace ghostforce {

// Trivially copyable: it crosses threads whole.
struct SpaceMouseReading {
  enum class Trouble : std::uint8_t {
    none,
    absent,       // none is plugged in
    not_allowed,  // one is, and this user may not open it
    not_opened,   // one is, and cannot be opened for another reason
  };

  Trouble trouble = Trouble::absent;
  std::uint32_t connection = 0;  // another number each time a device has been opened; 0: there is none
  std::array<char, 64> name{};   // of the one that was seen last, ends in 0
  std::array<double, 6> axes{};  // -1 to 1: right, towards the user, down, turns about these
  std::uint32_t buttons = 0;     // bit 0: the first
  std::uint64_t reports = 0;     // that came in since the input was made

  bool connected() const noexcept { return connection != 0; }
};

}  // namespace ghostforce
