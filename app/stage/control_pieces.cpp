#include "app/stage/control_pieces.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/picture/text.h"
#include "app/state/permit.h"
#include "core/scene_shape.h"

namespace ghostforce {
namespace {

constexpr double reach_mm = 60.0;  // of the sliders, each way; more where the hand is farther away
constexpr double step_mm = 1.0;

std::string refusal_of(const ControlSource& source, const Action& action) {
  const auto refusal = permit(source.session, action);
  return refusal ? std::string(source.language.refusals.*refusal->words) : std::string();
}

ControlRange range_round_wall(double value_mm) {
  const double reach = std::max(reach_mm, 10.0 * std::ceil(std::abs(value_mm) / 10.0));
  return {.value = value_mm, .least = -reach, .greatest = reach, .step = step_mm};
}

// Along the wall, to the right; upwards where the wall is upright.
Vector<2> direction_along(const Wall<2>& wall) {
  const Vector<2> along{wall.normal.y, -wall.normal.x};
  return along.x > 0.0 || (along.x == 0.0 && along.y > 0.0) ? along : -along;
}

struct PlaceAtWall {
  double depth_mm;
  double along_mm;
};

PlaceAtWall place_at(const Wall<2>& wall, const Vector<2>& place) {
  return {mm_per_m * depth(wall, place), mm_per_m * glm::dot(direction_along(wall), place - wall.point)};
}

Vector<2> world_place(const Wall<2>& wall, const PlaceAtWall& at) {
  return wall.point - wall.normal * (at.depth_mm / mm_per_m) + direction_along(wall) * (at.along_mm / mm_per_m);
}

// "12.0 mm deep in the wall".
std::string depth_words(double depth_mm, const StageLanguage& language) {
  const StageLanguage::Controls& all = language.controls;
  return filled(depth_mm >= 0.0 ? all.in_wall : all.in_front_of_wall, decimal_text(std::abs(depth_mm), 1));
}

// Two ranges for one place.
void add_place(const ControlSource& source, ControlParts& parts, const std::string& id, std::string_view depth_name,
               std::string_view along_name, const Vector<2>& place,
               const std::function<std::vector<Action>(const Vector<2>&)>& move) {
  const Wall<2> wall = wall_near(source.session.settings, place);
  const PlaceAtWall at = place_at(wall, place);
  parts.push_back(range_control(source, id + "-depth", depth_name, depth_words(at.depth_mm, source.language),
                                range_round_wall(at.depth_mm), [=](double value) {
                                  return move(world_place(wall, {value, at.along_mm}));
                                }));
  parts.push_back(range_control(source, id + "-along", along_name, decimal_text(at.along_mm, 1) + " mm",
                                range_round_wall(at.along_mm), [=](double value) {
                                  return move(world_place(wall, {at.depth_mm, value}));
                                }));
}

}  // namespace

StageControl text_control(std::string id, StageControlKind kind, std::string words) {
  return {.id = std::move(id), .kind = kind, .words = std::move(words)};
}

StageControl group_control(std::string id, StageControlKind kind, std::string_view words, ControlParts parts) {
  return {.id = std::move(id), .kind = kind, .words = std::string(words), .parts = std::move(parts)};
}

StageControl button_control(const ControlSource& source, std::string id, std::string words, const Action& action) {
  return {.id = std::move(id),
          .kind = StageControlKind::button,
          .words = std::move(words),
          .refusal = refusal_of(source, action),
          .act = [action](double) { return std::vector{action}; }};
}

StageControl range_control(const ControlSource& source, std::string id, std::string_view words, std::string about,
                           const ControlRange& range, StageControl::Act act) {
  return {.id = std::move(id),
          .kind = StageControlKind::range,
          .words = std::string(words),
          .about = std::move(about),
          .refusal = refusal_of(source, act(range.value).front()),
          .value = range.value,
          .least = range.least,
          .greatest = range.greatest,
          .step = range.step,
          .act = std::move(act)};
}

std::string hand_words(const ControlSource& source) {
  const PlaceAtWall at = place_at(wall_near(source.session.settings, source.session.goal), source.session.goal);
  return filled(source.language.controls.hand, depth_words(at.depth_mm, source.language), decimal_text(at.along_mm, 1));
}

void add_hand_controls(const ControlSource& source, ControlParts& parts) {
  const StageLanguage::Controls& all = source.language.controls;
  add_place(source, parts, "hand", all.hand_depth, all.hand_along, source.session.goal, [](const Vector<2>& goal) {
    return std::vector<Action>{MoveHandTo{goal}, LetGoOfHand{}};
  });
}

void add_guess_controls(const ControlSource& source, ControlParts& parts) {
  const StageLanguage::Controls& all = source.language.controls;
  const StageChoice& stage = source.session.stage;
  if (!stage.guess || !stage.guess_is_open) return;
  add_place(source, parts, "guess", all.guess_depth, all.guess_along, *stage.guess,
            [](const Vector<2>& guess) { return std::vector<Action>{MoveGuessTo{guess}}; });
}

}  // namespace ghostforce
