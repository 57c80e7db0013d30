// The ticks of a run put right while they are read: a damaged time makes a tick of its own, in the midst of others that
// go on without it. Looks two ticks back, so it holds no more than that. Any one thread.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <utility>

#include "app/files/run_reader.h"

namespace ghostforce {

class TickOrder {
 public:
  explicit TickOrder(std::function<void(const RunTick&)> hand_on) : hand_on_(std::move(hand_on)) {}

  // In the file's order.
  void take(const RunTick& tick);
  // There are no more.
  void end();

  std::size_t left_out() const noexcept { return left_out_; }

 private:
  void settle_newest(const RunTick* next);

  std::function<void(const RunTick&)> hand_on_;
  std::optional<RunTick> kept_;    // sound, but rows of the same tick may still come
  std::optional<RunTick> newest_;  // nobody knows yet
  std::size_t left_out_ = 0;
};

}  // namespace ghostforce
