#include "device/motors/device_link.h"
#include "device/motors/emergency_stop.h"

// One thread, which no signal interrupts.
namespace ghostforce::emergency_stop {
namespace {

DeviceLink* watched = nullptr;
bool has_been_ordered = false;

}  // namespace

void watch(DeviceLink* link) noexcept {
  watched = link;
}

void stop_motors() noexcept {
  if (has_been_ordered) return;
  has_been_ordered = true;
  if (watched != nullptr) watched->stop_at_once();
}

bool is_ordered() noexcept {
  return has_been_ordered;
}

}  // namespace ghostforce::emergency_stop
