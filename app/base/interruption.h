// Ctrl+C, SIGTERM and a closed terminal: long work asks now and then whether it should stop, and unwinds, so that
// nothing half-done stays behind. Asking is a plain atomic load, any thread.
//
// A signal ends only a system call that has begun: one that comes between a look at interrupted() and a read(2) would
// leave that read waiting. So whatever waits for a person or another program waits here first, where an interruption
// counts as something to read.
#pragma once

#include <cstddef>
#include <string>

namespace ghostforce {

// From here on the first SIGINT, SIGTERM or SIGHUP calls `stop_motors`, which must be async-signal-safe, and is
// remembered: motors are off before any thread has heard of it. A second one does so too, and ends the process at once.
// Signals that were ignored when the program started (nohup, background jobs) stay ignored; those that were blocked are
// not any longer. Called once, by main(), before there are other threads.
void remember_interruptions(void (*stop_motors)() noexcept) noexcept;

bool interrupted() noexcept;

// As a signal would have done it.
void interrupt() noexcept;

// Throws Failure(ExitCode::interrupted) if so.
void stop_if_interrupted();

// Who computes ticks asks after so many: well under a hundredth of a second.
inline constexpr int ticks_between_looks = 1024;

// Something to read from the interruption on, for whoever waits for several things with poll(2). Nobody may take it.
// Negative: there is none, and poll(2) passes over it.
int interruption_descriptor() noexcept;

// Wait until it can be read or written, or its other end has gone. What is there already is still taken: an interruption
// ends a wait, not the reading of what keeps coming. They throw as above where an interruption, however early it came,
// leaves nothing else to wait for. Any thread.
void wait_to_read(int descriptor);
void wait_to_write(int descriptor);

// For what is written even by an interrupted program, which waits a second at most. False: that was in vain.
bool wait_for_reader(int descriptor) noexcept;

// open(2), which waits where a pipe has nobody at its other end: that ends as above. Reading and writing do not wait:
// they may fail with EAGAIN.
int open_unless_interrupted(const char* path, int flags);

// --- A line that a person types or a script hands in ---

inline constexpr std::size_t longest_input_line = 65536;  // [bytes]

struct InputLine {
  std::string text;  // without its newline
  // False: the newline never came, because the input had ended or could not be read, or because the line is too long.
  // Whether that is an answer is for the caller to say; no text at all is none.
  bool is_whole = false;
};

// Nothing beyond the line is taken, so that whoever reads the same input next, in this program or after it, finds the
// rest. Waits as above. Any thread.
InputLine read_line(int descriptor);

}  // namespace ghostforce
