// The words beside the things of the stage, the most important first.
#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "app/view/stage/stage_layers.h"

namespace ghostforce {
namespace {

// The lower one of both directions across a line on the screen; of an upright line the right one.
Vector<2> lower_side(const Vector<2>& along) {
  const Vector<2> across{-along.y, along.x};
  return across.y > 0.0 || (across.y == 0.0 && across.x > 0.0) ? across : -across;
}

void add_force_words(const StageLayer& layer) {
  const auto& [content, layout, canvas] = layer;
  const StageMoment& moment = content.moment;
  const auto arrow = force_arrow(layer);
  if (!arrow) return;
  const Vector<2> below = lower_side(arrow->direction);
  const double half = canvas.points(arrow_width);
  if (glm::length(moment.ghost_force) >= least_shown_force) {
    const Vector<2> middle = arrow->share_end() + 0.5 * arrow->ghost * arrow->direction;
    canvas.label(Role::ghost_force,
                 {StageLabel::ghost,
                  {fmt::format("ghost {} N", force_number(glm::length(moment.ghost_force)))},
                  layout.letters.bold_words,
                  middle,
                  half,
                  below + 0.4 * arrow->direction},
                 content.theme.strategy_text[index_of(StrategyId::naive)]);
  }
}

void add_share_words(const StageLayer& layer) {
  const auto& [content, layout, canvas] = layer;
  const auto arrow = force_arrow(layer);
  const double share = glm::length(content.moment.wall_share);
  if (!arrow || share < least_shown_force) return;
  canvas.label(Role::wall_share,
               {StageLabel::wall_share,
                {fmt::format("{} {} N", content.moment.is_measured ? "motor" : "wall", force_number(share))},
                layout.letters.words,
                arrow->start + 0.5 * arrow->share * arrow->direction,
                canvas.points(arrow_width),
                lower_side(arrow->direction) - 0.3 * arrow->direction},
               content.theme.text);
}

void add_slide_words(const StageLayer& layer) {
  const auto& [content, layout, canvas] = layer;
  const auto ruler = slide_ruler(layer);
  const double slide = glm::length(content.moment.slide);
  if (!ruler || slide < least_shown_slide) return;
  canvas.label(Role::proxy_drift,
               {StageLabel::slide,
                {fmt::format("slid {} mm", slide_number(slide))},
                layout.letters.bold_words,
                0.5 * (ruler->from + ruler->to),
                canvas.points(12.0),
                ruler->out},
               stage_colour(content.moment, content.theme.strategy_text));
}

void add_thing_words(const StageLayer& layer) {
  const auto& [content, layout, canvas] = layer;
  const Theme& theme = content.theme;
  const StageMoment& moment = content.moment;
  const StageLetters& letters = layout.letters;
  const Vector<2> handle = canvas.at(moment.handle);
  const Vector<2> goal = canvas.at(moment.goal);
  const Vector<2> inwards = -to_screen_direction(direction_at(content.settings.wall_normal_angle));
  const Vector<2> rail = to_screen_direction(direction_at(content.settings.actuated_angle));

  canvas.label(Role::device,
               {StageLabel::handle,
                {"handle"},
                letters.bold_words,
                handle,
                canvas.points(1.4 * handle_radius),
                Vector<2>(0.6, -1.0)},
               stage_colour(moment, theme.strategy_text));
  add_share_words(layer);
  const bool is_asked_to_drag = content.hint == StageHint::drag;
  std::string hand_words = is_asked_to_drag ? "drag me: your hand pulls here" : "your hand pulls here";
  if (moment.is_measured) hand_words = "your hand, inferred";
  canvas.label(Role::hand,
               {StageLabel::hand,
                {std::move(hand_words)},
                is_asked_to_drag ? letters.bold_words : letters.words,
                goal,
                canvas.points(34.0),
                Vector<2>(0.5, -1.0)},
               is_asked_to_drag ? theme.accent : theme.text);
  if (moment.in_contact && !moment.is_measured) {
    const Vector<2> rest = canvas.at(moment.expected_rest);
    if (glm::distance(rest, handle) > canvas.points(2.0 * handle_radius)) {
      canvas.label(Role::expected_rest,
                   {StageLabel::expected_rest,
                    {"where it should rest"},
                    letters.words,
                    rest,
                    canvas.points(handle_radius),
                    Vector<2>(0.0, -1.0)},
                   theme.faint_text);
    }
    const Vector<2> foot = canvas.at(moment.expected_contact);
    if (glm::distance(foot, canvas.at(moment.proxy)) > canvas.points(26.0)) {
      canvas.label(Role::expected_contact,
                   {StageLabel::expected_contact,
                    {"the wall should hold here"},
                    letters.words,
                    foot,
                    canvas.points(7.0),
                    inwards + Vector<2>(0.6, -0.6)},
                   theme.faint_text);
    }
  }
  if (moment.weights[index_of(StrategyId::full)] == 0.0) {
    const bool is_asked_to_turn = content.hint == StageHint::motor;
    const std::string words = is_asked_to_turn
                                  ? "turn the motor by its ends"
                                  : "the only motor pushes " + motor_direction_words(content.settings.actuated_angle);
    const auto ends = stage_grips(content.settings, moment, canvas.camera, canvas.unit).motor;
    const bool is_right = ends[1].x > ends[0].x;
    const Vector<2> end = is_right ? ends[1] : ends[0];
    canvas.label(Role::motor_axis,
                 {StageLabel::motor,
                  {words},
                  is_asked_to_turn ? letters.bold_words : letters.words,
                  0.35 * handle + 0.65 * end,
                  canvas.points(10.0),
                  lower_side(rail)},
                 is_asked_to_turn ? theme.accent : theme.faint_text);
  }
  // Deep in the wall, above the hand.
  const Vector<2> inside = canvas.at(wall_of(content.settings).point) + inwards * canvas.points(150.0) +
                           Vector<2>(-inwards.y, inwards.x) * canvas.points(inwards.x >= 0.0 ? -230.0 : 230.0);
  canvas.label(Role::wall, {StageLabel::wall, {"virtual wall"}, letters.words, inside, 0.0, inwards}, theme.faint_text);
}

}  // namespace

void add_stage_words(const StageLayer& layer) {
  add_force_words(layer);
  add_slide_words(layer);
  add_thing_words(layer);
}

}  // namespace ghostforce
