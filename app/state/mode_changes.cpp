#include "app/state/mode_changes.h"

#include "app/state/stiffness_probe_guide.h"
#include "core/scene_shape.h"
#include "device/report/input_choice.h"

namespace ghostforce {

void begin_stage_mode(Session& session, StageMode mode) {
  leave_stage_mode(session);
  StageChoice& stage = session.stage;
  stage.mode = mode;
  if (mode != StageMode::ribbon) stage.looks_back_to_s.reset();
  if (mode == StageMode::why) stage.why_step = 1;
  if (mode == StageMode::round) begin_circle_test(session);
  if (mode == StageMode::landscape) session.fits_view = true;  // on all of a workspace
}

void leave_stage_mode(Session& session) {
  StageChoice& stage = session.stage;
  const bool goes_round = session.circle_test.is_on || session.wanted_input == circling_hand.name;
  if (stage.mode == StageMode::round && goes_round) end_circle_test(session);
  if (stage.mode == StageMode::ribbon) stage.looks_back_to_s.reset();
  if (stage.mode == StageMode::measure) session.stiffness_probe = {};
  // Wall and hand may be others now.
  if (stage.mode == StageMode::landscape) session.fits_view = true;
  stage.mode = StageMode::none;
  stage.why_step = 0;
  stage.guess.reset();
  stage.landscape_dial.reset();
}

void leave_stage(Session& session) {
  const std::optional<double> looks_back_to_s = session.stage.looks_back_to_s;
  leave_stage_mode(session);
  session.stage.looks_back_to_s = looks_back_to_s;
}

void choose_strategy(Session& session, StrategyId id, bool slowly) {
  session.settings.active = id;
  session.stage.is_black = false;
  session.stage.switches_slowly = slowly;
  session.stage.landscape_dial.reset();
}

StrategyId strategy_of_dial(double dial) noexcept {
  return dial < 0.5 ? StrategyId::naive : StrategyId::anisotropic;
}

std::optional<double> dragged_landscape_dial(const Session& session) noexcept {
  const std::optional<double>& dial = session.stage.landscape_dial;
  return dial && strategy_of_dial(*dial) == session.settings.active ? dial : std::nullopt;
}

void begin_circle_test(Session& session) {
  if (session.circle_test.is_on) {
    session.wanted_input.reset();  // which would end it, where one lesson follows another
    return;
  }
  session.circle_test.input_before = session.input;
  session.wanted_input = circling_hand.name;
}

void end_circle_test(Session& session) {
  session.wanted_input = session.circle_test.input_before;
}

Circle circle_of(const Session& session) noexcept {
  return circle_inside(wall_near(session.settings, session.goal), session.goal, session.circle_test.choice);
}

}  // namespace ghostforce
