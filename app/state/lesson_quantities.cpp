#include "app/state/lesson_quantities.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <variant>

#include <glm/geometric.hpp>

#include "app/files/scene_keys.h"
#include "app/picture/text.h"
#include "core/conventions.h"
#include "core/scene_shape.h"

namespace ghostforce {
namespace {

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();
constexpr double mJ_per_J = 1000.0;

// Nobody knows where a measured hand wants to be, unless it was told.
bool knows_goal(const StageMoment& moment) noexcept {
  return !moment.is_measured || moment.has_target;
}

// No task is done by a handle that touches nothing.
double ghost_force_size(const LessonReading& now) noexcept {
  const bool is_known = knows_goal(now.moment) && now.moment.knows_ghost_force;
  return is_known ? glm::length(now.moment.ghost_force) : not_known;
}

Efforts efforts_now(const LessonReading& now) noexcept {
  return efforts_of(now.settings, now.moment.handle, now.moment.wall_share + now.moment.ghost_force);
}

constexpr std::array quantities{
    LessonQuantityEntry{
        LessonQuantity::depth, "depth_mm", "how deep in the wall the hand is; negative in front of it",
        [](const LessonReading& now) noexcept { return mm_per_m * depth_in_wall(now.settings, now.moment.goal); }},
    LessonQuantityEntry{
        LessonQuantity::force, "force_N", "how hard the motors push, the ghost force included",
        [](const LessonReading& now) noexcept { return glm::length(now.moment.wall_share + now.moment.ghost_force); }},
    LessonQuantityEntry{LessonQuantity::ghost_force, "ghost_force_N", "the ghost force, whichever way it points",
                        [](const LessonReading& now) noexcept { return ghost_force_size(now); }},
    LessonQuantityEntry{LessonQuantity::slide, "slide_mm",
                        "how far the hollow mark has slid along the wall, either way",
                        [](const LessonReading& now) noexcept {
                          return knows_goal(now.moment) ? mm_per_m * glm::length(now.moment.slide) : not_known;
                        }},
    LessonQuantityEntry{LessonQuantity::handle_to_target, "handle_to_target_mm",
                        "from the handle to where it would rest without a ghost force",
                        [](const LessonReading& now) noexcept {
                          return mm_per_m * glm::distance(now.moment.handle, now.moment.expected_rest);
                        }},
    LessonQuantityEntry{LessonQuantity::angle, "angle_deg",
                        "between the motor and the wall's push: 0 straight at the wall, 90 along it",
                        [](const LessonReading& now) noexcept {
                          const double cosine = glm::dot(wall_near(now.settings, now.moment.goal).normal,
                                                         rail_direction(now.settings, now.moment.handle));
                          return degrees_per_radian * std::acos(std::min(std::abs(cosine), 1.0));
                        }},
    LessonQuantityEntry{LessonQuantity::energy, "energy_mJ",
                        "that the wall gave to the hand on the last round; negative: took from it",
                        [](const LessonReading& now) noexcept {
                          if (now.circle == nullptr || now.circle->turns == 0) return not_known;
                          return mJ_per_J * now.circle->strategies[index_of(now.settings.active)].last.energy;
                        }},
    LessonQuantityEntry{LessonQuantity::turns, "turns", "complete rounds of the hand",
                        [](const LessonReading& now) noexcept {
                          return now.circle == nullptr ? not_known : static_cast<double>(now.circle->turns);
                        }},
    LessonQuantityEntry{LessonQuantity::belief, "belief",
                        "the stiffness that the program believes the hand has, over the hand's true one",
                        [](const LessonReading& now) noexcept {
                          return believed_user_stiffness(now.settings.stiffnesses) / now.settings.stiffnesses.k_u;
                        }},
    LessonQuantityEntry{LessonQuantity::hand, "hand_N_per_m", "how stiff the hand is, as it was measured in this step",
                        [](const LessonReading& now) noexcept { return now.hand_k_u.value_or(not_known); }},
    LessonQuantityEntry{LessonQuantity::effort, "effort",
                        "of the motor that works hardest, either way: in N, or in N·m where motors turn joints",
                        [](const LessonReading& now) noexcept {
                          double hardest = 0.0;
                          for (const double effort : efforts_now(now)) hardest = std::max(hardest, std::abs(effort));
                          return hardest;
                        }},
    LessonQuantityEntry{LessonQuantity::slack_strings, "slack_strings", "how many of the strings pull nothing",
                        [](const LessonReading& now) noexcept {
                          return has_strings(now.settings)
                                     ? static_cast<double>(slack_strings(now.settings, efforts_now(now)))
                                     : not_known;
                        }},
    LessonQuantityEntry{
        LessonQuantity::active_walls, "active_walls", "how many walls hold the hollow mark: 0, 1, or 2 in a corner",
        [](const LessonReading& now) noexcept {
          const StageMoment& moment = now.moment;
          return static_cast<double>(std::popcount(acting_walls(now.settings, moment.proxy, moment.in_contact)));
        }},
};

}  // namespace

std::span<const LessonQuantityEntry> lesson_quantity_catalog() noexcept {
  return quantities;
}

const LessonQuantityEntry& lesson_quantity(LessonQuantity id) noexcept {
  return *std::ranges::find(quantities, id, &LessonQuantityEntry::id);
}

double missed_by(const LessonCondition& condition, const LessonReading& reading) noexcept {
  const double value = lesson_quantity(condition.quantity).read(reading);
  if (std::isnan(value)) return value;
  return std::max({0.0, condition.least - value, value - condition.greatest});
}

bool is_met(const LessonCondition& condition, const LessonReading& reading) noexcept {
  return missed_by(condition, reading) == 0.0;
}

bool is_done(const LessonStep& task, const LessonReading& reading) noexcept {
  if (task.with && reading.settings.active != *task.with) return false;
  return std::ranges::all_of(task.conditions, [&](const LessonCondition& each) { return is_met(each, reading); });
}

namespace {

using SliderTexts = StageLanguage::Lessons;

struct SliderWords {
  std::string_view key;
  std::string_view SliderTexts::*words;
};
constexpr std::array words_of_keys{
    SliderWords{"user.k_u_N_per_m", &SliderTexts::k_u},
    SliderWords{"user.believed_k_u_N_per_m", &SliderTexts::believed_k_u},
    SliderWords{"rendering.k_r_N_per_m", &SliderTexts::k_r},
    SliderWords{"rendering.tracking_ratio", &SliderTexts::tracking_ratio},
    SliderWords{"wall.normal_deg", &SliderTexts::wall_angle},
    SliderWords{"device.actuated_deg", &SliderTexts::motor_angle},
};

bool is_long_range(const LessonSlider& slider) {
  return slider.least > 0.0 && slider.greatest >= 8.0 * slider.least;
}

}  // namespace

std::optional<double> slider_value(const LessonSlider& slider, const Settings& settings) {
  Scene scene;
  scene.settings = settings;
  if (const auto* const number = std::get_if<NumberKey>(&slider.key->value)) return number->in(scene)*number->per_si;
  if (const auto* const optional = std::get_if<OptionalNumberKey>(&slider.key->value)) return optional->in(scene);
  return std::nullopt;
}

Settings with_slider_value(const LessonSlider& slider, const Settings& settings, double value) {
  Scene scene;
  scene.settings = settings;
  const double inside = std::clamp(value, slider.least, slider.greatest);
  if (const auto* const number = std::get_if<NumberKey>(&slider.key->value)) {
    number->in(scene) = inside / number->per_si;
  } else if (const auto* const optional = std::get_if<OptionalNumberKey>(&slider.key->value)) {
    optional->in(scene) = inside;
  }
  return scene.settings;
}

double slider_share(const LessonSlider& slider, double value) noexcept {
  const double inside = std::clamp(value, slider.least, slider.greatest);
  if (is_long_range(slider)) return std::log(inside / slider.least) / std::log(slider.greatest / slider.least);
  return (inside - slider.least) / (slider.greatest - slider.least);
}

double slider_value_at(const LessonSlider& slider, double share) noexcept {
  const double inside = std::clamp(share, 0.0, 1.0);
  if (inside == 1.0) return slider.greatest;
  if (is_long_range(slider)) return slider.least * std::pow(slider.greatest / slider.least, inside);
  return slider.least + inside * (slider.greatest - slider.least);
}

std::string slider_words(const LessonSlider& slider, const StageLanguage& language) {
  const std::string key = dotted_name(*slider.key);
  const auto* const found = std::ranges::find(words_of_keys, key, &SliderWords::key);
  return found == words_of_keys.end() ? key : std::string(language.lessons.*found->words);
}

std::string slider_text(const LessonSlider& slider, double value) {
  const double size = std::max({std::abs(slider.least), std::abs(slider.greatest)});
  const int decimals = size < 10.0 ? 2 : size < 100.0 ? 1 : 0;
  const std::string_view unit = unit_of(slider.key->name);
  const std::string number = decimal_text(value, decimals);
  return unit.empty() ? number : number + " " + std::string(unit);
}

}  // namespace ghostforce
