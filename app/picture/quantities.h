// The quantities that each strategy is measured by, in the units of the screen: what the live table shows, the plots
// draw and their export writes. Immutable, any thread.
#pragma once

#include <array>
#include <string_view>

#include "app/picture/glossary.h"
#include "core/snapshot.h"

namespace ghostforce {

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
