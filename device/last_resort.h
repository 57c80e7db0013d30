// The last resort: when the process is about to die of a bug, motors are told to stop by the signal handler itself,
// because nobody else will. One link per process has motors. Everything here is async-signal-safe, on any thread.
#pragma once

namespace ghostforce {

class FalconLink;

namespace last_resort {

// The link whose motors are to be stopped; null: none. A link must be taken out before it goes.
void guard(FalconLink* link) noexcept;

// Sends zero force, at once, to the link that is guarded. From then on is_taken(), and no driver may ask for a force.
void take() noexcept;
bool is_taken() noexcept;

// Makes SIGABRT (a failed assertion, an exception that nobody catches), SIGSEGV, SIGBUS, SIGFPE, SIGILL and SIGQUIT
// (Ctrl+\) take it and then end the process as they would have; a thread must not block those of them that are its own
// faults. exit() takes it too: libraries call it (Xlib does when its display has gone), and no destructor on a stack
// runs.
void install() noexcept;

}  // namespace last_resort
}  // namespace ghostforce
