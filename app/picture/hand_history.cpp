#include "app/picture/hand_history.h"

#include <algorithm>
#include <iterator>

namespace ghostforce {
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
