// A simulated board with arms and a hand (device/virtual_haply/haply_bench.h) behind a pseudo terminal, in real time on
// a thread of its own, which keeps account of each byte that it is sent and of each moment at which a motor had a duty:
// looking at truth() now and then would miss a force that comes back for a millisecond. The other end is for a
// driver in another process. Made, asked and destroyed on the test's thread. Times in ns of CLOCK_MONOTONIC.
#pragma once

#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <sched.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <span>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "device/haply/hapi.h"
#include "device/input/monotonic_clock.h"
#include "device/virtual_haply/haply_bench.h"
#include "tests/device/haply_serial/pseudo_terminal.h"

namespace ghostforce {

// What a driver sends, taken apart. There is no frame: a packet ends where the next one begins.
class PacketCount {
 public:
  std::uint64_t bytes = 0;
  std::uint64_t set_ups = 0;
  std::uint64_t exchanges = 0;
  std::uint64_t forces = 0;       // exchanges with a torque
  std::uint64_t stray_bytes = 0;  // at which no packet to the driver's address begins
  std::size_t unfinished = 0;     // bytes of a packet whose rest has not come

  void add(std::span<const std::uint8_t> more) {
    bytes += more.size();
    pending_.insert(pending_.end(), more.begin(), more.end());
    std::size_t at = 0;
    while (at < pending_.size()) {
      const std::span<const std::uint8_t> rest = std::span(pending_).subspan(at);
      const std::size_t size = rest[0] == 1 ? hapi::SetUpPacket{}.size() : hapi::ExchangePacket{}.size();
      const bool may_be_one = (rest[0] == 1 || rest[0] == 2) && (rest.size() < 2 || rest[1] == hapi::address);
      if (may_be_one && rest.size() < size) break;
      if (may_be_one) count(rest.first(size));
      if (!may_be_one) ++stray_bytes;
      at += may_be_one ? size : 1;
    }
    pending_.erase(pending_.begin(), pending_.begin() + static_cast<std::ptrdiff_t>(at));
    unfinished = pending_.size();
  }

 private:
  void count(std::span<const std::uint8_t> packet) {
    if (packet[0] == 1) {
      ++set_ups;
      return;
    }
    ++exchanges;
    bool is_force = false;
    for (std::size_t port = 0; port < hapi::motor_count; ++port) {
      std::uint32_t bits = 0;
      for (std::size_t i = 4; i-- > 0;) bits = bits << 8U | packet[2 + 4 * port + i];
      is_force |= std::bit_cast<float>(bits) != 0.0F;
    }
    if (is_force) ++forces;
  }

  std::vector<std::uint8_t> pending_;
};

class ListeningBoard {
 public:
  struct Heard {
    HaplyTruth truth;
    PacketCount packets;
    bool is_open = false;           // somebody has the port
    bool is_in_zero_pose = false;   // the hand holds the arms there
    std::uint64_t pushes = 0;       // how often a duty has come on
    std::int64_t last_push_ns = 0;  // when one stood last
    std::int64_t late_ns = 0;       // by at most so much that is too late: this machine had other things to do

    bool was_left_pushing = false;  // nobody had the port, and a duty stood

    bool has_duty() const { return truth.duties != std::array{0.0, 0.0}; }
  };

  ListeningBoard() : bench_({.starts_in_zero_pose = true}, monotonic_ns()), lived_ns_(monotonic_ns()) {
    const int master = terminal_.far_end();
    fcntl(master, F_SETFL, fcntl(master, F_GETFL) | O_NONBLOCK);
    // A terminal that nobody has opened yet does not say that nobody has it open.
    close(open(terminal_.path().c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC));
    thread_ = std::thread([this] { run(); });
  }
  ~ListeningBoard() {
    is_over_ = true;
    thread_.join();
  }
  ListeningBoard(const ListeningBoard&) = delete;
  ListeningBoard& operator=(const ListeningBoard&) = delete;

  const std::string& port() const { return terminal_.path(); }
  Heard heard() {
    const std::lock_guard lock(mutex_);
    return heard_;
  }
  void lead_hand(const HaplyHandPlan& plan) { bench_.lead_hand(plan); }
  void hold_zero_pose(bool holds) { bench_.hold_zero_pose(holds); }
  void inject(const InjectedHaplyFault& wrong) { bench_.inject(wrong); }

 private:
  static constexpr std::int64_t tick_ns = 200'000;
  static constexpr std::int64_t answer_ns = 1'000'000;  // in which it has done what a packet says

  void run() {
    // A real board has a processor of its own. Where the system grants it, this one comes before a servo, which may be
    // one that never stops, and after the guards.
    const sched_param parameters{.sched_priority = 85};
    pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters);
    for (std::int64_t began_ns = monotonic_ns(); !is_over_;) {
      // What it has just heard may take effect the next time.
      const std::int64_t before_ns = std::exchange(gap_ns_, monotonic_ns() - std::exchange(began_ns, monotonic_ns()));
      longest_gap_ns_ = std::max(before_ns, gap_ns_);
      listen();
      live_until(monotonic_ns());
      speak(monotonic_ns());
      now_.truth = bench_.truth();
      now_.was_left_pushing |= !now_.is_open && now_.has_duty() && lived_ns_ - heard_ns_ > answer_ns;
      now_.is_in_zero_pose = bench_.hand().is_in_zero_pose();
      {
        const std::lock_guard lock(mutex_);
        heard_ = now_;
      }
      const std::int64_t now_ns = monotonic_ns();
      wait_for_host(std::min(now_ns + tick_ns, std::max(now_ns, bench_.next_event_ns())));
    }
  }

  void listen() {
    std::array<std::uint8_t, 510> bytes{};
    // What has piled up on a busy machine came in whole packets, wherever it is cut here: it all comes at one time.
    const std::int64_t now_ns = monotonic_ns();
    live_until(now_ns);
    for (ssize_t size = 0; (size = ::read(terminal_.far_end(), bytes.data(), bytes.size())) > 0;) {
      const auto packet = std::span{bytes}.first(static_cast<std::size_t>(size));
      bench_.receive(packet, now_ns);
      now_.packets.add(packet);
      heard_ns_ = now_ns;
    }
    pollfd host{.fd = terminal_.far_end(), .events = POLLIN, .revents = 0};
    poll(&host, 1, 0);
    // Where it has been closed, what was written before comes first.
    now_.is_open = (host.revents & POLLHUP) == 0 || (host.revents & POLLIN) != 0;
  }

  // In the board's own steps, so that no duty goes unseen.
  void live_until(std::int64_t now_ns) {
    while (lived_ns_ < now_ns) {
      lived_ns_ = std::min(lived_ns_ + HaplyBench::step_ns, now_ns);
      bench_.live_until(lived_ns_);
      const bool has_duty = bench_.truth().duties != std::array{0.0, 0.0};
      if (has_duty && !had_duty_) ++now_.pushes;
      if (!has_duty && had_duty_) now_.late_ns = longest_gap_ns_;
      if (has_duty) now_.last_push_ns = lived_ns_;
      had_duty_ = has_duty;
    }
  }

  void speak(std::int64_t now_ns) {
    std::array<std::uint8_t, HaplyBench::most_bytes> packet{};
    for (std::size_t size = 0; (size = bench_.take(packet, now_ns)) > 0;) {
      // What nobody listens to is lost.
      if (now_.is_open && ::write(terminal_.far_end(), packet.data(), size) < 0) continue;
    }
  }

  void wait_for_host(std::int64_t until_ns) {
    const std::int64_t left_ns = until_ns - monotonic_ns();
    if (left_ns <= 0) return;
    const timespec timeout{.tv_sec = 0, .tv_nsec = left_ns};
    pollfd host{.fd = terminal_.far_end(), .events = POLLIN, .revents = 0};
    ppoll(&host, now_.is_open ? 1 : 0, &timeout, nullptr);
  }

  PseudoTerminal terminal_;
  // The board's thread's.
  HaplyBench bench_;
  Heard now_;
  std::int64_t lived_ns_;
  std::int64_t heard_ns_ = 0;
  std::int64_t gap_ns_ = 0;          // since it listened before
  std::int64_t longest_gap_ns_ = 0;  // of that one and the one before
  bool had_duty_ = false;

  std::mutex mutex_;
  Heard heard_;
  std::atomic<bool> is_over_ = false;
  std::thread thread_;
};

}  // namespace ghostforce
