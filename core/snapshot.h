// Snapshot: what one tick leaves behind, as a value. The servo publishes it, pictures are drawn from it, CSV rows are
// written from it. Trivially copyable: it crosses threads whole.
#pragma once

#include <cstdint>
#include <optional>
#include <type_traits>

#include "core/conventions.h"
#include "core/strategy.h"

namespace ghostforce {

template <glm::length_t D>
struct StrategySnapshot {
  Vector<D> device{0.0};       // q_h [m]
  Vector<D> proxy{0.0};        // q_p [m]
  Vector<D> contact{0.0};      // q_c, (3) [m]
  Vector<D> force{0.0};        // f_r [N]
  Vector<D> ghost_force{0.0};  // excess over the fully actuated force, along the motors [N]
  Vector<D> proxy_drift{0.0};  // along the wall [m]
  double energy = 0.0;         // given to the hand since the start [J]
  bool in_contact = false;     // the wall acts on this tick's proxy
};

template <glm::length_t D>
struct SnapshotIn {
  std::int64_t tick = 0;  // k
  double time_s = 0.0;    // t_k = k dt
  Vector<D> goal{0.0};    // q_u [m]
  // The strategy whose device is a real one, measured, and whose force goes to its motors. The goal is then an
  // estimate: nobody can measure it, and ghost forces and drifts against it would be circular: they are left at 0.
  // Empty: every device is simulated, under a goal that was given.
  std::optional<StrategyId> measured;
  // The hand at the measured device was told to aim at a target: the ghost force and the drift of that strategy are
  // against it (core/target_reading.h), NaN where they cannot be known. No tick says so, whoever draws the target does.
  bool has_target = false;
  PerStrategy<StrategySnapshot<D>> strategies{};
};

using Snapshot = SnapshotIn<2>;
static_assert(std::is_trivially_copyable_v<Snapshot>);

}  // namespace ghostforce
