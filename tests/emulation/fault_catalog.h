// Fault: something that goes wrong while the motors push, and what the program promises then. The catalog is what
// fault_table measures and falcon_faults_test checks. A row says how it is brought about: by the cable
// (usb_fault.h), by what is behind it (injected_fault.h), by the hand, by an order to the program (orders.h), by a
// signal, by what keeps the program from running (held_program.h), or by a way to end that the program goes by itself
// (armed_program.cpp). Immutable, any thread.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "tests/emulation/held_program.h"

namespace ghostforce {

enum class Promise : std::uint8_t {
  zero,            // on the wire, without opening the device anew
  zero_and_why,    // within 100 ms, with the reason: it has to be found out first
  zero_or_onward,  // that, or it is got over, and no force is held for long without a new command
  last_try,        // the wire is dead: what is tried last is a zero
  fade,            // the force fades; there is time
  stall_and_fade,  // after the window has been found to hang
  fast,            // no force: the device becomes fast enough to be armed
};

// Another Falcon, which is plugged in from the beginning. The program takes it when the first is pulled out.
enum class OtherFalcon : std::uint8_t {
  none,
  taken,
  taken_and_left,  // the program ends when the first is plugged in again
  pulled_out_too,  // while it pushes; then both are plugged in again
};

struct Fault {
  std::string_view name;   // of its test: letters and digits
  std::string_view title;  // for a person
  Promise promise;
  std::string_view usb = "";              // a name of usb_fault_catalog()
  std::string_view device = "";           // a name of injected_fault_catalog()
  std::string_view usb_at_start = "";     // as the cable is when the program begins to look for the device
  std::string_view device_at_start = "";  // as `device`, but before the motors are armed: they are never fully on
  std::string_view order = "";
  int signal = 0;
  bool starts_with_signals_blocked = false;
  ProcessHold hold = ProcessHold::none;
  int busy_processes = 0;  // beside the program
  OtherFalcon other_falcon = OtherFalcon::none;
  bool hand_is_torn_away = false;
  bool hand_goes_out = false;     // of the wall, in its own time
  std::string_view way = "obey";  // any other begins by itself

  bool program_hangs = false;  // it says nothing any more, and does not end

  int lasts_ms = 1500;                   // then the fault is taken away; 0: it has gone by itself
  std::string_view usb_afterwards = "";  // as the cable is then
  int plug_to_zero_ms = 1000;            // at most, where it was pulled out and still pushes when it is plugged in
  bool is_fast_again = false;            // as before, in the end
  bool forgets_home = false;             // the device does, and nobody can help it
  bool is_quick = true;                  // of the half that a change has to pass
};

std::span<const Fault> fault_catalog() noexcept;

}  // namespace ghostforce
