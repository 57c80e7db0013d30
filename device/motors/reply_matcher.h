// ReplyMatcher: which command a reply belongs to, where neither carries a number. A plain value; never allocates, throws
// or waits; any one thread. Times in ns on one clock.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace ghostforce {

// When a reply is lost, the next could be taken for it, and a late one for a fresh one. So replies are matched with
// commands in their order, and a command that is given up keeps its place: its reply may still come. A reply that is late
// then never looks younger than it is; after a loss it looks one exchange older. Once replies are fresh again, a pause
// shows whether the one that was given up comes after all.
class ReplyMatcher {
 public:
  // Commands that may be asked again without an answer to any of them.
  static constexpr std::size_t most_given_up = 3;
  // A command is given up after this. Two of them fit into the 20 ms after which motors go off.
  static constexpr std::int64_t patience_ns = 6'000'000;
  // Of the pause, and how fresh a reply must be to begin it: together less than those 20 ms.
  static constexpr std::int64_t pause_ns = 12'000'000;
  static constexpr std::int64_t fresh_ns = 5'000'000;

  void reset() noexcept { *this = {}; }

  // The newest command has no reply yet.
  bool is_waiting() const noexcept { return unanswered_ > given_up_; }

  // No command is without a reply, the ones that were given up included.
  bool is_clear() const noexcept { return unanswered_ == 0; }

  // Nothing is waited for, neither a reply nor the end of the pause.
  bool may_send(std::int64_t now_ns) noexcept {
    if (is_waiting() || now_ns < pause_until_ns_) return false;
    if (pause_until_ns_ != 0) reset();
    return true;
  }
  // Off does not wait for a reply.
  bool may_send(std::int64_t now_ns, bool ends_force) noexcept { return may_send(now_ns) || ends_force; }

  // The newest command has waited long enough, and asking again leaves no doubt that could not be resolved.
  bool may_ask_again(std::int64_t now_ns) const noexcept {
    return is_waiting() && given_up_ < most_given_up && now_ns - sent_ns_[unanswered_ - 1] >= patience_ns;
  }

  // A command goes out. One that is still waited for is given up.
  void sent(std::int64_t now_ns) noexcept {
    if (unanswered_ == sent_ns_.size()) reset();
    given_up_ = unanswered_;
    sent_ns_[unanswered_++] = now_ns;
    pause_until_ns_ = 0;
  }

  // A reply has come; when the command that it belongs to was sent. Nothing: nobody has asked for it.
  std::optional<std::int64_t> replied(std::int64_t now_ns) noexcept {
    if (unanswered_ == 0) return {};
    const std::int64_t asked_ns = sent_ns_[0];
    for (std::size_t i = 1; i < unanswered_; ++i) sent_ns_[i - 1] = sent_ns_[i];
    --unanswered_;
    if (given_up_ > unanswered_) given_up_ = unanswered_;
    const bool is_in_doubt = given_up_ > 0 && !is_waiting();
    pause_until_ns_ = is_in_doubt && now_ns - asked_ns < fresh_ns ? now_ns + pause_ns : 0;
    return asked_ns;
  }

 private:
  std::array<std::int64_t, most_given_up + 1> sent_ns_{};  // of the commands without a reply, the oldest first
  std::size_t unanswered_ = 0;
  std::size_t given_up_ = 0;         // the older ones of these
  std::int64_t pause_until_ns_ = 0;  // 0: there is none
};

}  // namespace ghostforce
