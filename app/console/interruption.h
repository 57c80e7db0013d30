// Ctrl+C, SIGTERM and a closed terminal: long work asks now and then whether it should stop, and unwinds, so that
// nothing half-done stays behind. Asking is a plain atomic load, any thread.
#pragma once

namespace ghostforce {

// From here on the first SIGINT, SIGTERM or SIGHUP is only remembered; a second one calls `stop_motors`, which must be
// async-signal-safe, and ends the process at once. Signals that were ignored when the program started (nohup,
// background jobs) stay ignored. Called once, by main().
void remember_interruptions(void (*stop_motors)() noexcept) noexcept;

bool interrupted() noexcept;

// As a signal would have done it.
void interrupt() noexcept;

// Throws Failure(ExitCode::interrupted) if so.
void stop_if_interrupted();

// open(2), which waits where a pipe has nobody at its other end: that ends when interrupted, as above.
// A first signal in the moment before it waits does not end the wait; the second one ends the process, as always.
int open_unless_interrupted(const char* path, int flags);

// Once interrupted, before a write that no further signal would end: waits until a pipe can be written to, a second at
// most, and then throws as above.
void wait_for_reader_of(int descriptor);

}  // namespace ghostforce
