// How the program ends, as a number for scripts and as words for people. Anything under app/ may throw a Failure,
// but readers of files, which throw a ReadError (app/files/read_error.h). main() is the only place that catches both and
// ends the program. Not for the servo thread, which never throws.
#pragma once

#include <stdexcept>
#include <string>

namespace ghostforce {

enum class ExitCode : int {
  done = 0,
  answer_is_no = 1,
  wrong_call = 2,
  device_absent = 3,
  device_refused = 4,
  device_failed = 5,
  no_display = 6,
  safety_stop = 7,
  file_trouble = 8,
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
