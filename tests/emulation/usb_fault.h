// UsbFault: what the emulated USB device is asked to do wrong, and the catalog of the faults that tests ask for
// by name, alone or together. They are those that the USB specification and the kernel's usbfs know: an endpoint
// stalls, halts, answers NAK or garbles its packets; the control endpoint is slow or refuses a request; the device
// goes. What the serial line and the processor behind it do wrong is InjectedFault's.
// A trivially copyable value; its catalog is immutable after start, any thread. Times in ms.
#pragma once

#include <span>
#include <string_view>

namespace ghostforce {

// Of a bulk endpoint. Counts and times begin when the fault is asked for.
struct EndpointFaults {
  static constexpr int for_ever = -1;

  int failures = 0;    // transfers that fail
  int error = 0;       // with this errno, as the status of a URB has it; EPIPE is a stall
  bool halts = false;  // all transfers fail with EPIPE until the host clears the halt: what asked for it may be gone
  bool halts_again = false;  // as soon as the halt is cleared, as long as this is asked for
  int nak_ms = 0;            // for this long no transfer ends and none fails; or for_ever

  friend bool operator==(const EndpointFaults&, const EndpointFaults&) = default;
};

// As it is made: none.
struct UsbFault {
  static constexpr int no_request = -1;

  EndpointFaults in;
  EndpointFaults out;

  // The control endpoint. A request that is refused is stalled; the next one is welcome again.
  int control_nak_ms = 0;             // for this long it answers nothing
  int control_nak_ms_when_taken = 0;  // once, from when a program next claims the interface
  int refused_request = no_request;   // bRequest of the chip's
  int refusals = 0;                   // how many of them are refused; or EndpointFaults::for_ever
  int clear_halt_ms = 0;              // clearing a halt takes so long

  bool is_unplugged = false;

  friend bool operator==(const UsbFault&, const UsbFault&) = default;
};

struct UsbFaultKind {
  std::string_view name;
  std::string_view sentence;  // what it does, for a person
  void (*add)(UsbFault&) noexcept;
};

std::span<const UsbFaultKind> usb_fault_catalog() noexcept;

// Throws when no fault has that name.
UsbFault usb_fault(std::string_view name);

}  // namespace ghostforce
