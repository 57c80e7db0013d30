#include "app/picture/moment_history.h"

#include <algorithm>
#include <ranges>

#include <glm/geometric.hpp>

namespace ghostforce {
namespace {

// A tenth of what the finest number on screen shows, and less than a pixel.
constexpr LeastVisible least_visible{.step = 0.00001, .force = 0.001};

}  // namespace

void MomentHistory::Queue::push(const Kept& kept) {
  const std::size_t place = begin_ + size_;
  if (place == blocks_.size() * block_size) blocks_.emplace_back(block_size);
  blocks_[place / block_size][place % block_size] = kept;
  ++size_;
}

void MomentHistory::Queue::pop() noexcept {
  --size_;
  if (++begin_ < block_size) return;
  begin_ = 0;
  std::ranges::rotate(blocks_, blocks_.begin() + 1);
}

void MomentHistory::add(const Snapshot& snapshot, const Settings& settings) {
  const bool is_first = is_empty();
  if (!is_first && snapshot.time_s <= kept(size() - 1).snapshot.time_s) return;
  const bool has_other_settings = is_first || eras_.back() != settings;
  if (has_other_settings) eras_.push_back(settings);
  const Kept now{snapshot, first_era_ + eras_.size() - 1};
  if (has_other_settings || differs_visibly(seen_, snapshot, least_visible)) {
    for (; resting_.size() > 0; resting_.pop()) keep_moving(resting_.oldest());
    keep_moving(now);
    seen_ = snapshot;
  } else {
    resting_.push(now);
    while (resting_.size() > resting_capacity || snapshot.time_s - resting_.oldest().snapshot.time_s > span_s) {
      resting_.pop();
    }
  }
  forget_settings();
}

void MomentHistory::keep_moving(const Kept& kept) {
  plots_.add(kept.snapshot);
  moving_.push(kept);
  while (moving_.size() > capacity - resting_capacity ||
         kept.snapshot.time_s - moving_.oldest().snapshot.time_s > span_s) {
    moving_.pop();
  }
}

void MomentHistory::forget_settings() noexcept {
  for (; first_era_ < kept(0).era; ++first_era_) eras_.pop_front();
}

void MomentHistory::clear() {
  moving_.clear();
  resting_.clear();
  eras_.clear();
  plots_.clear();
}

std::optional<ShownMoment> MomentHistory::moment(std::size_t i) const {
  if (i >= size()) return std::nullopt;
  const Kept& found = kept(i);
  return ShownMoment{eras_[static_cast<std::size_t>(found.era - first_era_)], found.snapshot, true};
}

std::size_t MomentHistory::first_not_before(double time_s) const {
  return *std::ranges::partition_point(std::views::iota(std::size_t{0}, size()),
                                       [&](std::size_t i) { return kept(i).snapshot.time_s < time_s; });
}

std::size_t MomentHistory::first_after(double time_s) const {
  return *std::ranges::partition_point(std::views::iota(std::size_t{0}, size()),
                                       [&](std::size_t i) { return kept(i).snapshot.time_s <= time_s; });
}

std::optional<ShownMoment> MomentHistory::oldest() const {
  return moment(0);
}

std::optional<ShownMoment> MomentHistory::newest() const {
  return moment(size() - 1);  // of none: far beyond
}

std::optional<ShownMoment> MomentHistory::at(double time_s) const {
  return moment(first_after(time_s) - 1);
}

std::optional<ShownMoment> MomentHistory::before(double time_s) const {
  return moment(first_not_before(time_s) - 1);
}

std::optional<ShownMoment> MomentHistory::after(double time_s) const {
  return moment(first_after(time_s));
}

std::vector<Vector<2>> last_loop(const MomentHistory& moments, StrategyId id, double turn_s) {
  constexpr int corners = 160;
  std::vector<Vector<2>> loop;
  const auto newest = moments.newest();
  if (!newest) return loop;
  const double end_s = newest->snapshot.time_s;
  for (int i = 0; i <= corners; ++i) {
    const auto moment = moments.at(end_s - turn_s + turn_s * i / corners);
    if (moment) loop.push_back(moment->snapshot.strategies[index_of(id)].device);
  }
  return loop;
}

bool differs_visibly(const Snapshot& seen, const Snapshot& now, const LeastVisible& least) noexcept {
  if (now.measured != seen.measured || glm::distance(now.goal, seen.goal) > least.step) return true;
  for (std::size_t i = 0; i < strategy_count; ++i) {
    const StrategySnapshot<2>& a = seen.strategies[i];
    const StrategySnapshot<2>& b = now.strategies[i];
    if (a.in_contact != b.in_contact || glm::distance(a.device, b.device) > least.step ||
        glm::distance(a.proxy, b.proxy) > least.step || glm::distance(a.force, b.force) > least.force ||
        glm::distance(a.ghost_force, b.ghost_force) > least.force) {
      return true;
    }
  }
  return false;
}

}  // namespace ghostforce
