// What a file is that somebody opens or drops on the window. Its content tells, and its name only where that does not:
// people rename files. A further kind is a row in file_kind.cpp, and one where the application opens it. UI thread.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace ghostforce {

enum class FileKind : std::uint8_t {
  scene,
  lesson,
  run,      // a recording to be replayed
  picture,  // that may carry a set-up
};

// Empty: it is of another kind, or a folder, a pipe or the like; never waits for these. Where there is no file, or it
// cannot be read, a scene is meant: that may be a name, and its reader tells what is wrong.
std::optional<FileKind> kind_of_file(const std::string& path);

// "a scene (.toml), a recording (.csv), …"
std::string file_kinds_words();

}  // namespace ghostforce
