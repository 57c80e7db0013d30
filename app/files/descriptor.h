// Open files: how one is closed in the end, and how what was written is made to outlast a power cut. That waits for the
// disk: not for the servo thread, and for the UI thread only where a person waits for a file anyway, or while motors
// are off.
#pragma once

#include <filesystem>

#include <unistd.h>

namespace ghostforce {

// An open file, closed in the end; negative: there is none. Any one thread.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) noexcept : number_(number) {}
  ~Descriptor() { reset(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int number() const noexcept { return number_; }
  void reset(int number = -1) noexcept {
    if (number_ >= 0) close(number_);
    number_ = number;
  }

 private:
  int number_;
};

// What the file holds, and how much of it there is: sync_file() with its times and permissions, by fsync(2);
// sync_data() without, by fdatasync(2). They return the errno of what went wrong; 0: nothing did, or what is written to
// cannot be synchronised (a pipe, some file systems) and so promises nothing.
int sync_file(int descriptor) noexcept;
int sync_data(int descriptor) noexcept;

// The names in a folder, with the same result. A folder that may not be read cannot be synchronised either.
int sync_folder(const std::filesystem::path& folder) noexcept;

}  // namespace ghostforce
