#include "app/base/newest_line_writer.h"

#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <string_view>
#include <utility>

namespace ghostforce {
namespace {

constexpr std::chrono::seconds patience{1};

// Of a file, nobody can hold the writing up.
bool has_reader(int descriptor) {
  struct stat status {};
  if (fstat(descriptor, &status) != 0) return false;  // writing to it fails at once
  return S_ISFIFO(status.st_mode) || S_ISSOCK(status.st_mode) || isatty(descriptor) == 1;
}

// 0, or errno.
int write_whole_line(int descriptor, std::string_view line) {
  while (!line.empty()) {
    const ssize_t written = write(descriptor, line.data(), line.size());
    if (written >= 0) {
      line.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno == EAGAIN) {
      // Somebody else has made it non-blocking.
      pollfd wait{descriptor, POLLOUT, 0};
      poll(&wait, 1, -1);
    } else if (errno != EINTR) {
      return errno;
    }
  }
  return 0;
}

}  // namespace

struct NewestLineWriter::State {
  explicit State(int number) : descriptor(number) {}

  const int descriptor;
  std::atomic<int> error{0};
  std::mutex mutex;
  std::condition_variable changed;
  // Guarded by the mutex.
  std::optional<std::string> next;
  bool is_ending = false;
  bool has_ended = false;
};

NewestLineWriter::NewestLineWriter(int descriptor, std::string first)
    : state_(std::make_shared<State>(descriptor)),
      thread_([state = state_, first = std::move(first)] { write_lines(*state, first); }) {}

void NewestLineWriter::write_lines(State& state, const std::string& first) {
  int error = write_whole_line(state.descriptor, first);
  std::unique_lock lock(state.mutex);
  while (error == 0) {
    state.changed.wait(lock, [&] { return state.next || state.is_ending; });
    if (!state.next) break;
    const std::string line = std::exchange(state.next, std::nullopt).value();
    lock.unlock();
    error = write_whole_line(state.descriptor, line);
    lock.lock();
  }
  state.error = error;
  state.has_ended = true;
  state.changed.notify_all();
}

int NewestLineWriter::finish() {
  if (!thread_.joinable()) return problem();
  bool has_ended = false;
  {
    std::unique_lock lock(state_->mutex);
    state_->is_ending = true;
    state_->changed.notify_all();
    const auto is_over = [&] { return state_->has_ended; };
    if (has_reader(state_->descriptor)) {
      has_ended = state_->changed.wait_for(lock, patience, is_over);
    } else {
      state_->changed.wait(lock, is_over);
      has_ended = true;
    }
  }
  if (has_ended) {
    thread_.join();
  } else {
    thread_.detach();
  }
  return problem();
}

void NewestLineWriter::put(std::string line) {
  {
    const std::scoped_lock lock(state_->mutex);
    state_->next = std::move(line);
  }
  state_->changed.notify_all();
}

int NewestLineWriter::problem() const noexcept {
  return state_->error;
}

}  // namespace ghostforce
