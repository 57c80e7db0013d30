// FalconReport: what the driver knows of its device, for the screen and for `doctor`. Trivially copyable: it crosses
// threads whole.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>

#include "core/conventions.h"
#include "device/falcon/calibration.h"

namespace ghostforce {

enum class FalconState : std::uint8_t {
  absent,
  opening,  // taken, and asked whether it has firmware
  loading_firmware,
  homing,  // the person moves the handle until all three motors have found their zero
  idle,    // may be read
  active,  // may push
  fault,   // tried again by itself, after a pause
};

// Why a Falcon cannot be used now.
enum class FalconFault : std::uint8_t {
  none,
  not_allowed,
  busy,
  unsupported,
  unplugged,
  broken,        // transfers fail
  no_firmware,   // it has none, and there is no file to give it
  no_handshake,  // see BootFault
  no_baud_answer,
  echo_missing,
  echo_differs,
  firmware_silent,  // loaded, and no frame is answered
  no_replies,       // frames were answered, and are no more
  kinematics,       // the encoders' numbers belong to no position of the handle
  overruled,        // the guard has stopped the motors in place of this program
  unguarded,        // the guard is gone
  stop_owed,        // another one, which may still push, is plugged in again and comes first
};

struct FalconFaultEntry {
  FalconFault id;
  std::string_view name;   // in JSON
  std::string_view title;  // on screen
};

std::span<const FalconFaultEntry> falcon_fault_catalog() noexcept;
const FalconFaultEntry& entry_of(FalconFault fault) noexcept;

std::string_view name_of(FalconState state) noexcept;  // in JSON

struct FalconReport {
  // Fewer exchanges than these make a wall that jerks in the hand [1/s].
  static constexpr double fast_enough_hz = 500.0;

  FalconState state = FalconState::absent;
  FalconFault fault = FalconFault::none;  // in the state fault; else the one before, while it is tried again
  DeviceSerial serial;
  bool is_virtual = false;
  bool has_looked = false;  // for a device, once at least
  bool is_guarded = false;  // somebody stops the motors when this program cannot
  // A device, this one or another, was told to stop and has not answered since: until it does, only its power plug
  // helps for certain.
  bool may_still_push = false;
  DeviceSerial owed_serial;  // of one of them

  bool has_firmware_file = false;
  bool has_firmware = false;  // the device answers frames
  int attempt = 0;            // to load it, from 1
  int attempts = 0;           // at most
  std::uint32_t bytes_echoed = 0;
  std::uint32_t firmware_size = 0;

  std::array<std::int16_t, 3> encoders{};  // [counts]
  std::array<bool, 3> has_homed{};
  std::array<bool, 3> has_moved{};       // the encoder, since homing
  std::uint8_t buttons = 0;              // bits of ReplyFrame
  Vector<3> position{0.0};               // of the handle in the device's frame [m]; good in idle and active
  std::array<std::int16_t, 3> motors{};  // sent last [counts]

  double exchange_hz = 0.0;           // over the last half second
  double exchange_s = 0.0;            // from command to reply, on average over it
  double worst_exchange_s = 0.0;      // in it
  std::uint64_t exchanges = 0;        // since it was opened
  std::uint64_t lost_exchanges = 0;   // commands that were sent again for want of a reply
  std::uint64_t discarded_bytes = 0;  // that belonged to no frame
  std::uint64_t line_errors = 0;      // see LinkCounters
  std::uint64_t faults = 0;           // since the program began

  bool is_homed() const noexcept { return has_homed[0] && has_homed[1] && has_homed[2]; }
  bool encoders_move() const noexcept { return has_moved[0] && has_moved[1] && has_moved[2]; }
  bool is_readable() const noexcept { return state == FalconState::idle || state == FalconState::active; }
  bool is_fast_enough() const noexcept { return exchange_hz >= fast_enough_hz; }
};
static_assert(std::is_trivially_copyable_v<FalconReport>);

}  // namespace ghostforce
