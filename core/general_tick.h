// One tick of the sampled-data loop for any device and any constraint, for all strategies under the same goal: what
// tick.h is for the paper's scenes. docs/theory.md, "Any device", derives it.
//
//     (M + dt B + dt² K_u) v_k = M v_k−1 + dt (K_u (q_u(t_k) − q_h,k−1) + f_k−1)        (23)
//     q_h,k = q_h,k−1 + dt v_k                                                          (24)
//     q_p,k, u_k: round_contact.h, for q_h,k−1 and A(q_h,k−1)                           (25)
//     f_k = A(q_h,k−1) u_k                                                              (5)
//
// With the paper's parameters f_k is that of tick.h plus k_r dt P_A v_k, and the same at rest: nothing acts in free
// space. noexcept, allocates nothing, takes no lock, reads no clock. Any thread.
#pragma once

#include "core/constraint.h"
#include "core/contact_solver.h"
#include "core/fixed_contact.h"
#include "core/mechanism.h"
#include "core/settings.h"
#include "core/snapshot.h"
#include "core/tick.h"

namespace ghostforce {

// Of a strategy, in a general scene.
struct GeneralStrategy {
  bool has_every_motor;
  double share;  // s [1]: 0 naïve, 1 the cure
};
GeneralStrategy general_strategy(const Strategy& strategy, const GeneralSettings& general) noexcept;

// What a general scene is made of, in place and in force.
struct GeneralScene {
  Mechanism mechanism;
  Constraint constraint;
  Matrix<2> user_compliance;   // C_u of the hand [m/N]
  Compliances<2> compliances;  // of the renderer, with the hand that it believes in
  PerStrategy<GeneralStrategy> strategies;
};
Mechanism mechanism_of(const Settings& settings) noexcept;
Constraint constraint_of(const Settings& settings) noexcept;
GeneralScene general_scene_of(const Settings& settings) noexcept;

// What a strategy renders with the handle at q.
Contact<2> contact_at(const GeneralScene& scene, const GeneralStrategy& strategy, const Vector<2>& q,
                      const Vector<2>& last_proxy) noexcept;

// What a tick needs of the settings, computed once per change of a setting.
struct GeneralCoefficients {
  GeneralScene scene;
  double mass;                   // [kg]
  double damping;                // [N·s/m]
  double rate;                   // 1/dt [Hz]
  double period;                 // dt [s]
  Matrix<2> user_stiffness;      // K_u [N/m]
  Matrix<2> velocity_per_force;  // dt (M + dt B + dt² K_u)⁻¹ [m/s/N]
  double encoder_step;           // see sampled_device.h [m]

  // Empty: the mechanism turns, or a wall is round.
  std::optional<PerStrategy<FixedContact<2>>> fixed;
};
GeneralCoefficients general_coefficients_of(const Settings& settings) noexcept;

// From the next tick on the hand has another stiffness, the same all round [N/m]. The renderer knows nothing of it.
void set_user_stiffness(GeneralCoefficients& coefficients, double k_u) noexcept;

// k ≥ 1: advances `state` from k − 1 to k; `goal` is q_u(t_k). Tones as in tick.h. Begins at state_at_start().
void tick(const GeneralCoefficients& coefficients, const Vector<2>& goal, TickState<2>& state) noexcept;

// The state as it stands. Ghost force: f_r − A u°, where u° are the efforts whose force is the nearest to the fully
// actuated one, with A where that strategy's handle is. Slide, the proxy's drift: q_p − q_p of the fully actuated.
void take_snapshot(const GeneralCoefficients& coefficients, const TickState<2>& state, Snapshot& snapshot) noexcept;

// What the state tells beside that.
inline ContactReadings contact_readings_of(const TickState<2>& state) noexcept {
  ContactReadings readings;
  for (std::size_t i = 0; i < strategy_count; ++i) readings[i] = state.strategies[i].contact;
  return readings;
}

// f_r − A u° for a handle at q [N]. 0 where the handle cannot be.
Vector<2> general_ghost_force(const GeneralScene& scene, const Vector<2>& q, const Vector<2>& force,
                              const Vector<2>& full_force) noexcept;

// --- Whichever loop the scene has ------------------------------------------------------------------------------------

// The paper's coefficients, and those of the general loop where the scene needs it. The choice is made once per tick,
// outside of either.
struct LoopCoefficients {
  TickCoefficients<2> paper{};  // of a general scene the rate alone means anything
  std::optional<GeneralCoefficients> general;

  double rate() const noexcept { return paper.rate; }
};

inline LoopCoefficients loop_coefficients_of(const Settings& settings) noexcept {
  LoopCoefficients loop{coefficients_of(settings), std::nullopt};
  if (is_general(settings)) loop.general = general_coefficients_of(settings);
  return loop;
}

inline void set_user_stiffness(LoopCoefficients& loop, double k_u) noexcept {
  if (loop.general) return set_user_stiffness(*loop.general, k_u);
  set_user_stiffness(loop.paper, k_u);
}

inline void tick(const LoopCoefficients& loop, const Vector<2>& goal, TickState<2>& state) noexcept {
  if (loop.general) [[unlikely]]
    return tick(*loop.general, goal, state);
  tick(loop.paper, goal, state);
}

inline void take_snapshot(const LoopCoefficients& loop, const TickState<2>& state, Snapshot& snapshot) noexcept {
  if (loop.general) [[unlikely]]
    return take_snapshot(*loop.general, state, snapshot);
  take_snapshot(loop.paper, state, snapshot);
}

inline Snapshot snapshot_of(const LoopCoefficients& loop, const TickState<2>& state) noexcept {
  Snapshot snapshot;
  take_snapshot(loop, state, snapshot);
  return snapshot;
}

}  // namespace ghostforce
