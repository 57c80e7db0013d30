// What a person is asked to do with a Haply 2DIY while it is measured (HaplyAction), and the simulated person who does it
// with the virtual one (MeasuredHaplyPerson). SI units, the device's frame.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "device/virtual_haply/virtual_port.h"

namespace ghostforce {

// What to do, as a value: the words for it are the caller's, and a simulated person can do it too.
struct HaplyAction {
  enum class Kind : std::uint8_t {
    read_on,         // nothing
    hold_zero_pose,  // and keep still
    turn_arm,        // the driven link of `arm` to `angle`, the other one halfway outwards, and keep still
    hold,            // the handle loosely at `place`: motors may push from now on
    let_go,          // motors carry the handle
    hang_weight,     // of `weight`, which pulls the handle away from the base and is held at `place`; 0: take it off
    press,           // lightly from `place` towards the base
    say_weight,      // what hangs on the handle later, in g
    say_yes_or_no,
  };

  Kind kind = Kind::read_on;
  Vector<2> place{0.0};
  std::size_t arm = 0;
  double angle = 0.0;   // [rad]
  double weight = 0.0;  // [N]
};

// Does with the simulated hand what is asked for, and answers what the scales would tell. Same thread as the port's.
class MeasuredHaplyPerson {
 public:
  struct Habits {
    double grip = 100.0;     // how stiff the hand is [N/m]
    double damping = 3.0;    // of the hand [N·s/m]
    double weight = 50.0;    // what there is to hang on the handle, as scales tell it [g]
    double pressing = 0.4;   // how hard it presses against a wall [N]
    double angle_off = 0.0;  // by which it turns an arm too far [rad]
  };

  MeasuredHaplyPerson(VirtualPort& port, const Habits& habits) noexcept : port_(port), habits_(habits) {}

  // Begins to do it; the hand takes about a second. Returns what the person would type, mostly nothing.
  std::string act(const HaplyAction& action);

 private:
  void lead(const Vector<2>& place, double stiffness, double damping);

  VirtualPort& port_;
  Habits habits_;
  double load_ = 0.0;  // the weight [N]
};

}  // namespace ghostforce
