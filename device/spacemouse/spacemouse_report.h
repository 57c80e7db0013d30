// What a SpaceMouse says, report by report. Older ones send translation and rotation in reports of their own, newer
// ones all six axes in one; its length tells which one it is. Pure values, any thread; never allocates or throws.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "device/report/spacemouse.h"

namespace ghostforce {

struct SpaceMouseState {
  // As the device counts them: x to the right, y towards the user, z down, then turns about these. Some ±350.
  std::array<int, 6> axes{};
  std::uint32_t buttons = 0;  // bit 0: the first

  friend bool operator==(const SpaceMouseState&, const SpaceMouseState&) = default;
};

// Takes over what this report says, its number first. False, and nothing changes: the report is not known here.
bool take_report(std::span<const std::uint8_t> report, SpaceMouseState& state) noexcept;
// The same, of a report that comes with its number apart, as from a browser.
bool take_report(std::uint8_t number, std::span<const std::uint8_t> bytes, SpaceMouseState& state) noexcept;

// Axes and buttons of the reading become these: full deflection is 1.
void show(const SpaceMouseState& state, SpaceMouseReading& reading) noexcept;

}  // namespace ghostforce
