// FaultTrial: armed_program, armed and pushing through the real libusb, meets one fault of the catalog; and what was
// seen of it at the far end of the cable. The fault's own thread; the test bed's.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "core/safety.h"
#include "device/falcon/falcon_report.h"
#include "tests/emulation/fault_catalog.h"
#include "tests/emulation/test_bed.h"

namespace ghostforce {

// Times since the fault, in ns. "Off" is what the program says while it says neither that motors are on nor that the
// device may still push.
struct FaultOutcome {
  std::optional<std::int64_t> zero_ns;      // on the wire, for good; none: the force stayed
  std::optional<std::int64_t> zero_try_ns;  // the last thing tried before the fault was taken away was a zero: when
  bool was_taken_anew = false;              // the device was, before the force had ended
  bool went_on = false;                     // the motors stayed armed, and got new commands
  std::int64_t longest_hold_ns = 0;         // of a force without a new command
  std::int64_t longest_false_off_ns = 0;    // of a device that went on pushing while the program said "off"
  std::uint64_t forces_after_hold = 0;      // commands with a force that came once the program could run again
  bool lost_home = false;
  OffReason reason = OffReason::none;            // by which the motors went off, as the program says
  FalconFault device_fault = FalconFault::none;  // what it says of the device
  std::optional<int> exit_code;                  // none: it goes on
  bool came_back = false;                        // the device can be read again, and the motors are off
  std::int64_t back_ns = 0;                      // since the fault was taken away
  std::optional<std::int64_t> plug_to_zero_ns;   // of what was pulled out and plugged in again: how soon it let go
  bool other_was_taken_first = false;            // the other Falcon, while this one was there and pushed
  std::optional<std::int64_t> fast_ns;           // since it was taken away: until the device was fast enough
  bool stays_slow = false;
  std::int64_t late_ns = 0;  // the longest delay of the machine itself while the force ended

  std::string words() const;  // what the program says
};

// Tries until a fault meets motors that push: they may go off before, because the machine has other things to do. What
// breaks the promise while the machine was late is tried again. Throws MachineTooBusy where trying is in vain.
// `patience`: for a force to end. `busy_processes` run beside the program from when it pushes; the fault may ask for more.
FaultOutcome try_fault(TestBed& bed, const Fault& fault, std::chrono::milliseconds patience, int busy_processes = 0);

// How the promise was broken; empty: it was kept. `timed`: its times count too, of a machine that does little else.
std::string broken_promise(const Fault& fault, const FaultOutcome& outcome, bool timed);

}  // namespace ghostforce
