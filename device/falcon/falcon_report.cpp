#include "device/falcon/falcon_report.h"

namespace ghostforce {
namespace {

// In the order of FalconFault.
constexpr std::array faults{
    FalconFaultEntry{FalconFault::none, "none", "no fault"},
    FalconFaultEntry{FalconFault::not_allowed, "not_allowed", "not allowed"},
    FalconFaultEntry{FalconFault::busy, "busy", "in use by another program"},
    FalconFaultEntry{FalconFault::unsupported, "unsupported", "cannot be driven"},
    FalconFaultEntry{FalconFault::unplugged, "unplugged", "unplugged"},
    FalconFaultEntry{FalconFault::broken, "broken", "transfers fail"},
    FalconFaultEntry{FalconFault::no_firmware, "no_firmware", "no firmware file"},
    FalconFaultEntry{FalconFault::no_handshake, "no_handshake", "boot loader silent"},
    FalconFaultEntry{FalconFault::no_baud_answer, "no_baud_answer", "boot loader lost the rate"},
    FalconFaultEntry{FalconFault::echo_missing, "echo_missing", "upload broke off"},
    FalconFaultEntry{FalconFault::echo_differs, "echo_differs", "upload was garbled"},
    FalconFaultEntry{FalconFault::firmware_silent, "firmware_silent", "firmware does not answer"},
    FalconFaultEntry{FalconFault::no_replies, "no_replies", "stopped answering"},
    FalconFaultEntry{FalconFault::kinematics, "kinematics", "impossible position"},
    FalconFaultEntry{FalconFault::overruled, "overruled", "turned off by the guard"},
    FalconFaultEntry{FalconFault::unguarded, "unguarded", "guard gone"},
    FalconFaultEntry{FalconFault::stop_owed, "stop_owed", "another Falcon comes first"},
};

// In the order of FalconState.
constexpr std::array<std::string_view, 7> states{"absent", "opening", "loading_firmware", "homing", "idle",
                                                 "active", "fault"};

}  // namespace

std::span<const FalconFaultEntry> falcon_fault_catalog() noexcept {
  return faults;
}

const FalconFaultEntry& entry_of(FalconFault fault) noexcept {
  return faults[static_cast<std::size_t>(fault)];
}

std::string_view name_of(FalconState state) noexcept {
  return states[static_cast<std::size_t>(state)];
}

}  // namespace ghostforce
