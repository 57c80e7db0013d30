#include "app/runs/live_readings.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "core/hand_measurement.h"
#include "core/settings.h"
#include "core/user_measurement.h"

namespace ghostforce {
namespace {

bool is_measured_by_tones(const std::optional<RunRow>& row) noexcept {
  return row && row->tone != Vector<2>(0.0);
}

// Which device the tones shake: the real one, or else the one whose row has them. That need not be the active one of the
// settings: a run that was made elsewhere may not tell which that is.
StrategyId shaken_device(const RunTick& tick, StrategyId otherwise) noexcept {
  if (tick.measured) return *tick.measured;
  const auto row = std::ranges::find_if(tick.rows, is_measured_by_tones);
  return row != tick.rows.end() ? strategy_catalog()[static_cast<std::size_t>(row - tick.rows.begin())].id : otherwise;
}

// Newtons at the handle of a real device per newton in the scene, where its way is shown enlarged: the share of the
// model's force that was sent beside the tones. The median, because force that leads over from one strategy to another
// has another share for a moment.
double force_at_handle(const Run& run) {
  std::vector<double> shares;
  for (const RunTick& tick : run.ticks) {
    if (!tick.measured) continue;
    const std::optional<RunRow>& row = tick.rows[index_of(*tick.measured)];
    if (!is_measured_by_tones(row) || !row->sent) continue;
    const double share = glm::dot(*row->sent - row->tone, row->force) / glm::dot(row->force, row->force);
    if (share > 0.0 && std::isfinite(share)) shares.push_back(share);
  }
  return shares.empty() ? 1.0 : spread_of(shares).median;
}

class LiveReader {
 public:
  explicit LiveReader(const Run& run) : run_(run), at_handle_(force_at_handle(run)) {}

  std::vector<LiveReading> read() {
    for (const RunTick& tick : run_.ticks) take(tick);
    if (readings_.empty()) readings_.push_back({run_.ticks.back().time_s, estimator_.estimate()});
    return std::move(readings_);
  }

 private:
  void take(const RunTick& tick) {
    const Settings& settings = run_.settings[tick.settings];
    if (std::exchange(settings_, &settings) != &settings) {
      axis_ = direction_at(settings.actuated_angle);
      wall_ = wall_of(settings);
    }
    const bool is_other_rate = std::exchange(rate_, settings.rate) != settings.rate;
    device_ = shaken_device(tick, is_other_rate ? settings.active : device_);
    const HandSource source{settings.actuated_angle, tick.measured ? std::nullopt : std::optional(device_)};
    const bool is_other_source = std::exchange(source_, source) != source;
    const bool begins = is_other_rate || tick.state != RunTick::none;
    if (begins) begin_ = tick.tick;
    // A real hand goes on while the loop does not.
    const bool is_late = tick.measured && tick.loop_s * rate_ > longest_gap_periods;
    const bool is_next = std::exchange(tick_, tick.tick) + 1 == tick.tick && !is_late;
    if (is_other_rate) {
      estimator_ = HandEstimator(rate_);
    } else if (begins || is_other_source) {
      estimator_.reset();
    } else if (!is_next) {
      estimator_.reset(HandUnknown::damaged);
    }
    if (const auto sample = sample_of(tick, settings)) {
      estimator_.add(*sample);
    } else {
      estimator_.reset(HandUnknown::damaged);
    }
    const std::int64_t ticks_per_reading = std::max<std::int64_t>(1, std::llround(HandEstimator::period_s * rate_));
    const bool can_have_window = time_of(tick.tick - begin_, rate_) >= HandEstimator::usual_window_s;
    if (can_have_window && tick.tick % ticks_per_reading == 0) {
      readings_.push_back({tick.time_s, estimator_.estimate()});
    }
  }

  // Empty: the file does not tell it.
  std::optional<HandSample> sample_of(const RunTick& tick, const Settings& settings) const {
    const std::optional<RunRow>& row = tick.rows[index_of(device_)];
    if (!row || (tick.measured && !row->sent)) return std::nullopt;
    const Vector<2> force = tick.measured ? *row->sent / at_handle_ : row->force + row->tone;
    const Vector<2> place = tick.measured ? row->device : measured_position(settings, row->device);
    return HandSample{.position = glm::dot(axis_, place),
                      .force = glm::dot(axis_, force),
                      .tone = glm::dot(axis_, row->tone),
                      .in_contact = depth(wall_, row->device) > 0.0,
                      .is_at_limit = row->is_saturated};
  }

  const Run& run_;
  double at_handle_;
  const Settings* settings_ = nullptr;  // of the newest tick; null: no tick yet
  Vector<2> axis_{0.0};                 // and what takes a sine and a cosine of them
  Wall<2> wall_{};
  double rate_ = 0.0;
  StrategyId device_ = StrategyId::anisotropic;
  HandSource source_;
  std::int64_t begin_ = 0;  // k where the run began, or was reset last
  HandEstimator estimator_{HandEstimator::least_rate};
  std::int64_t tick_ = 0;
  std::vector<LiveReading> readings_;
};

}  // namespace

bool has_tones(const Run& run) noexcept {
  return std::ranges::any_of(run.ticks,
                             [](const RunTick& tick) { return std::ranges::any_of(tick.rows, is_measured_by_tones); });
}

std::vector<LiveReading> live_readings(const Run& run) {
  if (run.ticks.empty()) return {};
  if (!has_tones(run)) return {{run.ticks.back().time_s, {.why = HandUnknown::no_tones}}};
  return LiveReader(run).read();
}

}  // namespace ghostforce
