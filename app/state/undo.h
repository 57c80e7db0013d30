// Undo: every change of a setting or of the hand's goal can be taken back, and the opening of another scene too. A drag
// is one change, and so are all the key presses that move the goal between two others. UI thread.
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "app/state/faces_and_modes.h"
#include "app/state/measurement.h"
#include "app/state/stage_language.h"
#include "core/scene.h"

namespace ghostforce {

// What undo goes back to.
struct UndoState {
  std::shared_ptr<const Scene> scene;
  Settings settings;
  BeliefSource belief_source = BeliefSource::typed;
  Vector<2> goal{0.0};          // [m]
  bool goal_is_chosen = false;  // by the person: no input moves it
  // How the scene stood on the screen. To change this is no step, but it comes back together with another scene.
  SceneView view{};
  Face face = Face::stage;
  StageMode mode = StageMode::none;

  bool has_same_settings_as(const UndoState& other) const {
    return scene == other.scene && belief_source == other.belief_source &&
           chosen_settings(settings, belief_source) == chosen_settings(other.settings, other.belief_source);
  }
  bool has_same_goal_as(const UndoState& other) const {
    return !goal_is_chosen || !other.goal_is_chosen || goal == other.goal;
  }
  bool is_same_step_as(const UndoState& other) const { return has_same_settings_as(other) && has_same_goal_as(other); }
};

class UndoHistory {
 public:
  static constexpr std::size_t most_steps = 500;

  explicit UndoHistory(UndoState present) : present_(std::move(present)) {}

  // Once per frame: what the person sees now. While something is held, its change is not complete.
  void note(const UndoState& now, bool is_held) {
    was_held_ = was_held_ || is_held;
    if (is_held) return;
    const bool was_held = std::exchange(was_held_, false);
    if (now.is_same_step_as(present_)) {
      present_ = now;
      return;
    }
    const bool is_nudge = !was_held && now.has_same_settings_as(present_);
    if (!is_nudge || !ends_in_nudge_) past_.push_back(std::move(present_));
    if (past_.size() > most_steps) past_.pop_front();
    future_.clear();
    present_ = now;
    ends_in_nudge_ = is_nudge;
  }

  // What undo() and redo() would go to; null where there is nothing.
  const UndoState* before() const noexcept { return past_.empty() ? nullptr : &past_.back(); }
  const UndoState* after() const noexcept { return future_.empty() ? nullptr : &future_.back(); }
  const UndoState& present() const noexcept { return present_; }

  // What to go back or forward to; empty when there is nothing.
  std::optional<UndoState> undo() { return step(past_, future_); }
  std::optional<UndoState> redo() { return step(future_, past_); }

 private:
  std::optional<UndoState> step(std::deque<UndoState>& from, std::deque<UndoState>& to) {
    if (from.empty()) return std::nullopt;
    ends_in_nudge_ = false;
    to.push_back(std::move(present_));
    present_ = std::move(from.back());
    from.pop_back();
    return present_;
  }

  std::deque<UndoState> past_;
  UndoState present_;
  std::deque<UndoState> future_;
  bool was_held_ = false;       // since the last complete change
  bool ends_in_nudge_ = false;  // the last change was the goal's, by keys: the next press belongs to it
};

// What a step of undo changes, in words for the button that takes it: "k_r", "the strategy and the wall's angle",
// "opening “A wall at 45 degrees”"; never empty.
std::string words_of_change(const UndoState& before, const UndoState& after);
// The same in the words of the stage.
std::string words_of_change(const UndoState& before, const UndoState& after, const StageLanguage& language);

}  // namespace ghostforce
