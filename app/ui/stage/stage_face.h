// StageFace: the stage in the window: takes the pointer, moves what moves by itself (a switch of the strategy, the answer
// to a guess, the show for nobody), and composes the picture. It edits the session and knows neither servo nor file.
// Between ImGui's NewFrame and Render, UI thread.
#pragma once

#include <optional>
#include <vector>

#include "app/session/session.h"
#include "app/view/moment_history.h"
#include "app/view/shown_moment.h"
#include "app/view/stage/stage.h"
#include "app/view/stage/stage_attract.h"
#include "app/view/stage/stage_transition.h"

namespace ghostforce {

// What the stage is drawn from, and onto what.
struct StageFrame {
  const ShownMoment& shown;
  const MomentHistory& moments;
  const LoopReading& loop;
  const Theme& theme;
  const MeasureText& measure;
  Vector<2> size;  // of the window [points]
  double scale;    // UI scale
};

class StageFace {
 public:
  // The pointer on the picture of the frame before, in an ImGui window that covers it; then time goes on.
  void update(Session& session, const StageFrame& frame, double interval_s);

  // The picture of now.
  const StagePicture& compose(const Session& session, const StageFrame& frame, double interval_s);

  // Without anything that moves, and without what is for a person: as for a file.
  static StagePicture compose_still(const Session& session, const StageFrame& frame);

  // Something moves by itself, and wants to be drawn.
  bool is_moving(const Session& session) const noexcept;

 private:
  enum class Hold : std::uint8_t { nothing, goal, motor, wall, picture, guess, landscape_ring, landscape_dial, ribbon };

  void take_pointer(Session& session, const StageFrame& frame);
  void begin(Session& session, const StageFrame& frame, const Vector<2>& pointer);
  void drag(Session& session, const StageFrame& frame, const Vector<2>& pointer);
  void turn(double& angle, const Vector<2>& pivot, const Vector<2>& pointer, double period);
  void follow_strategy(const Session& session, const StageFrame& frame);
  void follow_guess(Session& session, double interval_s);
  void follow_idleness(const Session& session, const StageFrame& frame, double interval_s);
  StageMoment moment_of(const Session& session, const StageFrame& frame) const;

  StagePicture picture_;
  StageLabelMemory memory_;
  StageTransition transition_{StrategyId::full};
  bool has_begun_ = false;
  std::shared_ptr<const Scene> scene_;

  Hold hold_ = Hold::nothing;
  StageGrip hovered_grip_ = StageGrip::none;
  std::optional<StageAction> hovered_;
  Vector<2> began_at_{0.0};
  Vector<2> last_{0.0};
  double began_angle_ = 0.0;
  bool has_turned_ = false;

  // The answer to a guess, while it is being shown.
  std::uint32_t reveals_ = 0;
  std::optional<double> reveal_s_;
  StageGuess guess_;
  Settings guessed_settings_;
  Vector<2> guessed_goal_{0.0};

  // Nobody is there.
  double idle_s_ = 0.0;
  double show_s_ = 0.0;
  double show_strength_ = 0.0;
  Settings idle_settings_;
  Vector<2> idle_goal_{0.0};
};

}  // namespace ghostforce
