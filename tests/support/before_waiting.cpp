#include "tests/support/before_waiting.h"

#include <dlfcn.h>
#include <poll.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <ctime>
#include <utility>

namespace ghostforce {
namespace {

thread_local bool is_on = false;
std::function<void()> next;

int poll_for(pollfd* descriptors, nfds_t count, int longest_ms) {
  const timespec time{longest_ms / 1000, longest_ms % 1000 * 1'000'000L};
  return static_cast<int>(syscall(SYS_ppoll, descriptors, count, longest_ms < 0 ? nullptr : &time, nullptr, 0));
}

// As poll(). What it would wait for must be there by the time that it has waited.
int poll_at_once(pollfd* descriptors, nfds_t count, int longest_ms) {
  const int ready = poll_for(descriptors, count, 0);
  if (ready != 0) return ready;
  if (const auto happens = std::exchange(next, nullptr)) happens();
  const int ready_then = poll_for(descriptors, count, 0);
  if (ready_then == 0 && longest_ms < 0) _exit(would_wait_for_ever);
  return ready_then;
}

}  // namespace

void before_waiting(std::function<void()> happens) {
  next = std::move(happens);
  is_on = true;
}

}  // namespace ghostforce

extern "C" {

int poll(pollfd* descriptors, nfds_t count, int longest_ms) {
  return ghostforce::is_on ? ghostforce::poll_at_once(descriptors, count, longest_ms)
                           : ghostforce::poll_for(descriptors, count, longest_ms);
}

ssize_t read(int descriptor, void* into, size_t size) {
  pollfd wait{descriptor, POLLIN, 0};
  if (ghostforce::is_on) ghostforce::poll_at_once(&wait, 1, -1);
  static const auto read_on = reinterpret_cast<ssize_t (*)(int, void*, size_t)>(dlsym(RTLD_NEXT, "read"));
  return read_on(descriptor, into, size);
}
}
