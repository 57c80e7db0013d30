// What the options and reports of all drivers with motors say by the same names: FalconReport, HaplyReport. Each has
// states and faults of its own; among them are idle, absent and fault, none, and all that a link may have. Plain
// functions, any thread; never allocate or throw.
#pragma once

#include "device/motors/device_link.h"
#include "device/motors/motor_keeper.h"

namespace ghostforce {

// Of a virtual device nobody is told that it was left pushing.
template <typename DriverOptions>
MotorKeeper::Options keeper_options(const DriverOptions& options) {
  return {options.debts, options.is_virtual ? nullptr : options.when_left_pushing};
}

// As a driver calls it. A device that is not there is no fault.
template <typename Fault>
constexpr Fault fault_of_link(LinkFault fault) noexcept {
  switch (fault) {
    case LinkFault::none:
    case LinkFault::absent:
      return Fault::none;
    case LinkFault::not_allowed:
      return Fault::not_allowed;
    case LinkFault::busy:
      return Fault::busy;
    case LinkFault::unsupported:
      return Fault::unsupported;
    case LinkFault::unplugged:
      return Fault::unplugged;
    case LinkFault::broken:
      return Fault::broken;
    case LinkFault::overruled:
      return Fault::overruled;
    case LinkFault::unguarded:
      return Fault::unguarded;
  }
  return Fault::broken;
}

// It has been looked for. That it was there and has gone stays on screen until it is back.
template <typename Report>
void report_absent(Report& report) noexcept {
  using State = decltype(report.state);
  using Fault = decltype(report.fault);
  if (report.fault != Fault::none) report.fault = Fault::unplugged;
  report.state = report.fault == Fault::none ? State::absent : State::fault;
}

template <typename Report>
void report_fault(Report& report, decltype(Report::fault) fault) noexcept {
  report.state = decltype(report.state)::fault;
  report.fault = fault;
  ++report.faults;
}

// Its handle's position is known, and no force goes out yet.
template <typename Report>
void report_idle(Report& report) noexcept {
  report.state = decltype(report.state)::idle;
  report.fault = decltype(report.fault)::none;
}

}  // namespace ghostforce
