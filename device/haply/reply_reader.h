// ReplyReader: takes hAPI's replies out of a stream of bytes, whatever lies between them. A reply has no mark but the
// address that it begins with: nine bytes count as one where that leaves two finite angles of a size that a counter can
// have. What comes before is passed over and counted. A plain value; never allocates or throws; any one thread.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "device/haply/hapi.h"

namespace ghostforce {

class ReplyReader {
 public:
  // No arm turns farther from where it was set up, and few misread bytes make so small a number [degrees].
  static constexpr double greatest_angle_deg = 1000.0;

  // The oldest reply that has come and was not taken, by port [degrees]. `bytes`: what has come since.
  std::optional<hapi::PerPort<double>> take(std::span<const std::uint8_t> bytes) noexcept {
    for (const std::uint8_t byte : bytes) {
      if (held_ == bytes_.size()) pass_over(1);
      bytes_[held_++] = byte;
    }
    while (held_ >= hapi::reply_size) {
      const auto angles = hapi::decode_reply(std::span(bytes_).first(hapi::reply_size));
      if (angles && std::ranges::all_of(*angles, [](double a) { return std::abs(a) <= greatest_angle_deg; })) {
        drop(hapi::reply_size);
        return angles;
      }
      pass_over(1);
    }
    return std::nullopt;
  }

  // All that has come since the last reply is the address, once or more often: how a board answers that is not set up for
  // it.
  bool holds_address_alone() const noexcept {
    const auto held = std::span(bytes_).first(held_);
    return held_ > 0 && std::ranges::all_of(held, [](std::uint8_t byte) { return byte == hapi::address; });
  }

  // Something has come since the last reply, and is no whole one.
  bool holds_bytes() const noexcept { return held_ > 0; }

  // The rest of a reply will not come.
  void reset() noexcept { pass_over(held_); }

  std::uint64_t discarded_bytes() const noexcept { return discarded_; }

 private:
  void drop(std::size_t count) noexcept {
    std::copy(bytes_.begin() + static_cast<std::ptrdiff_t>(count), bytes_.begin() + static_cast<std::ptrdiff_t>(held_),
              bytes_.begin());
    held_ -= count;
  }
  void pass_over(std::size_t count) noexcept {
    discarded_ += count;
    drop(count);
  }

  std::array<std::uint8_t, 8 * hapi::reply_size> bytes_{};
  std::size_t held_ = 0;
  std::uint64_t discarded_ = 0;
};

}  // namespace ghostforce
