// What a thread needs of the operating system to keep its deadlines: priority over ordinary threads, memory that is
// never paged out, timers that are not batched. Tried once, on the thread itself, before its loop; what could not be
// had is a line of text for the status bar, never an error: a mouse-driven session works without any of it.
#pragma once

#include <string>

namespace ghostforce {

// Trivially copyable: it crosses threads whole. Each is 0 when granted, else the error number that says why not.
struct RealtimeStatus {
  int priority_error = 0;
  int memory_lock_error = 0;
};

// On the thread that wants it. Sets the thread's scheduling and timer slack, and locks the memory of the process.
RealtimeStatus request_realtime() noexcept;

// One line for a person. Not for the servo thread (it allocates).
std::string describe(const RealtimeStatus& status);

}  // namespace ghostforce
