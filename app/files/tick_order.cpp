#include "app/files/tick_order.h"

namespace ghostforce {
namespace {

bool can_join(const RunTick& a, const RunTick& b) noexcept {
  if (a.time_s != b.time_s || a.goal != b.goal || a.settings != b.settings) return false;
  for (std::size_t s = 0; s < strategy_count; ++s) {
    if (a.rows[s] && b.rows[s]) return false;
  }
  return true;
}

}  // namespace

void TickOrder::take(const RunTick& tick) {
  settle_newest(&tick);
  newest_ = tick;
}

void TickOrder::end() {
  settle_newest(nullptr);
  if (kept_) hand_on_(*kept_);
  kept_.reset();
}

// `next` comes after it; null: nothing does.
void TickOrder::settle_newest(const RunTick* next) {
  if (!newest_) return;
  const RunTick tick = *std::exchange(newest_, std::nullopt);
  if (kept_ && tick.state == RunTick::none) {
    const bool next_follows = next != nullptr && next->state == RunTick::none && kept_->time_s <= next->time_s;
    if (next_follows && (tick.time_s < kept_->time_s || tick.time_s > next->time_s)) {
      ++left_out_;
      return;
    }
    if (can_join(*kept_, tick)) {
      for (std::size_t s = 0; s < strategy_count; ++s) {
        if (tick.rows[s]) kept_->rows[s] = tick.rows[s];
      }
      if (tick.measured) kept_->measured = tick.measured;
      return;
    }
  }
  if (kept_) hand_on_(*kept_);
  kept_ = tick;
}

}  // namespace ghostforce
