// Settings: everything about a scene that a person may change while it runs. SI units, plane of the window. A plain
// value, trivially copyable: the window publishes it whole, the servo takes it whole.
#pragma once

#include <algorithm>
#include <type_traits>

#include "core/equilibrium.h"
#include "core/general_settings.h"
#include "core/stiffness.h"
#include "core/strategy.h"
#include "core/tick.h"

namespace ghostforce {

// Its ends are included.
struct NumberRange {
  double least;
  double greatest;

  constexpr double nearest_to(double number) const noexcept { return std::clamp(number, least, greatest); }

  friend bool operator==(const NumberRange&, const NumberRange&) = default;
};

// A hand has some 10 to 10,000 N/m; a value far outside is a typing error [N/m].
inline constexpr NumberRange user_stiffness_range{0.1, 1e6};
// The range of what a renderer may be given, k_r and k_t [N/m]; with a k_r of 0 there is no force.
inline constexpr NumberRange rendering_stiffness_range{0.0, 1e6};
inline constexpr NumberRange tracking_stiffness_range{0.1, 1e6};
// ρ where a person chooses it: three decades to either side of the naive one.
inline constexpr NumberRange tracking_ratio_range{1e-3, 1e3};
// s where a person chooses it: from naïve rendering past the cure. Beyond 1 the proxy is held less than it should be.
inline constexpr NumberRange compliance_share_range{0.0, 10.0};
// No desktop computer keeps up with more, and the servo does not try [Hz].
inline constexpr NumberRange rate_range{10.0, 20000.0};

struct Settings {
  Vector<2> wall_point{0.0};                    // o [m]
  double wall_normal_angle = 0.0;               // direction of n, counter-clockwise from +x [rad]
  double actuated_angle = 0.0;                  // direction of the actuated degree of freedom [rad]
  double mass = 0.0;                            // device and hand [kg]
  double damping = 0.0;                         // device and hand [N·s/m]
  double rate = 0.0;                            // ticks per second of model time, 1/dt [Hz]
  double encoder_step = 0.0;                    // of a simulated device, see sampled_device.h [m]; 0: the place itself
  Stiffnesses stiffnesses;                      // k_u, k_r, k_t, k_c, ρ
  StrategyId active = StrategyId::anisotropic;  // the one on the device; the others run beside it
  GeneralSettings general;                      // beyond the paper's scenes

  friend bool operator==(const Settings&, const Settings&) = default;
};
static_assert(std::is_trivially_copyable_v<Settings>);

// `to` = `from`. A servo does it with every sample, and the general part of either is seldom anything but the usual one:
// see without_idle_general().
inline void copy_settings(const Settings& from, Settings& to) noexcept {
  to.wall_point = from.wall_point;
  to.wall_normal_angle = from.wall_normal_angle;
  to.actuated_angle = from.actuated_angle;
  to.mass = from.mass;
  to.damping = from.damping;
  to.rate = from.rate;
  to.encoder_step = from.encoder_step;
  to.stiffnesses = from.stiffnesses;
  to.active = from.active;
  if (is_general(from.general) || is_general(to.general)) to.general = from.general;
}

// The same scene for a loop: what stands in the general part of a scene that is none means nothing.
inline Settings without_idle_general(Settings settings) noexcept {
  if (!is_general(settings.general)) settings.general = {};
  return settings;
}

// Whether wall_of(), actuation_of() and what is made of them do not tell the whole scene.
inline bool is_general(const Settings& settings) noexcept {
  return is_general(settings.general);
}

inline Wall<2> wall_of(const Settings& settings) noexcept {
  return {settings.wall_point, direction_at(settings.wall_normal_angle)};
}

inline Actuation<2> actuation_of(const Settings& settings) noexcept {
  return actuated_along(direction_at(settings.actuated_angle));
}

inline TickCoefficients<2> coefficients_of(const Settings& settings) noexcept {
  TickCoefficients<2> coefficients = coefficients_of(wall_of(settings), actuation_of(settings), settings.stiffnesses,
                                                     settings.mass, settings.damping, settings.rate);
  coefficients.encoder_step = settings.encoder_step;
  return coefficients;
}

// What the renderer sees of a simulated device [m].
inline Vector<2> measured_position(const Settings& settings, const Vector<2>& device) noexcept {
  return measured_position(settings.encoder_step, device);
}

// k = 0, without force also where the renderer sees the device through an encoder: each proxy is where that sees it.
inline TickState<2> state_at_start(const Settings& settings, const Vector<2>& goal) noexcept {
  TickState<2> state = state_at_start(goal);
  for (auto& strategy : state.strategies) strategy.proxy = measured_position(settings, goal);
  return state;
}

// With another hand [N/m]; the renderer believes what it believed.
inline Settings with_user_stiffness(Settings settings, double k_u) noexcept {
  settings.stiffnesses.believed_k_u = believed_user_stiffness(settings.stiffnesses);
  settings.stiffnesses.k_u = k_u;
  return settings;
}

// Where a strategy comes to rest under a goal that is held still [m].
inline Equilibrium<2> equilibrium_of(StrategyId id, const Settings& settings, const Vector<2>& goal) noexcept {
  return equilibrium_of(strategy(id), wall_of(settings), actuation_of(settings), settings.stiffnesses, goal);
}

}  // namespace ghostforce
