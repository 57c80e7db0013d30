#include "app/stage/stage_sentence.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "core/conventions.h"
#include "core/scene_shape.h"

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

  // Of a general scene's device, while naïve rendering drags its handle.
  bool has_ghost_of(MechanismKind kind) const {
    return settings.general.mechanism == kind && is(StrategyId::naive) && ghost >= least_dragging_force;
  }
  bool has_motor_at_elbow() const { return settings.general.arm.motor == TwoLinkArm::Motor::elbow; }
  bool has_slack_string() const {
    if (!has_strings(settings) || !moment.in_contact) return false;
    return slack_strings(settings, efforts_of(settings, moment.handle, moment.wall_share + moment.ghost_force)) > 0;
  }
  // Naïve rendering presses into a wall that would not be touched.
  bool is_dragged_into_corner() const {
    if (settings.general.constraint != ConstraintKind::corner || !is(StrategyId::naive)) return false;
    const auto full = rest_of(StrategyId::full, settings, moment.goal);
    const auto walls = [&](const Vector<2>& proxy) { return std::popcount(acting_walls(settings, proxy, true)); };
    return full && full->at.in_contact && walls(moment.proxy) > walls(full->at.proxy);
  }
  bool is(StrategyId id) const { return moment.weights[index_of(id)] == 1.0; }
  // On the way between the two strategies with one motor, or about to leave.
  bool is_on_the_way() const {
    const bool is_about_to_leave = settings.active != StrategyId::full && !is(settings.active);
    return moment.is_between() || is_about_to_leave;
  }
  bool has_ghost() const { return std::abs(ghost) >= least_shown_force; }
  bool has_none_at_rest() const { return std::abs(ghost_at_rest) < least_shown_force; }
  // Tones move the handle by some tenths of a millimetre, and a soft hand by more.
  bool is_at_rest_but_for_tones() const {
    constexpr double near = 0.002;  // [m]
    return audience.feels_tones && glm::distance(moment.handle, moment.expected_rest) < near;
  }
  bool is_at_rest() const {
    constexpr double near = 0.0005;  // [m]
    return glm::distance(moment.handle, moment.expected_rest) < near && glm::length(moment.slide) < near;
  }
  bool believes_wrongly() const {
    const Stiffnesses& all = settings.stiffnesses;
    return !all.chosen_tracking_ratio && all.believed_k_u && *all.believed_k_u != all.k_u;
  }
};

using Sentences = StageLanguage::Sentences;

struct Sentence {
  std::string_view Sentences::*words;
  bool (*is_true)(const Facts&);
};

// The first that is true is the one.
constexpr std::array sentences{
    Sentence{&Sentences::in_hand,
             [](const Facts& now) {
               return now.moment.is_measured && now.moment.in_contact && !now.moment.knows_ghost_force;
             }},
    Sentence{
        &Sentences::aim_and_push,
        [](const Facts& now) { return now.moment.is_measured && !now.moment.in_contact && now.moment.has_target; }},
    Sentence{&Sentences::push, [](const Facts& now) { return now.moment.is_measured && !now.moment.in_contact; }},
    Sentence{&Sentences::aimed_with_ghost, [](const Facts& now) { return now.moment.is_measured && now.has_ghost(); }},
    Sentence{&Sentences::aimed_without_ghost, [](const Facts& now) { return now.moment.is_measured; }},
    Sentence{&Sentences::no_rest,
             [](const Facts& now) {
               return !now.moment.has_rest && now.is(StrategyId::naive) &&
                      motor_reach(now.settings, now.moment.goal).count > 0;
             }},
    Sentence{&Sentences::no_rest_for_cure,
             [](const Facts& now) {
               return !now.moment.has_rest && now.is(StrategyId::anisotropic) &&
                      motor_reach(now.settings, now.moment.goal).count > 0;
             }},
    Sentence{&Sentences::out_of_reach,
             [](const Facts& now) {
               return now.moment.is_outside ||
                      (!now.moment.has_rest && motor_reach(now.settings, now.moment.goal).count == 0);
             }},
    Sentence{&Sentences::drag_into_wall,
             [](const Facts& now) {
               return !now.moment.in_contact && now.audience.can_drag && !now.audience.looks_back &&
                      depth_in_wall(now.settings, now.moment.goal) <= 0.0;
             }},
    Sentence{&Sentences::in_front_of_wall, [](const Facts& now) { return !now.moment.in_contact; }},
    Sentence{&Sentences::every_motor,
             [](const Facts& now) { return now.is(StrategyId::full) && has_strings(now.settings); }},
    Sentence{&Sentences::two_motors, [](const Facts& now) { return now.is(StrategyId::full); }},
    Sentence{&Sentences::one_becomes_two,
             [](const Facts& now) {
               return now.moment.weights[index_of(StrategyId::full)] > 0.0 &&
                      now.audience.heads_for == StrategyId::full;
             }},
    Sentence{&Sentences::two_become_one,
             [](const Facts& now) { return now.moment.weights[index_of(StrategyId::full)] > 0.0; }},
    Sentence{&Sentences::motor_along_wall, [](const Facts& now) { return std::abs(now.motor_along) < 0.02; }},
    Sentence{&Sentences::on_way_to_cure,
             [](const Facts& now) {
               return now.is_on_the_way() && now.has_ghost() && now.audience.heads_for == StrategyId::anisotropic;
             }},
    Sentence{&Sentences::on_way_to_naive, [](const Facts& now) { return now.is_on_the_way() && now.has_ghost(); }},
    Sentence{&Sentences::on_way_without_ghost, [](const Facts& now) { return now.is_on_the_way(); }},
    // Naïve.
    Sentence{&Sentences::dragged_into_corner,
             [](const Facts& now) { return now.has_ghost() && now.is_dragged_into_corner(); }},
    Sentence{&Sentences::arm_pushes_by_elbow,
             [](const Facts& now) { return now.has_ghost_of(MechanismKind::arm) && now.has_motor_at_elbow(); }},
    Sentence{&Sentences::arm_pushes_by_base, [](const Facts& now) { return now.has_ghost_of(MechanismKind::arm); }},
    Sentence{&Sentences::pantograph_throws,
             [](const Facts& now) { return now.has_ghost_of(MechanismKind::pantograph); }},
    Sentence{&Sentences::string_is_slack,
             [](const Facts& now) { return now.is(StrategyId::naive) && now.has_slack_string(); }},
    Sentence{&Sentences::naive_ghost,
             [](const Facts& now) { return now.is(StrategyId::naive) && now.ghost >= least_dragging_force; }},
    Sentence{&Sentences::naive_too_little,
             [](const Facts& now) { return now.is(StrategyId::naive) && now.ghost <= -least_dragging_force; }},
    Sentence{&Sentences::straight_at_wall,
             [](const Facts& now) { return now.is(StrategyId::naive) && std::abs(now.motor_along) > 0.9998; }},
    Sentence{&Sentences::press_deeper, [](const Facts& now) { return now.is(StrategyId::naive); }},
    // Anisotropic.
    Sentence{&Sentences::cured,
             [](const Facts& now) { return !now.has_ghost() && now.is_at_rest() && now.has_none_at_rest(); }},
    Sentence{&Sentences::cured_but_for_tones,
             [](const Facts& now) { return now.has_none_at_rest() && now.is_at_rest_but_for_tones(); }},
    Sentence{&Sentences::hold_still, [](const Facts& now) { return now.has_none_at_rest(); }},
    Sentence{&Sentences::stiffer_than_believed,
             [](const Facts& now) {
               return now.has_ghost() && now.believes_wrongly() &&
                      now.settings.stiffnesses.k_u > *now.settings.stiffnesses.believed_k_u;
             }},
    Sentence{&Sentences::softer_than_believed,
             [](const Facts& now) { return now.has_ghost() && now.believes_wrongly(); }},
    Sentence{&Sentences::wrong_ratio, [](const Facts& now) { return now.has_ghost(); }},
    Sentence{&Sentences::ghost_will_remain, [](const Facts&) { return true; }},
};

// Three digits, whatever the size.
std::string three_digits(double size) {
  const int decimals = size < 9.995 ? 2 : size < 99.95 ? 1 : 0;
  return fmt::format("{:.{}f}", size, decimals);
}

}  // namespace

std::string stage_sentence(const Settings& settings, const StageMoment& moment, const StageAudience& audience,
                           const StageLanguage& language) {
  const MotorReach motors = motor_reach(settings, moment.handle);
  constexpr double neither = 0.5;  // along the wall, nor straight at it
  const double motor_along = motors.only_pulls || motors.count == 0
                                 ? neither
                                 : glm::dot(wall_near(settings, moment.expected_contact).normal, motors.directions[0]);
  const double at_rest = signed_ghost_force(stage_moment_at_rest(settings, moment.goal));
  const Facts now{settings, moment, audience, signed_ghost_force(moment), at_rest, motor_along};
  const auto* const found =
      std::ranges::find_if(sentences, [&](const Sentence& sentence) { return sentence.is_true(now); });
  return filled(language.sentences.*found->words, slide_number(glm::length(moment.slide)));
}

StageNumbers stage_numbers(const StageMoment& moment) noexcept {
  StageNumbers numbers{.force = glm::length(moment.wall_share + moment.ghost_force)};
  if (!moment.has_rest) return numbers;  // a handle that runs away has none worth telling
  if (moment.knows_ghost_force) {
    numbers.wall_share = glm::length(moment.wall_share);
    numbers.ghost_force = signed_ghost_force(moment);
  }
  if (moment.knows_slide()) numbers.slide = glm::length(moment.slide);
  return numbers;
}

std::string_view words_of_ghost_force(const std::optional<double>& newton,
                                      const StageLanguage::Numbers& words) noexcept {
  if (!newton) return words.ghost_force_unknown;
  return *newton <= -least_shown_force ? words.negative_ghost_force : words.ghost_force;
}

std::string force_number(double newton) {
  return three_digits(std::abs(newton));
}

std::string slide_number(double metres) {
  const double mm = std::abs(metres) * mm_per_m;
  return mm < 99.95 ? fmt::format("{:.1f}", mm) : fmt::format("{:.0f}", mm);
}

namespace {

// An axis has two ends: 30° and 210° are the same.
double degrees_of_axis(double angle) {
  const double degrees = std::remainder(angle * degrees_per_radian, 180.0);
  return degrees < 0.0 ? degrees + 180.0 : degrees;
}

// Empty for an axis that is neither level nor upright.
std::string_view words_of_axis(double degrees, const StageLanguage& language) {
  constexpr double near = 0.5;
  if (degrees < near || degrees > 180.0 - near) return language.labels.left_and_right;
  return std::abs(degrees - 90.0) < near ? std::string_view(language.labels.up_and_down) : "";
}

}  // namespace

std::string rail_words(double actuated_angle, const StageLanguage& language) {
  const std::string_view words = words_of_axis(degrees_of_axis(actuated_angle), language);
  return std::string(words.empty() ? language.labels.along_rail : words);
}

std::string motor_direction_words(double actuated_angle, const StageLanguage& language) {
  const double degrees = degrees_of_axis(actuated_angle);
  const std::string_view words = words_of_axis(degrees, language);
  return words.empty() ? filled(language.labels.at_angle, fmt::format("{:.0f}", degrees)) : std::string(words);
}

std::string force_direction_words(const Vector<2>& force, const StageLanguage& language) {
  const StageLanguage::Directions& all = language.directions;
  const std::array ways{all.right, all.up_right,  all.up,   all.up_left,
                        all.left,  all.down_left, all.down, all.down_right};
  const double eighths = std::round(std::atan2(force.y, force.x) * degrees_per_radian / 45.0);
  return std::string(ways[static_cast<std::size_t>(eighths + 8.0) % 8]);
}

}  // namespace ghostforce
