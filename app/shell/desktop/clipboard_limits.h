// What reading the clipboard of another program may cost, and what is said when it would cost more. Any thread.
#pragma once

#include <cstdint>

#include "app/base/failure.h"

namespace ghostforce {

// About as long as a person waits for a paste, or for a window to close.
inline constexpr std::int64_t clipboard_patience_ns = 1'000'000'000;
inline constexpr std::uint32_t most_clipboard_bytes = 1 << 20;

[[noreturn]] inline void throw_clipboard_is_silent() {
  throw Failure(ExitCode::file_trouble,
                "The program that owns the clipboard does not answer. Copy the text again, from another program.");
}

[[noreturn]] inline void throw_clipboard_is_too_long() {
  throw Failure(ExitCode::file_trouble, "The text on the clipboard is too long. Copy less of it.");
}

}  // namespace ghostforce
