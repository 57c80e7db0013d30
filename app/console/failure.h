// How the program ends, as a number for scripts and as words for people. Anything under app/ may throw a Failure,
// but readers of files, which throw a ReadError (app/files/read_error.h). main() is the only place that catches both and
// ends the program. Not for the servo thread, which never throws.
#pragma once

#include <stdexcept>
#include <string>

namespace ghostforce {

enum class ExitCode : int {
  done = 0,
  answer_is_no = 1,    // ran, and the answer is no: pictures differ, a replay diverged, no reading
  wrong_call = 2,      // wrong arguments, or a file that says something wrong
  device_absent = 3,   // no such device plugged in
  device_refused = 4,  // seen, but not allowed or busy
  device_failed = 5,   // firmware or homing failed
  no_display = 6,      // no display, or no usable OpenGL
  safety_stop = 7,     // stopped by a safety limit
  file_trouble = 8,    // a file cannot be read or written, or memory is short
  bug = 70,
  interrupted = 130,
};

// `what_to_say` is complete: what is wrong, where, and what to do about it; one line per problem, no newline at the end.
class Failure : public std::runtime_error {
 public:
  Failure(ExitCode code, const std::string& what_to_say) : std::runtime_error(what_to_say), code_(code) {}
  ExitCode code() const noexcept { return code_; }

 private:
  ExitCode code_;
};

}  // namespace ghostforce
