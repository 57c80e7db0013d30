// ExchangeWindow: how many exchanges a device makes in a second, and how long they take, over half a second after another.
// A plain value; never allocates or throws; any one thread. s; times in ns on one clock.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

namespace ghostforce {

class ExchangeWindow {
 public:
  static constexpr double duration_s = 0.5;

  // Of one that is over.
  struct Measured {
    double exchange_hz;
    double exchange_s;  // on average; 0 without any
    double worst_exchange_s;
  };

  void begin(std::int64_t now_ns) noexcept {
    *this = {};
    began_ns_ = now_ns;
  }

  // It took so long.
  void add(double exchange_s) noexcept {
    ++exchanges_;
    sum_s_ += exchange_s;
    add_lost(exchange_s);
  }
  // It was waited for so long, and given up.
  void add_lost(double waited_s) noexcept { worst_s_ = std::max(worst_s_, waited_s); }

  // What a driver's report says of the window that was. Whether it is over; then the next one begins.
  template <typename Report>
  bool tell(Report& report, std::int64_t now_ns) noexcept {
    const auto measured = next(now_ns);
    if (!measured) return false;
    report.exchange_hz = measured->exchange_hz;
    report.exchange_s = measured->exchange_s;
    report.worst_exchange_s = measured->worst_exchange_s;
    return true;
  }

  // Where it is over, the next one begins.
  std::optional<Measured> next(std::int64_t now_ns) noexcept {
    const double window_s = static_cast<double>(now_ns - began_ns_) * 1e-9;
    if (window_s < duration_s) return std::nullopt;
    const Measured measured{exchanges_ / window_s, exchanges_ > 0 ? sum_s_ / exchanges_ : 0.0, worst_s_};
    begin(now_ns);
    return measured;
  }

 private:
  std::int64_t began_ns_ = 0;
  int exchanges_ = 0;
  double sum_s_ = 0.0;
  double worst_s_ = 0.0;
};

}  // namespace ghostforce
