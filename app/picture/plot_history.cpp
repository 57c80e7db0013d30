#include "app/picture/plot_history.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <ranges>

namespace ghostforce {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

PlotBucket bucket_of(const Snapshot& snapshot) {
  PlotBucket bucket{snapshot.time_s, snapshot.time_s, {}, {}};
  for (std::size_t q = 0; q < quantity_count; ++q) {
    for (std::size_t i = 0; i < strategy_count; ++i) {
      const Quantity& quantity = quantity_catalog()[q];
      const bool has_value = is_known(quantity, snapshot, strategy_catalog()[i].id);
      bucket.least[q][i] = has_value ? quantity.value(snapshot.strategies[i]) : unknown;
    }
  }
  bucket.greatest = bucket.least;
  return bucket;
}

void merge(const PlotBucket& later, PlotBucket& into) {
  into.to_s = later.to_s;
  for (std::size_t q = 0; q < quantity_count; ++q) {
    for (std::size_t i = 0; i < strategy_count; ++i) {
      // As std::fmin and std::fmax, which pass over what is unknown, but without calls.
      double& least = into.least[q][i];
      double& greatest = into.greatest[q][i];
      if (later.least[q][i] < least || std::isnan(least)) least = later.least[q][i];
      if (later.greatest[q][i] > greatest || std::isnan(greatest)) greatest = later.greatest[q][i];
    }
  }
}

// The first bucket of a level that is not behind.
template <typename Level, typename IsBehind>
std::size_t first_ahead(const Level& level, IsBehind&& is_behind) {
  return *std::ranges::partition_point(std::views::iota(std::size_t{0}, level.size()),
                                       [&](std::size_t i) { return is_behind(level.at(i)); });
}

}  // namespace

void PlotHistory::add(const Snapshot& snapshot) {
  // The tick that a run goes on from comes twice; with another rate it may lie a little before the newest.
  if (snapshot.time_s <= newest_s_) return;
  const PlotBucket tick = bucket_of(snapshot);
  std::size_t ticks = 1;
  for (Level& level : levels_) {
    if (level.filled == 0) {
      level.filling = tick;
    } else {
      merge(tick, level.filling);
    }
    if (++level.filled == ticks) {
      level.filled = 0;
      if (level.ring.size() < capacity / ticks) {
        level.ring.push_back(level.filling);
      } else {
        level.ring[level.oldest] = level.filling;
        level.oldest = (level.oldest + 1) % level.ring.size();
      }
    }
    ticks *= merged;
  }
  newest_s_ = snapshot.time_s;
  oldest_s_ = levels_.front().at(0).from_s;
}

void PlotHistory::clear() {
  *this = {};
}

std::vector<PlotBucket> PlotHistory::between(double from_s, double to_s, std::size_t most) const {
  struct Range {
    const Level* level;
    std::size_t begin, end;
  };
  Range range{};
  for (const Level& level : levels_) {
    range = {&level, first_ahead(level, [&](const PlotBucket& bucket) { return bucket.to_s < from_s; }),
             first_ahead(level, [&](const PlotBucket& bucket) { return bucket.from_s <= to_s; })};
    range.end = std::max(range.begin, range.end);
    if (range.end - range.begin <= most) break;
  }
  std::vector<PlotBucket> buckets;
  if (is_empty()) return buckets;
  buckets.reserve(range.end - range.begin);
  for (std::size_t i = range.begin; i < range.end; ++i) buckets.push_back(range.level->at(i));
  return buckets;
}

const PlotBucket* PlotHistory::at(double time_s) const {
  if (time_s > newest_s_) return nullptr;
  const Level& ticks = levels_.front();
  const std::size_t later = first_ahead(ticks, [&](const PlotBucket& tick) { return tick.from_s <= time_s; });
  return later == 0 ? nullptr : &ticks.at(later - 1);
}

namespace {

// A given stiffness may change in each tick, and shows as well every interval_s.
bool is_same(const HandPoint& a, const HandPoint& b) {
  return a.estimate == b.estimate && a.believed_k_u == b.believed_k_u &&
         a.given_k_u.has_value() == b.given_k_u.has_value();
}

}  // namespace

void HandHistory::add(const HandPoint& point) {
  if (!points_.empty()) {
    const HandPoint& last = points_.back();
    if (point.time_s <= last.time_s) return;  // the tick that a run goes on from comes twice
    if (point.time_s - last.time_s < interval_s && is_same(last, point)) return;
  }
  points_.push_back(point);
  while (points_.size() > most_points || point.time_s - points_.front().time_s > span_s) points_.pop_front();
}

std::vector<HandPoint> HandHistory::between(double from_s, double to_s) const {
  auto begin = std::ranges::lower_bound(points_, from_s, {}, &HandPoint::time_s);
  auto end = std::ranges::upper_bound(points_, to_s, {}, &HandPoint::time_s);
  if (begin != points_.begin()) --begin;
  if (end != points_.end()) ++end;
  return begin < end ? std::vector<HandPoint>(begin, end) : std::vector<HandPoint>();
}

const HandPoint* HandHistory::at(double time_s) const {
  const auto after = std::ranges::upper_bound(points_, time_s, {}, &HandPoint::time_s);
  return after == points_.begin() ? nullptr : &*std::prev(after);
}

}  // namespace ghostforce
