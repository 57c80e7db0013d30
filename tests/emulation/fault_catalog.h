// Fault: something that goes wrong while the motors push, and what the program promises then. The catalog is what
// fault_table measures and falcon_faults_test checks. A row says how it is brought about: by the cable
// (usb_fault.h), by what is behind it (injected_fault.h), by the hand, by an order to the program (orders.h), by a
// signal, or by a way to end that the program goes by itself (armed_program.cpp). Immutable, any thread.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace ghostforce {

enum class Promise : std::uint8_t {
  zero,            // on the wire, without opening the device anew
  zero_or_onward,  // that, or it is got over, and no force is held for long without a new command
  last_try,        // the wire is dead: what is tried last is a zero
  fade,            // the force fades; there is time
  stall_and_fade,  // after the window has been found to hang
  none,            // there is nobody left to send anything
};

struct Fault {
  std::string_view name;   // of its test: letters and digits
  std::string_view title;  // for a person
  Promise promise;
  std::string_view usb = "";     // a name of usb_fault_catalog()
  std::string_view device = "";  // a name of injected_fault_catalog()
  std::string_view order = "";
  int signal = 0;
  bool hand_is_torn_away = false;
  std::string_view way = "obey";  // any other begins by itself

  int lasts_ms = 1500;                   // then the fault is taken away
  std::string_view usb_afterwards = "";  // as the cable is then
  bool forgets_home = false;             // the device does, and nobody can help it
  bool is_quick = true;                  // of the half that a change has to pass
};

std::span<const Fault> fault_catalog() noexcept;

}  // namespace ghostforce
