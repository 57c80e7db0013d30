// StageLabel: the words of the stage. One thing has one set of words at a time.
#pragma once

#include "app/picture/label_search.h"

namespace ghostforce {

struct StageLabel {
  // In the order of their importance.
  enum Id : LabelId {
    numbers,  // the block of the two large numbers
    hint,     // what a newcomer is asked to do
    guess,
    measured_hand,
    ghost,
    slide,
    handle,
    wall_share,
    hand,
    expected_rest,
    expected_contact,
    motor,
    wall,
  };
};

}  // namespace ghostforce
