// What a thread needs of the operating system to keep its deadlines: priority over ordinary threads, memory that is
// never paged out, timers that are not batched. Tried once, on the thread itself, before its loop; what could not be
// had is a line of text for the status bar, never an error: a mouse-driven session works without any of it.
#pragma once

#include "device/servo/realtime_status.h"

namespace ghostforce {

// On the thread that wants it. Sets the thread's scheduling and timer slack, and locks the memory of the process. Where
// real-time threads may run only for so long without a pause (RLIMIT_RTTIME), SIGXCPU comes before the kill.
RealtimeStatus request_realtime() noexcept;

// On the thread that draws, before it makes others: a graphics driver's threads draw too, and go where theirs goes.
// Where the servo would not be granted its priority, drawing leaves the last processor of two or more to it, and
// request_realtime() keeps its own thread there: beside other programs it was seen to wait far longer where drawing
// runs, too. What programs the process starts draw no more on that processor either. The idle class, in which drawing
// would stand back everywhere, is none for it: Linux lets an ordinary user's thread go there but not come back, as it
// must before motors are armed. Once, before request_realtime().
void leave_processor_to_servo() noexcept;

}  // namespace ghostforce
