// FalconLink: the pipe between the driver and a Falcon, which on USB is a serial chip of FTDI's: vendor requests that
// set the chip up, bytes out, bytes in. The real one is libusb's (ftdi_link.h), the other one is this program's own end
// of the protocol (device/virtual_falcon/virtual_link.h). The driver above cannot tell them apart.
//
// All functions but now_ns(), send_at_once() and is_any_plugged_in() belong to one thread at a time: link_opener.h says
// which. None throws, and none waits except wait_until(), open() and close(). Times in ns.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace ghostforce {

class StopDebts;

// A control transfer to the chip: bmRequestType 0x40, no data.
struct VendorRequest {
  std::uint8_t request = 0;
  std::uint16_t value = 0;
  std::uint16_t index = 0;

  friend bool operator==(const VendorRequest&, const VendorRequest&) = default;
};

// Why a link is not open, or is of no use any more.
enum class LinkFault : std::uint8_t {
  none,
  absent,       // no device with these ids and that serial number is plugged in
  not_allowed,  // it is, and this user may not open it
  busy,         // another program has it
  unsupported,  // it, or this system's USB, cannot be driven this way
  unplugged,    // it was there and has gone
  broken,       // transfers fail for another reason
  overruled,    // the guard has stopped the motors, because this program did not live
  unguarded,    // the guard is gone
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

class FalconLink {
 public:
  FalconLink() = default;
  FalconLink(const FalconLink&) = delete;
  FalconLink& operator=(const FalconLink&) = delete;
  virtual ~FalconLink() = default;  // closes

  // Whether open() and close() wait for a system or a device and allocate, so that they need a thread of their own.
  virtual bool waits_to_open() const noexcept = 0;

  // Looks for the device, takes it and clears what an earlier fault has left; from then on bytes come in by themselves.
  // Returns fault().
  virtual LinkFault open() noexcept = 0;
  // The same, but devices that are owed a stop come before the one that would be chosen: while one of them is plugged
  // in, no other is opened, and the fault says why it cannot be. A link that leads to a single device has no choice.
  virtual LinkFault open_first(const StopDebts& /*owed*/) noexcept { return open(); }
  // Looks whether one of these devices is plugged in, whatever is open. Waits for the system; on the thread that opens.
  virtual bool is_any_plugged_in(const StopDebts& /*owed*/) const noexcept { return false; }

  // Sends what owes_stop() speaks of, ends what is under way and gives the device back. Also after a fault. Nothing if
  // it is not open.
  virtual void close() noexcept = 0;

  // none: open and well. Stays what it is until the next open().
  virtual LinkFault fault() const noexcept = 0;

  // Of the device that is open or was; empty before.
  virtual std::string_view serial() const noexcept = 0;

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

  // Whether somebody stops the motors when this program cannot: a guard (device/falcon_usb/motor_guard.h), to which
  // wait_until() tells that the program lives. Without it motors must stay off. A link that ends with the program needs
  // none.
  virtual bool is_guarded() const noexcept { return true; }
  // From before the first force is written until the device has answered a zero.
  virtual void set_may_push(bool /*may_push*/) noexcept {}

  // Takes the bytes that have come in, oldest first, without the chip's status bytes; returns how many.
  virtual std::size_t read(std::span<std::uint8_t> into) noexcept = 0;

  // The chip's newest first status byte; bit 4 is CTS. 0 before the first.
  virtual std::uint8_t modem_status() const noexcept = 0;

  virtual LinkCounters counters() const noexcept = 0;

  // The clock by which everything here happens: that of CLOCK_MONOTONIC, or one that a test moves.
  virtual std::int64_t now_ns() const noexcept = 0;

  // Lets transfers make progress; returns when bytes have come in or something has been sent, or on a fault, and at
  // `deadline_ns` at the latest. If the deadline has passed, looks and returns at once.
  virtual void wait_until(std::int64_t deadline_ns) noexcept = 0;

  // The emergency stop, from a signal handler, on any thread: sends these bytes beside what is under way, and waits until
  // the chip has taken them, 30 ms at most. Async-signal-safe. The program is about to end.
  virtual void send_at_once(std::span<const std::uint8_t> bytes) noexcept = 0;
};

}  // namespace ghostforce
