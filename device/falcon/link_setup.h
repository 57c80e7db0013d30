// What the Falcon's serial chip can be asked for, and how it is set up for a Falcon that runs its firmware, as scripts
// of the link (link_script.h): after opening it, and after the device has been silent. Immutable, any thread.
#pragma once

#include <array>

#include "device/falcon/falcon_link.h"
#include "device/falcon/link_script.h"

namespace ghostforce {

// Requests by name: see FTDI's application note on vendor requests.
namespace ftdi {

inline constexpr VendorRequest forget_received{0x00, 0x0001, 0};  // of the device's bytes, in the chip
inline constexpr VendorRequest forget_unsent{0x00, 0x0002, 0};    // of the host's
inline constexpr VendorRequest data_terminal_ready_low{0x01, 0x0100, 0};
inline constexpr VendorRequest data_terminal_ready_high{0x01, 0x0101, 0};
inline constexpr VendorRequest request_to_send_low{0x01, 0x0200, 0};
inline constexpr VendorRequest no_flow_control{0x02, 0x0000, 0};
inline constexpr VendorRequest eight_bits_no_parity_one_stop{0x04, 0x0008, 0};

// 3 MHz divided by a number in eighths.
inline constexpr VendorRequest handshake_rate{0x03, 0x4138, 0};  // 9600 baud
inline constexpr VendorRequest upload_rate{0x03, 0x0015, 0};     // 142857 baud
inline constexpr VendorRequest running_rate{0x03, 0x0002, 0};    // 1.5 Mbaud

// How long the chip holds bytes back in the hope for more [ms].
constexpr VendorRequest latency(std::uint16_t ms) noexcept {
  return {0x09, ms, 0};
}

}  // namespace ftdi

// How long replies to commands that were given up may still come.
inline constexpr int late_replies_ms = 60;

// DTR and RTS are left as they are: a device that runs may take their edge for a reset.
inline constexpr std::array set_up_link{
    ask(ftdi::running_rate),
    ask(ftdi::eight_bits_no_parity_one_stop),
    ask(ftdi::no_flow_control),
    ask(ftdi::latency(1)),
    ask(ftdi::forget_received),
    ask(ftdi::forget_unsent),
    LinkScriptStep{.kind = LinkScriptStep::Kind::flush},
};

// For a device that does not answer: the stop at once, and again as soon as it can be understood, for the chip may have
// been reset without leaving the bus and have lost the rate, and perhaps the format. What it has not sent by then may
// be a force, and takes long at a low rate.
inline constexpr std::array stop_and_set_up_link_again{
    LinkScriptStep{.kind = LinkScriptStep::Kind::stop},
    ask(ftdi::running_rate),
    ask(ftdi::forget_unsent),
    LinkScriptStep{.kind = LinkScriptStep::Kind::stop},
    ask(ftdi::eight_bits_no_parity_one_stop),
    LinkScriptStep{.kind = LinkScriptStep::Kind::stop},
    ask(ftdi::no_flow_control),
    ask(ftdi::latency(1)),
    LinkScriptStep{.kind = LinkScriptStep::Kind::wait, .duration_ms = late_replies_ms},
    ask(ftdi::forget_received),
    ask(ftdi::forget_unsent),
    LinkScriptStep{.kind = LinkScriptStep::Kind::flush},
};

}  // namespace ghostforce
