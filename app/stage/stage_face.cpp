#include "app/stage/stage_face.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include <glm/geometric.hpp>

#include "app/stage/hints.h"
#include "app/stage/landscape_layers.h"
#include "app/stage/lesson_content.h"
#include "app/state/front_keys.h"
#include "app/state/kiosk_visit.h"
#include "app/state/lesson_guide.h"
#include "app/state/mode_changes.h"
#include "app/state/permit.h"
#include "app/state/stage_action.h"
#include "app/state/stage_view.h"
#include "app/state/stiffness_probe_guide.h"
#include "app/state/target.h"
#include "core/scene_shape.h"

namespace ghostforce {
namespace {

// A show of rests needs some.
bool rests_everywhere(const Session& session) {
  return !is_general(session.settings) || rest_of(StrategyId::naive, session.settings, session.goal).has_value();
}

// Nothing must take the picture away from who is at work, or who wants it to stand still.
bool may_show_itself(const Session& session, const StageFrame& frame) {
  return !reduces_motion(session) && session.face == Face::stage && (!session.lesson || invites_visitors(session)) &&
         session.stage.mode == StageMode::none && session.dialog == Dialog::none && !session.paused &&
         !session.stage.looks_back_to_s && !session.stage.is_black && !session.notice && !frame.loop.recording.is_on &&
         !frame.loop.motors.has_motors && !frame.shown.snapshot.measured && session.pointer_moves_goal &&
         !session.drags_goal && rests_everywhere(session);
}

// Its picture is not of where the session looks.
bool has_own_view(const StageContent& content) {
  return content.mode == StageMode::round || (content.handle_is_unknown && content.linkage);
}

// All of the circle, and all that comes to rest round it.
SceneView view_of_round(const Settings& settings, const Circle& circle, double reference_force) {
  constexpr int places = 12;
  std::vector<Vector<2>> goals;
  for (int i = 0; i < places; ++i) {
    goals.push_back(position_on(circle, static_cast<double>(i) / places / circle.turns_per_second));
  }
  return stage_view_of(settings, goals, reference_force);
}

// Each only while it is true of the picture; until then it waits.
std::optional<StageHint> stage_hint(const Session& session, const StageMoment& moment, const StageAudience& audience) {
  if (invites_visitors(session) && audience.can_drag) return StageHint::drag;
  const bool is_busy = session.lesson || session.stage.mode != StageMode::none;
  if (is_busy || audience.looks_back || moment.is_measured) return std::nullopt;
  if (points_at(session, HintTarget::goal) && audience.can_drag && !session.drags_goal) return StageHint::drag;
  const bool has_ghost = glm::length(moment.ghost_force) >= least_shown_force;
  if (points_at(session, HintTarget::third_strategy) && has_ghost &&
      moment.weights[index_of(StrategyId::naive)] == 1.0) {
    return StageHint::cure;
  }
  const bool has_one_motor = moment.weights[index_of(StrategyId::full)] == 0.0;
  if (points_at(session, HintTarget::motor_axis) && has_one_motor && session.has_handles &&
      !permit(session, TurnMotorTo{})) {
    return StageHint::motor;
  }
  return std::nullopt;
}

// What there is to do about it; empty: to wait.
std::string_view measuring_words(const Session& session) {
  const StageLanguage::Buttons& all = stage_language(session.language).buttons;
  const StiffnessProbe& probe = session.stiffness_probe;
  if (probe.is_running()) return {};
  if (session.lesson) return probe.stage == StiffnessProbe::Stage::off ? all.measure : all.measure_again_in_lesson;
  return probe.is_known() && !stiffness_probe_is_believed(session) ? all.believe : all.measure_again;
}

// A button of its own where the corner is not free for it.
std::optional<StageMeasuringButton> measuring_button(const Session& session, const MotorReport& motors) {
  const bool has_corner = !session.lesson && !motors.has_motors;
  if (session.stage.mode != StageMode::measure || has_corner) return std::nullopt;
  const StageLanguage::Buttons& all = stage_language(session.language).buttons;
  const std::string_view words = measuring_words(session);
  const std::array each{all.measure, all.measure_again_in_lesson, all.measuring, all.measure_again, all.believe};
  const std::span<const std::string_view> possible =
      session.lesson ? std::span(each).first(3) : std::span(each).subspan(2);
  return StageMeasuringButton{.words = std::string(words.empty() ? all.measuring : words),
                              .longest = std::string(std::ranges::max(possible, {}, &std::string_view::size))};
}

// The motors' comes first; else what there is to do next, or the way back out of a mode.
std::optional<StageCornerButton> corner_button(const Session& session, const MotorReport& motors,
                                               const StageGuess& guess, bool is_revealing) {
  const StageLanguage& language = stage_language(session.language);
  if (motors.has_motors) {
    const bool may_push = motors.state != SafetyState::off || motors.may_still_push;
    return StageCornerButton{StageCommand::motors, motor_words(motors, language), may_push};
  }
  const StageChoice& stage = session.stage;
  if (session.lesson || stage.mode == StageMode::none) return std::nullopt;
  const bool is_in_wall = depth_in_wall(session.settings, session.goal) > 0.0;
  if (stage.mode == StageMode::predict && is_in_wall) {
    const std::string_view words = guess.is_open  ? language.buttons.show_guess
                                   : is_revealing ? language.buttons.skip
                                                  : language.buttons.guess_again;
    return StageCornerButton{StageCommand::next, std::string(words)};
  }
  if (const std::string_view words = measuring_words(session); stage.mode == StageMode::measure && !words.empty()) {
    return StageCornerButton{StageCommand::measure, std::string(words)};
  }
  const bool has_more = session.settings.active != StrategyId::full && stage.why_step < last_why_step;
  if (stage.mode == StageMode::why && has_more && is_in_wall) {
    return StageCornerButton{StageCommand::next, std::string(language.buttons.next_step)};
  }
  return StageCornerButton{stage.mode, std::string(language.buttons.back)};
}

// Only while the mode is on. A lesson's step asks for it when it likes.
std::optional<StageMeasuring> measuring_content(const Session& session) {
  const StiffnessProbe& probe = session.stiffness_probe;
  if (session.stage.mode != StageMode::measure || probe.stage == StiffnessProbe::Stage::off) return std::nullopt;
  std::optional<double> asked;
  if (probe.is_known() && has_open_question(session, LessonQuestion::task)) {
    for (const LessonCondition& condition : lesson_step(*session.lesson).conditions) {
      if (condition.quantity != LessonQuantity::hand) continue;
      const double nearest = std::clamp(probe.estimate.k_u, condition.least, condition.greatest);
      if (nearest != probe.estimate.k_u) asked = nearest;
    }
  }
  return StageMeasuring{.is_running = probe.is_running(),
                        .filled = probe.filled,
                        .why = probe.why,
                        .result = probe.is_known() ? std::optional(probe.estimate) : std::nullopt,
                        .before = probe.before,
                        .is_believed = stiffness_probe_is_believed(session),
                        .asked = asked};
}

StageKeys keys_in(const Session& session) {
  StageKeys keys = stage_keys();
  if (!session.offers_full_screen) keys.full_screen = {};
  return keys;
}

// What the check of the motors has found, and where to read on; empty: nothing.
std::string finding_words(const MotorReport& motors, const StageLanguage::Device& words) {
  if (motors.reason != OffReason::calibration) return {};
  const std::string_view status_key = front_keys().device_status.shown;
  switch (motors.finding.verdict) {
    case MotorVerdict::none:
    case MotorVerdict::right:
      return {};
    case MotorVerdict::wrong_way:
      return filled(words.motor_wrong_way, motors.finding.motor + 1, status_key);
    case MotorVerdict::crossed:
      return filled(words.motors_crossed, status_key);
    case MotorVerdict::silent:
      return filled(words.motor_silent, motors.finding.motor + 1, status_key);
    case MotorVerdict::undecided:
      return std::string(words.motors_undecided);
  }
  return {};
}

// What the hand at the device cannot see in the picture; empty: nothing.
std::string words_about_motors(const MotorReport& motors, const StageLanguage::Device& words) {
  if (!motors.has_motors) return {};
  if (motors.state == SafetyState::off) {
    const bool was_chosen = motors.reason == OffReason::none || motors.reason == OffReason::key;
    return std::string(was_chosen ? std::string_view() : words.motors_went_off);
  }
  if (motors.is_checking || motors.sent == Vector<2>(0.0)) return {};
  constexpr double rest_step_s = 10.0;  // of a number that stands still while it is read
  if (const double heat = std::ranges::max(motors.heat); heat > 1.0) {
    return filled(words.motors_get_hot, rest_step_s * std::ceil(motor_rest_s(heat) / rest_step_s));
  }
  return std::string(motors.motor_is_at_limit ? words.motor_is_at_limit : std::string_view());
}

// What is not as it should be comes before what there is to see.
std::string warning_of(const Session& session, const LoopReading& loop) {
  const StageLanguage::Warnings& words = stage_language(session.language).warnings;
  if (loop.diverged) {
    return std::string(session.face == Face::stage && !session.kiosk_visit ? words.unstable
                                                                           : words.unstable_on_workbench);
  }
  if (loop.motors.may_still_push) {
    return session.kiosk_visit ? std::string(words.motors_may_still_push_for_visitors)
                               : filled(stage_language(session.language).device.motors_may_still_push,
                                        front_keys().device_status.shown);
  }
  const auto step = std::ranges::find_if(loop.readiness, &ReadinessStepState::is_current);
  if (loop.motors.waits_for_zero_pose && !session.kiosk_visit) {
    if (loop.motors.zero_pose_moved) return std::string(stage_language(session.language).device.zero_pose_moved);
    if (loop.motors.reason == OffReason::not_homed)
      return std::string(stage_language(session.language).device.zero_pose_lost);
    return filled(stage_language(session.language).device.zero_pose, front_keys().device_status.shown);
  }
  const std::string finding = finding_words(loop.motors, stage_language(session.language).device);
  if (!finding.empty()) return session.kiosk_visit ? std::string(words.device_not_ready_for_visitors) : finding;
  // Motors that are on have been found ready; arming tells by itself what it waits for.
  const bool is_off = loop.motors.state == SafetyState::off;
  if (loop.motors.has_motors && is_off && !loop.motors.is_ready && step != loop.readiness.end()) {
    return session.kiosk_visit ? std::string(words.device_not_ready_for_visitors)
                               : filled(words.device_not_ready, front_keys().device_status.shown);
  }
  if (loop.motors.state == SafetyState::arming && loop.motors.obstacle != ArmingObstacle::none) {
    const auto& waits = stage_language(session.language).motors.waits;
    return std::string(waits[static_cast<std::size_t>(loop.motors.obstacle) - 1]);
  }
  const bool is_at_work =
      session.lesson || session.stage.mode != StageMode::none || session.stage.looks_back_to_s || session.kiosk_visit;
  std::string about = words_about_motors(loop.motors, stage_language(session.language).device);
  if (!about.empty() && !(is_off && is_at_work)) return about;
  if (session.paused && !session.stage.looks_back_to_s) return std::string(words.paused);
  return {};
}

// What the hand at a device needs to know more than what the moment would have to say; empty: nothing.
std::string remark_of(const Session& session, const StageMoment& moment, const StageFrame& frame) {
  const StageLanguage::Device& words = stage_language(session.language).device;
  const MotorReport& motors = frame.loop.motors;
  if (!motors.has_motors || session.kiosk_visit || session.paused || frame.shown.is_past) return {};
  if (motors.state == SafetyState::off) return std::string(words.motors_are_off);
  if (motors.is_checking) return std::string(words.motors_are_checked);
  const bool is_unknown = moment.is_measured && moment.in_contact && !moment.knows_ghost_force;
  return is_unknown && !moment.has_target ? std::string(words.aim_is_unknown) : std::string();
}

}  // namespace

void StageFace::follow_session(const Session& session, const StageFrame& frame) {
  const bool is_other = std::exchange(scene_, session.scene) != session.scene;
  // What a device shows is what it does.
  if (is_other || frame.shown.snapshot.measured || reduces_motion(session)) {
    transition_.jump_to(session.settings.active);
  } else {
    transition_.go_to(session.settings.active, session.stage.switches_slowly);
  }
}

// Before it has been known once, it is unknown; and of one answer that is late nothing is to be seen.
void StageFace::follow_handle(const MotorReport& motors, double interval_s) noexcept {
  unknown_s_ = !motors.has_motors ? patience_s : motors.is_handle_known ? 0.0 : unknown_s_ + interval_s;
}

bool StageFace::handle_is_unknown(const StageFrame& frame) const noexcept {
  const MotorReport& motors = frame.loop.motors;
  const bool is_unknown = motors.has_motors && !motors.is_handle_known && !frame.shown.is_past;
  return is_unknown && (motors.waits_for_zero_pose || unknown_s_ >= patience_s);
}

void StageFace::update(Session& session, const ActionSink& apply, const StageFrame& frame, bool has_keys,
                       double interval_s) {
  pointer_.update(session, apply, frame, picture_);
  follow_handle(frame.loop.motors, interval_s);
  const bool is_busy = transition_.is_running() || show_.is_on() || handle_is_unknown(frame);
  view_.follow(session, {frame, picture_, pointer_.is_holding(), is_busy, has_rest_}, interval_s);
  // What begins in this frame begins at its beginning.
  transition_.advance(interval_s);
  follow_session(session, frame);
  guess_.update(session, interval_s);
  const bool is_changed = std::exchange(seen_settings_, session.settings) != session.settings ||
                          std::exchange(seen_goal_, session.goal) != session.goal;
  show_.update(has_keys || pointer_.has_touched() || is_changed, may_show_itself(session, frame), interval_s);
}

namespace {

// What is being turned is shown as the loop has it, so that all of the picture is of one moment: settings that it has
// not seen yet come with the next frame.
ShownMoment of_one_moment(const Session& session, const StageFrame& frame) {
  const auto newest = frame.history.moments().newest();
  const bool is_live = !session.paused && !frame.shown.is_past;
  if (!is_live || !newest || newest->snapshot.tick == 0) return frame.shown;
  ShownMoment moment = *newest;
  moment.settings = settings_at(*session.scene, moment.settings, moment.snapshot.time_s);
  moment.settings.active = frame.shown.settings.active;
  return moment;
}

}  // namespace

StageBlend StageFace::blend_of(const StageFrame& frame) const {
  return transition_.is_running() ? transition_.blend() : stage_blend_of(frame.shown.settings.active);
}

StageFace::Shown StageFace::live_in(const Session& session, const StageFrame& frame, const StageBlend& blend) const {
  const ShownMoment shown_moment = of_one_moment(session, frame);
  const Settings& settings = shown_moment.settings;
  const Snapshot& snapshot = shown_moment.snapshot;
  // A hand that is dragged is where the pointer is, whatever the loop has seen of it yet.
  const bool is_live = session.pointer_moves_goal && !frame.shown.is_past && !snapshot.measured;
  const Vector<2> goal = is_live ? session.goal : snapshot.goal;
  Shown shown{settings, stage_moment_between(settings, snapshot, goal, blend)};
  if (const auto target = target_of(session, frame.loop.motors)) {
    shown.moment = with_target(shown.moment, wall_of(settings), *target);
  }
  // What is felt is what the motors are told to give, not what they were asked for.
  const MotorReport& motors = frame.loop.motors;
  const bool is_felt_now = shown.moment.is_measured && !session.paused && !frame.shown.is_past;
  if (is_felt_now && !motors.gives_all() && shown.moment.in_contact && !shown.moment.knows_ghost_force) {
    shown.moment.wall_share = motors.sent;
  }
  if (session.stage.mode == StageMode::predict && guess_.is_revealing()) shown.moment = guess_.moment(session);
  return shown;
}

StageFace::Shown StageFace::shown_in(const Session& session, const StageFrame& frame) const {
  Shown shown = live_in(session, frame, blend_of(frame));
  if (show_.is_on()) {
    StageShow show = show_.shown_instead_of(shown.moment, session);
    shown = {show.settings, show.moment};
  }
  return shown;
}

StageContent StageFace::content_of(const Session& session, const StageFrame& frame, const Shown& shown) const {
  const StageBlend blend = transition_.blend();
  StageContent content{
      .settings = shown.settings,
      .moment = shown.moment,
      .language = stage_language(session.language),
      .keys = keys_in(session),
      .theme = frame.theme,
      .measure = frame.measure,
      .shown = session.stage_shown,
      .reference_force = reference_force_of(session),
      .size = frame.size,
      .scale = frame.scale,
      .mode = session.stage.mode,
      .audience = {.can_drag = session.pointer_moves_goal,
                   .sees_show = show_.is_on() && !session.lesson,
                   .looks_back = frame.shown.is_past,
                   .feels_tones = frame.loop.hand.tone_gain > 0.0 && !show_.is_on() && !frame.shown.is_past,
                   .heads_for = shown.settings.active},
      .guess = guess_.guess(session),
      .why_step = session.stage.why_step,
      .landscape_dial = dragged_landscape_dial(session).value_or(blend.cure),
      .looks_back_to_s = session.stage.looks_back_to_s,
      .warning = warning_of(session, frame.loop),
      .remark = remark_of(session, shown.moment, frame),
      .is_bare = frame.is_bare,
      .has_controls = frame.has_controls};
  if (session.lesson) {
    content.lesson = lesson_content(session);
    content.hides = lesson_secrets(session);
    content.guess = lesson_guess(session);
  }
  content.hides.numbers = content.hides.numbers || session.stage.hides_numbers;
  content.measuring = measuring_content(session);
  content.measuring_button = measuring_button(session, frame.loop.motors);
  content.corner = corner_button(session, frame.loop.motors, content.guess, guess_.is_revealing());
  const MotorReport& motors = frame.loop.motors;
  content.handle_is_unknown = handle_is_unknown(frame);
  if (!frame.shown.is_past && (!content.handle_is_unknown || motors.waits_for_zero_pose)) {
    content.linkage = motors.linkage;
  }
  if (content.handle_is_unknown) {
    content.hides = {.numbers = true, .force = true, .slide = true, .rest = true, .handle = true};
    if (content.linkage) content.shown = stage_view_of(*content.linkage);
  } else if (content.linkage && motors.line_turns && !session.lesson) {
    content.motors_in_use = shown.settings.active == StrategyId::full ? MotorsInUse::both
                            : motors.pushing_motor == 0               ? MotorsInUse::first
                                                                      : MotorsInUse::second;
  }
  if (session.stage.mode == StageMode::ribbon) content.moments = &frame.history.moments();
  if (session.stage.mode == StageMode::round && frame.loop.circle && !content.handle_is_unknown) {
    const CircleReading& reading = *frame.loop.circle;
    content.shown = view_of_round(shown.settings, reading.circle, content.reference_force);
    const std::optional<double> turn_s = turn_to_show(frame.loop);
    content.round = StageRound{
        turn_s ? last_loop(frame.history.moments(), shown.settings.active, *turn_s) : std::vector<Vector<2>>(),
        reading};
  }
  return content;
}

namespace {

// One motor pushes the handle away from the hand along its rail: at rest the rail goes through the hand, which stands
// still while it is turned. A handle that is held, or that does not move, stays where it is instead.
std::optional<Vector<2>> pivot_of_rail(const Session& session, const StageMoment& moment) {
  const bool comes_to_rest = session.pointer_moves_goal && !session.paused && !moment.is_measured;
  const bool has_one_motor = session.settings.active != StrategyId::full && !is_general(session.settings);
  return comes_to_rest && has_one_motor ? std::optional(session.goal) : std::nullopt;
}

// While the workbench is shown, what goes on by itself on the stage, and its modes, are not there.
Session beside_stage(const Session& session) {
  Session plain = session;
  plain.stage = {.looks_back_to_s = session.stage.looks_back_to_s};
  return plain;
}

}  // namespace

StageReading StageFace::reading(const Session& session, const StageFrame& frame) const {
  if (session.face == Face::stage) {
    const Shown shown = live_in(session, frame, blend_of(frame));
    return stage_reading(content_of(session, frame, shown));
  }
  const Session plain = beside_stage(session);
  const Shown shown = live_in(plain, frame, stage_blend_of(frame.shown.settings.active));
  return stage_reading(content_of(plain, frame, shown));
}

const StagePicture& StageFace::compose(const Session& session, const StageFrame& frame, double interval_s) {
  const Shown shown = shown_in(session, frame);
  StageContent content = content_of(session, frame, shown);
  if (!has_own_view(content)) content.shown = view_.view();
  content.hovered = pointer_.hovered();
  content.hovered_grip = pointer_.hovered_grip();
  content.is_dragging = pointer_.is_holding();
  content.held_end = pointer_.held_end();
  content.shows_menu = session.stage.shows_menu;
  content.may_turn_motor = session.has_handles && !content.handle_is_unknown && !permit(session, TurnMotorTo{});
  content.may_turn_wall = session.has_handles && !permit(session, TurnWallTo{});
  content.may_move_parts = session.has_handles && (is_general(session.settings) || content.linkage) &&
                           session.stage.mode != StageMode::why && !content.hides.handle;
  content.hovered_part = pointer_.hovered_part();
  content.widths = &widths_;
  content.rail_pivot = pivot_of_rail(session, content.moment);
  // One thing to do at a time.
  if (content.warning.empty()) content.hint = stage_hint(session, content.moment, content.audience);
  has_rest_ = content.moment.has_rest;
  picture_ = compose_stage(content, memory_, interval_s, std::move(picture_.pane.marks));
  return picture_;
}

Pane StageFace::pane_apart(const Session& session, const StageFrame& frame, LabelMemory& memory,
                           double interval_s) const {
  if (session.face == Face::stage) {
    const Shown shown = shown_in(session, frame);
    StageContent content = content_of(session, frame, shown);
    if (!has_own_view(content)) content.shown = view_.view();
    return compose_stage(content, memory, interval_s).pane;
  }
  Session plain = beside_stage(session);
  plain.stage.hides_numbers = session.stage.hides_numbers;
  const Shown shown = live_in(plain, frame, stage_blend_of(frame.shown.settings.active));
  return compose_stage(content_of(plain, frame, shown), memory, interval_s).pane;
}

StagePicture StageFace::still(const Session& session, const StageFrame& frame) const {
  const Shown shown = shown_in(session, frame);
  LabelMemory memory;
  return compose_stage(content_of(session, frame, shown), memory, 0.0);
}

bool StageFace::is_moving() const noexcept {
  return transition_.is_running() || memory_.is_moving() || show_.is_moving() || guess_.is_revealing() ||
         view_.is_moving();
}

}  // namespace ghostforce
