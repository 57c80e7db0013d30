// What a thread has got of the operating system to keep its deadlines, as a value and in words. Where nobody has asked for
// anything, nothing was refused.
#pragma once

#include <string>

namespace ghostforce {

// Trivially copyable: it crosses threads whole. Each error is 0 when granted, else the number that says why not.
struct RealtimeStatus {
  int priority_error = 0;
  int memory_lock_error = 0;
  bool has_short_slice = false;  // instead of the priority: ordinary threads make room soon when this one wakes
};

// What was refused, in a few words for the status bar: "no real-time priority"; empty: nothing. Not for the servo thread,
// nor is the next.
std::string refused_words(const RealtimeStatus& status);

// The same in one line that also says why it is no better.
std::string describe(const RealtimeStatus& status);

}  // namespace ghostforce
