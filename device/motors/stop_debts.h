// StopDebts: the devices that were told to stop and have not answered a zero since, by their serial numbers, in the order
// in which they are tried: one that could not be stopped comes last. That USB has taken a stop proves nothing: a chip
// that has lost its baud rate passes it on as noise.
// A plain value, any thread; never allocates or throws.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "device/motors/device_serial.h"

namespace ghostforce {

class StopDebts {
 public:
  // More than are ever plugged into one machine. One more debt than these is not kept.
  static constexpr std::size_t most = 8;

  bool empty() const noexcept { return count_ == 0; }
  std::span<const DeviceSerial> serials() const noexcept { return std::span(serials_).first(count_); }

  // In that order, from 0; `most`: it is owed nothing.
  std::size_t place_of(const DeviceSerial& serial) const noexcept {
    const auto all = serials();
    const auto found = std::ranges::find(all, serial);
    return found == all.end() ? most : static_cast<std::size_t>(found - all.begin());
  }
  bool has(const DeviceSerial& serial) const noexcept { return place_of(serial) < most; }

  void add(const DeviceSerial& serial) noexcept {
    if (count_ < most && !has(serial)) serials_[count_++] = serial;
  }
  // It could not be paid now: the others come first.
  void postpone(const DeviceSerial& serial) noexcept {
    if (!has(serial)) return;
    remove(serial);
    add(serial);
  }
  void remove(const DeviceSerial& serial) noexcept {
    const std::size_t place = place_of(serial);
    if (place == most) return;
    std::copy(serials_.begin() + place + 1, serials_.begin() + count_, serials_.begin() + place);
    --count_;
  }

 private:
  std::array<DeviceSerial, most> serials_{};
  std::size_t count_ = 0;
};

}  // namespace ghostforce
