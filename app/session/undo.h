// Undo: every change of a setting can be taken back, and the opening of another scene too. A drag of a slider or a
// handle is one change. UI thread.
#pragma once

#include <deque>
#include <memory>
#include <optional>

#include "core/scene.h"

namespace ghostforce {

// What undo goes back to.
struct Edited {
  std::shared_ptr<const Scene> scene;
  Settings settings;

  friend bool operator==(const Edited&, const Edited&) = default;
};

class UndoHistory {
 public:
  static constexpr std::size_t most_steps = 500;

  explicit UndoHistory(Edited present) : present_(std::move(present)) {}

  // Once per frame: what the person sees now. While something is held (`is_editing`) its change is not complete.
  void note(const Edited& now, bool is_editing) {
    if (is_editing || now == present_) return;
    past_.push_back(std::move(present_));
    if (past_.size() > most_steps) past_.pop_front();
    future_.clear();
    present_ = now;
  }

  // What undo() and redo() would go to; null where there is nothing.
  const Edited* before() const noexcept { return past_.empty() ? nullptr : &past_.back(); }
  const Edited* after() const noexcept { return future_.empty() ? nullptr : &future_.back(); }
  const Edited& present() const noexcept { return present_; }

  // What to go back or forward to; empty when there is nothing.
  std::optional<Edited> undo() { return step(past_, future_); }
  std::optional<Edited> redo() { return step(future_, past_); }

 private:
  std::optional<Edited> step(std::deque<Edited>& from, std::deque<Edited>& to) {
    if (from.empty()) return std::nullopt;
    to.push_back(std::move(present_));
    present_ = std::move(from.back());
    from.pop_back();
    return present_;
  }

  std::deque<Edited> past_;
  Edited present_;
  std::deque<Edited> future_;
};

}  // namespace ghostforce
