// What armed_program does when it is told to obey: it goes on as a window does, tells each change of its motors' and
// its device's state in a line, and takes orders on its standard input, a line each. Its main thread.
#pragma once

#include <poll.h>
#include <unistd.h>

#include <chrono>
#include <cinttypes>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>
#include <thread>

#include "core/safety.h"
#include "device/falcon/falcon_report.h"
#include "device/input/monotonic_clock.h"
#include "device/report/motor_report.h"

namespace ghostforce {

class Orders {
 public:
  // The next one, if there is one; "end" when nobody can give any more.
  std::optional<std::string> next() {
    pollfd wait{STDIN_FILENO, POLLIN, 0};
    if (heard_.find('\n') == std::string::npos && poll(&wait, 1, 0) > 0) {
      char piece[256];
      const ssize_t count = ::read(STDIN_FILENO, piece, sizeof piece);
      if (count <= 0) return "end";
      heard_.append(piece, static_cast<std::size_t>(count));
    }
    const std::size_t end = heard_.find('\n');
    if (end == std::string::npos) return std::nullopt;
    const std::string order = heard_.substr(0, end);
    heard_.erase(0, end + 1);
    return order;
  }

 private:
  std::string heard_;
};

// As a line: "state", the time in ns of CLOCK_MONOTONIC, then SafetyState, OffReason, FalconState and FalconFault by
// name, whether the device may still push, and whether it is fast enough.
class ToldState {
 public:
  void tell(const MotorReport& motors, const FalconReport& device) {
    std::string state;
    for (const std::string_view word :
         {name_of(motors.state), entry_of(motors.reason).name, name_of(device.state), entry_of(device.fault).name,
          std::string_view(device.may_still_push ? "may push" : "cannot push"),
          std::string_view(device.is_fast_enough() ? "fast" : "slow")}) {
      state += '\t';
      state += word;
    }
    if (state == told_) return;
    told_ = state;
    std::printf("state\t%" PRId64 "%s\n", monotonic_ns(), state.c_str());
    std::fflush(stdout);
  }

 private:
  std::string told_;
};

// Returns when it is told to end; throws when interrupted.
template <typename Person>
void obey_orders(Person& person) {
  Orders orders;
  ToldState told;
  for (;;) {
    person.live();
    told.tell(person.motors(), person.input().report());
    const std::optional<std::string> order = orders.next();
    if (!order) continue;
    if (*order == "end") return;
    if (*order == "arm") person.arm_and_lean_in();
    if (*order == "ask for motors") person.ask_for_motors();
    if (*order == "off") ++person.command().offs_asked;  // as Esc does
    if (*order == "focus lost") person.command().has_focus = false;
    if (*order == "focus") person.command().has_focus = true;
    if (*order == "hang") std::this_thread::sleep_for(std::chrono::milliseconds(1500));
  }
}

}  // namespace ghostforce
