#include "app/tools/check/evaluation.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <deque>
#include <map>
#include <stdexcept>
#include <utility>

#include <errno.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "app/base/failure.h"
#include "app/base/interruption.h"
#include "app/base/quoted.h"
#include "app/files/descriptor.h"
#include "app/shell/desktop/renderer.h"
#include "app/tools/check/rendered_cases.h"

namespace ghostforce {
namespace {

[[noreturn]] void refuse_to_guess(const WorkerEnded& ended, const std::vector<const Case*>& chosen) {
  const std::string doing =
      ended.piece < 0
          ? ""
          : fmt::format(" while checking {}", quoted_text(chosen.at(static_cast<std::size_t>(ended.piece))->name));
  if (ended.signal == SIGKILL) {
    throw Failure(ExitCode::file_trouble,
                  fmt::format("a worker process was killed{}, perhaps because memory is short; choose fewer --jobs, "
                              "or close other programs",
                              doing));
  }
  throw std::runtime_error(ended.signal == 0
                               ? fmt::format("a worker process ended unexpectedly{}", doing)
                               : fmt::format("a worker process was ended by signal {}{}", ended.signal, doing));
}

}  // namespace

void evaluate_all(const std::vector<Case>& all, const std::vector<const Case*>& chosen, const Evaluation& how,
                  const std::function<void(Verdict)>& take) {
  RenderedCases rendered(all, chosen, how.renderer);
  const auto count = static_cast<std::int64_t>(chosen.size());
  const auto verdict_on = [&](std::int64_t i) {
    stop_if_interrupted();
    return evaluate(*chosen[static_cast<std::size_t>(i)], rendered, how.folder, how.wants_pictures);
  };
  if (how.jobs == 1) {
    for (std::int64_t i = 0; i < count; ++i) take(verdict_on(i));
    return;
  }
  if (how.renderer != Renderer::gpu) choose_offscreen_driver();  // what it says is said once
  try {
    run_in_workers(
        count, how.jobs, [&](std::int64_t i) { return bytes_of(verdict_on(i)); },
        [&](const std::string& bytes) { take(verdict_of(bytes)); });
  } catch (const WorkerEnded& ended) {
    refuse_to_guess(ended, chosen);
  }
}

namespace {

using MakePiece = std::function<std::string(std::int64_t)>;

// Enough that a worker rarely waits while another has a slow piece.
constexpr std::int64_t pieces_per_worker = 4;

// Before the bytes of each piece.
struct PieceHeader {
  bool is_made = false;  // false: it was thrown instead, and there are no bytes
  std::size_t size = 0;
};

// False: the other process has ended. `wait` is called before each time that it may wait for the other one.
bool receive_all(int socket, void* into, std::size_t size, void (*wait)(int socket)) {
  for (std::size_t have = 0; have < size;) {
    wait(socket);
    const ssize_t got = recv(socket, static_cast<char*>(into) + have, size - have, 0);
    if (got == 0 || (got < 0 && errno != EINTR)) return false;
    if (got > 0) have += static_cast<std::size_t>(got);
  }
  return true;
}

bool send_all(int socket, const void* from, std::size_t size) {
  for (std::size_t sent = 0; sent < size;) {
    const ssize_t got = send(socket, static_cast<const char*>(from) + sent, size - sent, MSG_NOSIGNAL);
    if (got < 0 && errno != EINTR) return false;
    if (got > 0) sent += static_cast<std::size_t>(got);
  }
  return true;
}

// The life of a worker: a piece for each number that it is sent, until there is nobody any more to send one.
void serve(int socket, const MakePiece& make) noexcept {
  const auto go_on = [](int) {};  // an interruption is the parent's matter, and make()'s
  for (std::int64_t i = 0; receive_all(socket, &i, sizeof i, go_on);) {
    std::string piece;
    PieceHeader header;
    try {
      piece = make(i);
      header = {true, piece.size()};
    } catch (...) {
      piece.clear();
    }
    if (!send_all(socket, &header, sizeof header) || !send_all(socket, piece.data(), piece.size())) return;
  }
}

class Worker {
 public:
  // `elder`: the workers before it.
  Worker(const MakePiece& make, std::deque<Worker>& elder) {
    std::array<int, 2> ends{};
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) fail(errno);
    socket_.reset(ends[0]);
    Descriptor other(ends[1]);
    process_ = fork();
    if (process_ < 0) fail(errno);
    if (process_ > 0) return;
    // Only the parent holds its ends, so that they close where it dies.
    socket_.reset();
    for (Worker& each : elder) each.socket_.reset();
    serve(other.number(), make);
    _exit(0);  // no destructor: what the parent has under way is the parent's
  }
  ~Worker() { end(); }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  int socket() const noexcept { return socket_.number(); }
  bool is_idle() const noexcept { return piece_ < 0; }

  // Throws WorkerEnded, as does the next one.
  void start(std::int64_t piece) {
    piece_ = piece;
    if (!send_all(socket(), &piece, sizeof piece)) has_ended();
  }
  // The piece that it was sent, once there is something to read; no text: make() has thrown.
  std::pair<std::int64_t, std::optional<std::string>> finish() {
    PieceHeader header;
    if (!receive_all(socket(), &header, sizeof header, wait_to_read)) has_ended();
    std::string text(header.size, '\0');
    if (!receive_all(socket(), text.data(), text.size(), wait_to_read)) has_ended();
    const std::int64_t piece = std::exchange(piece_, -1);
    return {piece, header.is_made ? std::optional(std::move(text)) : std::nullopt};
  }

 private:
  [[noreturn]] static void fail(int error) {
    throw Failure(ExitCode::file_trouble, fmt::format("another process cannot be started: {}; choose fewer --jobs",
                                                      std::generic_category().message(error)));
  }

  [[noreturn]] void has_ended() {
    const int status = end();
    throw WorkerEnded{piece_, WIFSIGNALED(status) ? WTERMSIG(status) : 0};
  }

  // It holds nothing that has to be put in order. How it has ended, as waitpid() has it.
  int end() noexcept {
    int status = 0;
    if (process_ <= 0) return status;
    // Where it has ended already, the first signal is what waitpid() tells.
    kill(process_, SIGKILL);
    while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
    process_ = -1;
    return status;
  }

  pid_t process_ = -1;
  Descriptor socket_;
  std::int64_t piece_ = -1;  // that it makes; negative: none
};

}  // namespace

void run_in_workers(std::int64_t count, int workers, const MakePiece& make,
                    const std::function<void(std::string)>& take) {
  std::deque<Worker> crew;
  for (std::int64_t i = 0; i < std::min<std::int64_t>(count, workers); ++i) crew.emplace_back(make, crew);

  std::map<std::int64_t, std::optional<std::string>> ready;  // made and not taken
  std::int64_t next = 0;
  for (std::int64_t taken = 0; taken < count;) {
    stop_if_interrupted();
    const std::int64_t end = std::min(count, taken + pieces_per_worker * workers);
    for (Worker& worker : crew) {
      if (worker.is_idle() && next < end) worker.start(next++);
    }
    if (auto found = ready.extract(taken)) {
      take(found.mapped() ? std::move(*found.mapped()) : make(taken));
      ++taken;
      continue;
    }
    std::vector<pollfd> waits;
    for (const Worker& worker : crew) waits.push_back({worker.socket(), POLLIN, 0});
    waits.push_back({interruption_descriptor(), POLLIN, 0});
    if (poll(waits.data(), waits.size(), -1) <= 0) continue;  // a signal
    for (std::size_t i = 0; i < crew.size(); ++i) {
      if (waits[i].revents != 0) ready.insert(crew[i].finish());
    }
  }
}

}  // namespace ghostforce
