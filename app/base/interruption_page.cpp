// Nothing interrupts a page: whoever closes it ends it. It has no pipes and terminals to wait for.
#include <fcntl.h>

#include "app/base/interruption.h"

namespace ghostforce {

void remember_interruptions(void (*)() noexcept) noexcept {}

bool interrupted() noexcept {
  return false;
}

void interrupt() noexcept {}

void stop_if_interrupted() {}

int interruption_descriptor() noexcept {
  return -1;
}

void wait_to_read(int) {}

void wait_to_write(int) {}

bool wait_for_reader(int) noexcept {
  return true;
}

int open_unless_interrupted(const char* path, int flags) {
  return open(path, flags);
}

}  // namespace ghostforce
