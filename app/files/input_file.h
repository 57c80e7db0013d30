// The one reader of files: as one text (scenes, cases, preferences, calibrations, shaders), or in pieces (runs), so
// that opening and reading go wrong in one way; and what is at a path where a plain file is wanted, since opening a
// pipe waits for its other end, and that may never come. Not for the servo thread.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

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

// Hands the file on in pieces, as long as `take` returns true. Returns the errno of what went wrong; 0: nothing did.
// Waits as above. Throws Failure(interrupted), and what `take` throws.
int read_pieces(const std::filesystem::path& path, const std::function<bool(std::string_view piece)>& take);

// What is in a folder, sorted. Where it cannot be read to its end `error` says why.
std::vector<std::filesystem::path> paths_in(const std::filesystem::path& folder, std::error_code& error);

// The name nearest to `word` (typed_text.h) of those that `name_of` makes of what is in a folder; an empty one is
// none.
std::optional<std::string> nearest_name_in(const std::filesystem::path& folder, std::string_view word,
                                           const std::function<std::string(const std::filesystem::path&)>& name_of);

// "a folder", "a pipe", "a broken link", …. Empty: a file or a link to one, nothing at all, or what cannot
// be looked at.
std::string_view kind_instead_of_file(const std::filesystem::path& path);

// Words for people about a file that cannot be read: errno as a reason, and what to do about it. None of them costs a
// sound file.
std::string unreadable_words(int error);

// ReadError(unreadable), "FILE cannot be read: " and those words.
ReadError unreadable(std::string_view shown_path, int error, std::string_view joint = " ");

}  // namespace ghostforce
