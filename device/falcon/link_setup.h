// How the chip is set up for a Falcon that runs its firmware, as scripts of the link (link_script.h): after opening it,
// and after the device has been silent. Immutable, any thread.
#pragma once

#include <array>

#include "device/falcon/ftdi_requests.h"
#include "device/falcon/link_script.h"

namespace ghostforce {

// Replies to commands that were given up may still come for so long.
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
// been reset without leaving the bus and have lost the rate, and perhaps the format. What it has not sent by then may be
// a force, and takes long at a low rate.
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
