// Files that are written whole or not at all, one (OutputFile) or a folder of them (OutputFolder); and a file that
// grows while the program runs. Not for the servo thread.
//
// Every function of the two classes may throw Failure: file_trouble with path, reason and remedy; interrupted. Those of
// OutputFile may throw BrokenPipe, too.
#pragma once

#include <cstddef>
#include <deque>
#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <sys/types.h>

#include "app/base/failure.h"

namespace ghostforce {

// Nobody reads a pipe any more (head, less): the program ends without a word, and nothing has gone wrong.
struct BrokenPipe {};

// What is written goes to a temporary file in the same folder (part_file.h), and commit() puts it in place of the old
// one, so that even a power cut leaves the old one or the new one. Without commit() nothing is left behind. "-" is the
// standard output; it, pipes and devices take what is written as it comes.
class OutputFile {
 public:
  // Fails at once where a file can never come to be, not after long work.
  explicit OutputFile(const std::string& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  // For output whose beginning is worth something by itself: from here on an interruption does not end a write halfway.
  // A reader who takes nothing for a second is waited for no longer, though: then `interrupted` is thrown.
  void finish_despite_interruption() noexcept { finishes_ = true; }

  // Buffered: long output should come in few large pieces all the same.
  void write(std::string_view text);

  // In place of what was written `at` so many bytes after the beginning. For files that are not written directly.
  void rewrite(std::size_t at, std::string_view text);

  // Where the file is until commit(), for another program to write it; empty: it is written directly.
  const std::string& part_path() const noexcept { return temporary_; }

  void commit();

  // Commits several files, of which then all or none are there: an interruption, or one that cannot be put in place,
  // leaves everything as it was. `folders` get new names besides those of the files.
  static void commit_all(std::deque<OutputFile>& files, std::set<std::filesystem::path> folders = {});

  // The steps of commit(). Without keep() the file is put back as it was, where the file system can exchange two names
  // (RENAME_EXCHANGE: ext4, XFS, Btrfs, tmpfs).
  // All that was written is on the disk, as far as the disk tells: what can still go wrong is the name.
  void finish();
  void put_in_place();
  // The folder, whose new names then outlast a power cut, is the caller's matter.
  void keep() noexcept;

  // Whether the words on a terminal and this file would run into each other.
  bool is_terminal() const noexcept;

 private:
  void flush();
  void remove_temporary() noexcept;
  ssize_t write_some(std::string_view text) const;
  [[noreturn]] void fail(int error) const;

  std::string shown_;      // the path, for messages
  std::string target_;     // where the file will be; empty: written directly
  std::string temporary_;  // what is written until then, and the old file after; empty: there is none
  std::string buffer_;
  int descriptor_ = -1;
  bool finishes_ = false;
  bool has_reader_ = false;   // a pipe, a terminal, a device: who is at its other end may take nothing for a while
  bool is_in_place_ = false;  // and not kept yet
};

// Where a chain of links ends, whether or not anything is there yet.
std::filesystem::path end_of_links(std::filesystem::path path);

// Words for people about a file that cannot be read or written: errno as a reason, and what to do about it.
std::string reason_of(int error);

// A folder of files that are written all or not at all: until commit() there are temporary files in it, and without
// commit(), or where that fails half-way, everything is as it was, where the file system can exchange two names; not
// even the folder is left behind if it was not there before.
class OutputFolder {
 public:
  // Makes the folder, and those above it. Fails at once where it can never hold a file, not after long work.
  explicit OutputFolder(const std::string& path);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  // `name` is that of a file in the folder.
  void write(const std::string& name, std::string_view content);

  void commit();

 private:
  std::filesystem::path path_;
  std::vector<std::filesystem::path> made_;  // folders, the innermost first
  std::deque<OutputFile> files_;
  bool is_committed_ = false;
};

// Makes a file that grows while the program runs, and whose beginning is of use whenever it ends: it is new, and what
// is in it stays. Its descriptor; negative: there is none, and errno says why.
int open_growing_file(const std::string& path) noexcept;

// Why a growing file cannot be had. `kind`: what it would be, as "a recording"; `error`: as errno has it.
Failure no_growing_file(const std::string& path, std::string_view kind, int error);

// Adds to a growing file. 0, or the errno that says why not all of it is there.
int append_whole(int descriptor, std::string_view text) noexcept;

}  // namespace ghostforce
