#include "app/doctor/examination.h"

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

bool has_been_moved(const FalconReport& report) noexcept {
  return report.is_readable() && report.encoders_move();
}

class Examination {
 public:
  Examination(FalconInput& falcon, const std::function<void(const FalconReport&)>& watch)
      : falcon_(falcon), watch_(watch) {}

  // Until the device is lost, `is_enough` says so, or the time is over.
  template <typename IsEnough>
  void go_on(double longest_s, IsEnough is_enough) {
    const std::int64_t began_ns = falcon_.now_ns();
    const auto elapsed_s = [&] { return static_cast<double>(falcon_.now_ns() - began_ns) * 1e-9; };
    do {
      falcon_.wait_until(falcon_.now_ns() + tick_ns);
      falcon_.read();
      falcon_.set_force(Vector<2>(0.0), false);
      report_ = falcon_.report();
      watch_(report_);
    } while (!has_ended(report_) && !is_enough(report_) && elapsed_s() < longest_s);
  }

  const FalconReport& report() const noexcept { return report_; }

 private:
  FalconInput& falcon_;
  const std::function<void(const FalconReport&)>& watch_;
  FalconReport report_;
};

}  // namespace

FalconReport examine(FalconInput& falcon, double wait_s, const std::function<void(const FalconReport&)>& watch) {
  // The driver itself gives up, after its attempts.
  constexpr double for_ever_s = 1e9;
  Examination examination(falcon, watch);
  examination.go_on(for_ever_s, [](const FalconReport& report) {
    return report.state == FalconState::homing || report.is_readable();
  });
  if (!has_ended(examination.report())) {
    examination.go_on(std::max(wait_s, first_replies_s), [&](const FalconReport& report) {
      return wait_s > 0.0 ? has_been_moved(report) : report.is_readable();
    });
  }
  if (!has_ended(examination.report())) {
    examination.go_on(measuring_s, [](const FalconReport&) { return false; });
  }
  falcon.shut_down();
  return examination.report();
}

}  // namespace ghostforce
