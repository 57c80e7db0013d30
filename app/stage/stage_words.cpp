// The words beside the things of the stage, the most important first, and those on buttons and in the menu.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "app/stage/stage_layers.h"
#include "app/stage/stage_layout.h"
#include "app/stage/stage_scene.h"

namespace ghostforce {
namespace {

// The lower one of both directions across a line on the screen; of an upright line the right one.
Vector<2> lower_side(const Vector<2>& along) {
  const Vector<2> across{-along.y, along.x};
  return across.y > 0.0 || (across.y == 0.0 && across.x > 0.0) ? across : -across;
}

// Above stand the same numbers, larger.
std::string once(const StageLayer& layer, std::string_view words, const std::string& number, std::string_view unit) {
  return layer.layout.numbers ? std::string(words) : with_number(layer.content, words, number, unit);
}

void add_force_words(const StageLayer& layer) {
  const auto& [content, layout, canvas] = layer;
  const StageMoment& moment = content.moment;
  const auto arrow = force_arrow(layer);
  if (!arrow) return;
  if (content.hides.force || glm::length(moment.ghost_force) < least_shown_force) return;
  canvas.label(Role::ghost_force,
               {StageLabel::ghost,
                {once(layer, content.language.labels.ghost, force_number(glm::length(moment.ghost_force)), "N")},
                layout.letters.bold_words,
                arrow->share_end(),
                arrow->tip(),
                canvas.points(arrow_width),
                lower_side(arrow->direction)},
               content.theme.strategy_text[index_of(StrategyId::naive)]);
}

void add_share_words(const StageLayer& layer) {
  const auto& [content, layout, canvas] = layer;
  const auto arrow = force_arrow(layer);
  const double share = glm::length(content.moment.wall_share);
  if (content.hides.force || !arrow || share < least_shown_force) return;
  const StageLanguage::Labels& words = content.language.labels;
  canvas.label(
      Role::wall_share,
      {StageLabel::wall_share,
       {with_number(content, content.moment.knows_ghost_force ? words.wall : words.motor, force_number(share), "N")},
       layout.letters.words,
       arrow->start,
       arrow->share_end(),
       canvas.points(arrow_width),
       lower_side(arrow->direction)},
      content.theme.text);
}

void add_slide_words(const StageLayer& layer) {
  const auto& [content, layout, canvas] = layer;
  const auto ruler = slide_ruler(layer);
  const double slide = glm::length(content.moment.slide);
  if (content.hides.slide || !ruler || slide < least_shown_slide) return;
  canvas.label(Role::proxy_drift,
               {StageLabel::slide,
                {once(layer, content.language.labels.slid, slide_number(slide), "mm")},
                layout.letters.bold_words,
                ruler->from,
                ruler->to,
                canvas.points(12.0),
                ruler->out},
               stage_colour(content.moment, content.theme.strategy_text));
}

void add_handle_words(const StageLayer& layer) {
  const auto& [content, layout, canvas] = layer;
  canvas.label(Role::device,
               {StageLabel::handle,
                {std::string(content.language.labels.handle)},
                layout.letters.bold_words,
                canvas.at(content.moment.handle),
                canvas.at(content.moment.handle),
                shape_reach(content.moment, canvas.points(handle_radius)) + canvas.width(2.0),
                Vector<2>(1.0, -1.0)},
               stage_colour(content.moment, content.theme.strategy_text));
}

Vector<2> into_the_wall(const StageContent& content, const Vector<2>& place) {
  return -to_screen_direction(wall_near(content.settings, place).normal);
}

void add_expectation_words(const StageLayer& layer) {
  const auto& [content, layout, canvas] = layer;
  const StageMoment& moment = content.moment;
  if (moment.has_target) {
    canvas.label(Role::target,
                 {StageLabel::expected_contact,
                  {std::string(content.language.labels.target)},
                  layout.letters.bold_words,
                  canvas.at(moment.expected_contact),
                  canvas.at(moment.expected_contact),
                  canvas.points(target_radius),
                  into_the_wall(content, moment.expected_contact)},
                 content.theme.text);
  }
  if (!moment.in_contact || moment.is_measured) return;
  const Vector<2> rest = canvas.at(moment.expected_rest);
  const bool is_apart = glm::distance(rest, canvas.at(moment.handle)) > canvas.points(2.0 * handle_radius);
  if (is_apart && !content.hides.rest) {
    canvas.label(Role::expected_rest,
                 {StageLabel::expected_rest,
                  {std::string(content.language.labels.should_rest)},
                  layout.letters.words,
                  rest,
                  rest,
                  canvas.points(handle_radius),
                  Vector<2>(0.0, -1.0)},
                 content.theme.faint_text);
  }
  const Vector<2> foot = canvas.at(moment.expected_contact);
  if (glm::distance(foot, canvas.at(moment.proxy)) > canvas.points(26.0)) {
    canvas.label(Role::expected_contact,
                 {StageLabel::expected_contact,
                  {std::string(content.language.labels.should_hold)},
                  layout.letters.words,
                  foot,
                  foot,
                  canvas.points(7.0),
                  into_the_wall(content, moment.expected_contact) + Vector<2>(0.6, -0.6)},
                 content.theme.faint_text);
  }
}

// In a corner of the picture that is deep in the wall, above if there is one.
void add_wall_words(const StageLayer& layer) {
  const auto& [content, layout, canvas] = layer;
  const std::string words(content.language.labels.virtual_wall);
  const Vector<2> extent = content.measure(words, layout.letters.words);
  const ScreenBox room = layout.room().grown(-canvas.points(26.0));
  const double top = layout.top + canvas.points(16.0);
  const std::array corners{Vector<2>(room.most.x - extent.x, top), room.most - extent,
                           Vector<2>(room.least.x, room.most.y - extent.y), Vector<2>(room.least.x, top)};
  const auto wall_at = [&](const Vector<2>& corner) {
    return wall_near(content.settings, to_world(canvas.camera, corner + 0.5 * extent));
  };
  const auto is_deep = [&](const Vector<2>& corner) {
    const Wall<2> wall = wall_at(corner);
    const Vector<2> inwards = -to_screen_direction(wall.normal);
    return glm::dot(corner + 0.5 * extent - canvas.at(wall.point), inwards) > 0.5 * extent.x + canvas.points(30.0);
  };
  const auto* const corner = std::ranges::find_if(corners, is_deep);
  if (corner == corners.end()) return;
  const Vector<2> edge = canvas.at(wall_at(*corner).point);
  const Vector<2> inwards = -to_screen_direction(wall_at(*corner).normal);
  const LabelBlock block{.id = StageLabel::wall,
                         .extent = extent,
                         .region = layout.room(),
                         .wanted = *corner,
                         // What lies in the wall lies to the right of its edge.
                         .edge = ScreenPiece{edge, edge + Vector<2>(inwards.y, -inwards.x), 0.0}};
  canvas.label(Role::wall, {.id = StageLabel::wall, .lines = {words}, .style = layout.letters.words, .block = block},
               content.theme.faint_text);
}

}  // namespace

std::string with_number(const StageContent& content, std::string_view words, const std::string& number,
                        std::string_view unit) {
  return content.hides.numbers ? std::string(words) : fmt::format("{} {} {}", words, number, unit);
}

namespace {

// Above the hand and with it, whatever lies there: who passes by sees a moving hand for a moment only.
void add_show_words(const StageLayer& layer) {
  const auto& [content, layout, canvas] = layer;
  const std::string words(content.language.labels.hand_shown);
  const TextStyle& style = layout.letters.bold_words;
  const Vector<2> extent = content.measure(words, style);
  constexpr double above_hand = 40.0;
  const Vector<2> wanted =
      canvas.at(content.moment.goal) - Vector<2>(0.5 * extent.x, canvas.points(above_hand) + extent.y);
  const ScreenBox room = layout.room();
  const Vector<2> corner = glm::clamp(wanted, room.least, glm::max(room.least, room.most - extent));
  const ScreenBox box{corner, corner + extent};
  if (canvas.labels.obstacles().is_crossed(box, Clearance::always)) add_plate(layer, Role::hint, box, under_sentences);
  canvas.labels.keep_clear(box);
  canvas.text(Role::hint, corner, words, style, content.theme.accent);
}

}  // namespace

void add_hand_words(const StageLayer& layer) {
  const auto& [content, layout, canvas] = layer;
  if (content.audience.sees_show) return add_show_words(layer);
  const bool is_asked_to_drag = content.hint == StageHint::drag;
  const StageLanguage::Labels& all = content.language.labels;
  // Lessons ask for a depth.
  const double deep = depth_in_wall(content.settings, content.moment.goal);
  const std::string words = content.moment.is_measured                    ? std::string(all.hand_inferred)
                            : is_asked_to_drag                            ? std::string(all.hand_to_drag)
                            : content.lesson && deep >= least_shown_slide ? filled(all.hand_in_wall, slide_number(deep))
                                                                          : std::string(all.hand);
  const std::vector<std::string> measured =
      content.measuring ? measured_hand_words(*content.measuring, content.language) : std::vector<std::string>();
  const bool stands_out = is_asked_to_drag || !measured.empty();
  canvas.label(Role::hand,
               {is_asked_to_drag   ? StageLabel::hint
                : measured.empty() ? StageLabel::hand
                                   : StageLabel::measured_hand,
                is_asked_to_drag || measured.empty() ? std::vector{words} : measured,
                stands_out ? layout.letters.bold_words : layout.letters.words, canvas.at(content.moment.goal),
                canvas.at(content.moment.goal), canvas.points(content.measuring ? measuring_ring + 6.0 : 34.0),
                Vector<2>(0.5, -1.0)},
               stands_out ? content.theme.accent : content.theme.text);
}

void add_motor_words(const StageLayer& layer) {
  const auto& [content, layout, canvas] = layer;
  if (content.moment.weights[index_of(StrategyId::full)] > 0.0) return;
  const StageLanguage::Labels& all = content.language.labels;
  // Whoever feels tones must not take them for the wall. The mode that measures says so by itself.
  const bool trembles = content.audience.feels_tones && !content.measuring;
  const bool is_asked_to_turn = content.hint == StageHint::motor && !trembles;
  const MotorReach motors = motor_reach(content.settings, content.moment.handle);
  if (motors.count == 0) return;
  const Vector<2>& along = motors.directions[0];
  const double angle = content.settings.general.mechanism == MechanismKind::axes ? content.settings.actuated_angle
                                                                                 : std::atan2(along.y, along.x);
  const std::string direction = rail_words(angle, content.language);
  const bool is_one_of_two = content.motors_in_use && *content.motors_in_use != MotorsInUse::both;
  const int number = content.motors_in_use == MotorsInUse::second ? 2 : 1;
  const std::string words = trembles            ? std::string(all.motor_measures)
                            : is_asked_to_turn  ? std::string(all.motor_to_turn)
                            : motors.only_pulls ? std::string(all.strings_pull)
                            : is_one_of_two     ? filled(content.language.device.motor_pushes, number, direction)
                                                : filled(all.motor_pushes, direction);
  const auto ends =
      motors.only_pulls
          ? std::array{canvas.at(content.moment.handle), canvas.at(content.settings.general.strings.anchors[0])}
          : stage_grips(content.settings, content.moment, canvas.camera, layout, content.held_end).motor;
  const Vector<2> rail = to_screen_direction(along);
  canvas.label(Role::motor_axis,
               {is_asked_to_turn ? StageLabel::hint : StageLabel::motor,
                {words},
                is_asked_to_turn ? layout.letters.bold_words : layout.letters.words,
                ends[0],
                ends[1],
                canvas.points(10.0),
                lower_side(rail),
                ends[1].x > ends[0].x ? 0.85 : 0.15,
                !is_asked_to_turn},
               is_asked_to_turn ? content.theme.accent : content.theme.faint_text);
}

void add_stage_words(const StageLayer& layer) {
  add_force_words(layer);
  add_slide_words(layer);
  add_handle_words(layer);
  add_share_words(layer);
  add_hand_words(layer);
  add_expectation_words(layer);
  add_motor_words(layer);
  add_wall_words(layer);
}

std::string hover_words(const StageAction& action, const StageLanguage& language, const StageKeys& keys) {
  if (const auto* const mode = std::get_if<StageMode>(&action)) {
    const auto entry = std::ranges::find(stage_mode_catalog(), *mode, &StageModeEntry::id);
    const StageLanguage::Mode& words = language.modes.*entry->words;
    return fmt::format("{} ({}): {}", words.title, entry->key, words.about);
  }
  if (action == StageAction(StageCommand::lessons)) return filled(language.hovers.lessons, keys.lessons);
  if (action == StageAction(StageCommand::menu)) return std::string(language.hovers.more);
  if (action == StageAction(StageCommand::fit)) return std::string(language.hovers.fit);
  if (action == StageAction(StageCommand::reset)) return std::string(language.hovers.reset);
  if (action == StageAction(StageCommand::reset_all)) return std::string(language.hovers.reset_all);
  if (const auto* const motors = std::get_if<MotorsInUse>(&action)) {
    return std::string(*motors == MotorsInUse::both ? language.device.about_both_motors
                                                    : language.device.about_one_motor);
  }
  if (action == StageAction(StageCommand::leave)) return std::string(language.hovers.leave_lesson);
  return {};
}

std::vector<StageButton> key_hints(const StageLanguage& language, const StageKeys& keys) {
  if (keys.link.empty()) return {};
  const StageLanguage::Buttons& all = language.buttons;
  return {{StageCommand::link, {}, filled(all.link, keys.link)},
          {StageCommand::lessons, {}, filled(all.lessons, keys.lessons)},
          {StageCommand::keys, {}, filled(all.keys, keys.help)}};
}

std::vector<StageMenuRow> stage_menu(const StageLanguage& language, const StageKeys& keys) {
  std::vector<StageMenuRow> rows;
  for (const StageModeEntry& mode : stage_mode_catalog()) {
    const StageLanguage::Mode& words = language.modes.*mode.words;
    if (mode.is_in_menu) rows.push_back({mode.id, words.title, mode.key, words.about});
  }
  const StageLanguage::MenuRows& all = language.menu_rows;
  rows.push_back({Face::workbench, all.workbench.title, "F4", all.workbench.about});
  rows.push_back({StageCommand::palette, all.actions.title, "Ctrl+P", all.actions.about});
  if (!keys.controls.empty()) {
    rows.push_back({StageCommand::controls, all.controls.title, keys.controls, all.controls.about});
  }
  if (!keys.full_screen.empty()) {
    rows.push_back({StageCommand::full_screen, all.full_screen.title, keys.full_screen, all.full_screen.about});
  }
  rows.push_back({StageCommand::keys, all.keys.title, keys.help, all.keys.about});
  return rows;
}

}  // namespace ghostforce
