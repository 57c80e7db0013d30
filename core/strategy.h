// The catalog of rendering strategies: the one list that the tick, the window, the command line and the tests walk.
// CONTRIBUTING.md says what a new one needs.
// Immutable after start, any thread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/actuation.h"
#include "core/stiffness.h"

namespace ghostforce {

enum class StrategyId : std::uint8_t { full, naive, anisotropic };

inline constexpr std::size_t strategy_count = 3;

// One value per strategy, indexed by index_of(). A table of values is written with std::to_array(): then the compiler
// refuses one that lacks a strategy.
template <typename T>
using PerStrategy = std::array<T, strategy_count>;

constexpr std::size_t index_of(StrategyId id) noexcept {
  return static_cast<std::size_t>(id);
}

struct Strategy {
  StrategyId id;
  std::string_view name;                                  // in files and on the command line
  char letter;                                            // in pictures and tables
  std::string_view title;                                 // on screen
  std::string_view sentence;                              // what it does, for a person who hovers over it
  std::string_view with_ghost;                            // what to see where it makes a ghost force,
  std::string_view without_ghost;                         // and where it makes none
  bool has_every_motor;                                   // K_r = k_r I, else k_r P_A
  double (*tracking_ratio)(const Stiffnesses&) noexcept;  // ρ of K_t
};

const PerStrategy<Strategy>& strategy_catalog() noexcept;

inline const Strategy& strategy(StrategyId id) noexcept {
  return strategy_catalog()[index_of(id)];
}

// Empty when no strategy has that name.
std::optional<StrategyId> find_strategy(std::string_view name) noexcept;

// Where a name may stand: all of them.
inline constexpr std::string_view every_strategy = "all";

// K_r and K_t of a strategy. With `has_every_motor` there is no non-actuated degree of freedom, hence no ratio.
template <glm::length_t D>
Coupling<D> make_coupling(const Strategy& strategy, const Stiffnesses& stiffnesses,
                          const Actuation<D>& actuation) noexcept {
  return strategy.has_every_motor ? fully_actuated_coupling<D>(stiffnesses.k_r, stiffnesses.k_t)
                                  : underactuated_coupling<D>(stiffnesses.k_r, stiffnesses.k_t,
                                                              strategy.tracking_ratio(stiffnesses), actuation);
}

}  // namespace ghostforce
