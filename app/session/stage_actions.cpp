#include "app/session/stage_actions.h"

#include <algorithm>
#include <array>

#include "app/session/front_keys.h"
#include "app/session/hand_burst_guide.h"
#include "app/session/lesson_guide.h"
#include "app/session/measurement_guide.h"
#include "app/session/motor_button.h"
#include "app/session/visit.h"

namespace ghostforce {
namespace {

template <StrategyId id>
void show_strategy(Session& session) {
  leave_stage_mode(session);
  choose_strategy(session, id, true);
}

template <int step>
void show_why(Session& session) {
  if (session.stage.mode != StageMode::why) begin_stage_mode(session, StageMode::why);
  session.stage.why_step = step;
}

template <StageMode mode>
void show_mode(Session& session) {
  if (session.stage.mode != mode) begin_stage_mode(session, mode);
}

// From the wall as it should be to the cure, and where it matters.
constexpr std::array<void (*)(Session&), 9> talk{show_strategy<StrategyId::full>,
                                                 show_strategy<StrategyId::naive>,
                                                 show_why<1>,
                                                 show_why<2>,
                                                 show_why<3>,
                                                 show_why<4>,
                                                 show_strategy<StrategyId::anisotropic>,
                                                 show_mode<StageMode::landscape>,
                                                 show_mode<StageMode::round>};

void obey(Session& session, StageCommand command, const MotorReport& motors) {
  switch (command) {
    case StageCommand::keys:
      session.dialog = Dialog::help;
      return;
    case StageCommand::link:
      session.requests.show_link = true;
      return;
    case StageCommand::motors:
      if (can_press_safety_button(motors)) press_safety_button(session, motors);
      return;
    case StageCommand::lessons:
      session.dialog = Dialog::lessons;
      return;
    case StageCommand::previous:
      return previous_talk_step(session);
    case StageCommand::next:
      return confirm_on_stage(session);
    case StageCommand::leave:
      return leave_lesson(session);
    case StageCommand::language:
      return switch_to_next_language(session);
    case StageCommand::measure:
      return press_hand_burst(session);
    case StageCommand::slider:  // is dragged
      return;
  }
}

void go_to_talk_step(Session& session, int step) {
  if (step < 0 || step >= static_cast<int>(talk.size())) return;
  show_face(session, Face::stage);
  session.stage.is_black = false;
  session.stage.talk_step = step;
  talk[static_cast<std::size_t>(step)](session);
}

}  // namespace

void show_face(Session& session, Face face) {
  if (session.lesson) return;
  if (face == Face::workbench) leave_stage_mode(session);
  session.face = face;
}

void toggle_stage_mode(Session& session, StageMode mode) {
  if (session.lesson) return;
  // It would show what a blind measurement hides.
  if (mode == StageMode::measure && (is_measuring(session) || hides_answer(session))) {
    session.notice = Notice{"First finish or cancel “Measure the hand” on the workbench.", false, 0.0};
    return;
  }
  show_face(session, Face::stage);
  session.stage.is_black = false;
  if (session.stage.mode == mode) {
    leave_stage_mode(session);
  } else {
    begin_stage_mode(session, mode);
    // A lesson waits until its button is pressed.
    if (mode == StageMode::measure) start_hand_burst(session);
  }
}

void choose_strategy(Session& session, StrategyId id, bool slowly) {
  if (!is_allowed(session, LessonControl::strategies)) return;
  session.settings.active = id;
  session.stage.is_black = false;
  session.stage.switches_slowly = slowly;
  session.stage.landscape_dial.reset();
}

void act_on_stage(Session& session, const StageAction& action, const MotorReport& motors) {
  if (const auto* const id = std::get_if<StrategyId>(&action)) {
    choose_strategy(session, *id, false);
  } else if (const auto* const mode = std::get_if<StageMode>(&action)) {
    toggle_stage_mode(session, *mode);
  } else if (const auto* const face = std::get_if<Face>(&action)) {
    show_face(session, *face);
  } else if (const auto* const answer = std::get_if<StageAnswer>(&action)) {
    answer_in_lesson(session, static_cast<std::size_t>(*answer));
  } else if (const auto* const command = std::get_if<StageCommand>(&action)) {
    obey(session, *command, motors);
  }
}

void confirm_on_stage(Session& session) {
  if (session.lesson) return confirm_in_lesson(session);
  StageChoice& stage = session.stage;
  const bool is_in_wall = depth(wall_of(session.settings), session.goal) > 0.0;
  if (stage.mode == StageMode::predict && is_in_wall) ++stage.reveals_asked;
  if (stage.mode == StageMode::measure) press_hand_burst(session);
  if (stage.mode == StageMode::why) stage.why_step = std::min(stage.why_step + 1, last_why_step);
}

void next_talk_step(Session& session) {
  if (session.lesson) return next_lesson_step(session);
  // Who has come to Why? by its key goes on there.
  const bool is_in_why = session.stage.mode == StageMode::why && session.stage.why_step < last_why_step;
  if (is_in_why && !session.stage.talk_step) return confirm_on_stage(session);
  go_to_talk_step(session, session.stage.talk_step.value_or(-1) + 1);
}

void previous_talk_step(Session& session) {
  if (session.lesson) return previous_lesson_step(session);
  go_to_talk_step(session, session.stage.talk_step.value_or(0) - 1);
}

std::size_t talk_length() noexcept {
  return talk.size();
}

StageKeys stage_keys() noexcept {
  const FrontKeys& keys = front_keys();
  return {.lessons = keys.lessons.shown, .help = keys.help.shown, .link = keys.link.shown};
}

}  // namespace ghostforce
