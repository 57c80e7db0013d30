#include "app/base/interruption.h"

#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <signal.h>
#include <sys/eventfd.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>

#include "app/base/failure.h"

namespace ghostforce {
namespace {

// How long a reader may take nothing once the program is to stop.
constexpr int patience_ms = 1000;
// Nothing tells when somebody opens the other end of a pipe.
constexpr int glance_ms = 20;

std::atomic<bool> is_interrupted{false};
void (*before_the_end)() noexcept = nullptr;  // set before any handler
// An event that happens once and is never taken back, so that it ends every wait on every thread, later ones too.
std::atomic<int> interruption_event{-1};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free,
              "a signal handler may touch nothing else");

void tell_waits() noexcept {
  const eventfd_t once = 1;
  [[maybe_unused]] const ssize_t ignored = write(interruption_event.load(), &once, sizeof once);
}

// Also in a forked process, whose signals are its own: with the parent's event it would end waits of the parent, which
// nothing has interrupted.
void make_event() noexcept {
  const int parents = interruption_event.exchange(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK));
  if (interrupted()) tell_waits();
  if (parents >= 0) close(parents);
}

extern "C" void remember(int number) {
  const int error_before = errno;
  const bool is_first = !is_interrupted.exchange(true);
  before_the_end();
  tell_waits();
  if (!is_first) {
    signal(number, SIG_DFL);
    raise(number);
  }
  errno = error_before;
}

// False: the time is over, or the program is interrupted, and there is nothing yet.
bool wait_for(int descriptor, short what, int longest_ms) noexcept {
  std::array<pollfd, 2> waits{{{descriptor, what, 0}, {interruption_event, POLLIN, 0}}};
  while (poll(waits.data(), waits.size(), longest_ms) < 0) {
    if (errno != EINTR) return true;  // whoever reads or writes next will be told why
    if (interrupted()) return false;
  }
  return waits[0].revents != 0;
}

bool is_pipe(const char* path) noexcept {
  struct stat status {};
  return stat(path, &status) == 0 && S_ISFIFO(status.st_mode);
}

}  // namespace

void remember_interruptions(void (*stop_motors)() noexcept) noexcept {
  before_the_end = stop_motors;
  make_event();
  pthread_atfork(nullptr, nullptr, make_event);
  sigset_t handled;
  sigemptyset(&handled);
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action {};
    sigaction(number, nullptr, &action);
    if (action.sa_handler == SIG_IGN) continue;
    action.sa_handler = remember;
    // No SA_RESTART: a write to a pipe that nobody reads must come back too.
    action.sa_flags = 0;
    // A second signal waits until the first has been dealt with.
    sigfillset(&action.sa_mask);
    sigaction(number, &action, nullptr);
    sigaddset(&handled, number);
  }
  // Whoever started this program may have had them blocked: then nothing but SIGKILL would end it.
  pthread_sigmask(SIG_UNBLOCK, &handled, nullptr);
}

bool interrupted() noexcept {
  return is_interrupted.load(std::memory_order_relaxed);
}

void interrupt() noexcept {
  is_interrupted.store(true, std::memory_order_relaxed);
  tell_waits();
}

void stop_if_interrupted() {
  if (interrupted()) throw Failure(ExitCode::interrupted, "interrupted");
}

int interruption_descriptor() noexcept {
  return interruption_event;
}

void wait_to_read(int descriptor) {
  if (!wait_for(descriptor, POLLIN, -1)) stop_if_interrupted();
}

void wait_to_write(int descriptor) {
  if (!wait_for(descriptor, POLLOUT, -1)) stop_if_interrupted();
}

bool wait_for_reader(int descriptor) noexcept {
  if (wait_for(descriptor, POLLOUT, -1)) return true;
  pollfd wait{descriptor, POLLOUT, 0};
  return poll(&wait, 1, patience_ms) > 0;
}

int open_unless_interrupted(const char* path, int flags) {
  for (;;) {
    const int descriptor = open(path, flags | O_NONBLOCK);
    if (descriptor >= 0) return descriptor;
    const int error = errno;
    // Nobody reads the pipe yet, or the file is locked by a lease that is just being broken.
    const bool may_come = (error == ENXIO && is_pipe(path)) || error == EWOULDBLOCK || error == EINTR;
    if (!may_come) {
      errno = error;
      return -1;
    }
    stop_if_interrupted();
    wait_for(-1, 0, glance_ms);
  }
}

InputLine read_line(int descriptor) {
  InputLine line;
  while (line.text.size() <= longest_input_line) {
    wait_to_read(descriptor);
    char letter = 0;
    const ssize_t count = read(descriptor, &letter, 1);
    stop_if_interrupted();
    if (count < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (count <= 0) break;
    if (letter == '\n') {
      line.is_whole = true;
      break;
    }
    line.text += letter;
  }
  return line;
}

}  // namespace ghostforce
