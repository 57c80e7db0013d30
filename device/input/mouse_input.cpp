#include "device/input/mouse_input.h"

#include <algorithm>
#include <cmath>

#include "core/scene.h"

namespace ghostforce {

void MouseInput::move_to(const Vector<2>& goal, double duration_s) noexcept {
  if (!std::isfinite(goal.x) || !std::isfinite(goal.y) || std::isnan(duration_s)) {
    ++ignored_moves_;
    return;
  }
  moves_.publish({nearest_in_scene(goal), std::clamp(duration_s, 0.0, slowest_move_s)});
}

void MouseInput::restart(const Vector<2>& goal) noexcept {
  moves_.latest();
  from_ = to_ = goal;
  ticks_ = ticks_gone_ = 0;
}

Vector<2> MouseInput::goal(std::int64_t /*tick*/, double rate) noexcept {
  if (moves_.has_news()) {
    from_ = position();
    const Move& move = moves_.latest();
    to_ = move.to;
    ticks_ = std::llround(move.duration_s * rate);  // 0: there at once, which is one tick
    ticks_gone_ = 0;
  }
  ticks_gone_ = std::min(ticks_gone_ + 1, ticks_);
  return position();
}

Vector<2> MouseInput::position() const noexcept {
  if (ticks_gone_ == ticks_) return to_;  // exactly, whatever the rounding
  return from_ + (static_cast<double>(ticks_gone_) / static_cast<double>(ticks_)) * (to_ - from_);
}

}  // namespace ghostforce
