#include "app/state/lesson_quantities.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "core/units.h"

namespace ghostforce {
namespace {

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();
constexpr double mJ_per_J = 1000.0;

double ghost_force_size(const LessonReading& now) noexcept {
  return now.moment.knows_ghost_force ? glm::length(now.moment.ghost_force) : not_known;
}

// Nobody knows where a measured hand wants to be, unless it was told.
bool knows_goal(const StageMoment& moment) noexcept {
  return !moment.is_measured || moment.has_target;
}

constexpr std::array quantities{
    LessonQuantityEntry{
        LessonQuantity::depth, "depth_mm", "how deep in the wall the hand is; negative in front of it",
        [](const LessonReading& now) noexcept { return mm_per_m * depth(wall_of(now.settings), now.moment.goal); }},
    LessonQuantityEntry{
        LessonQuantity::force, "force_N", "how hard the motors push, the ghost force included",
        [](const LessonReading& now) noexcept { return glm::length(now.moment.wall_share + now.moment.ghost_force); }},
    LessonQuantityEntry{LessonQuantity::ghost_force, "ghost_force_N", "the ghost force, whichever way it points",
                        [](const LessonReading& now) noexcept { return ghost_force_size(now); }},
    LessonQuantityEntry{LessonQuantity::slide, "slide_mm", "how far the wall has let the hand slide, either way",
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
                          const double cosine = glm::dot(direction_at(now.settings.wall_normal_angle),
                                                         direction_at(now.settings.actuated_angle));
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

}  // namespace ghostforce
