// What orders the emergency stop (emergency_stop.h) where a process may die: its signals, and its exit.
#pragma once

namespace ghostforce::emergency_stop {

// Makes every signal that would end the process stop the motors first, and then end the process as it would have. Not
// those that cannot be caught (SIGKILL), that are ignored (faults cannot be), or that somebody handles already. exit()
// does so too: libraries call it, and no destructor on a stack runs. The calling thread gets an AlternateStack; every
// other thread needs one itself.
void install_handlers() noexcept;

// From now on this process ignores signals that would suspend it (Ctrl+Z), because it could not turn motors off while
// it is suspended. SIGSTOP cannot be ignored.
void refuse_to_be_stopped() noexcept;

}  // namespace ghostforce::emergency_stop
