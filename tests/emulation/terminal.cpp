#include "tests/emulation/terminal.h"

#include <cerrno>
#include <cstdlib>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <termios.h>
#include <unistd.h>

namespace ghostforce {

// What follows makes the system calls themselves where the C library's name is one that umockdev wraps.

Terminal::Terminal() {
  near_ = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  char name[64];
  if (near_ < 0 || grantpt(near_) != 0 || unlockpt(near_) != 0 || ptsname_r(near_, name, sizeof name) != 0) {
    throw std::system_error(errno, std::generic_category(), "no pseudo-terminal");
  }
  path_ = name;
  far_ = static_cast<int>(syscall(SYS_openat, AT_FDCWD, name, O_RDWR | O_NOCTTY | O_CLOEXEC));
  struct stat status {};
  if (far_ < 0 || fstat(far_, &status) != 0) throw std::system_error(errno, std::generic_category(), path_);
  number_ = status.st_rdev;
  termios settings{};
  tcgetattr(far_, &settings);
  cfmakeraw(&settings);
  tcsetattr(far_, TCSANOW, &settings);
  set_writable(false);
}

Terminal::~Terminal() {
  hang_up();
  ::close(far_);
}

void Terminal::set_writable(bool yes) {
  const std::lock_guard lock(mutex_);
  if (near_ < 0 || yes == is_writable_) return;
  tcflow(far_, yes ? TCOON : TCOOFF);
  is_writable_ = yes;
}

void Terminal::set_readable(bool yes) {
  const std::lock_guard lock(mutex_);
  if (near_ < 0 || yes == is_readable_) return;
  if (yes) {
    const char byte = 0;
    if (syscall(SYS_write, near_, &byte, 1) != 1) return;
  } else {
    tcflush(far_, TCIFLUSH);
  }
  is_readable_ = yes;
}

void Terminal::hang_up() {
  const std::lock_guard lock(mutex_);
  if (near_ < 0) return;
  ::close(near_);
  near_ = -1;
}

}  // namespace ghostforce
