// What the Falcon's serial chip can be asked for, by name: see FTDI's application note on vendor requests.
#pragma once

#include "device/falcon/falcon_link.h"

namespace ghostforce::ftdi {

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

}  // namespace ghostforce::ftdi
