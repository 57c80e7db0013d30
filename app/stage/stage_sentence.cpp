#include "app/stage/stage_sentence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "core/conventions.h"

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
    Sentence{&Sentences::drag_into_wall,
             [](const Facts& now) {
               return !now.moment.in_contact && now.audience.can_drag && !now.audience.looks_back &&
                      depth(wall_of(now.settings), now.moment.goal) <= 0.0;
             }},
    Sentence{&Sentences::in_front_of_wall, [](const Facts& now) { return !now.moment.in_contact; }},
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
    Sentence{&Sentences::naive_ghost,
             [](const Facts& now) { return now.is(StrategyId::naive) && now.ghost >= least_shown_force; }},
    Sentence{&Sentences::naive_too_little,
             [](const Facts& now) { return now.is(StrategyId::naive) && now.has_ghost(); }},
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

std::string_view stage_sentence(const Settings& settings, const StageMoment& moment, const StageAudience& audience,
                                const StageLanguage& language) {
  const double motor_along = glm::dot(direction_at(settings.wall_normal_angle), direction_at(settings.actuated_angle));
  const double at_rest = signed_ghost_force(stage_moment_at_rest(settings, moment.goal));
  const Facts now{settings, moment, audience, signed_ghost_force(moment), at_rest, motor_along};
  const auto* const found =
      std::ranges::find_if(sentences, [&](const Sentence& sentence) { return sentence.is_true(now); });
  return language.sentences.*found->words;
}

StageNumbers stage_numbers(const StageMoment& moment) noexcept {
  StageNumbers numbers{.force = glm::length(moment.wall_share + moment.ghost_force)};
  if (moment.knows_ghost_force) {
    numbers.wall_share = glm::length(moment.wall_share);
    numbers.ghost_force = signed_ghost_force(moment);
  }
  if (moment.knows_slide()) numbers.slide = glm::length(moment.slide);
  return numbers;
}

std::string force_number(double newton) {
  return three_digits(std::abs(newton));
}

std::string slide_number(double metres) {
  const double mm = std::abs(metres) * mm_per_m;
  return mm < 99.95 ? fmt::format("{:.1f}", mm) : fmt::format("{:.0f}", mm);
}

std::string motor_direction_words(double actuated_angle, const StageLanguage& language) {
  // An axis has two ends: 30° and 210° are the same.
  double degrees = std::remainder(actuated_angle * degrees_per_radian, 180.0);
  if (std::abs(degrees) < 0.5) return std::string(language.labels.left_and_right);
  if (std::abs(degrees) > 89.5) return std::string(language.labels.up_and_down);
  return filled(language.labels.at_angle, fmt::format("{:.0f}", degrees < 0.0 ? degrees + 180.0 : degrees));
}

}  // namespace ghostforce
