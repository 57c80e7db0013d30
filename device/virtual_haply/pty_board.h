// PtyBoard: the simulated device (haply_bench.h) behind a pseudo-terminal, in real time, on a thread of its own: a
// driver in this or another process opens a real terminal device of the system.
//
// What a pseudo-terminal is not: it has no DTR line, no identity on USB and no edges of packets. So the line counts as
// low while the port's speed is 0, which is how a host lowers it by mistake; who looks for boards by what USB says
// finds none; and a write(2) of the host's may reach the board together with the next one. Its speed can be seen,
// though: the board vanishes when a port whose speed is 1200 is closed, whether or not that was asked for as a fault,
// and stays away until the next fault, or none, is injected.
//
// "not-allowed" takes the file's permissions away and "busy" claims it by TIOCEXCL: neither keeps root out, nor whoever
// may do all (CAP_SYS_ADMIN).
//
// Made, asked and destroyed on one thread; lead_hand() and hold_zero_pose() on that one or any other one. Times in ns
// of CLOCK_MONOTONIC.
#pragma once

#include <array>
#include <atomic>
#include <string>
#include <thread>

#include "core/latest_value.h"
#include "device/virtual_haply/haply_bench.h"

namespace ghostforce {

class PtyBoard {
 public:
  struct Options {
    HaplyBench::Options device{};
    // A symbolic link that is to lead to the port, wherever that is, and nowhere while it is unplugged. Whatever is
    // there already must be a symbolic link. Empty: none.
    std::string link{};
  };

  // Nothing on the thread sleeps for longer.
  static constexpr std::int64_t tick_ns = 200'000;

  // Throws std::system_error if there can be no pseudo-terminal, or no link.
  explicit PtyBoard(const Options& options);
  ~PtyBoard();
  PtyBoard(const PtyBoard&) = delete;
  PtyBoard& operator=(const PtyBoard&) = delete;

  // The link, if there is to be one; otherwise the terminal device, which after "unplugged" is a new one. Empty while
  // it is unplugged.
  std::string port();

  void inject(const InjectedHaplyFault& wrong) noexcept { bench_.inject(wrong); }
  void lead_hand(const HaplyHandPlan& plan) noexcept { bench_.lead_hand(plan); }
  void hold_zero_pose(bool holds) noexcept { bench_.hold_zero_pose(holds); }

  // As it was less than a tick or two ago.
  HaplyTruth truth() noexcept { return news_.latest().truth; }
  // Whether somebody has the port open.
  bool is_open() noexcept { return news_.latest().is_open; }

 private:
  using Path = std::array<char, 64>;

  // What other threads may know.
  struct News {
    HaplyTruth truth;
    Path port{};  // ends with a zero; empty: there is none
    bool is_open = false;
  };

  void run() noexcept;
  bool plug_in() noexcept;
  void unplug() noexcept;
  void obey(const InjectedHaplyFault& wrong) noexcept;
  void set_busy(bool is_busy) noexcept;
  void wait_for_host(std::int64_t until_ns) noexcept;
  void listen() noexcept;
  void speak(std::int64_t now_ns) noexcept;
  void note_closed() noexcept;
  bool point_link(const char* target) noexcept;

  std::string link_;
  std::string new_link_;  // beside it: a link is replaced in one go
  HaplyBench bench_;

  int master_ = -1;
  int claim_ = -1;  // the other end, while "another program" has it
  Path slave_{};
  bool is_open_ = false;

  LatestValue<News> news_;
  std::atomic<bool> is_over_ = false;
  std::thread thread_;  // last: it uses the others
};

}  // namespace ghostforce
