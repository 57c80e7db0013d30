// TwoBoards: a port to two simulated boards, of which one is open at a time, on one clock that only waiting moves. A
// board keeps its duties while its cable is out: its motors have a supply of their own. For tests. One thread.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "device/motors/stop_debts.h"
#include "device/virtual_haply/virtual_port.h"

namespace ghostforce {

struct SimulatedBoard {
  static constexpr std::int64_t never_ns = std::numeric_limits<std::int64_t>::max();

  explicit SimulatedBoard(std::string_view number) : serial(number) {}

  void unplug() {
    InjectedHaplyFault out;
    out.link = LinkFault::unplugged;
    port.inject(out);
    is_plugged = false;
  }
  void plug() {
    port.inject({});
    is_plugged = true;
  }
  bool pushes() const { return port.duties() != std::array{0.0, 0.0}; }

  std::string serial;
  bool is_plugged = true;
  bool is_busy = false;               // another program has it
  std::int64_t return_ns = never_ns;  // when it is plugged in by itself
  int times_opened = 0;
  std::vector<std::vector<std::uint8_t>> packets{};  // that were written to it
  VirtualPort port{{.clock = VirtualPort::Clock::stepped}};
};

class TwoBoards final : public SerialPort {
 public:
  // `named`: the one that a person has named; null: whichever is the only one there, or the one that was in use.
  TwoBoards(SimulatedBoard& a, SimulatedBoard& b, const SimulatedBoard* named) : boards_{&a, &b}, named_(named) {}
  ~TwoBoards() override { close(); }

  bool waits_to_open() const noexcept override { return false; }
  LinkFault open() noexcept override { return open_first({}); }
  LinkFault open_first(const StopDebts& owed) noexcept override {
    close();
    SimulatedBoard* const chosen = choose(owed);
    if (chosen == nullptr) return fault_ = LinkFault::absent;
    if (chosen->is_busy) return fault_ = LinkFault::busy;
    ++chosen->times_opened;
    open_ = chosen;
    if (!owed.has(device_serial_of(chosen->serial))) in_use_ = chosen;
    serial_ = chosen->serial;
    return fault_ = chosen->port.open();
  }
  bool is_any_plugged_in(const StopDebts& owed) const noexcept override {
    ++looks;
    return debtor(owed) != nullptr;
  }
  void close() noexcept override {
    if (open_ != nullptr) open_->port.close();
    open_ = nullptr;
  }
  LinkFault fault() const noexcept override { return open_ != nullptr ? open_->port.fault() : fault_; }
  std::string_view serial() const noexcept override { return serial_; }
  void set_may_push(bool may_push) noexcept override {
    if (open_ != nullptr) open_->port.set_may_push(may_push);
  }
  std::int64_t now_ns() const noexcept override { return boards_[0]->port.now_ns(); }

  bool write(std::span<const std::uint8_t> packet) noexcept override {
    if (open_ == nullptr || !open_->port.write(packet)) return false;
    open_->packets.emplace_back(packet.begin(), packet.end());
    return true;
  }
  std::size_t read(std::span<std::uint8_t> into) noexcept override {
    return open_ != nullptr ? open_->port.read(into) : 0;
  }
  void discard_input() noexcept override {
    if (open_ != nullptr) open_->port.discard_input();
  }
  void write_at_once(std::span<const std::uint8_t> packet) noexcept override {
    if (open_ != nullptr) open_->port.write_at_once(packet);
  }

  // What is open says when it is over; the others live until then.
  void wait_until(std::int64_t deadline_ns) noexcept override {
    if (open_ != nullptr) {
      open_->port.wait_until(deadline_ns);
      deadline_ns = open_->port.now_ns();
    }
    for (SimulatedBoard* const board : boards_) {
      if (board != open_) board->port.wait_until(deadline_ns);
      if (deadline_ns < board->return_ns) continue;
      board->return_ns = SimulatedBoard::never_ns;
      board->plug();
    }
  }

  mutable int looks = 0;  // for boards that are owed a stop

 private:
  SimulatedBoard* debtor(const StopDebts& owed) const {
    SimulatedBoard* first = nullptr;
    std::size_t first_place = StopDebts::most;
    for (SimulatedBoard* const board : boards_) {
      const std::size_t place = owed.place_of(device_serial_of(board->serial));
      if (!board->is_plugged || place >= first_place) continue;
      first = board;
      first_place = place;
    }
    return first;
  }
  SimulatedBoard* choose(const StopDebts& owed) const {
    if (SimulatedBoard* const first = debtor(owed)) {
      StopDebts others = owed;
      others.remove(device_serial_of(first->serial));
      SimulatedBoard* const second = first->is_busy ? debtor(others) : nullptr;
      return second != nullptr ? second : first;
    }
    std::vector<SimulatedBoard*> there;
    for (SimulatedBoard* const board : boards_) {
      if (board->is_plugged && (named_ == nullptr || board == named_)) there.push_back(board);
    }
    if (there.size() > 1) std::erase_if(there, [this](const SimulatedBoard* each) { return each != in_use_; });
    return there.empty() ? nullptr : there.front();
  }

  std::array<SimulatedBoard*, 2> boards_;
  const SimulatedBoard* named_;
  SimulatedBoard* open_ = nullptr;
  SimulatedBoard* in_use_ = nullptr;  // the last one that was opened for more than a stop that it was owed
  std::string serial_;
  LinkFault fault_ = LinkFault::absent;
};

}  // namespace ghostforce
