// What each exit code says, for the help and the manual. Pure, any thread.
#pragma once

#include <array>
#include <string_view>

#include "app/base/failure.h"

namespace ghostforce {

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
