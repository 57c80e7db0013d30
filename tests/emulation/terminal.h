// Terminal: a pseudo-terminal that stands behind an emulated device file, because poll() on that file reaches the
// kernel itself: through this, the emulator says when the file is readable, writable or gone. Any thread.
#pragma once

#include <sys/types.h>

#include <mutex>
#include <string>

namespace ghostforce {

class Terminal {
 public:
  Terminal();  // neither readable nor writable
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;
  ~Terminal();

  const std::string& path() const { return path_; }
  dev_t number() const { return number_; }

  void set_writable(bool yes);
  void set_readable(bool yes);
  // From now on POLLERR and POLLHUP.
  void hang_up();

 private:
  std::mutex mutex_;
  int near_ = -1;  // the end that is held by the emulator; the other one is the device file
  int far_ = -1;
  std::string path_;
  dev_t number_ = 0;
  bool is_writable_ = true;
  bool is_readable_ = false;
};

}  // namespace ghostforce
