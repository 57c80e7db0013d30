#include "app/state/device_status.h"

#include <fmt/format.h>

namespace ghostforce {

std::string why_no_readiness(const LoopReading& loop) {
  if (loop.motors.has_motors) {
    return fmt::format(
        "{} gets ready by itself within some seconds. Then keep its handle outside the wall to arm the motors. The "
        "desktop program shows each step.",
        loop.device);
  }
  if (!loop.why_no_falcon.empty()) return fmt::format("This input has no motors. {}", loop.why_no_falcon);
  return "This input has no motors. In the panel “Input”, choose Falcon, or Virtual Falcon to rehearse without one. "
         "'ghostforce doctor' examines a device from the command line.";
}

}  // namespace ghostforce
