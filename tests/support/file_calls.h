// What a test executable asks of the disk, in order: its fsync, fdatasync, rename and renameat2 are taken instead of
// the C library's, done, and noted; one of them may fail on demand. Any thread may make such calls; nothing is noted
// while no FileCalls lives, and one lives at a time.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace ghostforce {

struct FileCall {
  std::string call;            // "fsync", …
  std::string path;            // of the file or folder; of a renaming, where it leads to
  std::size_t bytes = 0;       // in the file at that moment
  bool is_by_creator = false;  // of the FileCalls: the thread
};

class FileCalls {
 public:
  FileCalls();
  ~FileCalls();
  FileCalls(const FileCalls&) = delete;
  FileCalls& operator=(const FileCalls&) = delete;

  std::vector<FileCall> all() const;
  std::ptrdiff_t count(std::string_view call, std::string_view path) const;
  // Nothing in it where there is none.
  FileCall last(std::string_view call, std::string_view path) const;
  bool was_made_by_this_thread(std::string_view call) const;

  // From here on such a call fails; 0: it does not.
  void fail(std::string_view call, int error);
};

}  // namespace ghostforce
