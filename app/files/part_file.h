// The temporary files that output goes to until it is whole: ".ghostforce-PID-N.part", each with a lock on it while its
// process lives. A killed process leaves its own behind without a lock, and the next one that writes into the folder
// removes them. A lock tells the living from the dead where a process id does not: ids are used again, and other
// containers and machines have their own. In a page nobody else writes, and what is left behind goes with it. Not for the
// servo thread.
#pragma once

#include <filesystem>
#include <string>

namespace ghostforce {

struct PartFile {
  std::string path;
  int descriptor = -1;  // open for writing and locked; negative: errno says why there is none
};

// A new one, with the permissions that any new file has.
PartFile make_part_file(const std::filesystem::path& folder);

// In one moment for whoever looks at the folder. False: that is impossible here, or one of the files is not there.
bool exchange_names(const std::string& one, const std::string& other) noexcept;

// Before an open file gets the name of a temporary one: another process might remove it.
void lock_part_file(int descriptor) noexcept;

// Removes those that nobody writes any more, the first time that it is asked to for a folder; what cannot be looked at
// or removed stays.
void remove_dead_part_files(const std::filesystem::path& folder);

}  // namespace ghostforce
