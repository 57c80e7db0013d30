// A small TOML file in which the program keeps something from one run to the next: preferences, the window's layout,
// progress. A damaged file is set aside under another name, and one that cannot be read, or whose format is newer than
// this program, stays where it is: what a person may want back is never overwritten, and nothing of this is a reason
// not to start. Saved whole or not at all (output_file.h). In a page the browser keeps the text, for this page alone,
// under the file's name. Not for the servo thread.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/files/toml_document.h"

namespace ghostforce {

struct KeptFile {
  std::filesystem::path path;  // empty: without a home folder nothing is kept
  std::string_view contents;   // for messages, with its verb: "preferences are", "the window's layout is"
  std::string_view comment;    // one line at its beginning, for who opens it
  std::string_view without = "the defaults are used";  // what happens where it cannot be used
};

// Hands the file to `read` if there is one. False: what `read` has made is not to be used: there is no file, it cannot
// be read, or `read` or the parser told of problems. `remarks` gets what the person should know of that: what was wrong,
// and where the file is now.
bool load(const KeptFile& file, const std::function<void(TomlReader&)>& read, std::vector<std::string>& remarks);

// Makes the folder too. `keys`: those at the top of the file that are this program's. What stands under others, written
// by a newer program, stays there; without any, nothing does. `text` must have no tables where there are keys. Throws
// Failure(file_trouble), with what to do.
void save(const KeptFile& file, std::string_view text, std::span<const std::string_view> keys = {});

// Removes it, with all that newer programs have written there. Throws Failure(file_trouble).
void forget(const KeptFile& file);

}  // namespace ghostforce
