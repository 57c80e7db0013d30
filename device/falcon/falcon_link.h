// FalconLink: the pipe between the driver and a Falcon, which on USB is a serial chip of FTDI's: vendor requests that
// set the chip up, bytes out, bytes in. The real one is libusb's (ftdi_link.h), the other one is this program's own end
// of the protocol (device/virtual_falcon/virtual_link.h). The driver above cannot tell them apart.
//
// send_at_once() belongs to any thread; the rest as device_link.h says. Times in ns.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "device/motors/device_link.h"

namespace ghostforce {

// A control transfer to the chip: bmRequestType 0x40, no data.
struct VendorRequest {
  std::uint8_t request = 0;
  std::uint16_t value = 0;
  std::uint16_t index = 0;

  friend bool operator==(const VendorRequest&, const VendorRequest&) = default;
};

// The outcome of a request.
enum class RequestOutcome : std::uint8_t {
  done,
  refused,     // the chip does not know it, or not now
  unanswered,  // in all the time that it had
};

// Since open(); for the diagnosis on screen.
struct LinkCounters {
  std::uint64_t library_calls = 0;  // into the USB library, which allocates as it likes
  std::uint64_t bytes_in = 0;       // without the chip's status bytes
  std::uint64_t bytes_out = 0;
  std::uint64_t packets_in = 0;
  std::uint64_t status_packets = 0;   // with nothing but status: the chip was there and had nothing to say
  std::uint64_t line_errors = 0;      // overrun, parity or framing, as the chip reports them
  std::uint64_t discarded_bytes = 0;  // that came while nobody took them
};

class FalconLink : public DeviceLink {
 public:
  // Starts to send; false, and nothing happens, while something else is still being sent (is_sending()) or the link is
  // not open. A request may go out beside a stop. At most 64 bytes.
  virtual bool request(const VendorRequest& request) noexcept = 0;
  // Of the newest request, once nothing is being sent any more.
  virtual RequestOutcome request_outcome() const noexcept = 0;
  virtual bool write(std::span<const std::uint8_t> bytes) noexcept = 0;
  virtual bool is_sending() const noexcept = 0;

  // The motors' zero, ahead of everything: what is being written is cancelled, and these bytes go out in its place,
  // even after a fault, unless the device is gone. At most 64 bytes. Returns at once; owes_stop() says whether the chip
  // still has to take them, and close() then keeps trying for a while. That the device behind the chip has heard them,
  // only its reply tells.
  virtual void stop(std::span<const std::uint8_t> bytes) noexcept = 0;
  virtual bool owes_stop() const noexcept = 0;

  // Takes the bytes that have come in, oldest first, without the chip's status bytes; returns how many.
  virtual std::size_t read(std::span<std::uint8_t> into) noexcept = 0;

  // The chip's newest first status byte; bit 4 is CTS. 0 before the first.
  virtual std::uint8_t modem_status() const noexcept = 0;

  virtual LinkCounters counters() const noexcept = 0;

  void stop_at_once() noexcept final;

  // Sends these bytes as stop_at_once() does.
  virtual void send_at_once(std::span<const std::uint8_t> bytes) noexcept = 0;
};

}  // namespace ghostforce
