// SimulatedHand: a hand on the virtual Falcon's handle. It pulls as f_u = k_u (q_u − q), (1), along all three axes,
// after a plan: a goal that moves from waypoint to waypoint, with the grip's buttons pressed on the way. It can home
// the device as a person would: pull the handle out, push it straight in, and come back.
//
// A plan is a whole value that another thread may give at any time (a mouse that moves the virtual hand). The rest
// belongs to the one thread that lets time pass: it may also say, at any time, how far the hand is from where it means
// to be, and how stiff it is instead of what the plan says. Device frame, SI units, times in ns; never allocates or throws.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/conventions.h"
#include "core/latest_value.h"

namespace ghostforce {

struct HandPlan {
  struct Waypoint {
    double time = 0.0;         // since the plan began; not before that of the waypoint before [s]
    Vector<3> goal{};          // [m]
    std::uint8_t buttons = 0;  // pressed from here on, as in ReplyFrame

    friend bool operator==(const Waypoint&, const Waypoint&) = default;
  };

  // Where the goal rests, unless something else is planned: the middle of the workspace.
  static constexpr Vector<3> centre{0.0, 0.0, 0.125};

  // The goal goes on from wherever it is, in a straight line to each of the first `count`, and stays at the last.
  std::array<Waypoint, 16> waypoints{Waypoint{.goal = centre}};
  std::size_t count = 1;
  double stiffness = 100.0;  // k_u; 0 lets go [N/m]
  double load = 0.0;         // a weight that it has hung on the handle [N]
  // A device that asks to be homed gets that first; then the plan begins anew.
  bool homes_when_asked = false;

  // At most so many as there are places; what is too much is left out.
  void add(const Waypoint& waypoint) noexcept {
    if (count < waypoints.size()) waypoints[count++] = waypoint;
  }

  friend bool operator==(const HandPlan&, const HandPlan&) = default;
};

// To one place, within so long [s].
HandPlan hand_at(const Vector<3>& goal, double time = 0.0) noexcept;

// Out, straight in to the stop, and to the middle.
HandPlan homing_hand() noexcept;

class SimulatedHand {
 public:
  SimulatedHand(const HandPlan& plan, std::int64_t now_ns) noexcept;

  // One other thread, or the same one.
  void follow(const HandPlan& plan) noexcept { plans_.publish(plan); }

  // Also begins the newest plan.
  void advance(std::int64_t now_ns, bool device_asks_for_homing) noexcept;

  // From now on, but for homing: a person who does that pays attention. `way` [m]; `stiffness`: empty: the plan's.
  void shake(const Vector<3>& way, std::optional<double> stiffness) noexcept {
    way_ = way;
    stiffness_ = stiffness;
  }

  Vector<3> goal() const noexcept { return homing_ ? goal_ : goal_ + way_; }  // q_u
  double stiffness() const noexcept;                                          // k_u
  double load() const noexcept { return course_.plan.load; }
  std::uint8_t buttons() const noexcept { return buttons_; }
  bool is_homing() const noexcept { return homing_.has_value(); }  // because the device has asked

 private:
  // A plan that is under way.
  struct Course {
    HandPlan plan;
    std::int64_t start_ns;
    Vector<3> start;  // the goal then

    void look_up(std::int64_t now_ns, Vector<3>& goal, std::uint8_t& buttons) const noexcept;
    bool is_over(std::int64_t now_ns) const noexcept;
  };

  LatestValue<HandPlan> plans_;
  Course course_;
  std::optional<Course> homing_;
  Vector<3> goal_;
  std::uint8_t buttons_ = 0;
  Vector<3> way_{0.0};
  std::optional<double> stiffness_;
};

}  // namespace ghostforce
