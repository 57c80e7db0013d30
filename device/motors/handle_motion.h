// What every device makes of the places of its handle: how fast it is, and where the goal is while the handle is only
// just being found. Plain values; never allocate or throw; any one thread. m, s; times in ns.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "core/conventions.h"
#include "core/scene.h"

namespace ghostforce {

// The speed of a handle, over several readings: over one, a single step of an encoder would be 5 cm/s.
template <glm::length_t D>
class HandleSpeed {
 public:
  static constexpr std::size_t readings = 8;

  // A place, and when it was read; the one that was read before is no news.
  void add(const Vector<D>& position, std::int64_t time_ns) noexcept {
    const std::size_t last = (next_ + readings - 1) % readings;
    if (count_ > 0 && places_[last].time_ns == time_ns) return;
    places_[next_] = {position, time_ns};
    next_ = (next_ + 1) % readings;
    count_ = std::min(count_ + 1, readings);
  }
  // Where it is is not known.
  void forget() noexcept { count_ = 0; }

  // 0 until there are enough readings [m/s].
  double value() const noexcept {
    if (count_ < readings) return 0.0;
    const Place& oldest = places_[next_];
    const Place& newest = places_[(next_ + readings - 1) % readings];
    return glm::length(newest.position - oldest.position) /
           (static_cast<double>(newest.time_ns - oldest.time_ns) * 1e-9);
  }

 private:
  struct Place {
    Vector<D> position{0.0};
    std::int64_t time_ns = 0;
  };

  std::array<Place, readings> places_{};  // a ring
  std::size_t next_ = 0;
  std::size_t count_ = 0;
};

// The goal of a hand at a device whose motors are off: where the handle is. When the handle is found, the goal moves
// there and does not jump.
class HandleGoal {
 public:
  static constexpr double approach_s = 0.5;

  void restart(const Vector<2>& goal) noexcept {
    goal_ = goal;
    approach_ = 0.0;
  }
  // While the handle is not known, the goal stays, and has to find it again.
  Vector<2> waiting() noexcept {
    approach_ = 0.0;
    return goal_;
  }
  // One tick later, with the handle there [m]. `rate` [Hz].
  Vector<2> next(const Vector<2>& handle, double rate) noexcept {
    // The rest of the way shrinks to nothing as the share that is gone grows to all.
    const double before = approach_;
    approach_ = std::min(1.0, approach_ + 1.0 / (approach_s * rate));
    goal_ = before < 1.0 ? glm::mix(goal_, handle, (approach_ - before) / (1.0 - before)) : handle;
    goal_ = nearest_in_scene(goal_);
    return goal_;
  }

 private:
  Vector<2> goal_{0.0};
  double approach_ = 0.0;  // how much of the way to the handle the goal has gone, 0 … 1
};

}  // namespace ghostforce
