// VirtualHaplyHand: a hand on the handle of simulated arms. It pulls as f_u = k_u (q_u − q), (1), with some damping,
// after a plan: a goal that moves from waypoint to waypoint. Asked to, it puts the arms into the zero pose and holds
// them there, as a person does before a set up, and afterwards goes back to its plan.
//
// A plan is a whole value that another thread may give at any time; hold_zero_pose() may be asked for by any thread.
// The rest belongs to the one thread that lets time pass. The device's frame (arms_geometry.h), SI units, times in ns;
// never allocates or throws.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "core/conventions.h"
#include "core/latest_value.h"
#include "device/virtual_haply/haply_arms.h"

namespace ghostforce {

struct HaplyHandPlan {
  struct Waypoint {
    double time = 0.0;    // since the plan began; not before that of the waypoint before [s]
    Vector<2> goal{0.0};  // [m]

    friend bool operator==(const Waypoint&, const Waypoint&) = default;
  };

  // The goal goes on from wherever it is, in a straight line to each of the first `count`, and stays at the last.
  // Without any it is in the middle (ArmsGeometry::middle()).
  std::array<Waypoint, 16> waypoints{};
  std::size_t count = 0;
  double stiffness = 100.0;  // k_u; 0 lets go [N/m]
  double damping = 3.0;      // [N·s/m]
  // With which the goal goes to the first waypoint at most, whatever its time [m/s].
  double greatest_speed = std::numeric_limits<double>::infinity();

  // At most so many as there are places; what is too much is left out.
  void add(const Waypoint& waypoint) noexcept {
    if (count < waypoints.size()) waypoints[count++] = waypoint;
  }

  friend bool operator==(const HaplyHandPlan&, const HaplyHandPlan&) = default;
};

// To one place, within so long [s].
HaplyHandPlan haply_hand_at(const Vector<2>& goal, double time = 0.0) noexcept;

class VirtualHaplyHand {
 public:
  static constexpr double turning_speed = 4.0;  // with which it brings the links to the zero pose [rad/s]
  static constexpr double return_s = 0.4;       // in which it goes back to its plan

  VirtualHaplyHand(const HaplyHandPlan& plan, const Vector<2>& middle, std::int64_t now_ns) noexcept;

  // One other thread, or the same one.
  void follow(const HaplyHandPlan& plan) noexcept { plans_.publish(plan); }
  // Any thread.
  void hold_zero_pose(bool holds) noexcept { is_to_hold_ = holds; }

  // Also begins the newest plan. `zero_pose`: what this person takes for it.
  void advance(std::int64_t now_ns, const HaplyArms& arms, const Vector<2>& zero_pose) noexcept;

  const HandPull& pull() const noexcept { return pull_; }
  // The arms have been in what the person takes for the zero pose, to within a tenth of a degree, and still are.
  bool is_in_zero_pose() const noexcept { return is_in_zero_pose_; }

 private:
  Vector<2> planned_goal(std::int64_t now_ns) const noexcept;

  LatestValue<HaplyHandPlan> plans_;
  std::atomic<bool> is_to_hold_ = false;
  HaplyHandPlan plan_;
  Vector<2> middle_;
  std::int64_t plan_start_ns_;
  Vector<2> plan_start_;  // the goal then
  std::int64_t last_ns_;
  std::int64_t released_ns_ = 0;  // 0: it has not held the links
  Vector<2> released_at_{0.0};
  HandPull pull_;
  bool is_in_zero_pose_ = false;
};

}  // namespace ghostforce
