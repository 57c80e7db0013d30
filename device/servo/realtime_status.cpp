#include "device/servo/realtime_status.h"

#include <system_error>

namespace ghostforce {

std::string refused_words(const RealtimeStatus& status) {
  if (status.priority_error != 0) return "no real-time priority";
  return status.memory_lock_error == 0 ? "" : "memory not locked";
}

std::string describe(const RealtimeStatus& status) {
  const auto why = [](int error) {
    return error == 0 ? std::string() : " (" + std::generic_category().message(error) + ")";
  };
  return (status.priority_error == 0 ? "real-time priority" : "no real-time priority") + why(status.priority_error) +
         (status.has_short_slice ? ", short time slices" : "") +
         (status.memory_lock_error == 0 ? ", memory locked" : ", memory not locked") + why(status.memory_lock_error);
}

}  // namespace ghostforce
