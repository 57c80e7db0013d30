#include "app/tools/doctor/examination.h"

#include <algorithm>
#include <cstdint>

namespace ghostforce {
namespace {

// As the servo's: what is measured here is what the window will have.
constexpr std::int64_t tick_ns = 1'000'000;

// A device that was homed before tells it with its first replies [s].
constexpr double first_replies_s = 0.1;

// The driver measures over half a second; in a whole one there is one that had nothing else in it [s].
constexpr double measuring_s = 1.1;

bool has_ended(const FalconReport& report) noexcept {
  if (!report.has_looked) return false;
  return report.state == FalconState::absent || report.state == FalconState::fault;
}

}  // namespace

FalconReport examine(FalconInput& falcon, double wait_s, const std::function<void(const FalconReport&)>& watch) {
  // The driver itself gives up, after its attempts.
  constexpr double for_ever_s = 1e9;
  FalconReport report;
  // Until the device is lost, `is_enough` says so, or the time is over.
  const auto go_on = [&](double longest_s, const auto& is_enough) {
    if (has_ended(report)) return;
    const std::int64_t began_ns = falcon.now_ns();
    const auto elapsed_s = [&] { return static_cast<double>(falcon.now_ns() - began_ns) * 1e-9; };
    do {
      falcon.wait_until(falcon.now_ns() + tick_ns);
      falcon.read();
      falcon.set_force(Vector<2>(0.0), false);
      report = falcon.report();
      watch(report);
    } while (!has_ended(report) && !is_enough() && elapsed_s() < longest_s);
  };
  go_on(for_ever_s, [&] { return report.state == FalconState::homing || report.is_readable(); });
  go_on(std::max(wait_s, first_replies_s),
        [&] { return report.is_readable() && (report.encoders_move() || !(wait_s > 0.0)); });
  go_on(measuring_s, [] { return false; });
  falcon.shut_down();
  return report;
}

}  // namespace ghostforce
