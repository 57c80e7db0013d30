#include "device/falcon/conversation.h"

#include <array>

namespace ghostforce {
namespace {

constexpr std::uint8_t clear_to_send = 0x10;  // of the chip's first status byte

void forget_everything(FalconLink& link) noexcept {
  std::array<std::uint8_t, 64> bytes;
  while (link.read(bytes) > 0) {
  }
}

}  // namespace

Progress Conversation::attend(FalconLink& link) noexcept {
  while (at_ < steps_.size()) {
    const ConversationStep& step = steps_[at_];
    if (!has_begun_) {
      const std::span bytes(reinterpret_cast<const std::uint8_t*>(step.bytes.data()), step.bytes.size());
      if (step.kind == ConversationStep::Kind::request && !link.request(step.asked)) return Progress::running;
      if (step.kind == ConversationStep::Kind::say && !link.write(bytes)) return Progress::running;
      if (step.kind == ConversationStep::Kind::forget) forget_everything(link);
      has_begun_ = true;
      began_ns_ = link.now_ns();
      heard_ = 0;
    }
    const Progress progress = pursue(step, link);
    if (progress != Progress::done) return progress;
    has_begun_ = false;
    attempts_ = 0;
    ++at_;
  }
  return Progress::done;
}

Progress Conversation::pursue(const ConversationStep& step, FalconLink& link) noexcept {
  const bool is_over = link.now_ns() - began_ns_ >= std::int64_t{step.duration_ms} * 1'000'000;
  const auto done_if = [](bool is_done) { return is_done ? Progress::done : Progress::running; };
  switch (step.kind) {
    case ConversationStep::Kind::request:
      return link.is_sending() ? Progress::running : pursue_request(link);
    case ConversationStep::Kind::say:
      return done_if(!link.is_sending());
    case ConversationStep::Kind::hear:
      return hears(step.bytes, link) ? Progress::done : is_over ? Progress::failed : Progress::running;
    case ConversationStep::Kind::settle:
      return done_if(is_over);
    case ConversationStep::Kind::await_clear_to_send:
      return done_if(is_over || (link.modem_status() & clear_to_send) != 0);
    case ConversationStep::Kind::forget:
      return Progress::done;
  }
  return Progress::done;
}

Progress Conversation::pursue_request(const FalconLink& link) noexcept {
  const RequestOutcome outcome = link.request_outcome();
  if (outcome == RequestOutcome::done) return Progress::done;
  if (++attempts_ < request_attempts) {
    has_begun_ = false;
    return Progress::running;
  }
  was_refused_ |= outcome == RequestOutcome::refused;
  return outcome == RequestOutcome::refused ? Progress::done : Progress::failed;
}

// None of the answers that there are repeats its own beginning before its end, so that a byte that does not fit can
// only be the beginning of another try.
bool Conversation::hears(std::string_view bytes, FalconLink& link) noexcept {
  std::array<std::uint8_t, 1> one;
  while (heard_ < bytes.size() && link.read(one) == 1) {
    if (one[0] != static_cast<std::uint8_t>(bytes[heard_])) heard_ = 0;
    if (one[0] == static_cast<std::uint8_t>(bytes[heard_])) ++heard_;
  }
  return heard_ == bytes.size();
}

}  // namespace ghostforce
