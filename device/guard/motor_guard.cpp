#include "device/guard/motor_guard.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <exception>
#include <new>
#include <utility>

#include "device/input/monotonic_clock.h"

namespace ghostforce {
namespace {

constexpr std::int64_t start_patience_ns = 5'000'000'000;
// After that it is killed: it holds nothing but files.
constexpr std::int64_t end_patience_ns = 500'000'000;
constexpr std::int64_t look_interval_ns = 500'000;

void pause() noexcept {
  sleep_until_monotonic(monotonic_ns() + look_interval_ns);
}

std::string folder_of_this_program() {
  std::array<char, 4096> path{};
  const ssize_t size = readlink("/proc/self/exe", path.data(), path.size());
  const std::string file(path.data(), size > 0 ? static_cast<std::size_t>(size) : 0);
  return file.substr(0, file.rfind('/'));
}

std::string guard_program() {
  const std::string folder = folder_of_this_program();
  for (const char* const place : {"/ghostforce-guard", "/../" GHOSTFORCE_GUARD_FOLDER "/ghostforce-guard"}) {
    if (access((folder + place).c_str(), X_OK) == 0) return folder + place;
  }
  return {};
}

void close_file(int& descriptor) noexcept {
  if (descriptor >= 0) close(std::exchange(descriptor, -1));
}

// A copy that is out of the way of the numbers that the guard expects its files at.
int moved_up(int descriptor) noexcept {
  return fcntl(descriptor, F_DUPFD_CLOEXEC, 16);
}

}  // namespace

bool MotorGuard::start(int descriptor, const std::string& node, const GuardOrders& orders, bool may_push) noexcept {
  end();
  if (descriptor < 0) return false;
  int page_file = memfd_create("ghostforce-guard", MFD_CLOEXEC);
  void* memory = MAP_FAILED;
  if (page_file >= 0 && ftruncate(page_file, sizeof(GuardMemory)) == 0) {
    memory = mmap(nullptr, sizeof(GuardMemory), PROT_READ | PROT_WRITE, MAP_SHARED, page_file, 0);
  }
  bool is_started = false;
  if (memory != MAP_FAILED) {
    page_ = new (memory) GuardMemory{};
    page_->orders = orders;
    set_may_push(may_push, monotonic_ns());
    is_started = spawn(descriptor, node, page_file) && wait_until_it_watches();
  }
  close_file(page_file);
  if (!is_started) end();
  return is_started;
}

bool MotorGuard::spawn(int descriptor, const std::string& node, int page_file) noexcept {
  std::array<int, 2> lifeline{-1, -1};
  if (pipe2(lifeline.data(), O_CLOEXEC) != 0) return false;
  lifeline_ = lifeline[1];
  int device = moved_up(descriptor);
  int page = moved_up(page_file);
  int end_of_lifeline = moved_up(lifeline[0]);
  close_file(lifeline[0]);

  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  for (const int standard : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    posix_spawn_file_actions_addopen(&files, standard, "/dev/null", O_RDWR, 0);
  }
  posix_spawn_file_actions_adddup2(&files, device, guard_call::device_descriptor);
  posix_spawn_file_actions_adddup2(&files, page, guard_call::page_descriptor);
  posix_spawn_file_actions_adddup2(&files, end_of_lifeline, guard_call::lifeline_descriptor);
  // A session of its own: what is sent to a terminal's processes, or to this one's group, does not reach it.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSID);

  int error = ENOENT;
  try {
    std::string program = guard_program();
    std::string file = node;
    char* const words[] = {program.data(), file.data(), nullptr};
    const bool has_files = device >= 0 && page >= 0 && end_of_lifeline >= 0;
    if (has_files && !program.empty())
      error = posix_spawn(&process_, program.c_str(), &files, &attributes, words, environ);
  } catch (const std::exception&) {  // out of memory
  }
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  for (int* const file : {&device, &page, &end_of_lifeline}) close_file(*file);
  if (error != 0) process_ = -1;
  if (error == 0) process_file_ = static_cast<int>(syscall(SYS_pidfd_open, process_, 0));
  return error == 0;
}

bool MotorGuard::wait_until_it_watches() noexcept {
  const std::int64_t deadline_ns = monotonic_ns() + start_patience_ns;
  while (monotonic_ns() < deadline_ns) {
    beat(monotonic_ns());  // this program lives, however long the guard takes to begin
    if (state() != GuardState::none) return true;
    if (waitpid(process_, nullptr, WNOHANG) == process_) {
      process_ = -1;
      return false;
    }
    pause();
  }
  return false;
}

void MotorGuard::end(bool are_stopped) noexcept {
  if (page_ != nullptr && are_stopped) page_->has_ended.store(true, std::memory_order_release);
  close_file(lifeline_);  // wakes it
  close_file(process_file_);
  has_gone_ = false;
  if (process_ > 0) {
    const std::int64_t deadline_ns = monotonic_ns() + end_patience_ns;
    pid_t ended = 0;
    while ((ended = waitpid(process_, nullptr, WNOHANG)) == 0 && monotonic_ns() < deadline_ns) pause();
    if (ended == 0) {
      kill(process_, SIGKILL);
      waitpid(process_, nullptr, 0);
    }
    process_ = -1;
  }
  if (page_ != nullptr) munmap(std::exchange(page_, nullptr), sizeof(GuardMemory));
}

}  // namespace ghostforce
