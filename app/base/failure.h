// How the program ends, as a number for scripts and as words for people. Anything under app/ may throw a Failure,
// except readers of files, which throw a ReadError (app/files/read_error.h). main() is the only place that catches both
// and ends the program. Not for the servo thread, which never throws.
#pragma once

#include <array>
#include <stdexcept>
#include <string>
#include <string_view>

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

// `what_to_say` is complete: what is wrong, where, and what to do about it; one line per problem, no final newline.
class Failure : public std::runtime_error {
 public:
  Failure(ExitCode code, const std::string& what_to_say) : std::runtime_error(what_to_say), code_(code) {}
  ExitCode code() const noexcept { return code_; }

 private:
  ExitCode code_;
};

// What each exit code says, for the help and the manual.
struct ExitCodeEntry {
  ExitCode code;
  std::string_view meaning;
};

inline constexpr std::array exit_code_catalog{
    ExitCodeEntry{ExitCode::done, "done"},
    ExitCodeEntry{ExitCode::answer_is_no, "ran, and the answer is no: pictures differ, a replay diverged, no reading"},
    ExitCodeEntry{ExitCode::wrong_call, "wrong arguments, or an error in an input file"},
    ExitCodeEntry{ExitCode::device_absent, "no such device plugged in"},
    ExitCodeEntry{ExitCode::device_refused, "device seen, but not allowed or busy"},
    ExitCodeEntry{ExitCode::device_failed, "firmware or homing failed"},
    ExitCodeEntry{ExitCode::no_display, "no display, or no usable OpenGL"},
    ExitCodeEntry{ExitCode::safety_stop, "stopped by a safety limit"},
    ExitCodeEntry{ExitCode::file_trouble, "a file cannot be read or written, or memory is short"},
    ExitCodeEntry{ExitCode::bug, "a bug in this program: please report it"},
    ExitCodeEntry{ExitCode::interrupted, "interrupted"},
};

}  // namespace ghostforce
