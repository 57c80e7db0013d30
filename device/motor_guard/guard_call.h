// How a program calls its guard: ghostforce-guard NODE, with three files open.
#pragma once

namespace ghostforce::guard_call {

inline constexpr int device_descriptor = 3;    // the device's file, with its interface claimed
inline constexpr int page_descriptor = 4;      // a GuardPage
inline constexpr int lifeline_descriptor = 5;  // a pipe that ends when the program does

}  // namespace ghostforce::guard_call
