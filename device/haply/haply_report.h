// HaplyReport: what the driver knows of its board, for the screen and for `doctor`. Trivially copyable: it crosses threads
// whole. SI units, in the device's frame (haply_kinematics.h).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>

#include "core/conventions.h"
#include "device/motors/device_serial.h"

namespace ghostforce {

enum class HaplyState : std::uint8_t {
  absent,
  opening,    // taken, and asked whether it speaks hAPI
  zero_pose,  // answers; waits for a person to hold the zero pose and say so
  idle,       // may be read
  active,     // may push
  fault,      // tried again by itself, after a pause
};

// Why a board cannot be used now.
enum class HaplyFault : std::uint8_t {
  none,
  not_allowed,
  busy,
  unsupported,  // what is named as the port is none
  unplugged,
  broken,      // bytes are lost on the way out
  no_board,    // something is there, and it does not speak hAPI
  no_replies,  // exchanges were answered, and are no more
  restarted,   // the board has forgotten how it was set up
  lost_count,  // an encoder does not tell where its arm is
  kinematics,  // the angles belong to no place of the handle
  overruled,   // the guard has stopped the motors in place of this program
  unguarded,   // the guard is gone
  stop_owed,   // another board, which may still push, is plugged in again and comes first
};

struct HaplyFaultEntry {
  HaplyFault id;
  std::string_view name;   // in JSON
  std::string_view title;  // on screen
};

std::span<const HaplyFaultEntry> haply_fault_catalog() noexcept;
const HaplyFaultEntry& entry_of(HaplyFault fault) noexcept;

std::string_view name_of(HaplyState state) noexcept;  // in JSON

// What became of a person's word that the arms are in the zero pose.
enum class ZeroPose : std::uint8_t {
  not_confirmed,
  moving,   // they were not still: it does not count
  setting,  // the board is being told
  refused,  // the board tells other angles afterwards
  confirmed,
};

struct HaplyReport {
  // Fewer exchanges than these make a wall that jerks in the hand [1/s].
  static constexpr double fast_enough_hz = 500.0;

  HaplyState state = HaplyState::absent;
  HaplyFault fault = HaplyFault::none;  // the newest, until the board is well again
  bool has_looked = false;              // once at least
  bool is_virtual = false;
  bool is_guarded = true;       // somebody stops the motors if this program cannot (DeviceLink::is_guarded)
  bool may_still_push = false;  // a board was told to stop, and has not answered since
  DeviceSerial serial;          // of the board that is open or was
  DeviceSerial owed_serial;     // of the one that may still push
  std::string_view variant;     // of the catalog, whose text it is
  bool was_set_up = false;      // it answered to this program's address when it was found

  ZeroPose zero_pose = ZeroPose::not_confirmed;
  std::array<double, 2> angles{};   // of the arms [rad]; before the zero pose is confirmed they mean nothing
  std::array<bool, 2> has_moved{};  // the encoder, since then
  Vector<2> position{0.0};          // of the handle; good in idle and active
  std::array<double, 2> torques{};  // sent last, of the arms [N·m]
  bool is_saturated = false;        // a motor cannot give what was asked for: both torques are less, in proportion
  double workspace_share = 1.0;     // of a force that the pose leaves: less near singular poses, 0 at them [1]

  bool is_lagging = false;            // its last replies came so late that a wall would shake the hand
  double exchange_hz = 0.0;           // over the last half second
  double exchange_s = 0.0;            // from command to reply, on average over it
  double worst_exchange_s = 0.0;      // in it
  std::uint64_t exchanges = 0;        // since the port was opened
  std::uint64_t lost_exchanges = 0;   // commands that were sent again for want of a reply
  std::uint64_t discarded_bytes = 0;  // that belonged to no reply
  std::uint64_t faults = 0;           // since the program began

  bool encoders_move() const noexcept { return has_moved[0] && has_moved[1]; }
  bool is_readable() const noexcept { return state == HaplyState::idle || state == HaplyState::active; }
  bool is_fast_enough() const noexcept { return exchange_hz >= fast_enough_hz; }
};
static_assert(std::is_trivially_copyable_v<HaplyReport>);

}  // namespace ghostforce
