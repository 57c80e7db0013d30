// What a SpaceMouse says, report by report, and which HID devices are one. Older ones send translation and rotation in
// reports of their own, newer ones all six axes in one; its length tells which one it is. Pure values, any thread;
// never allocates or throws.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

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
// Of a report that comes with its number apart, as from a browser.
bool take_report(std::uint8_t number, std::span<const std::uint8_t> bytes, SpaceMouseState& state) noexcept;

// Axes and buttons of the reading become these: full deflection is 1.
void show(const SpaceMouseState& state, SpaceMouseReading& reading) noexcept;

// Numbers that USB and its HID class give.
inline constexpr std::uint16_t logitech_vendor = 0x046D;  // made them until 2013, and makes other mice
inline constexpr std::uint16_t connexion_vendor = 0x256F;
inline constexpr std::uint16_t desktop_usage_page = 1;
inline constexpr std::uint16_t multi_axis_controller_usage = 8;

// Whether some of the device's reports are those of a multi-axis controller: its report descriptor (Device Class
// Definition for HID 1.11, 6.2.2) has a collection of that usage. False where the descriptor breaks off before it.
constexpr bool has_multi_axis_collection(std::string_view descriptor) noexcept {
  unsigned page = 0;
  unsigned usage = 0;
  while (!descriptor.empty()) {
    const unsigned prefix = static_cast<unsigned char>(descriptor[0]);
    const std::size_t size = (prefix & 3U) == 3U ? 4 : prefix & 3U;
    if (descriptor.size() <= size) return false;
    unsigned value = 0;  // the low byte is the first
    for (std::size_t i = size; i > 0; --i) value = value << 8U | static_cast<unsigned char>(descriptor[i]);
    switch (prefix & 0xFCU) {
      case 0x04:  // usage page
        page = value;
        break;
      case 0x08:  // usage
        usage = value;
        break;
      case 0xA0:  // collection
        if (page == desktop_usage_page && usage == multi_axis_controller_usage) return true;
        [[fallthrough]];
      case 0x80:  // input, output, feature, end of a collection: the usage was for this item only
      case 0x90:
      case 0xB0:
      case 0xC0:
        usage = 0;
        break;
      default:
        break;
    }
    descriptor.remove_prefix(1 + size);
  }
  return false;
}

// Whether a HID device is a SpaceMouse, by what the system tells of it. One device shows itself several times: a
// receiver, for instance, is a keyboard too.
constexpr bool is_spacemouse(std::uint16_t vendor, std::string_view descriptor) noexcept {
  return (vendor == logitech_vendor || vendor == connexion_vendor) && has_multi_axis_collection(descriptor);
}

}  // namespace ghostforce
