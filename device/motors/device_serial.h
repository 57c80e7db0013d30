// DeviceSerial: what tells one device with motors from others of its kind. A plain value, any thread; never allocates or
// throws.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace ghostforce {

// Falcons have 8 characters in all that were seen, boards with a microcontroller 32.
class DeviceSerial {
 public:
  static constexpr std::size_t longest = 63;

  DeviceSerial() = default;

  // Empty: too long.
  static constexpr std::optional<DeviceSerial> from(std::string_view text) noexcept {
    if (text.size() > longest) return std::nullopt;
    DeviceSerial serial;
    std::copy(text.begin(), text.end(), serial.letters_.begin());
    serial.size_ = static_cast<std::uint8_t>(text.size());
    return serial;
  }

  constexpr std::string_view text() const noexcept { return {letters_.data(), size_}; }

  friend bool operator==(const DeviceSerial&, const DeviceSerial&) = default;

 private:
  std::array<char, longest> letters_{};
  std::uint8_t size_ = 0;
};

// As a device is known by what it says; one whose number is too long is known as one without.
constexpr DeviceSerial device_serial_of(std::string_view text) noexcept {
  return DeviceSerial::from(text).value_or(DeviceSerial());
}

}  // namespace ghostforce
