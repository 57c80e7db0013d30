// The inputs that need nothing but this program, each with its link: all of device/input_catalog.h. A link that is more
// than a few lines is in a file of its own, which gives its row of the list. Any thread; making an input allocates and
// may throw.
#pragma once

#include <functional>
#include <vector>

#include "app/shell/input_link.h"

namespace ghostforce {

class FalconInput;
struct FalconReport;

// How far a Falcon is, found out by who knows what to do about it; may be empty.
using ReadinessOf =
    std::function<std::vector<ReadinessStepState>(const FalconReport& report, const MotorReport& motors)>;

// In the order in which people see them. `devices`: those that this front of the program adds, which come before what
// rehearses them.
std::vector<InputEntry> portable_inputs(const ReadinessOf& readiness_of, const std::vector<InputEntry>& devices = {});

InputEntry circle_entry();
InputEntry virtual_falcon_entry(const ReadinessOf& readiness_of);
// Of a Falcon on whatever cable the maker gives it.
InputEntry falcon_entry(const InputMaker<FalconInput>& maker, const ReadinessOf& readiness_of);

}  // namespace ghostforce
