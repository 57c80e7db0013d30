// FakeFalcons: a link to any number of Falcons that run their firmware and are homed, with a clock that only waiting
// moves. Motors keep their force until a frame says otherwise, also while the cable is out: they have a supply of their
// own. A chip that was just plugged in or reset is at its own rate, and what USB takes from the host then is noise to
// the device. One thread.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "device/falcon/falcon_link.h"
#include "device/falcon/frame.h"
#include "device/falcon/link_setup.h"
#include "device/motors/stop_debts.h"

namespace ghostforce {

struct FakeFalcon {
  explicit FakeFalcon(std::string serial_number) : serial(std::move(serial_number)) {}

  void reset_chip() {
    rate = ftdi::handshake_rate;
    latency_ms = 16;
  }
  void unplug() { is_plugged = false; }
  void plug() {
    reset_chip();
    is_plugged = true;
  }
  bool pushes() const { return motors != std::array<std::int16_t, 3>{}; }

  std::string serial;
  bool is_plugged = true;
  static constexpr std::int64_t never_ns = std::numeric_limits<std::int64_t>::max();
  std::int64_t return_ns = never_ns;  // when it is plugged in by itself
  std::int64_t reset_ns = never_ns;   // when its chip is reset
  bool is_busy = false;               // another program has it
  bool is_deaf = false;               // the processor; the chip goes on
  bool refuses_latency = false;
  std::int64_t reply_delay_ns = 0;

  VendorRequest rate = ftdi::handshake_rate;
  unsigned latency_ms = 16;
  std::array<std::int16_t, 3> motors{};
  std::uint8_t asked = 0;          // by the newest command: lights, and whether it is to be homed
  std::int64_t last_force_ns = 0;  // when a command ended a force
  int times_opened = 0;
  int noise_bytes = 0;       // that came at another rate
  int latency_requests = 0;  // also those that were refused
  FrameReader<CommandFrame> commands{};
};

class FakeFalcons final : public FalconLink {
 public:
  static constexpr std::int64_t transfer_ns = 60'000;

  // In the order of their serial numbers.
  FakeFalcons(std::vector<FakeFalcon*> falcons, std::int64_t& clock_ns)
      : falcons_(std::move(falcons)), now_ns_(clock_ns) {}

  bool waits_to_open() const noexcept override { return false; }
  LinkFault open() noexcept override { return open_first({}); }
  LinkFault open_first(const StopDebts& owed) noexcept override {
    close();
    FakeFalcon* chosen = nullptr;
    for (FakeFalcon* const falcon : falcons_) {
      if (!falcon->is_plugged) continue;
      const bool comes_first = chosen == nullptr || place_of(*falcon, owed) < place_of(*chosen, owed);
      if (comes_first) chosen = falcon;
    }
    if (chosen == nullptr) return fault_ = LinkFault::absent;
    if (chosen->is_busy) return fault_ = LinkFault::busy;
    ++chosen->times_opened;
    falcon_ = chosen;
    serial_ = chosen->serial;
    opened_ns_ = now_ns_;
    return fault_ = LinkFault::none;
  }
  bool is_any_plugged_in(const StopDebts& owed) const noexcept override {
    return std::ranges::any_of(falcons_, [&](const FakeFalcon* falcon) {
      return falcon->is_plugged && place_of(*falcon, owed) < StopDebts::most;
    });
  }
  void close() noexcept override {
    if (owes_stop()) hear();
    falcon_ = nullptr;
    sending_ = Sending::nothing;
    replies_.clear();
    received_.clear();
  }
  LinkFault fault() const noexcept override {
    return falcon_ != nullptr && !falcon_->is_plugged ? LinkFault::unplugged : fault_;
  }
  std::string_view serial() const noexcept override { return serial_; }

  bool request(const VendorRequest& request) noexcept override {
    if (!is_live() || is_sending()) return false;
    request_ = request;
    begin(Sending::request);
    return true;
  }
  RequestOutcome request_outcome() const noexcept override { return outcome_; }
  bool write(std::span<const std::uint8_t> bytes) noexcept override {
    if (!is_live() || is_sending()) return false;
    outgoing_.assign(bytes.begin(), bytes.end());
    begin(Sending::bytes);
    return true;
  }
  bool is_sending() const noexcept override { return sending_ != Sending::nothing; }
  void stop(std::span<const std::uint8_t> bytes) noexcept override {
    if (!is_live()) return;
    outgoing_.assign(bytes.begin(), bytes.end());
    begin(Sending::stop);
  }
  // The chip takes everything, whether or not the device understands it.
  bool owes_stop() const noexcept override { return is_live() && sending_ == Sending::stop; }

  std::size_t read(std::span<std::uint8_t> into) noexcept override {
    const std::size_t count = std::min(into.size(), received_.size());
    std::copy_n(received_.begin(), count, into.begin());
    received_.erase(received_.begin(), received_.begin() + static_cast<std::ptrdiff_t>(count));
    return count;
  }
  std::uint8_t modem_status() const noexcept override { return 0; }
  LinkCounters counters() const noexcept override {
    return {.packets_in = static_cast<std::uint64_t>(now_ns_ - opened_ns_) / 16'000'000};
  }
  std::int64_t now_ns() const noexcept override { return now_ns_; }

  void wait_until(std::int64_t deadline_ns) noexcept override {
    bool has_news = false;
    while (!has_news) {
      const std::int64_t next_ns = std::min(deadline_ns, next_event_ns());
      now_ns_ = std::max(now_ns_, next_ns);
      do_what_is_due();
      has_news = happen();
      if (now_ns_ >= deadline_ns && !has_news) break;
    }
    if (pause_ns_ == 0) return;
    const std::int64_t end_ns = now_ns_ + std::exchange(pause_ns_, 0);
    for (std::int64_t next_ns = 0; (next_ns = next_event_ns()) <= end_ns;) {
      now_ns_ = std::max(now_ns_, next_ns);
      happen();
    }
    now_ns_ = end_ns;
  }
  void send_at_once(std::span<const std::uint8_t> /*bytes*/) noexcept override {}

  // This process does not run for so long, from the next time that it waits. The devices do.
  void pause(std::int64_t duration_ns) { pause_ns_ = duration_ns; }

 private:
  enum class Sending : std::uint8_t { nothing, request, bytes, stop };
  struct Reply {
    std::int64_t at_ns;
    FrameBytes bytes;
  };

  static std::size_t place_of(const FakeFalcon& falcon, const StopDebts& owed) {
    return owed.place_of(device_serial_of(falcon.serial));
  }
  bool is_live() const { return falcon_ != nullptr && fault() == LinkFault::none; }
  void begin(Sending what) {
    sending_ = what;
    sent_ns_ = now_ns_ + transfer_ns;
  }
  std::int64_t next_event_ns() const {
    std::int64_t next_ns = std::numeric_limits<std::int64_t>::max();
    if (is_live() && is_sending()) next_ns = sent_ns_;
    if (is_live() && !replies_.empty()) next_ns = std::min(next_ns, replies_.front().at_ns);
    return next_ns;
  }
  void do_what_is_due() {
    for (FakeFalcon* const falcon : falcons_) {
      if (now_ns_ >= falcon->return_ns) {
        falcon->return_ns = FakeFalcon::never_ns;
        falcon->plug();
      }
      if (now_ns_ >= falcon->reset_ns) {
        falcon->reset_ns = FakeFalcon::never_ns;
        falcon->reset_chip();
      }
    }
  }
  bool happen() {
    if (!is_live()) return false;
    bool has_news = false;
    if (is_sending() && now_ns_ >= sent_ns_) {
      has_news = true;
      if (std::exchange(sending_, Sending::nothing) == Sending::request) {
        obey();
      } else {
        hear();
      }
    }
    for (; !replies_.empty() && now_ns_ >= replies_.front().at_ns; replies_.pop_front()) {
      received_.insert(received_.end(), replies_.front().bytes.begin(), replies_.front().bytes.end());
      has_news = true;
    }
    return has_news;
  }
  void obey() {
    outcome_ = RequestOutcome::done;
    if (request_.request == ftdi::running_rate.request) falcon_->rate = request_;
    if (request_.request != ftdi::latency(1).request) return;
    ++falcon_->latency_requests;
    if (falcon_->refuses_latency) {
      outcome_ = RequestOutcome::refused;
    } else {
      falcon_->latency_ms = request_.value;
    }
  }
  void hear() {
    if (falcon_->rate != ftdi::running_rate) {
      falcon_->noise_bytes += static_cast<int>(outgoing_.size());
      return;
    }
    if (falcon_->is_deaf) return;
    for (const std::uint8_t byte : outgoing_) {
      const auto command = falcon_->commands.take({&byte, 1});
      if (!command) continue;
      if (falcon_->pushes()) falcon_->last_force_ns = now_ns_;
      falcon_->motors = command->motors;
      falcon_->asked = command->info;
      // What the chip has for the host goes out when its latency timer says so.
      const std::int64_t latency_ns = std::int64_t{falcon_->latency_ms} * 1'000'000;
      const std::int64_t due_ns =
          falcon_->latency_ms <= 1 ? now_ns_ + 400'000 : (now_ns_ / latency_ns + 1) * latency_ns;
      replies_.push_back({due_ns + falcon_->reply_delay_ns, encode(ReplyFrame{.status = ReplyFrame::homed})});
    }
  }

  std::vector<FakeFalcon*> falcons_;
  FakeFalcon* falcon_ = nullptr;  // the one that is open
  std::string serial_;
  LinkFault fault_ = LinkFault::absent;
  std::int64_t& now_ns_;
  std::int64_t opened_ns_ = 0;
  std::int64_t pause_ns_ = 0;
  Sending sending_ = Sending::nothing;
  std::int64_t sent_ns_ = 0;
  VendorRequest request_;
  RequestOutcome outcome_ = RequestOutcome::done;
  std::vector<std::uint8_t> outgoing_;
  std::deque<Reply> replies_;
  std::deque<std::uint8_t> received_;
};

}  // namespace ghostforce
