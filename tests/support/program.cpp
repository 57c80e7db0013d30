#include "tests/support/program.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/inotify.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <stdexcept>
#include <system_error>
#include <utility>

extern char** environ;

namespace ghostforce {
namespace {

int checked(int result) {
  if (result < 0) throw std::system_error(errno, std::generic_category());
  return result;
}

class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() { reset(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int number() const { return number_; }
  void reset(int number = -1) {
    if (number_ >= 0) close(number_);
    number_ = number;
  }

 private:
  int number_ = -1;
};

struct Pipe {
  Descriptor read_end;
  Descriptor write_end;
  Pipe() {
    std::array<int, 2> ends{};
    checked(pipe2(ends.data(), O_CLOEXEC));
    read_end.reset(ends[0]);
    write_end.reset(ends[1]);
  }
};

std::vector<char*> pointers_to(std::vector<std::string>& words) {
  std::vector<char*> pointers;
  pointers.reserve(words.size() + 1);
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  return pointers;
}

// `in` -1: nothing to read.
pid_t spawn(const std::string& program, const ProgramCall& call, int in, int out, int err) {
  std::vector<std::string> words{program};
  words.insert(words.end(), call.words.begin(), call.words.end());
  std::vector<std::string> environment;
  for (char** variable = environ; *variable != nullptr; ++variable) {
    const std::string_view kept = *variable;
    const std::string_view name = kept.substr(0, kept.find('=') + 1);
    bool is_replaced = false;
    for (const std::string& given : call.environment) is_replaced |= given.starts_with(name);
    if (!is_replaced) environment.emplace_back(kept);
  }
  environment.insert(environment.end(), call.environment.begin(), call.environment.end());

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  if (in >= 0) {
    posix_spawn_file_actions_adddup2(&actions, in, STDIN_FILENO);
  } else {
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  }
  if (call.out_to.empty()) {
    posix_spawn_file_actions_adddup2(&actions, out, STDOUT_FILENO);
  } else {
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, call.out_to.c_str(), O_WRONLY | O_CREAT, 0666);
  }
  posix_spawn_file_actions_adddup2(&actions, err, STDERR_FILENO);
  if (!call.folder.empty()) posix_spawn_file_actions_addchdir_np(&actions, call.folder.c_str());

  // Whoever started this test may have had signals ignored or blocked.
  sigset_t by_default;
  sigfillset(&by_default);
  sigset_t blocked;
  sigemptyset(&blocked);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setsigdefault(&attributes, &by_default);
  posix_spawnattr_setsigmask(&attributes, &blocked);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);

  pid_t child = -1;
  const int error = posix_spawn(&child, program.c_str(), &actions, &attributes, pointers_to(words).data(),
                                pointers_to(environment).data());
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
  if (error != 0) throw std::system_error(error, std::generic_category(), program);
  return child;
}

// As Outcome has it.
int exit_code_from(int status) {
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

int exit_code_of(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return exit_code_from(status);
}

}  // namespace

Outcome run_program(const std::string& program, const ProgramCall& call) {
  Descriptor watch;
  if (!call.signal_when_created_in.empty()) {
    watch.reset(checked(inotify_init1(IN_CLOEXEC)));
    checked(inotify_add_watch(watch.number(), call.signal_when_created_in.c_str(), IN_CREATE));
  }
  Pipe out;
  Pipe err;
  const pid_t child = spawn(program, call, -1, out.write_end.number(), err.write_end.number());
  out.write_end.reset();
  err.write_end.reset();

  Outcome outcome;
  // A negative descriptor is passed over by poll().
  std::array<pollfd, 3> waits{
      {{out.read_end.number(), POLLIN, 0}, {err.read_end.number(), POLLIN, 0}, {watch.number(), POLLIN, 0}}};
  while (waits[0].fd >= 0 || waits[1].fd >= 0) {
    if (poll(waits.data(), waits.size(), -1) < 0 && errno != EINTR) throw std::runtime_error("poll");
    for (std::size_t i = 0; i < waits.size(); ++i) {
      if (waits[i].fd < 0 || waits[i].revents == 0) continue;
      std::array<char, 65536> piece;
      const ssize_t count = read(waits[i].fd, piece.data(), piece.size());
      if (i == 2) {
        kill(child, call.signal);
        waits[i].fd = -1;
      } else if (count <= 0) {
        waits[i].fd = -1;
      } else {
        (i == 0 ? outcome.out : outcome.err).append(piece.data(), static_cast<std::size_t>(count));
        if (i == 0 && call.close_after_first_piece) {
          waits[i].fd = -1;
          out.read_end.reset();
        }
      }
    }
  }
  outcome.exit_code = exit_code_of(child);
  return outcome;
}

RunningProgram::RunningProgram(const std::string& program, const ProgramCall& call) {
  Pipe in;
  Pipe out;
  child_ = spawn(program, call, call.takes_orders ? in.read_end.number() : -1, out.write_end.number(), STDERR_FILENO);
  in_ = checked(fcntl(in.write_end.number(), F_DUPFD_CLOEXEC, 0));
  out_ = checked(fcntl(out.read_end.number(), F_DUPFD_CLOEXEC, 0));
}

RunningProgram::~RunningProgram() {
  if (child_ >= 0) {
    send(SIGKILL);
    wait_for_end();
  }
  close(in_);
  close(out_);
}

std::optional<std::string> RunningProgram::next_line(std::chrono::milliseconds patience) {
  const auto deadline = std::chrono::steady_clock::now() + patience;
  for (;;) {
    if (const std::size_t end = heard_.find('\n'); end != std::string::npos) {
      const std::string line = heard_.substr(0, end);
      heard_.erase(0, end + 1);
      return line;
    }
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - std::chrono::steady_clock::now());
    pollfd wait{out_, POLLIN, 0};
    if (poll(&wait, 1, static_cast<int>(std::max<std::int64_t>(left.count(), 0))) <= 0) return std::nullopt;
    std::array<char, 4096> piece;
    const ssize_t count = read(out_, piece.data(), piece.size());
    if (count <= 0) return std::nullopt;
    heard_.append(piece.data(), static_cast<std::size_t>(count));
  }
}

void RunningProgram::send(int signal) const {
  kill(child_, signal);
}

void RunningProgram::order(const std::string& line) const {
  // Nobody may be there to read it.
  signal(SIGPIPE, SIG_IGN);
  const std::string text = line + '\n';
  if (write(in_, text.data(), text.size()) < 0 && errno != EPIPE)
    throw std::system_error(errno, std::generic_category());
}

bool RunningProgram::has_ended() {
  int status = 0;
  if (child_ >= 0 && waitpid(child_, &status, WNOHANG) == child_) {
    child_ = -1;
    exit_code_ = exit_code_from(status);
  }
  return child_ < 0;
}

int RunningProgram::wait_for_end() {
  if (child_ >= 0) exit_code_ = exit_code_of(std::exchange(child_, -1));
  return exit_code_;
}

}  // namespace ghostforce
