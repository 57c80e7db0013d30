// The emergency stop: when the process is to end, motors are told to stop by the signal handler itself, before any
// thread hears of it, or because no thread ever will. One link per process has motors. Everything here is
// async-signal-safe, on any thread. In a page no process dies that leaves a device behind: there it is ordered only by
// who calls it.
#pragma once

namespace ghostforce {

class DeviceLink;

namespace emergency_stop {

// The link whose motors are to be stopped; null: none. A link must be taken out before it is destroyed.
void watch(DeviceLink* link) noexcept;

// Sends zero force, at once, to the link that is watched; returns when it has been sent, by whichever thread came
// first. From then on is_ordered(), and no driver may ask for a force.
void stop_motors() noexcept;
bool is_ordered() noexcept;

// What orders the stop where a process may die, by its signals and its exit: every signal that would end the process
// stops the motors first, and then ends the process as it would have. Not those that cannot be caught (SIGKILL), that are
// ignored (faults cannot be), or that somebody handles already. exit() does so too: libraries call it, and no destructor
// on a stack runs. The calling thread gets an AlternateStack; every other thread needs one itself.
void install_handlers() noexcept;

// From now on this process ignores signals that would suspend it (Ctrl+Z), because it could not turn motors off while
// it is suspended. SIGSTOP cannot be ignored.
void refuse_to_be_stopped() noexcept;

}  // namespace emergency_stop

}  // namespace ghostforce
