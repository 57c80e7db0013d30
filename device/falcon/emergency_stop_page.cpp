#include "device/falcon/emergency_stop.h"
#include "device/falcon/falcon_link.h"
#include "device/falcon/frame.h"

// One thread, which no signal interrupts.
namespace ghostforce::emergency_stop {
namespace {

FalconLink* watched = nullptr;
bool has_been_ordered = false;

}  // namespace

void watch(FalconLink* link) noexcept {
  watched = link;
}

void stop_motors() noexcept {
  if (has_been_ordered) return;
  has_been_ordered = true;
  if (watched != nullptr) watched->send_at_once(encode(CommandFrame{}));
}

bool is_ordered() noexcept {
  return has_been_ordered;
}

}  // namespace ghostforce::emergency_stop
