#include "device/falcon/link_script.h"

#include "device/falcon/frame.h"

namespace ghostforce {
namespace {

constexpr std::uint8_t clear_to_send = 0x10;  // of the chip's first status byte

void flush(FalconLink& link) noexcept {
  std::array<std::uint8_t, 64> bytes;
  while (link.read(bytes) > 0) {
  }
}

}  // namespace

LinkProgress LinkScript::update(FalconLink& link) noexcept {
  while (at_ < steps_.size()) {
    const LinkScriptStep& step = steps_[at_];
    if (!has_begun_) {
      const std::span bytes(reinterpret_cast<const std::uint8_t*>(step.bytes.data()), step.bytes.size());
      if (step.kind == LinkScriptStep::Kind::request && !link.request(step.asked)) return LinkProgress::running;
      if (step.kind == LinkScriptStep::Kind::send && !link.write(bytes)) return LinkProgress::running;
      if (step.kind == LinkScriptStep::Kind::stop) link.stop(stop_frames());
      if (step.kind == LinkScriptStep::Kind::flush) flush(link);
      has_begun_ = true;
      began_ns_ = link.now_ns();
      received_ = 0;
    }
    const LinkProgress progress = pursue(step, link);
    if (progress != LinkProgress::done) return progress;
    has_begun_ = false;
    attempts_ = 0;
    ++at_;
  }
  return LinkProgress::done;
}

LinkProgress LinkScript::pursue(const LinkScriptStep& step, FalconLink& link) noexcept {
  const bool is_over = link.now_ns() - began_ns_ >= std::int64_t{step.duration_ms} * 1'000'000;
  const auto done_if = [](bool is_done) { return is_done ? LinkProgress::done : LinkProgress::running; };
  switch (step.kind) {
    case LinkScriptStep::Kind::request:
      return link.is_sending() ? LinkProgress::running : pursue_request(link);
    case LinkScriptStep::Kind::send:
      return done_if(!link.is_sending());
    case LinkScriptStep::Kind::expect:
      return receives(step.bytes, link) ? LinkProgress::done : is_over ? LinkProgress::failed : LinkProgress::running;
    case LinkScriptStep::Kind::wait:
      return done_if(is_over);
    case LinkScriptStep::Kind::await_clear_to_send:
      return done_if(is_over || (link.modem_status() & clear_to_send) != 0);
    case LinkScriptStep::Kind::stop:
    case LinkScriptStep::Kind::flush:
      return LinkProgress::done;
  }
  return LinkProgress::done;
}

LinkProgress LinkScript::pursue_request(const FalconLink& link) noexcept {
  const RequestOutcome outcome = link.request_outcome();
  if (outcome == RequestOutcome::done) return LinkProgress::done;
  if (++attempts_ < request_attempts) {
    has_begun_ = false;
    return LinkProgress::running;
  }
  was_refused_ |= outcome == RequestOutcome::refused;
  return outcome == RequestOutcome::refused ? LinkProgress::done : LinkProgress::failed;
}

// None of the answers that there are repeats its own beginning before its end, so that a byte that does not fit can
// only be the beginning of another try.
bool LinkScript::receives(std::string_view bytes, FalconLink& link) noexcept {
  std::array<std::uint8_t, 1> one;
  while (received_ < bytes.size() && link.read(one) == 1) {
    if (one[0] != static_cast<std::uint8_t>(bytes[received_])) received_ = 0;
    if (one[0] == static_cast<std::uint8_t>(bytes[received_])) ++received_;
  }
  return received_ == bytes.size();
}

}  // namespace ghostforce
