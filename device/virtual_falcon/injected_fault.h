// InjectedFault: what the virtual Falcon is asked to do wrong, and the catalog of the faults that a person may ask for
// by name, alone or together. Each has been seen on real devices, or would be the worst place for a driver to stumble.
// A trivially copyable value: it may change while the device runs. A new fault is a member here, one row in
// injected_fault.cpp, and the place in the device that obeys it. Immutable after start, any thread.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "device/falcon/falcon_link.h"

namespace ghostforce {

enum class EchoFault : std::uint8_t {
  none,
  corrupted_once,    // since the fault was asked for: the next upload is well again
  corrupted_always,  // in each upload
  lost_once,
};

enum class ReplyFault : std::uint8_t {
  none,
  lost,
  malformed,   // one of its bytes can be in no frame
  wrong,       // well-formed; one arm is said to be elsewhere
  impossible,  // well-formed; the arms are said to be where no arms can be
};

// As it is made: none.
struct InjectedFault {
  // The link: not_allowed and busy keep it from opening; absent and unplugged do too, and end one that is open. Off the
  // cable only the USB chip is without power; the processor and the motors have a supply of their own.
  LinkFault link = LinkFault::none;
  bool is_off_the_cable() const noexcept { return link == LinkFault::absent || link == LinkFault::unplugged; }

  // Hand-shake and upload.
  int lost_replies = 0;     // answers of the hand-shake that never come, counted since the fault was asked for
  bool leading_00 = false;  // before each answer of the hand-shake
  bool leading_13 = false;  // before the 'A' that answers the 'A' of the host
  bool without_cts = false;
  EchoFault echo = EchoFault::none;
  int echo_byte = 44;    // of the upload, from 0: whose echo is wrong
  int upload_stops = 0;  // after so many bytes of the upload nothing is heard of the device; 0: it does not

  // The cable.
  bool split_packets = false;   // few bytes in each
  bool joined_packets = false;  // held back until several answers fill one
  bool chip_resets = false;     // once, when the fault is asked for: the USB chip is as it is when it gets power

  // The firmware.
  unsigned short_frames = 0;  // each so many-th frame lacks two bytes; 0: none
  bool garbage = false;       // between frames
  bool silence = false;       // takes everything and answers nothing
  bool frozen_encoders = false;
  bool motors_are_reversed = false;  // all three push the other way
  bool never_homes = false;
  bool forgets_home = false;  // once, when the fault is asked for
  std::int64_t reply_delay_ns = 0;
  std::int64_t reply_creep_ns = 0;  // added to the delay of each further answer
  bool duplicated_replies = false;
  int noise_bytes = 0;  // that come before one answer, once
  ReplyFault reply = ReplyFault::none;
  unsigned reply_interval = 1;  // 1: every answer has this fault; n: every n-th
  int faulty_replies = 0;       // how many answers have it; 0: all

  // No power in the device behind the USB chip: silence, and what was loaded and homed is forgotten.
  bool power_lost = false;
  bool power_blinks = false;  // once, when the fault is asked for: forgets as well, and is there again

  friend bool operator==(const InjectedFault&, const InjectedFault&) = default;
};

struct InjectedFaultKind {
  std::string_view name;      // on the command line
  std::string_view sentence;  // what it does, for a person
  void (*add)(InjectedFault&) noexcept;
};

std::span<const InjectedFaultKind> injected_fault_catalog() noexcept;

// Null when no fault has that name.
const InjectedFaultKind* find_injected_fault(std::string_view name) noexcept;

}  // namespace ghostforce
