// OperatorAction: what a person is asked to do with the Falcon while it is measured, as a value: the words for it
// are the caller's, and a simulated person can do it too. [m], [N]; device frame: x right, y up, z out towards the person.
#pragma once

#include <cstdint>

#include "device/falcon/calibration.h"

namespace ghostforce {

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
  double weight = 0.0;
  std::uint8_t buttons = 0;  // as in ReplyFrame
};

}  // namespace ghostforce
