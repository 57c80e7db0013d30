#include "device/falcon_measurement/bench.h"

#include <algorithm>
#include <array>
#include <span>

#include "device/falcon/emergency_stop.h"

namespace ghostforce {
namespace {

constexpr std::int64_t ns_of(double seconds) noexcept {
  return static_cast<std::int64_t>(seconds * 1e9);
}

// After this, replies to what was given up no longer come.
constexpr double flush_s = 1e-3 * Falcon::flush_ms;

}  // namespace

FalconBench::FalconBench(FalconLink& link) noexcept : link_(link), next_ns_(0) {
  forget_replies();
  next_ns_ = link_.now_ns();
}

void FalconBench::wait_until(std::int64_t deadline_ns) noexcept {
  while (link_.now_ns() < deadline_ns && link_.fault() == LinkFault::none) link_.wait_until(deadline_ns);
}

void FalconBench::forget_replies() noexcept {
  wait_until(link_.now_ns() + ns_of(flush_s));
  std::array<std::uint8_t, 64> bytes;
  while (link_.read(bytes) > 0) {
  }
  reader_.reset();
}

std::optional<ReplyFrame> FalconBench::ask(const CommandFrame& command) noexcept {
  const std::int64_t began_ns = link_.now_ns();
  const std::int64_t deadline_ns = began_ns + ns_of(longest_exchange_s);
  const FrameBytes bytes = encode(emergency_stop::is_ordered() ? CommandFrame{} : command);
  bool has_sent = false;
  std::array<std::uint8_t, 64> heard;
  while (link_.fault() == LinkFault::none) {
    has_sent = has_sent || link_.write(bytes);
    while (const std::size_t count = link_.read(heard)) {
      if (const auto reply = reader_.take(std::span(heard).first(count)); reply && has_sent) {
        last_exchange_s_ = static_cast<double>(link_.now_ns() - began_ns) * 1e-9;
        return reply;
      }
    }
    if (link_.now_ns() >= deadline_ns) break;
    link_.wait_until(deadline_ns);
  }
  last_exchange_s_ = static_cast<double>(link_.now_ns() - began_ns) * 1e-9;
  return std::nullopt;
}

std::optional<ReplyFrame> FalconBench::exchange(const CommandFrame& command) noexcept {
  const auto reply = ask(command);
  if (!reply) {
    // It may hear and only not be heard.
    link_.stop(stop_frames());
    forget_replies();
    next_ns_ = link_.now_ns();
    return std::nullopt;
  }
  next_ns_ = std::max(next_ns_ + ns_of(period_s), link_.now_ns());
  wait_until(next_ns_);
  return reply;
}

bool FalconBench::stop() noexcept {
  constexpr int tries = 6;
  constexpr int enough = 3;
  int heard = 0;
  for (int i = 0; i < tries && heard < enough && link_.fault() == LinkFault::none; ++i) {
    if (ask(CommandFrame{})) ++heard;
  }
  if (heard < enough) link_.stop(stop_frames());
  next_ns_ = link_.now_ns();
  return heard == enough;
}

void FalconBench::be_silent(double seconds) noexcept {
  wait_until(link_.now_ns() + ns_of(seconds));
  next_ns_ = link_.now_ns();
}

}  // namespace ghostforce
