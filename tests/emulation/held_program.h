// What keeps a program from running, from outside, while others go on; and what keeps the machine busy beside it. For
// the thread that makes them.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <string_view>
#include <vector>

#include "tests/emulation/forked_processes.h"

namespace ghostforce {

enum class ProcessHold : std::uint8_t {
  none,
  stopped,   // by SIGSTOP
  debugged,  // a debugger has stopped each of its threads
  starved,   // real-time processes have every processor; of its servo's priority, so that only a higher one runs
};

// Why it cannot be done here, in words; empty: it can.
std::string_view hold_obstacle(ProcessHold hold);

// Begins at once, if the program still runs. Starving ends by itself after `duration`.
class HeldProgram {
 public:
  HeldProgram(pid_t program, ProcessHold hold, std::chrono::milliseconds duration);
  HeldProgram(const HeldProgram&) = delete;
  HeldProgram& operator=(const HeldProgram&) = delete;
  ~HeldProgram();

 private:
  void debug();
  void starve(std::chrono::milliseconds duration);

  pid_t program_;
  ProcessHold hold_;
  std::vector<pid_t> debugged_;  // its threads
  ForkedProcesses starvers_;
};

// So many processes that do nothing else, as ordinary ones.
class BusyProcesses {
 public:
  explicit BusyProcesses(int count);

 private:
  ForkedProcesses processes_;
};

// This process's threads go ahead of all others, where that is allowed: no load of the machine's makes an emulated
// device slow. Programs must not be started meanwhile; they would inherit it.
class UrgentHere {
 public:
  UrgentHere();
  UrgentHere(const UrgentHere&) = delete;
  UrgentHere& operator=(const UrgentHere&) = delete;
  ~UrgentHere();
};

}  // namespace ghostforce
