// EmulatedUsbDevice::File: the emulated device's file, as one program has it open; for the device itself alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include "tests/emulation/emulated_usb_device.h"

namespace ghostforce {

class EmulatedUsbDevice::File final : public OpenFile {
 public:
  struct Completion {
    std::uintptr_t urb = 0;
    std::uintptr_t buffer = 0;  // 0: nothing to store
    int status = 0;
    int length = 0;
    std::vector<std::uint8_t> data;
  };

  File(EmulatedUsbDevice& device, const CallerMemory& caller);
  ~File() override;

  CallResult ioctl(const CallerMemory& memory, unsigned long request, std::uintptr_t argument) override;
  CallResult read(const CallerMemory& memory, std::uintptr_t into, std::size_t size) override;

  const CallerMemory& caller() const { return caller_; }

  std::deque<Completion> completions;
  bool is_unplugged = false;  // for good, even if the device comes back: that is another file

 private:
  EmulatedUsbDevice& device_;
  const CallerMemory& caller_;
};

// Its endpoints.
inline constexpr std::uint8_t bulk_in = 0x81;
inline constexpr std::uint8_t bulk_out = 0x02;

}  // namespace ghostforce
