// Undo: every change of a setting can be taken back, and the opening of another scene too. A drag of a slider or a
// handle is one change. UI thread.
#pragma once

#include <deque>
#include <memory>
#include <optional>

#include "app/session/belief_source.h"
#include "app/view/stage/face.h"
#include "app/view/stage/stage_mode.h"
#include "core/scene.h"

namespace ghostforce {

// What undo goes back to.
struct Edited {
  std::shared_ptr<const Scene> scene;
  Settings settings;
  BeliefSource belief_source = BeliefSource::typed;
  // How the scene stood on the screen. To change this is no step, but it comes back together with another scene.
  Vector<2> goal{0.0};
  SceneView view{};
  Face face = Face::stage;
  StageMode mode = StageMode::none;

  bool is_same_step_as(const Edited& other) const {
    return scene == other.scene && belief_source == other.belief_source &&
           chosen_settings(settings, belief_source) == chosen_settings(other.settings, other.belief_source);
  }
};

class UndoHistory {
 public:
  static constexpr std::size_t most_steps = 500;

  explicit UndoHistory(Edited present) : present_(std::move(present)) {}

  // Once per frame: what the person sees now. While something is held (`is_editing`) its change is not complete.
  void note(const Edited& now, bool is_editing) {
    if (now.is_same_step_as(present_)) present_ = now;
    if (is_editing || now.is_same_step_as(present_)) return;
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
