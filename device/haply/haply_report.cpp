#include "device/haply/haply_report.h"

#include <cstddef>

namespace ghostforce {
namespace {

// In the order of HaplyFault.
constexpr std::array faults{
    HaplyFaultEntry{HaplyFault::none, "none", "No fault"},
    HaplyFaultEntry{HaplyFault::not_allowed, "not_allowed", "Not allowed"},
    HaplyFaultEntry{HaplyFault::busy, "busy", "In use by another program"},
    HaplyFaultEntry{HaplyFault::unsupported, "unsupported", "No serial port"},
    HaplyFaultEntry{HaplyFault::unplugged, "unplugged", "Unplugged"},
    HaplyFaultEntry{HaplyFault::broken, "broken", "Cannot be written to"},
    HaplyFaultEntry{HaplyFault::no_board, "no_board", "Not a hAPI board"},
    HaplyFaultEntry{HaplyFault::no_replies, "no_replies", "No answer"},
    HaplyFaultEntry{HaplyFault::restarted, "restarted", "Board restarted"},
    HaplyFaultEntry{HaplyFault::lost_count, "lost_count", "Encoder lost its count"},
    HaplyFaultEntry{HaplyFault::kinematics, "kinematics", "Impossible position"},
    HaplyFaultEntry{HaplyFault::overruled, "overruled", "Stopped by the guard"},
    HaplyFaultEntry{HaplyFault::unguarded, "unguarded", "Guard lost"},
    HaplyFaultEntry{HaplyFault::stop_owed, "stop_owed", "Another board comes first"},
};
static_assert(faults.size() == static_cast<std::size_t>(HaplyFault::stop_owed) + 1);

// In the order of HaplyState.
constexpr std::array<std::string_view, 6> state_names{"absent", "opening", "zero_pose", "idle", "active", "fault"};

}  // namespace

std::span<const HaplyFaultEntry> haply_fault_catalog() noexcept {
  return faults;
}

const HaplyFaultEntry& entry_of(HaplyFault fault) noexcept {
  return faults[static_cast<std::size_t>(fault)];
}

std::string_view name_of(HaplyState state) noexcept {
  return state_names[static_cast<std::size_t>(state)];
}

}  // namespace ghostforce
