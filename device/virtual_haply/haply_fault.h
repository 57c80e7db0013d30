// InjectedHaplyFault: what the simulated board, its cable, its arms and its person are asked to do wrong, and the
// catalog of the faults that one may ask for by name, alone or together. Each is what such a board could do to a
// driver. A trivially copyable value: it may change while the board runs. A new fault is a member here, one row in
// haply_fault.cpp, and the place in the bench that obeys it. Immutable after start, any thread.
//
// What happens once does so when the fault is asked for anew, or to the next packet or reply after that.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "device/motors/device_link.h"

namespace ghostforce {

enum class HaplyReplyFault : std::uint8_t {
  none,
  lost,
  shortened,     // its last three bytes are missing
  crossed,       // well-formed; the angles are those of arms that have passed through each other
  not_a_number,  // well-formed; its last angle is none
};

enum class BoardProgram : std::uint8_t {
  hapi,
  silent,  // takes all and says nothing
  chatty,  // another one, which sends lines of text by itself
};

// As it is made: none.
struct InjectedHaplyFault {
  // The link: not_allowed and busy keep it from opening; absent and unplugged do too, and end one that is open. Off the
  // cable the motors keep what they have: they have a supply of their own.
  LinkFault link = LinkFault::none;
  bool is_off_the_cable() const noexcept { return link == LinkFault::absent || link == LinkFault::unplugged; }

  bool touched_at_1200_baud = false;  // vanishes when the port is closed next
  bool dtr_is_low = false;            // to the board nobody listens: it obeys and sends nothing
  bool tears_packet = false;          // once: the second piece comes a millisecond after the first byte
  bool garbage = false;               // to the board after each tenth packet, to the host before each tenth reply

  std::int64_t reply_delay_ns = 0;
  std::int64_t reply_creep_ns = 0;  // added to the delay of each further reply
  bool duplicated_replies = false;
  HaplyReplyFault reply = HaplyReplyFault::none;
  unsigned reply_interval = 1;  // 1: every reply has this fault; n: every n-th
  int faulty_replies = 0;       // how many replies have it; 0: all

  BoardProgram program = BoardProgram::hapi;
  bool refuses_set_ups = false;
  bool is_another_programs = false;  // once: set up for another address, with a force
  bool restarts = false;             // once
  bool spoils_torque = false;        // once: the next positive torque comes out negative

  // Power of motors and encoders; the board's own comes through the cable.
  bool power_lost = false;

  // By arm.
  std::uint8_t reversed_motors = 0;  // bit 0: that of arm 1
  std::uint8_t frozen_encoders = 0;
  double encoder_share = 1.0;            // of the edges that there are, how many are made
  double encoder_jump_degrees = 0.0;     // once, of arm 1, as soon as a motor pushes
  double zero_pose_error_degrees = 0.0;  // by which the person holds each arm too far outwards

  friend bool operator==(const InjectedHaplyFault&, const InjectedHaplyFault&) = default;
};

struct InjectedHaplyFaultKind {
  std::string_view name;      // on the command line
  std::string_view sentence;  // what it does, for a person
  void (*add)(InjectedHaplyFault&) noexcept;
};

std::span<const InjectedHaplyFaultKind> injected_haply_fault_catalog() noexcept;

// Null when no fault has that name.
const InjectedHaplyFaultKind* find_injected_haply_fault(std::string_view name) noexcept;

}  // namespace ghostforce
