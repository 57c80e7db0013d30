// Glossary: every term on the screen in one sentence, with its formula and unit, as it appears on hover, over panels
// and over the marks of the scene alike; and the quantities among them that each strategy is measured by. Immutable,
// any thread.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "app/picture/marks.h"
#include "core/snapshot.h"

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
// Where the goal may be an estimate, which nobody can drag.
inline std::optional<Term> term_of(const Mark& mark, bool is_goal_estimated) noexcept {
  const std::optional<Term> term = term_of(mark);
  return term == Term::goal && is_goal_estimated ? Term::estimated_goal : term;
}

// What each strategy is measured by, in the units of the screen: the live table shows it, the plots draw it and their
// export writes it.
struct Quantity {
  std::string_view title;
  std::string_view unit;
  std::string_view column;  // in files
  Term term;
  double (*value)(const StrategySnapshot<2>&);  // [unit]
  int decimals;
  bool is_against_goal = false;  // where that is only inferred, known against a target alone
};

inline constexpr std::size_t quantity_count = 4;

const std::array<Quantity, quantity_count>& quantity_catalog() noexcept;

// Whether anybody knows it of that strategy at that moment.
bool is_known(const Quantity& quantity, const Snapshot& snapshot, StrategyId id) noexcept;

// Before numbers that are against a target, not against a goal that was given: a sign like the target on the wall.
inline constexpr std::string_view target_sign = "◎";

}  // namespace ghostforce
