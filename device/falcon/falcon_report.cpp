#include "device/falcon/falcon_report.h"

namespace ghostforce {
namespace {

// In the order of FalconFault.
constexpr std::array faults{
    FalconFaultEntry{FalconFault::none, "none", "no fault", ""},
    FalconFaultEntry{FalconFault::not_allowed, "not_allowed", "not allowed",
                     "This user may not open the device. Run 'ghostforce doctor --install-udev' once, then plug the "
                     "device in again."},
    FalconFaultEntry{FalconFault::busy, "busy", "in use by another program",
                     "Close the other program that has the device."},
    FalconFaultEntry{FalconFault::unsupported, "unsupported", "cannot be driven",
                     "What is plugged in has not the one interface with two bulk endpoints that a Falcon has."},
    FalconFaultEntry{FalconFault::unplugged, "unplugged", "unplugged",
                     "Plug it in again: it is looked for all the time. Motors stay off until you arm them."},
    FalconFaultEntry{FalconFault::broken, "broken", "transfers fail",
                     "Use another cable or another USB port, one of the machine itself."},
    FalconFaultEntry{FalconFault::no_firmware, "no_firmware", "no firmware file",
                     "The device has no firmware and there is no file to give it: name one with --firmware FILE, or "
                     "see docs/falcon.md for where to put it."},
    FalconFaultEntry{FalconFault::no_handshake, "no_handshake", "boot loader silent",
                     "The device does not answer its boot loader's call. Unplug both its cables, wait 5 s, plug power "
                     "in first; then another USB port."},
    FalconFaultEntry{FalconFault::no_baud_answer, "no_baud_answer", "boot loader lost the rate",
                     "The device does not follow to the upload's rate. Unplug both its cables, wait 5 s, and plug them "
                     "in again."},
    FalconFaultEntry{FalconFault::echo_missing, "echo_missing", "upload broke off",
                     "A byte of the firmware was not echoed. Use another cable or USB port; if it stays, unplug both "
                     "cables for 5 s."},
    FalconFaultEntry{FalconFault::echo_differs, "echo_differs", "upload was garbled",
                     "A byte of the firmware came back as another. Use another cable or USB port, without a hub."},
    FalconFaultEntry{FalconFault::firmware_silent, "firmware_silent", "firmware does not answer",
                     "The firmware is loaded and answers nothing: is it the file for this device? Compare its SHA-256 "
                     "with docs/falcon.md."},
    FalconFaultEntry{FalconFault::no_replies, "no_replies", "stopped answering",
                     "Is the device's power supply plugged in? It is being opened again by itself."},
    FalconFaultEntry{FalconFault::kinematics, "kinematics", "impossible position",
                     "The encoders tell a position that the arms cannot have: home the device again (F2), and check "
                     "the geometry in its calibration file."},
};

struct StateNames {
  std::string_view name;
  std::string_view title;
};

// In the order of FalconState.
constexpr std::array states{
    StateNames{"absent", "Not plugged in"},
    StateNames{"opening", "Opening"},
    StateNames{"loading_firmware", "Loading firmware"},
    StateNames{"homing", "Homing"},
    StateNames{"idle", "Ready"},
    StateNames{"active", "Motors on"},
    StateNames{"fault", "Fault"},
};

}  // namespace

std::span<const FalconFaultEntry> falcon_fault_catalog() noexcept {
  return faults;
}

const FalconFaultEntry& entry_of(FalconFault fault) noexcept {
  return faults[static_cast<std::size_t>(fault)];
}

std::string_view name_of(FalconState state) noexcept {
  return states[static_cast<std::size_t>(state)].name;
}

std::string_view title_of(FalconState state) noexcept {
  return states[static_cast<std::size_t>(state)].title;
}

}  // namespace ghostforce
