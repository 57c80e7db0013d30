// What can be done with a USB device through the kernel's file for it, without a library: each is one system call that
// waits for some ms at most. Async-signal-safe; allocates nothing; any thread. See the kernel's usbdevice_fs.h.
#pragma once

#include <cstdint>
#include <span>

#include "device/motors/guard_memory.h"

namespace ghostforce::usb_node {

// To a bulk endpoint, once. False: the device has not taken it in that time, or the file is none of a USB device.
bool send_once(int descriptor, std::uint8_t endpoint, std::span<const std::uint8_t> bytes,
               unsigned timeout_ms) noexcept;

// The same, within some ms. Clears the endpoint's halt where there is one, and sends again.
bool send(int descriptor, std::uint8_t endpoint, std::span<const std::uint8_t> bytes) noexcept;

bool control(int descriptor, const LineRequest& request) noexcept;

// Whether the file is that of a USB device.
bool is_one(int descriptor) noexcept;

// Takes an interface away from whoever has it, a driver or another program, whose transfers end.
bool take_over(int descriptor, std::uint8_t interface) noexcept;
void release(int descriptor, std::uint8_t interface) noexcept;

}  // namespace ghostforce::usb_node
