// Which HID devices are a SpaceMouse, by what a system or a browser tells of them. Pure values, any thread.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

namespace ghostforce {

// Numbers that USB and its HID class give.
inline constexpr std::uint16_t logitech_vendor = 0x046D;  // made them until 2013, and makes other mice
inline constexpr std::uint16_t connexion_vendor = 0x256F;
inline constexpr std::uint16_t desktop_usage_page = 1;
inline constexpr std::uint16_t multi_axis_controller_usage = 8;

struct HidIdentity {
  std::uint16_t vendor = 0;
  std::uint16_t product = 0;
  std::uint16_t usage_page = 0;  // 0: the system does not tell what the device is used for
  std::uint16_t usage = 0;
};

// One device shows several of these identities: a receiver, for instance, is a keyboard too.
constexpr bool is_spacemouse(const HidIdentity& identity) noexcept {
  constexpr std::array<std::uint16_t, 11> logitech_products{0xC603, 0xC605, 0xC606, 0xC621, 0xC623, 0xC625,
                                                            0xC626, 0xC627, 0xC628, 0xC629, 0xC62B};
  constexpr std::array<std::uint16_t, 8> connexion_products{0xC62E, 0xC62F, 0xC631, 0xC632,
                                                            0xC633, 0xC635, 0xC636, 0xC652};
  if (identity.vendor != logitech_vendor && identity.vendor != connexion_vendor) return false;
  if (identity.usage_page != 0) {
    return identity.usage_page == desktop_usage_page && identity.usage == multi_axis_controller_usage;
  }
  return identity.vendor == logitech_vendor
             ? std::ranges::find(logitech_products, identity.product) != logitech_products.end()
             : std::ranges::find(connexion_products, identity.product) != connexion_products.end();
}

}  // namespace ghostforce
