// The rows of the list of inputs for a Haply 2DIY (input_link.h), real or virtual. They need a serial port, which a page
// does not have: the desktop's front gives the makers.
#pragma once

#include <functional>
#include <vector>

#include "app/shell/input_link.h"
#include "device/haply/haply_input.h"

namespace ghostforce {

class VirtualHaplyInput;

using HaplyReadinessOf =
    std::function<std::vector<ReadinessStepState>(const HaplyReport& report, const MotorReport& motors)>;

InputEntry haply_entry(const InputMaker<HaplyInput>& maker, const HaplyReadinessOf& readiness_of);
InputEntry virtual_haply_entry(const InputMaker<VirtualHaplyInput>& maker, const HaplyReadinessOf& readiness_of);

}  // namespace ghostforce
