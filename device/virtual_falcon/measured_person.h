// MeasuredPerson: the person at the virtual Falcon while it is measured. Does with the simulated hand what it is asked
// to, and answers what the ruler, the scales and the light would tell. Same thread as the link's. SI units.
#pragma once

#include <string>

#include "device/virtual_falcon/operator_action.h"
#include "device/virtual_falcon/virtual_link.h"

namespace ghostforce {

class MeasuredPerson {
 public:
  struct Habits {
    double grip = 150.0;      // how stiff the hand is [N/m]
    double fingertip = 15.0;  // and one finger of it
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
