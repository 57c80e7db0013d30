#include "app/session/key_bindings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "app/session/hand_burst_guide.h"
#include "app/session/keys.h"
#include "app/session/lesson_guide.h"
#include "app/session/measurement_guide.h"
#include "app/session/scene_view_limits.h"
#include "app/session/stage_actions.h"
#include "core/units.h"

namespace ghostforce {
namespace {

// In a lesson that asks for it, the answer of that number.
template <StrategyId id>
void activate(Session& session) {
  const bool is_asked = has_open_question(session, LessonQuestion::choose);
  is_asked ? answer_in_lesson(session, index_of(id)) : choose_strategy(session, id, false);
}

template <StrategyId id>
void activate_slowly(Session& session) {
  choose_strategy(session, id, true);
}

template <StageMode mode>
void toggle_mode(Session& session) {
  toggle_stage_mode(session, mode);
}

// In a lesson the step says whether there is something to measure.
void measure_hand(Session& session) {
  if (!session.lesson) return toggle_stage_mode(session, StageMode::measure);
  if (session.stage.mode == StageMode::measure) press_hand_burst(session);
}

void other_face(Session& session) {
  show_face(session, session.face == Face::stage ? Face::workbench : Face::stage);
}

void hide_stage(Session& session) {
  session.stage.is_black = !session.stage.is_black;
}

// Millimetres in steps of a tenth. While a guess is open it is what moves: another goal would be another question. Where a
// lesson lets nobody move the hand, its slider moves.
template <int x, int y, int tenths>
void move_goal(Session& session) {
  const Vector<2> step = 0.0001 * tenths * Vector<2>(x, y);
  if (session.stage.guess && session.stage.guess_is_open) {
    session.stage.guess = nearest_in_scene(*session.stage.guess + step);
    return;
  }
  if (!is_allowed(session, LessonControl::hand)) return nudge_lesson_slider(session, 0.1 * tenths * (x + y));
  if (!session.pointer_moves_goal) return;
  session.goal = nearest_in_scene(session.goal + step);
}

template <int degrees>
void turn_motor_axis(Session& session) {
  if (!is_allowed(session, LessonControl::motor)) return;
  double& angle = session.settings.actuated_angle;
  // To whole steps, so that holding the key down runs through round angles.
  const double step = std::abs(degrees) * radians_per_degree;
  angle = std::remainder((std::round(angle / step) + (degrees > 0 ? 1.0 : -1.0)) * step, 2.0 * std::numbers::pi);
}

// The normal's angle at which the naïve proxy drifts farthest for a goal at a given depth, tan θ = √(1 + k_r/k_u) with
// θ between normal and motor axis; of the four such angles the nearest to the present one [rad].
double angle_of_largest_drift(const Settings& settings) noexcept {
  const double theta = std::atan(std::sqrt(1.0 + settings.stiffnesses.k_r / settings.stiffnesses.k_u));
  double nearest = settings.wall_normal_angle;
  double least_turn = 4.0;  // more than any
  for (const double offset : {theta, -theta, std::numbers::pi + theta, std::numbers::pi - theta}) {
    const double angle = std::remainder(settings.actuated_angle + offset, 2.0 * std::numbers::pi);
    const double turn = std::abs(std::remainder(angle - settings.wall_normal_angle, 2.0 * std::numbers::pi));
    if (turn < least_turn) {
      least_turn = turn;
      nearest = angle;
    }
  }
  return nearest;
}

void turn_wall_to_largest_drift(Session& session) {
  if (!is_allowed(session, LessonControl::wall)) return;
  session.settings.wall_normal_angle = angle_of_largest_drift(session.settings);
}

// In thousandths; as many steps up as down lead back.
template <int thousandths>
void turn_ratio_by(Session& session) {
  if (session.lesson) return;
  const double step = 1.0 + 0.001 * std::abs(thousandths);
  turn_ratio(session, thousandths > 0 ? step : 1.0 / step);
}

template <bool ViewOptions::*option>
void toggle(Session& session) {
  if (session.face != Face::workbench) return;  // nobody would see it
  session.options.*option = !(session.options.*option);
}

void toggle_plots(Session& session) {
  session.plots.is_open = !session.plots.is_open;
}

template <bool Requests::*request>
void ask(Session& session) {
  session.requests.*request = true;
}

void copy_picture(Session& session) {
  session.requests.copy_picture = CopyPictureRequest{};
}

template <int steps>
void change_scale(Session& session) {
  constexpr double step = 0.05;
  const double nearest = std::round(session.appearance.scale / step);
  session.appearance.scale = std::clamp((nearest + steps) * step, Appearance::least_scale, Appearance::greatest_scale);
}

// Where the mode that is on has a view of its own there is nothing to do.
SceneView* view_of(Session& session) {
  const StageMode mode = session.stage.mode;
  if (mode == StageMode::landscape || mode == StageMode::round) return nullptr;
  return session.face == Face::stage ? &session.stage_shown : &session.shown;
}

// Side by side each pane has a place of its own.
const PaneViews* panes_of(const Session& session) {
  return session.face == Face::workbench && session.pane_views ? &*session.pane_views : nullptr;
}

// In per cent.
template <int percent>
void zoom(Session& session) {
  constexpr double factor = 0.01 * percent;
  if (const PaneViews* const panes = panes_of(session)) {
    const StrategyId active = session.settings.active;
    session.pane_views = zoomed(*panes, factor, active, panes->centers[index_of(active)]);
  } else if (SceneView* const view = view_of(session)) {
    *view = zoomed(*view, factor, view->center);
  }
}

// By a twentieth of the picture's width; what is seen goes the other way.
template <int x, int y>
void move_picture(Session& session) {
  const auto by = [](double width) { return -0.05 * width * Vector<2>(x, y); };
  if (const PaneViews* const panes = panes_of(session)) {
    session.pane_views = moved(*panes, by(panes->width));
  } else if (SceneView* const view = view_of(session)) {
    *view = within_scene_limits({view->center + by(view->width), view->width});
  }
}

// The focus is the screen's.
void nothing_here(Session&) {}

void usual_scale(Session& session) {
  session.appearance.scale = 1.0;
}

void next_theme(Session& session) {
  const auto themes = theme_catalog();
  const std::size_t next = static_cast<std::size_t>(session.appearance.theme - themes.data()) + 1;
  session.appearance.theme = &themes[next % themes.size()];
}

// While the hand is measured, a reading; else what it means on the stage.
void confirm(Session& session) {
  if (session.measurement.stage == UserMeasurement::Stage::nulling && session.dialog == Dialog::none) {
    take_reading(session);
  } else {
    confirm_on_stage(session);
  }
}

// Before all else it turns motors off; it never quits.
void escape(Session& session) {
  ++session.offs_asked;
  const bool was_black = std::exchange(session.stage.is_black, false);
  const bool closes_more = was_black || session.dialog != Dialog::none || session.notice;
  session.dialog = Dialog::none;
  session.notice.reset();
  if (closes_more) return;
  if (session.lesson) {
    if (!session.motors_may_push && !session.visit) leave_lesson(session);
  } else if (session.stage.looks_back_to_s) {
    go_on_live(session);
  } else if (session.stage.mode != StageMode::none) {
    leave_stage_mode(session);
  } else {
    session.hint.reset();
  }
}

// A visitor may use it too.
constexpr KeyBinding for_visitors(KeyBinding binding) {
  binding.for_visitors = true;
  return binding;
}

// A page has no such key.
constexpr KeyBinding for_own_window(KeyBinding binding) {
  binding.for_own_window = true;
  return binding;
}

// With one of these nothing is typed.
constexpr int chords = modifier::control | modifier::alt | modifier::super;

// Into a field it types a letter or another sign.
constexpr bool types_a_sign(int key, int modifiers) {
  return key < key::escape && (modifiers & chords) == 0;
}

// What is typed, and the keys that move and delete without a chord. Function keys do nothing there.
bool is_for_field(const KeyPress& press) {
  const bool is_function_key = press.key >= key::f1 && press.key <= key::f24;
  return !is_function_key && (press.modifiers & chords) == 0;
}

// With a key that may be another in another front. `also_in_fields`: but where it is a letter there.
constexpr KeyBinding bound(const FrontKey& at, std::string_view sentence, void (*act)(Session&),
                           bool also_in_fields = false, std::string_view group = {}) {
  return {.key = at.key,
          .modifiers = at.modifiers,
          .shown = at.shown,
          .sentence = sentence,
          .act = act,
          .also_in_fields = also_in_fields && !types_a_sign(at.key, at.modifiers),
          .group = group};
}

constexpr int none = 0;
constexpr int shift = modifier::shift;
constexpr int ctrl = modifier::control;
constexpr int alt = modifier::alt;

// clang-format off
constexpr std::array gestures{
    MouseGesture{"Move and change", "Drag", "Move the goal of your hand"},
    MouseGesture{"Move and change", "Drag rail or arrow", "Turn the actuated direction in steps of 5° (Ctrl: freely)"},
    MouseGesture{"Move and change", "Drag a wall grip", "Turn the wall in steps of 5° (Ctrl: freely)"},
    MouseGesture{"View", "Wheel", "Zoom at the pointer"},
    MouseGesture{"View", "Right drag", "Move the view"},
    MouseGesture{"Move and change", "Ctrl+click a slider", "Type a number"},
};
// clang-format on

}  // namespace

std::vector<KeyBinding> key_table_of(const FrontKeys& keys) {
  // clang-format off
  std::vector bindings{
    for_visitors({key::left, none, "Arrows", "Move goal or guess 1 mm (Shift: 0.1, Ctrl: 10)", move_goal<-1, 0, 10>, true, false, "Move and change"}),
    for_visitors({key::right, none, "", "", move_goal<1, 0, 10>, true}),
    for_visitors({key::up, none, "", "", move_goal<0, 1, 10>, true}),
    for_visitors({key::down, none, "", "", move_goal<0, -1, 10>, true}),
    for_visitors({key::left, shift, "", "", move_goal<-1, 0, 1>, true}),
    for_visitors({key::right, shift, "", "", move_goal<1, 0, 1>, true}),
    for_visitors({key::up, shift, "", "", move_goal<0, 1, 1>, true}),
    for_visitors({key::down, shift, "", "", move_goal<0, -1, 1>, true}),
    for_visitors({key::left, ctrl, "", "", move_goal<-1, 0, 100>, true}),
    for_visitors({key::right, ctrl, "", "", move_goal<1, 0, 100>, true}),
    for_visitors({key::up, ctrl, "", "", move_goal<0, 1, 100>, true}),
    for_visitors({key::down, ctrl, "", "", move_goal<0, -1, 100>, true}),
    for_visitors({key::left_bracket, none, "[  ]", "Turn the actuated direction 5° (Shift: 1°)", turn_motor_axis<5>, true}),
    for_visitors({key::right_bracket, none, "", "", turn_motor_axis<-5>, true}),
    for_visitors({key::left_bracket, shift, "", "", turn_motor_axis<1>, true}),
    for_visitors({key::right_bracket, shift, "", "", turn_motor_axis<-1>, true}),
    KeyBinding{key::w, none, "W", "Turn the wall to where the naïve drift is largest", turn_wall_to_largest_drift},
    KeyBinding{key::minus, none, "−  +", "Lower or raise the ratio ρ by 5 % (Alt: 1 %)", turn_ratio_by<-50>, true},
    KeyBinding{key::equal, none, "", "", turn_ratio_by<50>, true},
    KeyBinding{key::number_pad_subtract, none, "", "", turn_ratio_by<-50>, true},
    KeyBinding{key::number_pad_add, none, "", "", turn_ratio_by<50>, true},
    KeyBinding{key::minus, alt, "", "", turn_ratio_by<-10>, true},
    KeyBinding{key::equal, alt, "", "", turn_ratio_by<10>, true},
    KeyBinding{key::equal, alt | shift, "", "", turn_ratio_by<10>, true},
    KeyBinding{key::number_pad_subtract, alt, "", "", turn_ratio_by<-10>, true},
    KeyBinding{key::number_pad_add, alt, "", "", turn_ratio_by<10>, true},

    for_visitors({key::digit_1, none, "1 2 3", "Fully actuated, naïve, anisotropic; in a lesson: answer", activate<StrategyId::full>, false, false, "Strategies"}),
    for_visitors({key::digit_2, none, "", "", activate<StrategyId::naive>}),
    for_visitors({key::digit_3, none, "", "", activate<StrategyId::anisotropic>}),
    for_visitors({key::digit_1, shift, "Shift+1 2 3", "The same in slow motion, on the stage", activate_slowly<StrategyId::full>}),
    for_visitors({key::digit_2, shift, "", "", activate_slowly<StrategyId::naive>}),
    for_visitors({key::digit_3, shift, "", "", activate_slowly<StrategyId::anisotropic>}),

    KeyBinding{key::space, none, "Space", "Pause / resume; also stops looking back", toggle_pause, false, false, "Time"},
    KeyBinding{key::comma, none, ",", "Pause and step back one tick, up to a minute", step_back, true},
    KeyBinding{key::period, none, ".", "Pause and step forward one tick", step_on, true},
    KeyBinding{key::r, none, "R", "Reset the motion", restart},
    KeyBinding{key::r, alt, "Alt+R", "Reset the motion and all settings", restart_with_scene_settings},

    KeyBinding{key::digit_0, none, "0", "Compare: overlay, side by side, active only", next_compare_mode, false, false, "View"},
    KeyBinding{key::g, none, "G", "Ghost force on / off (hatched end of the arrow)", toggle<&ViewOptions::ghost_forces>},
    KeyBinding{key::p, none, "P", "Prediction rings on / off", toggle<&ViewOptions::predictions>},
    KeyBinding{key::t, none, "T", "Trails on / off", toggle<&ViewOptions::trails>},
    KeyBinding{key::f, none, "F", "Fit everything into the view", ask<&Requests::fit_view>},
    KeyBinding{key::z, none, "Z", keys.zoom_sentence, zoom<125>, true},
    KeyBinding{key::z, shift, "", "", zoom<80>, true},
    KeyBinding{key::left, keys.move_view_modifiers, "", "", move_picture<-1, 0>, true},
    KeyBinding{key::right, keys.move_view_modifiers, "", "", move_picture<1, 0>, true},
    KeyBinding{key::up, keys.move_view_modifiers, "", "", move_picture<0, 1>, true},
    KeyBinding{key::down, keys.move_view_modifiers, "", "", move_picture<0, -1>, true},

    KeyBinding{key::q, none, "Q", "Predict: guess where the handle comes to rest", toggle_mode<StageMode::predict>, false, false, "Stage"},
    KeyBinding{key::y, none, "Y", "Why?: where the ghost force comes from", toggle_mode<StageMode::why>},
    KeyBinding{key::l, none, "L", "Landscape: the ghost force for all walls and hands", toggle_mode<StageMode::landscape>},
    KeyBinding{key::o, none, "O", "Round and round: the energy of a closed loop", toggle_mode<StageMode::round>},
    KeyBinding{key::h, none, "H", "Last minute: look at it again", toggle_mode<StageMode::ribbon>},
    KeyBinding{key::s, none, "S", "Measure my hand: how stiff it is", measure_hand},
    for_visitors({key::enter, none, "Enter", "Next step of a lesson or of Why?; answer a guess", confirm}),
    for_visitors({key::number_pad_enter, none, "", "", confirm}),
    bound(keys.lessons, "Lessons: choose one", open_dialog<Dialog::lessons>, true),
    for_visitors({key::page_down, none, "PgDn PgUp", "Lesson or talk: next / previous step", next_talk_step}),
    for_visitors({key::page_up, none, "", "", previous_talk_step}),
    KeyBinding{key::b, none, "B", "Blank the stage, or show it again", hide_stage},

    bound(keys.device_status, "Device status, and what to do next", open_dialog<Dialog::doctor>, true, "Device"),
    for_visitors({key::escape, none, "Esc", "Motors off; close what is open (never quits)", escape, false, true}),

    KeyBinding{key::z, ctrl, "Ctrl+Z", "Undo the last change to a setting", ask<&Requests::undo>, true, false, "Undo, files, clipboard"},
    KeyBinding{key::z, ctrl | shift, "Ctrl+Shift+Z", "Redo; also Ctrl+Y", ask<&Requests::redo>, true},
    KeyBinding{key::y, ctrl, "", "", ask<&Requests::redo>, true},
    KeyBinding{key::c, ctrl, "Ctrl+C", "Copy what is shown as a command, to hand it on", ask<&Requests::copy_set_up>},
    KeyBinding{key::v, ctrl, "Ctrl+V", "Paste such a command: show what it describes", ask<&Requests::paste_set_up>},
    bound(keys.link, "A link to what is shown, for others", ask<&Requests::show_link>),
    KeyBinding{key::o, ctrl, "Ctrl+O", "Open a scene (or drop a file on the window)", open_dialog<Dialog::open_scene>, false, true},
    KeyBinding{key::s, ctrl, "Ctrl+S", "Save the scene with its current settings", open_dialog<Dialog::save_scene>, false, true},
    bound(keys.save_picture, keys.save_picture_sentence, open_dialog<Dialog::save_picture>, true),
    bound(keys.save_clip, "Save the last seconds of the stage as a clip", open_dialog<Dialog::save_clip>, true),
    bound(keys.copy_picture, "Copy a picture to the clipboard", copy_picture),
    bound(keys.copy_values, "Copy the live values to the clipboard", ask<&Requests::copy_table>, true),

    bound(keys.help, "This help", open_dialog<Dialog::help>, true, "Window"),
    bound(keys.plots, "Plots over time, wall angle and ratio ρ", toggle_plots, true),
    KeyBinding{key::f4, none, "F4", "Switch between stage and workbench", other_face, false, true},
    bound(keys.full_screen, "Full screen on / off", ask<&Requests::toggle_full_screen>, true),
    bound(keys.next_theme, "Next theme: light, dark, projector", next_theme),
    for_own_window({key::equal, ctrl, "Ctrl+ + − 0", "Text size: larger, smaller, default", change_scale<1>, true}),
    for_own_window({key::equal, ctrl | shift, "", "", change_scale<1>, true}),
    for_own_window({key::number_pad_add, ctrl, "", "", change_scale<1>, true}),
    for_own_window({key::minus, ctrl, "", "", change_scale<-1>, true}),
    for_own_window({key::number_pad_subtract, ctrl, "", "", change_scale<-1>, true}),
    for_own_window({key::digit_0, ctrl, "", "", usual_scale}),
    for_visitors({key::tab, none, "Tab", "Next control (Shift: previous)", nothing_here, true}),
    for_visitors({key::tab, shift, "", "", nothing_here, true}),
    for_own_window({key::q, ctrl, "Ctrl+Q", "Quit", ask<&Requests::quit>, false, true}),
    for_visitors(for_own_window({key::q, ctrl | alt | shift, "", "", ask<&Requests::quit>, false, true})),  // told on the terminal
  };
  // clang-format on
  std::erase_if(bindings, [&](const KeyBinding& binding) {
    return binding.key == 0 || (binding.for_own_window && !keys.has_own_window);
  });
  return bindings;
}

std::span<const KeyBinding> key_table() {
  static const std::vector<KeyBinding> table = key_table_of(front_keys());
  return table;
}

std::span<const MouseGesture> mouse_table() noexcept {
  return gestures;
}

void act_on_key(Session& session, const KeyPress& press, bool is_typing) {
  for (const KeyBinding& binding : key_table()) {
    if (binding.key != press.key || binding.modifiers != press.modifiers) continue;
    if (session.visit && !binding.for_visitors) continue;
    if ((press.is_repeat && !binding.repeats) || (is_typing && !binding.also_in_fields)) continue;
    binding.act(session);
  }
}

bool is_ours(const KeyPress& press, bool is_typing) {
  if (is_typing && is_for_field(press)) return true;
  return std::ranges::any_of(key_table(), [&](const KeyBinding& binding) {
    return binding.key == press.key && binding.modifiers == press.modifiers && (!is_typing || binding.also_in_fields);
  });
}

void next_compare_mode(Session& session) {
  if (session.face != Face::workbench) return;
  const std::size_t next = static_cast<std::size_t>(session.options.compare) + 1;
  session.options.compare = compare_catalog()[next % compare_catalog().size()].id;
}

// A lesson tells its own time.
void toggle_pause(Session& session) {
  if (session.lesson) return;
  if (session.stage.looks_back_to_s) return go_on_live(session);
  session.paused = !session.paused;
}

void go_on_live(Session& session) {
  session.stage.looks_back_to_s.reset();
  session.paused = false;
}

void single_step(Session& session) {
  session.paused = true;
  ++session.steps_asked;
}

void step_back(Session& session) {
  if (session.lesson) return;
  session.paused = true;
  --session.requests.ticks_through_history;
}

void step_on(Session& session) {
  if (session.lesson) return;
  const bool looks_back = session.stage.looks_back_to_s || session.requests.ticks_through_history < 0;
  if (!looks_back) return single_step(session);
  session.paused = true;
  ++session.requests.ticks_through_history;
}

void restart(Session& session) {
  if (session.lesson) return;
  session.goal = session.scene->goal.points.back();
  ++session.restarts_asked;
}

void restart_with_scene_settings(Session& session) {
  if (session.lesson) return;
  if (is_measuring(session)) cancel_measurement(session);
  session.settings = session.scene->settings;
  restart(session);
}

}  // namespace ghostforce
