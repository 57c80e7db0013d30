// AwakeProcessors: keeps the processors of this machine from sleeping. A virtual machine gives an idle processor away
// and gets it back some milliseconds late. A device that is emulated by threads then answers too late for motors to
// come on, and the more so the less else there is to do.
// Its processes run where nothing else wants to. Where a container limits the processor time of all its processes
// together, they take their part of it.
#pragma once

#include <thread>

#include <sched.h>

#include "tests/emulation/forked_processes.h"

namespace ghostforce {

class AwakeProcessors {
 public:
  AwakeProcessors() {
    for (unsigned i = 0; i < std::thread::hardware_concurrency(); ++i) {
      processes_.add([] {
        const sched_param none{};
        // Where that is not allowed, they would take time from others.
        if (sched_setscheduler(0, SCHED_IDLE, &none) != 0) return;
        keep_busy();
      });
    }
  }

 private:
  ForkedProcesses processes_;
};

}  // namespace ghostforce
