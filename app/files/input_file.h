// A file as one text: scenes, cases, preferences, calibrations, shaders. Opening and reading go wrong in one way. Not
// for the servo thread.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "app/files/read_error.h"

namespace ghostforce {

// A hundred thousand waypoints take a few million bytes; what is larger than this is some other file, or a device that
// never ends.
inline constexpr std::size_t largest_text_file = 1 << 24;

struct FileContents {
  std::string text;
  int error = 0;  // as errno has it; EFBIG: the file is larger than largest_text_file. 0: `text` is all of it
};

// Waits where a pipe has no other end yet. Throws Failure(interrupted).
FileContents file_contents(const std::filesystem::path& path);

// Words for people about a file that cannot be read: errno as a reason, and what to do about it. None of them costs a
// sound file.
std::string unreadable_words(int error);

// ReadError(unreadable), "FILE cannot be read: " and those words.
ReadError unreadable(std::string_view shown_path, int error, std::string_view joint = " ");

}  // namespace ghostforce
