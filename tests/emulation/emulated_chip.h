// EmulatedChip: the far end of an emulated USB cable, a serial chip as the Falcon has. The emulated device
// (emulated_usb_device.h) calls it, one thread at a time, and tells it the time in ns of CLOCK_MONOTONIC.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "device/falcon/falcon_link.h"

namespace ghostforce {

class EmulatedChip {
 public:
  static constexpr std::size_t packet_size = 64;

  virtual ~EmulatedChip() = default;

  // It gets power, which comes through the cable: what it was told before is forgotten.
  virtual void power_up(std::int64_t now_ns) = 0;

  virtual void control(const VendorRequest& request, std::int64_t now_ns) = 0;

  // The host waits with bytes for which there is no room.
  virtual std::size_t room() const = 0;
  virtual void receive(std::span<const std::uint8_t> bytes, std::int64_t now_ns) = 0;

  // A packet as it goes over the cable, status bytes included; returns its size, 0: none now. None comes before
  // next_due_ns() unless something is sent.
  virtual std::size_t take_packet(std::span<std::uint8_t, packet_size> into, std::int64_t now_ns) = 0;
  virtual std::int64_t next_due_ns() const = 0;
};

}  // namespace ghostforce
