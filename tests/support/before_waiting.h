// Does something in the very moment before a test executable begins to wait for a descriptor: its poll and read are
// taken instead of the C library's. What the program looked at before is out of date then, and what it has not asked
// poll() for will never end the wait. Time passes at once. For a test in a process of its own (EXPECT_EXIT).
#pragma once

#include <functional>

namespace ghostforce {

// Of a process that would wait for ever: it ends instead.
inline constexpr int would_wait_for_ever = 99;

// From here on, in this process, on the thread that calls this; `happens` only before the first wait.
void before_waiting(std::function<void()> happens);

}  // namespace ghostforce
