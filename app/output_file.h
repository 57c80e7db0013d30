// A file that is written whole or not at all: what is written goes to a
// temporary file in the same folder, and commit() puts it in place of the old
// one. Without commit() nothing is left behind. "-" is the standard output;
// it, pipes and devices take what is written as it comes. Not for the servo
// thread.
//
// Every function may throw Failure: file_trouble with path, reason and remedy;
// interrupted; or done, without a word, when the reader of a pipe has gone.
#pragma once

#include <sys/types.h>

#include <string>
#include <string_view>

namespace ghostforce {

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

  // All that was written is on the disk, as far as the disk tells: what can still go wrong with commit() is the name.
  void finish();

  void commit();

  // Whether the words on a terminal and this file would run into each other.
  bool is_terminal() const noexcept;

 private:
  void flush();
  ssize_t write_some(std::string_view text) const;
  [[noreturn]] void fail(int error) const;

  std::string shown_;      // the path, for messages
  std::string target_;     // where the file shall be; empty: written directly
  std::string temporary_;  // what is written until then; empty: written directly
  std::string buffer_;
  int descriptor_ = -1;
  bool finishes_ = false;
};

// Words for people about a file that cannot be read or written: errno as a
// reason, and what to do about it.
std::string reason_of(int error);

}  // namespace ghostforce
