#include "device/virtual_haply/virtual_port.h"

#include <algorithm>
#include <limits>

#include "device/input/monotonic_clock.h"
#include "device/motors/guard_memory.h"

namespace ghostforce {
namespace {

constexpr std::int64_t longest_port_sleep_ns = 10'000'000;

// By when a board that does nothing else has obeyed.
constexpr std::int64_t obeying_ns = 2 * HaplyBoard::pass_ns;

constexpr std::uint8_t exchange_command = 2;

bool is_zero_exchange(std::span<const std::uint8_t> packet) noexcept {
  return packet.size() >= 2 && packet[0] == exchange_command &&
         std::ranges::all_of(packet.subspan(2), [](std::uint8_t byte) { return byte == 0; });
}

}  // namespace

VirtualPort::VirtualPort(const Options& options) noexcept
    : clock_(options.clock),
      lived_ns_(now_ns()),
      bench_(options.device, lived_ns_),
      link_fault_(options.device.fault.link) {}

LinkFault VirtualPort::open() noexcept {
  close();
  live_until(now_ns());
  // A cable that was pulled out is, to whoever looks for the device, none.
  const bool is_gone = has_vanished_ || link_fault_ == LinkFault::unplugged;
  fault_ = is_gone ? LinkFault::absent : link_fault_;
  if (fault_ != LinkFault::none) return fault_;
  incoming_.clear();
  was_open_ = true;
  is_open_ = true;
  may_push_ = false;
  beat_ns_ = now_ns();
  return fault_;
}

void VirtualPort::close() noexcept {
  if (is_live()) {
    live_until(now_ns());
    while (!outgoing_.empty()) {
      const Packet packet = outgoing_.pop();
      bench_.receive(std::span{packet.bytes}.first(packet.size), now_ns());
    }
    has_vanished_ |= bench_.fault().touched_at_1200_baud;
    if (has_vanished_) bench_.lose_cable();
  }
  is_open_ = false;
  outgoing_.clear();
}

bool VirtualPort::write(std::span<const std::uint8_t> packet) noexcept {
  if (!is_live() || packet.empty() || packet.size() > most_bytes || outgoing_.room() == 0) return false;
  if (at_once_ != AtOnce::nothing && !is_zero_exchange(packet)) return false;
  Packet sent;
  sent.arrival_ns = (outgoing_.empty() ? now_ns() : std::max(now_ns(), outgoing_.back().arrival_ns)) + transfer_ns;
  sent.size = packet.size();
  std::ranges::copy(packet, sent.bytes.begin());
  if (packet.size() > 1) last_address_ = packet[1];
  return outgoing_.push(sent);
}

std::size_t VirtualPort::read(std::span<std::uint8_t> into) noexcept {
  const std::size_t count = std::min(into.size(), incoming_.size());
  for (std::uint8_t& byte : into.first(count)) byte = incoming_.pop();
  return count;
}

// Also what has come in since somebody last looked.
void VirtualPort::discard_input() noexcept {
  live_until(now_ns());
  incoming_.clear();
}

std::int64_t VirtualPort::now_ns() const noexcept {
  return clock_ == Clock::stepped ? stepped_ns_ : monotonic_ns();
}

void VirtualPort::wait_until(std::int64_t deadline_ns) noexcept {
  for (;;) {
    const std::int64_t now = now_ns();
    const bool has_news = live_until(now);
    beat_ns_ = now;
    if (has_news || now >= deadline_ns) return;
    const std::int64_t until_ns = std::min({deadline_ns, next_event_ns(), now + longest_port_sleep_ns});
    if (clock_ == Clock::monotonic) {
      sleep_until_monotonic(until_ns);
    } else {
      stepped_ns_ = std::max(stepped_ns_, until_ns);
    }
  }
}

void VirtualPort::write_at_once(std::span<const std::uint8_t> packet) noexcept {
  if (!is_open_ || packet.size() > most_bytes) return;
  AtOnce before = AtOnce::nothing;
  if (!at_once_.compare_exchange_strong(before, AtOnce::being_written)) return;
  packet_at_once_.size = packet.size();
  std::copy(packet.begin(), packet.end(), packet_at_once_.bytes.begin());
  at_once_ = AtOnce::ready;
}

HaplyTruth VirtualPort::truth() const noexcept {
  if (at_once_ != AtOnce::ready) return bench_.truth();
  HaplyBoard board = bench_.board();
  const std::int64_t at_ns = now_ns();
  board.receive(std::span{packet_at_once_.bytes}.first(packet_at_once_.size), at_ns);
  board.run_until(at_ns + obeying_ns);
  return bench_.truth_with(board);
}

// In the order in which things happen. Returns whether there is something that a waiting driver wants to know.
bool VirtualPort::live_until(std::int64_t now_ns) noexcept {
  bool has_news = obey_injected_fault();
  while (lived_ns_ + HaplyBench::step_ns <= now_ns) {
    // Who has been away for long finds that nothing has happened meanwhile; so does the bench.
    lived_ns_ = std::max(lived_ns_ + HaplyBench::step_ns, now_ns - 1'000'000'000);
    has_news |= exchange_until(lived_ns_);
    guard_motors();
  }
  has_news |= exchange_until(now_ns);
  return has_news;
}

bool VirtualPort::obey_injected_fault() noexcept {
  if (!bench_.obey_injected_fault()) return false;
  const InjectedHaplyFault& wrong = bench_.fault();
  link_fault_ = wrong.link;
  if (!wrong.touched_at_1200_baud) has_vanished_ = false;
  if (!wrong.is_off_the_cable()) return false;
  bench_.lose_cable();
  outgoing_.clear();
  if (!is_live()) return false;
  fault_ = LinkFault::unplugged;
  return true;
}

// What was sent on the way to `at_ns` arrives when it does.
bool VirtualPort::exchange_until(std::int64_t at_ns) noexcept {
  bool has_news = false;
  if (is_live() && at_once_ == AtOnce::ready) {
    bench_.receive(std::span{packet_at_once_.bytes}.first(packet_at_once_.size), lived_ns_);
    at_once_ = AtOnce::gone;
  }
  while (!outgoing_.empty() && outgoing_.front().arrival_ns <= at_ns) {
    const Packet packet = outgoing_.pop();
    bench_.receive(std::span{packet.bytes}.first(packet.size), packet.arrival_ns);
    has_news = true;
  }
  bench_.live_until(at_ns);
  has_news |= take_in(at_ns);
  return has_news;
}

bool VirtualPort::take_in(std::int64_t now_ns) noexcept {
  bool has_news = false;
  std::array<std::uint8_t, HaplyBench::most_bytes> packet{};
  for (std::size_t size = 0; (size = bench_.take(packet, now_ns)) > 0;) {
    if (!is_live()) continue;  // nobody listens
    has_news = true;
    for (const std::uint8_t byte : std::span{packet}.first(size)) {
      if (incoming_.room() == 0) incoming_.pop();
      incoming_.push(byte);
    }
  }
  return has_news;
}

void VirtualPort::guard_motors() noexcept {
  if (!is_live() || guard_action(false, may_push_, beat_ns_, false, lived_ns_) != GuardAction::stop_motors) return;
  outgoing_.clear();
  bench_.receive(std::array<std::uint8_t, 10>{exchange_command, last_address_}, lived_ns_);
  may_push_ = false;
  fault_ = LinkFault::overruled;
}

std::int64_t VirtualPort::next_event_ns() const noexcept {
  if (!is_live()) return std::numeric_limits<std::int64_t>::max();
  return outgoing_.empty() ? bench_.next_event_ns() : std::min(bench_.next_event_ns(), outgoing_.front().arrival_ns);
}

}  // namespace ghostforce
