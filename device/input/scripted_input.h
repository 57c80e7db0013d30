// The hand as a scene's path: the same goal at the same tick, every time. Has no memory: the path starts again because
// the servo counts ticks from its start again. Made on the UI thread (copies the path), then the servo thread's only.
#pragma once

#include <cstdint>
#include <utility>

#include "core/goal_path.h"
#include "core/tick.h"
#include "device/input/input.h"

namespace ghostforce {

class ScriptedInput final : public Input {
 public:
  // A valid path (core/scene.h).
  explicit ScriptedInput(GoalPath path) : path_(std::move(path)) {}

  void restart(const Vector<2>& /*goal*/) noexcept override {}
  Vector<2> goal(std::int64_t tick, double rate) noexcept override { return goal_at(path_, time_of(tick, rate)); }

 private:
  GoalPath path_;
};

}  // namespace ghostforce
