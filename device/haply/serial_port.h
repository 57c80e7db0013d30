// SerialPort: the cable to a board that speaks hAPI (hapi.h), as the driver sees it: packets out, bytes in. The real one is
// a terminal device of the system (device/haply_serial), the other one leads to a simulated board
// (device/virtual_haply). Threads as device_link.h says.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "device/motors/device_link.h"

namespace ghostforce {

class SerialPort : public DeviceLink {
 public:
  // Sends one packet of at most 64 bytes in one piece: boards that speak hAPI misread a torn one. False, and nothing has
  // gone out: the port takes nothing now, or is not open, or the emergency stop was ordered and these are not zeros.
  virtual bool write(std::span<const std::uint8_t> packet) noexcept = 0;

  // Takes the bytes that have come in, oldest first; returns how many.
  virtual std::size_t read(std::span<std::uint8_t> into) noexcept = 0;
  // Those that have come in and are not taken yet are forgotten.
  virtual void discard_input() noexcept = 0;

  // Zero torques for both motors, to the address that this program gives its boards.
  void stop_at_once() noexcept final;

  // As stop_at_once(), these bytes.
  virtual void write_at_once(std::span<const std::uint8_t> packet) noexcept = 0;
};

}  // namespace ghostforce
