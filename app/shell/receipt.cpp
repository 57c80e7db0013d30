#include "app/shell/receipt.h"

#include <algorithm>
#include <utility>

namespace ghostforce {

void SessionLog::note(const ServoReport& report, std::string_view device_fault) {
  const double now_s = report.snapshot.time_s;
  const MotorReport& motors = report.motors;
  if (std::exchange(reason_, motors.reason) != motors.reason && motors.reason != OffReason::none) {
    motors_off_.push_back({now_s, entry_of(motors.reason).name});
  }
  if (std::exchange(fault_, device_fault) != device_fault && !device_fault.empty()) {
    device_faults_.push_back({now_s, device_fault});
  }
  if (report.hand.estimate.is_known()) hand_ = Hand{report.hand.estimate, report.hand.at_s};
  std::ranges::transform(greatest_heat_, motors.heat, greatest_heat_.begin(),
                         [](double before, double now) { return std::max(before, now); });
}

}  // namespace ghostforce
