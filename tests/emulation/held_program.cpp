#include "tests/emulation/held_program.h"

#include <algorithm>
#include <csignal>
#include <cstddef>
#include <filesystem>
#include <string>
#include <system_error>

#include <sched.h>
#include <sys/ptrace.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "device/input/monotonic_clock.h"

namespace ghostforce {
namespace {

// Until the starving processes are all there.
constexpr std::int64_t gathering_ns = 20'000'000;

std::vector<pid_t> threads_of(pid_t process) {
  std::vector<pid_t> threads;
  std::error_code gone;
  for (const auto& task : std::filesystem::directory_iterator("/proc/" + std::to_string(process) + "/task", gone)) {
    threads.push_back(std::stoi(task.path().filename()));
  }
  return threads;
}

bool set_real_time(pid_t thread, int priority) {
  sched_param parameters{};
  parameters.sched_priority = priority;
  return sched_setscheduler(thread, priority > 0 ? SCHED_FIFO : SCHED_OTHER, &parameters) == 0;
}

int real_time_priority(pid_t thread) {
  sched_param parameters{};
  return sched_getparam(thread, &parameters) == 0 ? parameters.sched_priority : 0;
}

}  // namespace

std::string_view hold_obstacle(ProcessHold hold) {
  if (hold != ProcessHold::starved) return "";
  const bool is_allowed = set_real_time(0, sched_get_priority_max(SCHED_FIFO));
  if (is_allowed) set_real_time(0, 0);
  return is_allowed ? "" : "this user may not run real-time processes (SCHED_FIFO)";
}

HeldProgram::HeldProgram(pid_t program, ProcessHold hold, std::chrono::milliseconds duration)
    : program_(program), hold_(hold) {
  if (program <= 0) return;
  if (hold == ProcessHold::stopped) kill(program, SIGSTOP);
  if (hold == ProcessHold::debugged) debug();
  if (hold == ProcessHold::starved) starve(duration);
}

HeldProgram::~HeldProgram() {
  if (program_ > 0 && hold_ == ProcessHold::stopped) kill(program_, SIGCONT);
  for (const pid_t thread : debugged_) ptrace(PTRACE_DETACH, thread, nullptr, nullptr);
}

void HeldProgram::debug() {
  for (const pid_t thread : threads_of(program_)) {
    if (ptrace(PTRACE_SEIZE, thread, nullptr, nullptr) != 0) continue;
    debugged_.push_back(thread);
    ptrace(PTRACE_INTERRUPT, thread, nullptr, nullptr);
  }
  // Whoever waits for the program's end must not be told of this.
  for (const pid_t thread : debugged_) waitpid(thread, nullptr, __WALL);
}

void HeldProgram::starve(std::chrono::milliseconds duration) {
  int priority = 1;
  for (const pid_t thread : threads_of(program_)) priority = std::max(priority, real_time_priority(thread));
  cpu_set_t processors;
  sched_getaffinity(0, sizeof processors, &processors);
  const std::int64_t start_ns = monotonic_ns() + gathering_ns;
  const std::int64_t end_ns = start_ns + duration / std::chrono::nanoseconds(1);
  for (std::size_t processor = 0; processor < CPU_SETSIZE; ++processor) {
    if (!CPU_ISSET(processor, &processors)) continue;
    starvers_.add([=] {
      cpu_set_t one;
      CPU_ZERO(&one);
      CPU_SET(processor, &one);
      sched_setaffinity(0, sizeof one, &one);
      set_real_time(0, priority);
      sleep_until_monotonic(start_ns);
      while (monotonic_ns() < end_ns) {
      }
    });
  }
  sleep_until_monotonic(start_ns);
}

BusyProcesses::BusyProcesses(int count) {
  for (int i = 0; i < count; ++i) {
    processes_.add([] {
      set_real_time(0, 0);
      keep_busy();
    });
  }
}

UrgentHere::UrgentHere() {
  for (const pid_t thread : threads_of(getpid())) set_real_time(thread, sched_get_priority_max(SCHED_FIFO));
}

UrgentHere::~UrgentHere() {
  for (const pid_t thread : threads_of(getpid())) set_real_time(thread, 0);
}

}  // namespace ghostforce
