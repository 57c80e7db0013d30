#include "device/virtual_falcon/virtual_link.h"

#include <algorithm>
#include <limits>

#include "device/input/monotonic_clock.h"
#include "device/motors/guard_memory.h"

namespace ghostforce {
namespace {

// Who has not looked for longer finds that nothing has happened meanwhile.
constexpr std::int64_t longest_gap_ns = 1'000'000'000;
constexpr std::int64_t longest_sleep_ns = 10'000'000;

constexpr std::uint64_t emergency_stop_ordered = std::uint64_t{1} << 48U;

constexpr std::uint8_t line_errors = 0x0E;  // overrun, parity, framing, of the second status byte

}  // namespace

VirtualLink::VirtualLink(const Options& options) noexcept
    : clock_(options.clock),
      lived_ns_(now_ns()),
      injected_faults_(options.injected_fault),
      link_fault_(options.injected_fault.link),
      dsp_(options.device, lived_ns_),
      arm_(options.arm),
      hand_(options.hand, lived_ns_) {
  dsp_.inject(options.injected_fault);
  dsp_.set_encoders(arm_.encoders());
}

LinkFault VirtualLink::open() noexcept {
  close();
  live_until(now_ns());
  // A cable that was pulled out is, to whoever looks for the device, none.
  fault_ = link_fault_ == LinkFault::unplugged ? LinkFault::absent : link_fault_;
  if (fault_ != LinkFault::none) return fault_;
  counters_ = {};
  modem_status_ = 0;
  incoming_.clear();
  was_open_ = true;
  is_open_ = true;
  may_push_ = false;
  beat_ns_ = now_ns();
  owes_stop_ = false;
  return fault_;
}

void VirtualLink::close() noexcept {
  settle_stop();
  is_open_ = false;
  sending_ = Sending::nothing;
}

bool VirtualLink::request(const VendorRequest& request) noexcept {
  if (!is_live() || is_sending()) return false;
  request_ = request;
  sending_ = Sending::request;
  delivery_ns_ = now_ns() + transfer_ns;
  return true;
}

bool VirtualLink::write(std::span<const std::uint8_t> bytes) noexcept {
  if (!is_live() || is_sending() || bytes.size() > outgoing_.size()) return false;
  std::ranges::copy(bytes, outgoing_.begin());
  outgoing_size_ = bytes.size();
  sending_ = Sending::bytes;
  delivery_ns_ = now_ns() + transfer_ns;
  return true;
}

void VirtualLink::stop(std::span<const std::uint8_t> bytes) noexcept {
  if (bytes.size() > outgoing_.size()) return;
  std::ranges::copy(bytes, outgoing_.begin());
  outgoing_size_ = bytes.size();
  owes_stop_ = true;
  if (!is_live()) return;
  sending_ = Sending::bytes;
  delivery_ns_ = now_ns() + transfer_ns;
}

// What is on its way arrives before the link closes.
void VirtualLink::settle_stop() noexcept {
  if (!is_live() || !owes_stop_) return;
  dsp_.receive(std::span{outgoing_}.first(outgoing_size_), now_ns());
  owes_stop_ = false;
}

std::size_t VirtualLink::read(std::span<std::uint8_t> into) noexcept {
  const std::size_t count = std::min(into.size(), incoming_.size());
  for (std::uint8_t& byte : into.first(count)) byte = incoming_.pop();
  return count;
}

std::int64_t VirtualLink::now_ns() const noexcept {
  return clock_ == Clock::stepped ? stepped_ns_ : monotonic_ns();
}

void VirtualLink::wait_until(std::int64_t deadline_ns) noexcept {
  for (;;) {
    const std::int64_t now = now_ns();
    const bool has_news = live_until(now);
    beat_ns_ = now;
    if (has_news || now >= deadline_ns) return;
    const std::int64_t until_ns = std::min({deadline_ns, next_event_ns(), now + longest_sleep_ns});
    if (clock_ == Clock::monotonic) {
      sleep_until_monotonic(until_ns);
    } else {
      stepped_ns_ = std::max(stepped_ns_, until_ns);
    }
  }
}

void VirtualLink::send_at_once(std::span<const std::uint8_t> bytes) noexcept {
  if (!is_open_) return;
  FrameReader<CommandFrame> reader;
  const auto frame = reader.take(bytes);
  if (!frame) return;
  std::uint64_t packed = emergency_stop_ordered;
  for (std::size_t i = 0; i < frame->motors.size(); ++i) {
    packed |= std::uint64_t{static_cast<std::uint16_t>(frame->motors[i])} << (16 * i);
  }
  emergency_stop_ = packed;
}

MotorNumbers VirtualLink::motors() const noexcept {
  const std::uint64_t packed = emergency_stop_;
  if ((packed & emergency_stop_ordered) == 0) return dsp_.motors();
  MotorNumbers numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    numbers[i] = static_cast<std::int16_t>(static_cast<std::uint16_t>(packed >> (16 * i)));
  }
  return numbers;
}

// In the order in which things happen. Returns whether there is something that a waiting driver wants to know.
bool VirtualLink::live_until(std::int64_t now_ns) noexcept {
  lived_ns_ = std::max(lived_ns_, now_ns - longest_gap_ns);
  bool has_news = obey_injected_fault();
  while (lived_ns_ + step_ns <= now_ns) {
    has_news |= exchange_until(lived_ns_ + step_ns);
    step_to(lived_ns_ + step_ns);
    guard_motors();
  }
  has_news |= exchange_until(now_ns);
  return has_news;
}

bool VirtualLink::obey_injected_fault() noexcept {
  if (!injected_faults_.has_news()) return false;
  const InjectedFault& wrong = injected_faults_.latest();
  dsp_.inject(wrong);
  link_fault_ = wrong.link;
  if (!is_live() || !wrong.is_off_the_cable()) return false;
  fault_ = LinkFault::unplugged;
  sending_ = Sending::nothing;
  return true;
}

bool VirtualLink::exchange_until(std::int64_t at_ns) noexcept {
  bool has_news = false;
  while (is_live()) {
    const std::int64_t event = next_event_ns();
    if (event > at_ns) break;
    // What has been due since before the link was opened happens now.
    const std::int64_t now = std::max(event, lived_ns_);
    has_news |= is_sending() && delivery_ns_ <= now ? deliver(now) : take_packet(now);
  }
  return has_news;
}

bool VirtualLink::deliver(std::int64_t at_ns) noexcept {
  if (sending_ == Sending::request) {
    dsp_.control(request_, at_ns);
  } else {
    if (dsp_.room() < outgoing_size_) {
      // The chip cannot take it yet; USB asks again.
      dsp_.advance(at_ns);
      delivery_ns_ = at_ns + transfer_ns;
      return false;
    }
    dsp_.receive(std::span{outgoing_}.first(outgoing_size_), at_ns);
    counters_.bytes_out += outgoing_size_;
  }
  sending_ = Sending::nothing;
  owes_stop_ = false;
  return true;
}

bool VirtualLink::take_packet(std::int64_t at_ns) noexcept {
  std::array<std::uint8_t, FalconDsp::packet_size> packet{};
  const std::size_t size = dsp_.take_packet(packet, at_ns);
  if (size == 0) return false;
  ++counters_.packets_in;
  modem_status_ = packet[0];
  if ((packet[1] & line_errors) != 0) ++counters_.line_errors;
  const auto payload = std::span{packet}.first(size).subspan(FalconDsp::status_size);
  if (payload.empty()) {
    ++counters_.status_packets;
    return false;
  }
  counters_.bytes_in += payload.size();
  for (const std::uint8_t byte : payload) {
    if (incoming_.room() == 0) {
      incoming_.pop();
      ++counters_.discarded_bytes;
    }
    incoming_.push(byte);
  }
  return true;
}

void VirtualLink::step_to(std::int64_t at_ns) noexcept {
  constexpr double seconds_per_ns = 1e-9;
  dsp_.advance(at_ns);
  hand_.advance(at_ns, dsp_.wants_homing());
  arm_.step(static_cast<double>(at_ns - lived_ns_) * seconds_per_ns, motors(), hand_.goal(), hand_.stiffness(),
            hand_.load());
  dsp_.set_encoders(arm_.encoders());
  dsp_.set_buttons(hand_.buttons());
  lived_ns_ = at_ns;
}

void VirtualLink::guard_motors() noexcept {
  if (!is_live() || guard_action(false, may_push_, beat_ns_, false, lived_ns_) != GuardAction::stop_motors) return;
  dsp_.receive(stop_frames(), lived_ns_);
  may_push_ = false;
  sending_ = Sending::nothing;
  fault_ = LinkFault::overruled;
}

std::int64_t VirtualLink::next_event_ns() const noexcept {
  if (!is_live()) return std::numeric_limits<std::int64_t>::max();
  return is_sending() ? std::min(dsp_.next_due_ns(), delivery_ns_) : dsp_.next_due_ns();
}

}  // namespace ghostforce
