// Bytes as a host sends them, for tests of the simulated board: written out, and without a look at the driver.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "device/virtual_haply/haply_fault.h"
#include "device/virtual_haply/virtual_haply_variant.h"

namespace ghostforce::hapi_bytes {

using Bytes = std::vector<std::uint8_t>;

inline constexpr std::int64_t us = 1'000;
inline constexpr std::int64_t ms = 1'000'000;
inline constexpr std::uint8_t host_id = 5;

// The worked examples of the published protocol.
inline const Bytes set_up_v31{0x01, 0x05, 0x03, 0x01, 0x01, 0x03, 0x01, 0x01, 0x00, 0x00, 0x00, 0x00, 0x40,
                              0x41, 0x00, 0x80, 0x98, 0x45, 0x00, 0x00, 0x28, 0x43, 0x00, 0x80, 0x98, 0x45};
inline const Bytes set_up_v2{0x01, 0x05, 0x03, 0x00, 0x01, 0x03, 0x00, 0x01, 0x00, 0x00, 0x00, 0x00, 0x74,
                             0xc2, 0x00, 0x00, 0x28, 0x46, 0x00, 0x00, 0x71, 0x43, 0x00, 0x00, 0x28, 0x46};
inline const Bytes exchange_at_port_2{0x02, 0x05, 0x00, 0x00, 0x00, 0x00, 0xcd, 0xcc, 0x4c, 0x3d};
inline const Bytes reply_v31{0x05, 0x00, 0x00, 0x40, 0x41, 0x00, 0x00, 0x28, 0x43};

inline void add_number(Bytes& bytes, double number) {
  const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(number));
  for (unsigned i = 0; i < 4; ++i) bytes.push_back(static_cast<std::uint8_t>(bits >> (8 * i)));
}

inline float number_of(std::span<const std::uint8_t> bytes, std::size_t at) {
  std::uint32_t bits = 0;
  for (unsigned i = 0; i < 4; ++i) bits |= std::uint32_t{bytes[at + i]} << (8 * i);
  return std::bit_cast<float>(bits);
}

// In port order, as torques go over the cable [N·m].
inline Bytes exchange_of(double port_1, double port_2, std::uint8_t id = host_id) {
  Bytes bytes{0x02, id};
  add_number(bytes, port_1);
  add_number(bytes, port_2);
  return bytes;
}

// By arm.
inline Bytes exchange_of_arms(const VirtualHaplyVariant& variant, double arm_1, double arm_2) {
  return variant.motors[0].port == 0 ? exchange_of(arm_1, arm_2) : exchange_of(arm_2, arm_1);
}

inline Bytes set_up_of(const VirtualHaplyVariant& variant, double resolution_factor = 1.0, std::uint8_t id = host_id) {
  const std::size_t first_motor = variant.motors[0].port == 0 ? 0 : 1;
  const std::size_t first = variant.encoders[0].port == 0 ? 0 : 1;
  Bytes bytes{0x01, id, 0x03, variant.motors[first_motor].direction, variant.motors[1 - first_motor].direction};
  bytes.insert(bytes.end(), {0x03, variant.encoders[first].direction, variant.encoders[1 - first].direction, 0, 0});
  for (const std::size_t arm : {first, 1 - first}) {
    add_number(bytes, variant.encoders[arm].offset_degrees);
    add_number(bytes, resolution_factor * variant.encoders[arm].counts_per_turn);
  }
  return bytes;
}

// The angle of an arm in a whole reply [degrees].
inline double angle_in(std::span<const std::uint8_t> reply, const VirtualHaplyVariant& variant, std::size_t arm) {
  return number_of(reply, 1 + 4 * variant.encoders[arm].port);
}

inline InjectedHaplyFault haply_fault(std::string_view name) {
  InjectedHaplyFault wrong;
  find_injected_haply_fault(name)->add(wrong);
  return wrong;
}

}  // namespace ghostforce::hapi_bytes
