// DeviceLink: what every cable to a device with motors is to those who open it, pace it and stop its motors. What goes
// through it is its own: FalconLink and SerialPort add that.
//
// All functions but now_ns(), stop_at_once() and is_any_plugged_in() belong to one thread at a time: link_opener.h says
// which. None throws, and none waits except wait_until(), open() and close(). Times in ns.
#pragma once

#include <cstdint>
#include <string_view>

namespace ghostforce {

class StopDebts;

// Why a link is not open, or is of no use any more.
enum class LinkFault : std::uint8_t {
  none,
  absent,       // no such device is plugged in
  not_allowed,  // it is, and this user may not open it
  busy,         // another program has it
  unsupported,  // it, or this system, cannot be driven this way
  unplugged,    // it was there and has gone
  broken,       // transfers fail for another reason
  overruled,    // the guard has stopped the motors, because this program did not live
  unguarded,    // the guard is gone
};

class DeviceLink {
 public:
  DeviceLink() = default;
  DeviceLink(const DeviceLink&) = delete;
  DeviceLink& operator=(const DeviceLink&) = delete;
  virtual ~DeviceLink() = default;  // closes

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

  // Ends what is under way and gives the device back, once a stop that it is owed has gone out. Also after a fault.
  // Nothing if it is not open.
  virtual void close() noexcept = 0;

  // none: open and well. Stays what it is until the next open().
  virtual LinkFault fault() const noexcept = 0;

  // Of the device that is open or was; empty before.
  virtual std::string_view serial() const noexcept = 0;

  // Whether somebody stops the motors when this program cannot: a guard (device/guard/motor_guard.h), to which
  // wait_until() tells that the program lives. Without it motors must stay off. A link that ends with the program needs
  // none.
  virtual bool is_guarded() const noexcept { return true; }
  // From before the first force is written until the device has answered a zero.
  virtual void set_may_push(bool /*may_push*/) noexcept {}

  // The clock by which everything here happens: that of CLOCK_MONOTONIC, or one that a test moves.
  virtual std::int64_t now_ns() const noexcept = 0;

  // Lets transfers make progress; returns when bytes have come in or something has been sent, or on a fault, and at
  // `deadline_ns` at the latest. If the deadline has passed, looks and returns at once.
  virtual void wait_until(std::int64_t deadline_ns) noexcept = 0;

  // The emergency stop, from a signal handler, on any thread: sends zero force beside what is under way, and waits until
  // it has been taken, 30 ms at most. Async-signal-safe. The program is about to end.
  virtual void stop_at_once() noexcept = 0;
};

}  // namespace ghostforce
