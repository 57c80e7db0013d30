// TtyPort: the SerialPort over a terminal device of the system: a microcontroller's own USB port (/dev/ttyACM0), or one
// end of a pseudo terminal.
//
// A packet goes out in a single call, because the kernel then sends it as one packet of USB, and in bytes that nobody
// changes on the way. The baud rate means nothing to such a board save two, which are never set: 1200 restarts it into
// its boot loader, and 0 hangs up. DTR stays up when the port is closed: a board without it falls silent.
//
// open() allocates and starts a guard; afterwards nothing here allocates. What has come in must be read: wait_until() does
// not wait while there is any.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "device/guard/motor_guard.h"
#include "device/haply/serial_port.h"
#include "device/haply_serial/port_search.h"
#include "device/input/monotonic_clock.h"
#include "device/motors/stop_debts.h"

namespace ghostforce {

struct TtyPortOptions {
  // Of the port, or of a link to it; empty: that of the only known board, or of several the one that was in use.
  std::string path{};
  bool is_guarded = true;     // false: a simulated board in this process, whose motors end with it
  SerialPortPlaces places{};  // where it looks for boards and their serial numbers
};

class TtyPort final : public SerialPort {
 public:
  explicit TtyPort(TtyPortOptions options = {}) : options_(std::move(options)) {}
  ~TtyPort() override { close(); }

  bool waits_to_open() const noexcept override { return true; }
  LinkFault open() noexcept override { return open_first({}); }
  LinkFault open_first(const StopDebts& owed) noexcept override;
  bool is_any_plugged_in(const StopDebts& owed) const noexcept override;
  void close() noexcept override;
  LinkFault fault() const noexcept override { return fault_; }
  // SerialPortFound::identity(); of a port that is not on USB, the path by which it is named.
  std::string_view serial() const noexcept override { return serial_; }

  bool is_guarded() const noexcept override { return !options_.is_guarded || guard_.is_watching(monotonic_ns()); }
  void set_may_push(bool may_push) noexcept override;

  // Zeros for both motors also go out after a fault, as long as the port is there: at worst they are not needed. After
  // the emergency stop there are only those and set ups.
  bool write(std::span<const std::uint8_t> packet) noexcept override;
  std::size_t read(std::span<std::uint8_t> into) noexcept override;
  void discard_input() noexcept override;

  std::int64_t now_ns() const noexcept override { return monotonic_ns(); }
  void wait_until(std::int64_t deadline_ns) noexcept override;
  void write_at_once(std::span<const std::uint8_t> packet) noexcept override;

 private:
  LinkFault take_one(const StopDebts& owed);
  LinkFault take(const std::string& node, const std::string& serial, bool is_owed);
  void start_guard(const std::string& node) noexcept;
  bool is_overruled() const noexcept { return guard_.state() > GuardState::watching; }
  void heed_guard() noexcept;
  bool has_gone() const noexcept { return descriptor_ < 0 || fault_ == LinkFault::unplugged; }
  bool await_input(std::int64_t longest_ns) noexcept;
  bool insist_on_stop(std::int64_t deadline_ns) noexcept;
  bool is_still_port(int file) const noexcept;
  bool empty_output(std::int64_t deadline_ns) noexcept;  // whether all of it has gone
  void failed(int error) noexcept;
  void set_fault(LinkFault fault) noexcept;

  TtyPortOptions options_;
  MotorGuard guard_;
  LinkFault fault_ = LinkFault::absent;
  std::string serial_;
  std::string in_use_;          // the number of the last one that was opened for more than a stop that it was owed
  std::string set_up_in_vain_;  // the number of the one that was set up in closing, and has answered no zero since
  bool may_push_ = false;
  dev_t device_ = 0;  // of the port that was opened

  // -1: not open.
  std::atomic<int> descriptor_{-1};
  std::atomic<bool> is_writing_at_once_{false};
  static_assert(std::atomic<int>::is_always_lock_free && std::atomic<bool>::is_always_lock_free,
                "a signal handler may touch nothing else");
};

}  // namespace ghostforce
