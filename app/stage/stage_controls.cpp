#include "app/stage/stage_controls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "app/picture/text.h"
#include "app/stage/control_pieces.h"
#include "app/state/faces_and_modes.h"
#include "app/state/mode_changes.h"
#include "app/state/permit.h"
#include "app/state/stage_action.h"
#include "app/state/stage_language.h"
#include "core/scene_shape.h"

namespace ghostforce {
namespace {

using Kind = StageControlKind;

// Long ranges of numbers go by their logarithm: a step is 5 % more.
constexpr double growth_of_step = 1.05;

double steps_of(double number) {
  return std::log(number) / std::log(growth_of_step);
}

double number_of(double steps) {
  return std::pow(growth_of_step, steps);
}

// --- What is read ---

void add_notice(const ControlSource& source, ControlParts& parts) {
  const std::optional<Notice>& notice = source.session.notice;
  if (!notice) return;
  parts.push_back(text_control("notice", notice->is_problem ? Kind::alert : Kind::status, notice->words));
  parts.back().language = notice->language;
  const std::string close(source.language.notices.close);
  parts.push_back(button_control(source, "notice-close", close, CloseNotice{}));
}

// "ghost force: 1.27 N", or why there is no number.
std::string value_words(const ControlSource& source, bool is_hidden, const std::optional<double>& number,
                        std::string_view words, std::string_view words_if_unknown, std::string (*write)(double),
                        std::string_view unit) {
  const StageLanguage::Controls& all = source.language.controls;
  if (is_hidden) return filled(all.hidden, words);
  if (!number) return std::string(words_if_unknown);
  return fmt::format("{}: {} {}", words, write(*number), unit);
}

double wall_degrees(const Settings& settings) {
  return degrees_per_radian * std::remainder(settings.wall_normal_angle, 2.0 * std::numbers::pi);
}

// Where a key turns them, nothing else tells how far.
void add_angles(const ControlSource& source, ControlParts& parts) {
  const StageLanguage::Controls& all = source.language.controls;
  const Settings& settings = source.session.settings;
  if (settings.general.mechanism == MechanismKind::axes) {
    parts.push_back(
        text_control("value-motor", Kind::told,
                     filled(all.motor_value, motor_direction_words(settings.actuated_angle, source.language))));
  }
  if (settings.general.constraint == ConstraintKind::plane) {
    parts.push_back(
        text_control("value-wall", Kind::told, filled(all.wall_value, decimal_text(wall_degrees(settings), 0))));
  }
}

StageControl values_group(const ControlSource& source) {
  const StageReading& reading = source.reading;
  const StageLanguage::Numbers& names = source.language.numbers;
  const StageLanguage::Controls& all = source.language.controls;
  const bool hides_force = reading.hides.numbers || reading.hides.force;
  const bool hides_slide = reading.hides.numbers || reading.hides.slide;
  const bool has_two_motors = source.session.settings.active == StrategyId::full;
  const std::string_view share = has_two_motors ? all.share_of_two : all.share;
  ControlParts parts;
  if (!source.session.lesson) {
    parts.push_back(text_control("value-scene", Kind::told, filled(all.scene, source.session.scene->title)));
  }
  parts.push_back(text_control("value-hand", Kind::told, hand_words(source)));
  add_angles(source, parts);
  const auto add_number = [&](std::string id, bool is_hidden, const std::optional<double>& number,
                              std::string_view words, std::string_view words_if_unknown, std::string (*write)(double),
                              std::string_view unit) {
    parts.push_back(text_control(std::move(id), Kind::told,
                                 value_words(source, is_hidden, number, words, words_if_unknown, write, unit)));
  };
  add_number("value-ghost", hides_force, reading.numbers.ghost_force,
             words_of_ghost_force(reading.numbers.ghost_force.value_or(0.0), names), names.ghost_force_unknown,
             force_number, "N");
  add_number("value-slide", hides_slide, reading.numbers.slide, names.slide, names.slide_unknown, slide_number, "mm");
  add_number("value-share", hides_force, reading.numbers.wall_share, share, share, force_number, "N");
  return group_control("values", Kind::group, all.values, std::move(parts));
}

// --- What can be changed ---

StageControl strategies_group(const ControlSource& source) {
  ControlParts parts;
  for (const Strategy& each : strategy_catalog()) {
    const StrategyWords words = strategy_words(source.language, each.id, has_strings(source.session.settings));
    StageControl choice = button_control(source, fmt::format("strategy-{}", each.name),
                                         fmt::format("{}: {}", words.name, words.about), ChooseStrategy{each.id});
    choice.kind = Kind::choice;
    choice.is_on = source.session.settings.active == each.id;
    parts.push_back(std::move(choice));
  }
  return group_control("strategies", Kind::choices, source.language.controls.strategies, std::move(parts));
}

void add_directions(const ControlSource& source, ControlParts& parts) {
  const StageLanguage::Controls& all = source.language.controls;
  const Settings& settings = source.session.settings;
  constexpr double step_deg = 5.0;
  // A motor pushes both ways along its line.
  const double motor_deg = degrees_per_radian * std::remainder(settings.actuated_angle, std::numbers::pi);
  const double wall_deg = wall_degrees(settings);
  const GeneralSettings& general = settings.general;
  if (general.mechanism == MechanismKind::axes) {
    parts.push_back(
        range_control(source, "motor", all.motor, motor_direction_words(settings.actuated_angle, source.language),
                      {.value = motor_deg, .least = -90.0, .greatest = 90.0, .step = step_deg},
                      [](double degrees) { return std::vector<Action>{TurnMotorTo{degrees * radians_per_degree}}; }));
  }
  if (has_joints(settings)) {
    parts.push_back(
        button_control(source, "switch-motor", std::string(source.language.actions.switch_motor.words), SwitchMotor{}));
  }
  if (general.constraint == ConstraintKind::plane) {
    parts.push_back(
        range_control(source, "wall", all.wall, decimal_text(wall_deg, 0) + "°",
                      {.value = wall_deg, .least = -180.0, .greatest = 180.0, .step = step_deg},
                      [](double degrees) { return std::vector<Action>{TurnWallTo{degrees * radians_per_degree}}; }));
  }
}

void add_ratio(const ControlSource& source, ControlParts& parts) {
  constexpr NumberRange range{0.1, 100.0};
  const double ratio = tracking_ratio(source.session.settings.stiffnesses);
  parts.push_back(range_control(
      source, "ratio", source.language.controls.ratio, fmt::format("ρ = {:.2f}", ratio),
      {.value = std::clamp(steps_of(ratio), std::floor(steps_of(range.least)), std::ceil(steps_of(range.greatest))),
       .least = std::floor(steps_of(range.least)),
       .greatest = std::ceil(steps_of(range.greatest)),
       .step = 1.0},
      [ratio](double steps) { return std::vector<Action>{TurnRatio{number_of(steps) / ratio}}; }));
}

void add_landscape(const ControlSource& source, ControlParts& parts) {
  const Session& session = source.session;
  if (session.stage.mode != StageMode::landscape || has_joints(session.settings)) return;
  const StageLanguage::Controls& all = source.language.controls;
  const double dial =
      dragged_landscape_dial(session).value_or(session.settings.active == StrategyId::anisotropic ? 1.0 : 0.0);
  parts.push_back(range_control(source, "landscape-dial", all.landscape_dial, fmt::format("{:.0f} %", 100.0 * dial),
                                {.value = 100.0 * dial, .least = 0.0, .greatest = 100.0, .step = 5.0},
                                [](double percent) { return std::vector<Action>{TurnLandscapeDial{0.01 * percent}}; }));
  const LandscapePoint point = landscape_point(session.settings);
  parts.push_back(range_control(source, "landscape-stiffness", all.landscape_stiffness, decimal_text(point.kappa, 1),
                                {.value = steps_of(point.kappa),
                                 .least = 0.0,
                                 .greatest = std::ceil(steps_of(shown_kappas.greatest)),
                                 .step = 1.0},
                                [point](double steps) {
                                  return std::vector<Action>{
                                      GoToLandscapePoint{{.angle = point.angle, .kappa = number_of(steps)}}};
                                }));
}

void add_look_back(const ControlSource& source, ControlParts& parts) {
  const Session& session = source.session;
  if (session.stage.mode != StageMode::ribbon) return;
  constexpr double longest_s = 60.0;
  const double newest_s = session.time_s;
  const double ago_s = session.stage.looks_back_to_s ? std::max(0.0, newest_s - *session.stage.looks_back_to_s) : 0.0;
  const StageLanguage::Ribbon& words = source.language.ribbon;
  parts.push_back(
      range_control(source, "look-back", source.language.controls.look_back,
                    ago_s == 0.0 ? std::string(words.now) : filled(words.seconds_ago, decimal_text(ago_s, 1)),
                    {.value = -ago_s, .least = -longest_s, .greatest = 0.0, .step = 1.0}, [newest_s](double later_s) {
                      return std::vector<Action>{
                          LookBackTo{later_s < 0.0 ? std::optional(std::max(0.0, newest_s + later_s)) : std::nullopt}};
                    }));
}

// In a lesson only what its step leaves to the person.
StageControl settings_group(const ControlSource& source) {
  ControlParts parts;
  add_hand_controls(source, parts);
  add_directions(source, parts);
  add_ratio(source, parts);
  add_landscape(source, parts);
  add_look_back(source, parts);
  if (source.session.lesson) {
    std::erase_if(parts, [](const StageControl& each) { return !each.refusal.empty(); });
  }
  return group_control("settings", Kind::group, source.language.controls.settings, std::move(parts));
}

// A mode's toggle, then what there is to do in the one that is on.
StageControl modes_group(const ControlSource& source) {
  const Session& session = source.session;
  ControlParts parts;
  for (const StageModeEntry& mode : stage_mode_catalog()) {
    const StageLanguage::Mode& said = source.language.modes.*mode.words;
    const Action action = mode.id == StageMode::measure ? Action(MeasureHand{}) : ToggleMode{mode.id};
    StageControl toggle = button_control(source, fmt::format("mode-{}", mode.name), std::string(said.title), action);
    toggle.kind = Kind::toggle;
    toggle.about = said.about;
    toggle.is_on = session.stage.mode == mode.id;
    parts.push_back(std::move(toggle));
  }
  const StageLanguage::MenuRow& workbench = source.language.menu_rows.workbench;
  const bool is_on_workbench = session.face == Face::workbench;
  StageControl face = button_control(source, "workbench", std::string(workbench.title),
                                     ShowFace{is_on_workbench ? Face::stage : Face::workbench});
  face.kind = Kind::toggle;
  face.about = workbench.about;
  face.is_on = is_on_workbench;
  parts.push_back(std::move(face));
  return group_control("modes", Kind::group, source.language.controls.modes, std::move(parts));
}

// What the mode that is on says besides its sentence, and asks for. It comes before the rest: it is what one has chosen.
void add_mode(const ControlSource& source, ControlParts& parts) {
  const StageReading& reading = source.reading;
  for (std::size_t i = 0; i < reading.steps.size(); ++i) {
    parts.push_back(text_control(fmt::format("why-{}", i + 1), Kind::told, reading.steps[i]));
  }
  if (!source.session.lesson) add_guess_controls(source, parts);
  if (reading.measuring) {
    parts.push_back(button_control(source, "measure", without_key(reading.measuring->words), PressMeasuringButton{}));
  }
  if (!reading.corner) return;
  if (const auto action = action_of_button(reading.corner->action, source.loop.motors)) {
    parts.push_back(button_control(source, "next", without_key(reading.corner->words), *action));
  }
}

void add_motors(const ControlSource& source, ControlParts& parts) {
  if (!source.loop.motors.has_motors) return;
  parts.push_back(
      button_control(source, "motors-stop", std::string(source.language.actions.stop_motors.words), StopMotors{}));
}

// --- Lists of all that there is ---

// Where the dialog is open that shows one, it stands there.
struct FoldedList {
  Dialog dialog;
  StageControl (*list)(const ControlSource& source);
};
constexpr std::array folded_lists{FoldedList{Dialog::lessons, lesson_list}, FoldedList{Dialog::help, key_list},
                                  FoldedList{Dialog::palette, action_list}};

}  // namespace

std::vector<StageControl> stage_controls(const Session& session, const LoopReading& loop, const StageReading& reading) {
  const ControlSource source{session, loop, reading, stage_language(session.language)};
  std::vector<StageControl> all;
  const bool is_on_stage = session.face == Face::stage;
  all.push_back(text_control("sentence", Kind::told,
                             is_on_stage ? reading.sentence : std::string(source.language.controls.on_workbench)));
  add_notice(source, all);
  if (!session.kiosk_visit) add_dialog(source, all);
  add_motors(source, all);
  if (session.lesson && reading.lesson) all.push_back(lesson_control(source));
  add_mode(source, all);
  if (!session.lesson || !permit(session, ChooseStrategy{session.settings.active})) {
    all.push_back(strategies_group(source));
  }
  all.push_back(values_group(source));
  if (StageControl settings = settings_group(source); !settings.parts.empty()) all.push_back(std::move(settings));
  if (!session.lesson && !session.kiosk_visit) all.push_back(modes_group(source));
  if (session.kiosk_visit) return all;
  for (const auto& [dialog, list] : folded_lists) {
    if (dialog != session.dialog) all.push_back(list(source));
  }
  return all;
}

const StageControl* find_control(std::span<const StageControl> controls, std::string_view id) noexcept {
  for (const StageControl& each : controls) {
    if (each.id == id) return &each;
    if (const StageControl* const part = find_control(each.parts, id)) return part;
  }
  return nullptr;
}

void SettledTexts::settle(std::vector<StageControl>& controls, bool is_later) {
  Texts settled;  // without those that are no longer there
  settle(controls, is_later, settled);
  texts_ = std::move(settled);
}

void SettledTexts::settle(std::vector<StageControl>& controls, bool is_later, Texts& settled) const {
  const auto has_settled = [&](const StageControl& each) {
    const auto found = texts_.find(each.id);
    return each.kind != Kind::told || found == texts_.end() || found->second.seen == each.words;
  };
  const auto has_waited = [&](const StageControl& each) {
    const auto found = texts_.find(each.id);
    return each.kind == Kind::told && found != texts_.end() && found->second.unsettled_looks >= most_unsettled_looks;
  };
  const bool are_told =
      is_later && (std::ranges::all_of(controls, has_settled) || std::ranges::any_of(controls, has_waited));
  for (StageControl& each : controls) {
    settle(each.parts, is_later, settled);
    if (each.kind != Kind::told) continue;
    const auto found = texts_.find(each.id);
    Text text = found == texts_.end() ? Text{.seen = each.words, .told = each.words} : found->second;
    if (are_told) text.told = each.words;
    if (is_later) {
      text.seen = each.words;
      text.unsettled_looks = are_told ? 0 : text.unsettled_looks + 1;
    }
    each.words = text.told;
    settled.emplace(each.id, std::move(text));
  }
}

}  // namespace ghostforce
