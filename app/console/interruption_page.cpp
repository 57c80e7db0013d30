// Nothing interrupts a page: whoever closes it ends it.
#include <fcntl.h>

#include "app/console/interruption.h"

namespace ghostforce {

void remember_interruptions(void (*)() noexcept) noexcept {}

bool interrupted() noexcept {
  return false;
}

void interrupt() noexcept {}

void stop_if_interrupted() {}

int open_unless_interrupted(const char* path, int flags) {
  return open(path, flags);
}

void wait_for_reader_of(int) {}

}  // namespace ghostforce
