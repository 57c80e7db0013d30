#include "app/tools/doctor/bench.h"

#include <algorithm>
#include <array>
#include <span>

#include "device/falcon/link_script.h"
#include "device/falcon/link_setup.h"
#include "device/motors/emergency_stop.h"

namespace ghostforce {
namespace {

constexpr std::int64_t ns_of(double seconds) noexcept {
  return static_cast<std::int64_t>(seconds * 1e9);
}

}  // namespace

FalconBench::FalconBench(FalconLink& link) noexcept : link_(link), next_ns_(0) {
  forget_replies();
  next_ns_ = link_.now_ns();
}

void FalconBench::wait_until(std::int64_t deadline_ns) noexcept {
  while (link_.now_ns() < deadline_ns && link_.fault() == LinkFault::none) link_.wait_until(deadline_ns);
}

void FalconBench::forget_replies() noexcept {
  wait_until(link_.now_ns() + ns_of(1e-3 * late_replies_ms));
  std::array<std::uint8_t, 64> bytes;
  while (link_.read(bytes) > 0) {
  }
  reader_.reset();
}

std::optional<ReplyFrame> FalconBench::ask(const CommandFrame& command) noexcept {
  const std::int64_t began_ns = link_.now_ns();
  const std::int64_t deadline_ns = began_ns + ns_of(longest_exchange_s);
  const CommandFrame allowed = emergency_stop::is_ordered() ? CommandFrame{} : command;
  const bool is_zero = allowed.motors == MotorNumbers{};
  const FrameBytes bytes = encode(allowed);
  if (!is_zero) link_.set_may_push(true);
  bool has_sent = false;
  std::optional<ReplyFrame> reply;
  std::array<std::uint8_t, 64> heard;
  while (!reply && link_.fault() == LinkFault::none) {
    if (!has_sent) {
      has_sent = link_.write(bytes);
      may_push_ |= has_sent && !is_zero;
    }
    while (const std::size_t count = link_.read(heard)) {
      if (const auto frame = reader_.take(std::span(heard).first(count)); frame && has_sent) reply = frame;
    }
    if (reply || link_.now_ns() >= deadline_ns) break;
    link_.wait_until(deadline_ns);
  }
  // By the clock as it is now: where this process did not run for a while, a reply has waited and is old.
  const std::int64_t now_ns = link_.now_ns();
  last_exchange_s_ = static_cast<double>(now_ns - began_ns) * 1e-9;
  if (!reply || now_ns > deadline_ns) return std::nullopt;
  if (is_zero) link_.set_may_push(may_push_ = false);
  watched_ns_ = now_ns;
  return reply;
}

std::optional<ReplyFrame> FalconBench::exchange(const CommandFrame& command) noexcept {
  const bool were_left_alone = may_push_ && link_.now_ns() - watched_ns_ > ns_of(longest_exchange_s);
  const auto reply = were_left_alone ? std::nullopt : ask(command);
  if (!reply) {
    recover();
    return std::nullopt;
  }
  next_ns_ = std::max(next_ns_ + ns_of(period_s), link_.now_ns());
  wait_until(next_ns_);
  return reply;
}

// The device may hear and only not be heard, or its chip may have lost the rate. False: it could not be set up again.
bool FalconBench::recover() noexcept {
  LinkScript script(stop_and_set_up_link_again);
  const std::int64_t deadline_ns = link_.now_ns() + ns_of(Falcon::give_up_s);
  // Also through a link that is of no use any more: the stop is the first step.
  LinkProgress progress = script.update(link_);
  while (progress == LinkProgress::running && link_.fault() == LinkFault::none && link_.now_ns() < deadline_ns) {
    link_.wait_until(link_.now_ns() + ns_of(period_s));
    progress = script.update(link_);
  }
  reader_.reset();
  next_ns_ = watched_ns_ = link_.now_ns();
  return progress == LinkProgress::done;
}

bool FalconBench::stop() noexcept {
  constexpr int tries = 6;
  constexpr int enough = 3;
  int heard = 0;
  for (int i = 0; i < tries && heard < enough; ++i) {
    if (ask(CommandFrame{})) {
      ++heard;
    } else if (!recover()) {
      break;
    }
  }
  next_ns_ = link_.now_ns();
  return heard == enough;
}

bool FalconBench::be_silent(double seconds) noexcept {
  const std::int64_t end_ns = link_.now_ns() + ns_of(seconds);
  wait_until(end_ns);
  next_ns_ = watched_ns_ = link_.now_ns();
  if (link_.fault() == LinkFault::none && next_ns_ - end_ns <= ns_of(longest_exchange_s)) return true;
  recover();
  return false;
}

}  // namespace ghostforce
