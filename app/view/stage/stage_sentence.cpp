#include "app/view/stage/stage_sentence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "core/units.h"

namespace ghostforce {
namespace {

// What the sentences are chosen by.
struct Facts {
  const Settings& settings;
  const StageMoment& moment;
  const StageAudience& audience;
  double ghost;          // of the moment, with its sign [N]
  double ghost_at_rest;  // that the active strategy comes to under this goal [N]
  double motor_along;    // cosine between the wall's normal and the motor

  bool is(StrategyId id) const { return moment.weights[index_of(id)] == 1.0; }
  // On the way between the two strategies with one motor, or about to leave.
  bool is_on_the_way() const {
    const bool is_about_to_leave = settings.active != StrategyId::full && !is(settings.active);
    return moment.is_between() || is_about_to_leave;
  }
  bool has_ghost() const { return std::abs(ghost) >= least_shown_force; }
  bool has_none_at_rest() const { return std::abs(ghost_at_rest) < least_shown_force; }
  bool is_at_rest() const {
    constexpr double near = 0.0005;  // [m]
    return glm::distance(moment.handle, moment.expected_rest) < near && glm::length(moment.slide) < near;
  }
  bool believes_wrongly() const {
    const Stiffnesses& all = settings.stiffnesses;
    return !all.chosen_tracking_ratio && all.believed_k_u && *all.believed_k_u != all.k_u;
  }
};

struct Sentence {
  std::string_view words;
  bool (*is_true)(const Facts&);
};

// The first that is true is the one.
constexpr std::array sentences{
    Sentence{"In your hand: the goal is inferred, so the ghost force cannot be known.",
             [](const Facts& now) {
               return now.moment.is_measured && now.moment.in_contact && !now.moment.knows_ghost_force;
             }},
    Sentence{
        "Aim at the target and push the handle into the wall.",
        [](const Facts& now) { return now.moment.is_measured && !now.moment.in_contact && now.moment.has_target; }},
    Sentence{"Push the handle into the wall.",
             [](const Facts& now) { return now.moment.is_measured && !now.moment.in_contact; }},
    Sentence{"You aim at the target, and a ghost force drags you along the wall.",
             [](const Facts& now) { return now.moment.is_measured && now.has_ghost(); }},
    Sentence{"You aim at the target, and there is no ghost force.",
             [](const Facts& now) { return now.moment.is_measured; }},
    Sentence{"Drag the hand into the wall.",
             [](const Facts& now) {
               return !now.moment.in_contact && now.audience.can_drag && !now.audience.looks_back &&
                      depth(wall_of(now.settings), now.moment.goal) <= 0.0;
             }},
    Sentence{"The handle is in front of the wall: nothing pushes it.",
             [](const Facts& now) { return !now.moment.in_contact; }},
    Sentence{"Two motors: the wall feels right.", [](const Facts& now) { return now.is(StrategyId::full); }},
    Sentence{"One motor becomes two.",
             [](const Facts& now) {
               return now.moment.weights[index_of(StrategyId::full)] > 0.0 &&
                      now.audience.heads_for == StrategyId::full;
             }},
    Sentence{"Two motors become one.",
             [](const Facts& now) { return now.moment.weights[index_of(StrategyId::full)] > 0.0; }},
    Sentence{"The only motor pushes along the wall: it cannot hold the hand.",
             [](const Facts& now) { return std::abs(now.motor_along) < 0.02; }},
    Sentence{"On the way to the cure: still a ghost force.",
             [](const Facts& now) {
               return now.is_on_the_way() && now.has_ghost() && now.audience.heads_for == StrategyId::anisotropic;
             }},
    Sentence{"On the way back to naïve: a ghost force.",
             [](const Facts& now) { return now.is_on_the_way() && now.has_ghost(); }},
    Sentence{"On the way between the two: no ghost force.", [](const Facts& now) { return now.is_on_the_way(); }},
    // Naïve.
    Sentence{"A ghost force drags the handle along the wall.",
             [](const Facts& now) { return now.is(StrategyId::naive) && now.ghost >= least_shown_force; }},
    Sentence{"The motor pushes too little while the hand moves.",
             [](const Facts& now) { return now.is(StrategyId::naive) && now.has_ghost(); }},
    Sentence{"One motor, straight at the wall: no ghost force here.",
             [](const Facts& now) { return now.is(StrategyId::naive) && std::abs(now.motor_along) > 0.9998; }},
    Sentence{"Press deeper: there is hardly any ghost force here.",
             [](const Facts& now) { return now.is(StrategyId::naive); }},
    // Anisotropic.
    Sentence{"Same motor, same hand: the ghost force is gone.",
             [](const Facts& now) { return !now.has_ghost() && now.is_at_rest() && now.has_none_at_rest(); }},
    Sentence{"Hold the hand still, and the ghost force goes away.",
             [](const Facts& now) { return now.has_none_at_rest(); }},
    Sentence{"The hand is stiffer than believed: a ghost force is left.",
             [](const Facts& now) {
               return now.has_ghost() && now.believes_wrongly() &&
                      now.settings.stiffnesses.k_u > *now.settings.stiffnesses.believed_k_u;
             }},
    Sentence{"The hand is softer than believed: a ghost force is left.",
             [](const Facts& now) { return now.has_ghost() && now.believes_wrongly(); }},
    Sentence{"This ratio does not fit the hand: a ghost force is left.",
             [](const Facts& now) { return now.has_ghost(); }},
    Sentence{"Hold the hand still: a small ghost force will remain.", [](const Facts&) { return true; }},
};

// Three digits, whatever the size.
std::string three_digits(double size) {
  const int decimals = size < 9.995 ? 2 : size < 99.95 ? 1 : 0;
  return fmt::format("{:.{}f}", size, decimals);
}

}  // namespace

std::string_view stage_sentence(const Settings& settings, const StageMoment& moment, const StageAudience& audience) {
  const double motor_along = glm::dot(direction_at(settings.wall_normal_angle), direction_at(settings.actuated_angle));
  const double at_rest = signed_ghost_force(stage_moment_at_rest(settings, moment.goal));
  const Facts now{settings, moment, audience, signed_ghost_force(moment), at_rest, motor_along};
  return std::ranges::find_if(sentences, [&](const Sentence& sentence) { return sentence.is_true(now); })->words;
}

StageNumbers stage_numbers(const StageMoment& moment) noexcept {
  StageNumbers numbers{.force = glm::length(moment.wall_share + moment.ghost_force)};
  if (moment.knows_ghost_force) {
    numbers.wall_share = glm::length(moment.wall_share);
    numbers.ghost_force = signed_ghost_force(moment);
  }
  if (!moment.is_measured || moment.has_target) numbers.slide = glm::length(moment.slide);
  return numbers;
}

std::string force_number(double newton) {
  return three_digits(std::abs(newton));
}

std::string slide_number(double metres) {
  const double mm = std::abs(metres) * mm_per_m;
  return mm < 99.95 ? fmt::format("{:.1f}", mm) : fmt::format("{:.0f}", mm);
}

std::string motor_direction_words(double actuated_angle) {
  // An axis has two ends: 30° and 210° are the same.
  double degrees = std::remainder(actuated_angle * degrees_per_radian, 180.0);
  if (std::abs(degrees) < 0.5) return "left and right";
  if (std::abs(degrees) > 89.5) return "up and down";
  return fmt::format("at {:.0f}°", degrees < 0.0 ? degrees + 180.0 : degrees);
}

}  // namespace ghostforce
