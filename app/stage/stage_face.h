// StageFace: the stage in the window. Takes the pointer, moves what moves by itself, and composes the picture. It edits
// the session and knows neither servo nor file. Between ImGui's NewFrame and Render, UI thread.
#pragma once

#include <memory>

#include "app/stage/guess_game.h"
#include "app/stage/idle_show.h"
#include "app/stage/sentence_widths.h"
#include "app/stage/stage.h"
#include "app/stage/stage_content.h"
#include "app/stage/stage_pointer.h"
#include "app/stage/stage_transition.h"
#include "app/stage/view_follower.h"
#include "app/state/action.h"

namespace ghostforce {

class StageFace {
 public:
  // The pointer on the picture of the frame before, in an ImGui window that covers it; then time goes on.
  // `has_keys`: a key was pressed in this frame.
  void update(Session& session, const ActionSink& apply, const StageFrame& frame, bool has_keys, double interval_s);

  // The picture of now.
  const StagePicture& compose(const Session& session, const StageFrame& frame, double interval_s);

  // That of the last frame.
  const StagePicture& picture() const noexcept { return picture_; }

  // The picture of now for who only watches, in a window of another size, where labels have places of their own. On the
  // workbench, too.
  Pane pane_apart(const Session& session, const StageFrame& frame, LabelMemory& memory, double interval_s) const;

  // The same for a file: nothing fades in, and nobody can take hold of anything.
  StagePicture still(const Session& session, const StageFrame& frame) const;

  // The same for those who do not look, on the workbench too; the stage's show for passers-by is not for them.
  StageReading reading(const Session& session, const StageFrame& frame) const;

  // Time goes on, whether a frame is drawn or not: left alone for long enough, the stage begins to move.
  void advance(double interval_s) noexcept { show_.advance(interval_s); }

  // Something moves by itself, and wants to be drawn.
  bool is_moving() const noexcept;

 private:
  // What the content refers to.
  struct Shown {
    Settings settings;
    StageMoment moment;
  };
  StageBlend blend_of(const StageFrame& frame) const;
  Shown live_in(const Session& session, const StageFrame& frame, const StageBlend& blend) const;
  Shown shown_in(const Session& session, const StageFrame& frame) const;
  StageContent content_of(const Session& session, const StageFrame& frame, const Shown& shown) const;
  void follow_session(const Session& session, const StageFrame& frame);
  void follow_handle(const MotorReport& motors, double interval_s) noexcept;
  bool handle_is_unknown(const StageFrame& frame) const noexcept;

  static constexpr double patience_s = 0.3;

  StagePicture picture_;
  double unknown_s_ = patience_s;  // since when nobody knows where the handle of a device is [s]
  LabelMemory memory_;
  SentenceWidths widths_;
  StageTransition transition_{StrategyId::full};
  GuessGame guess_;
  IdleShow show_;
  StagePointer pointer_;
  std::shared_ptr<const Scene> scene_;  // that the transition is in
  ViewFollower view_;
  bool has_rest_ = true;    // under the hand of the last frame
  Settings seen_settings_;  // of the last frame
  Vector<2> seen_goal_{0.0};
};

}  // namespace ghostforce
