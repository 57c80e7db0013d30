// What a person is asked to do with a Falcon while it is measured (OperatorAction), and the simulated person who does
// it with the virtual one (MeasuredPerson). SI units.
#pragma once

#include <cstdint>
#include <string>

#include "device/falcon/calibration.h"
#include "device/virtual_falcon/virtual_link.h"

namespace ghostforce {

// What to do, as a value: the words for it are the caller's, and a simulated person can do it too. Device frame: x
// right, y up, z out towards the person.
struct OperatorAction {
  enum class Kind : std::uint8_t {
    read_on,       // nothing
    go_to,         // move the handle to `place` and hold it there
    push_in,       // all the way, straight, until it stops
    hold_button,   // at `place`, with a button of the grip held down: motors may push from now on
    loosen,        // until one fingertip on the button is left
    take_again,    // hold the handle firmly at `place` again, no button
    hang_weight,   // of `weight` on the handle, which is held at `place`; 0: take it off
    press,         // `buttons`, for a moment, and let go
    say_distance,  // what the ruler says between the last two places, in mm
    say_weight,    // what hangs on the handle later, in g
    say_light,     // what colour the light has
    say_yes_or_no,
  };

  Kind kind = Kind::read_on;
  Vector<3> place = workspace_center;
  double weight = 0.0;       // [N]
  std::uint8_t buttons = 0;  // as in ReplyFrame
};

// Does with the simulated hand what is asked for, and answers what the ruler, the scales and the light would tell. Same
// thread as the link's.
class MeasuredPerson {
 public:
  struct Habits {
    double grip = 150.0;      // how stiff the hand is [N/m]
    double fingertip = 15.0;  // how stiff one finger of it is [N/m]
    double weight = 50.0;     // what there is to hang on the handle, as scales tell it [g]
    double ruler_step = 0.5;  // what the ruler is read to [mm]
  };

  MeasuredPerson(VirtualLink& link, const Habits& habits) noexcept : link_(link), habits_(habits) {}

  // Begins to do it; the hand takes about a second. Returns what the person would type, mostly nothing.
  std::string act(const OperatorAction& action);

 private:
  void lead(const Vector<3>& place, double stiffness, std::uint8_t buttons);

  VirtualLink& link_;
  Habits habits_;
  Vector<3> place_{HandPlan::centre};
  Vector<3> marks_[2]{HandPlan::centre, HandPlan::centre};  // where the handle really was when asked to move on
  double load_ = 0.0;
};

}  // namespace ghostforce
