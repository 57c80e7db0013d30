// Glossary: every term on the screen in one sentence, with its formula and unit. What appears on hover, over panels and
// over the marks of the scene alike. Immutable, any thread.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "app/picture/marks.h"

namespace ghostforce {

enum class Term : std::uint8_t {
  goal,
  device,
  proxy,
  contact,
  wall,
  force,
  ghost_force,
  proxy_drift,
  energy,
  model_error,
  prediction,
  trail,
  hand_spring,
  tracking_link,
  motor_axis,
  wall_normal,
  rendering_stiffness,
  tracking_stiffness,
  constraint_stiffness,
  hard_constraint,
  tracking_ratio,
  user_stiffness,
  believed_user_stiffness,
  right_belief,
  force_scale,
  target,
  drift_of_belief,
  null_drift,
  drift_from_target,
  null_ratio,
  loop_area,
  loop_energy,
  loop_formula,
  estimated_goal,
  live_user_stiffness,
  given_user_stiffness,
  live_ratio,
};

struct GlossaryEntry {
  Term id;
  std::string_view title;
  std::string_view sentence;
  std::string_view formula;  // may be empty
  std::string_view unit;     // may be empty
};

// In the order of Term.
std::span<const GlossaryEntry> glossary() noexcept;
const GlossaryEntry& glossary(Term term) noexcept;

// What a mark of the scene shows, or names in the legend; empty for decoration.
std::optional<Term> term_of(Role role) noexcept;
inline std::optional<Term> term_of(const Mark& mark) noexcept {
  return term_of(mark.about.value_or(mark.role));
}
// The same where the goal may be an estimate, which nobody can drag.
inline std::optional<Term> term_of(const Mark& mark, bool is_goal_estimated) noexcept {
  const std::optional<Term> term = term_of(mark);
  return term == Term::goal && is_goal_estimated ? Term::estimated_goal : term;
}

}  // namespace ghostforce
