// The landscape: how bad the ghost force is at any wall and any hand, by closed form. Across, the angle θ between the
// wall's normal and the motor; upwards, κ = k_r/k_u. Its value is the ghost force along the motor as a share of the
// push that the wall should give: of |f_r| of the fully actuated device. Depth does not matter: both grow with it
// alike.
//
//     ε  = k_t/k_c,  ρ* = 1 + κ                                               (17)
//     |f_r|      = k_r d / (ρ* + ε)                                           (11), fully actuated
//     P_A f_r    = k_r d cos θ / (ρ* cos²θ + ρ sin²θ + ε)                     equilibrium_with_ratio; ρ = 1 is (15)
//     share(θ,κ) = (P_A f_r − cos θ |f_r|) / |f_r|
//                = cos θ sin²θ (ρ* − ρ) / (ρ* cos²θ + ρ sin²θ + ε)
//
// Positive: the motor pushes too much, (ρ < ρ*); negative: too little. It lies over −1 and is 0 at both ends: at 0°
// one motor is as good as two, and at 90° it can give nothing of the push.
// Pure values and functions, any thread; whatever the settings hold, numbers are finite.
#pragma once

#include <optional>

#include "core/settings.h"

namespace ghostforce {

struct LandscapePoint {
  double angle = 0.0;  // θ, from 0 to π/2 [rad]
  double kappa = 1.0;  // κ [1]

  friend bool operator==(const LandscapePoint&, const LandscapePoint&) = default;
};

// What of κ the map shows; a set-up may lie beyond it.
inline constexpr NumberRange shown_kappas{1.0, 100.0};

// One map: what all of its points have in common.
struct Landscape {
  double dial = 0.0;                   // u: 0 is naïve, 1 what anisotropic rendering runs with
  double true_over_believed = 1.0;     // k_u/k̂_u [1]
  std::optional<double> chosen_ratio;  // ρ at u = 1, where a person has chosen it [1]
  double softness = 0.0;               // ε of the wall as it is set up [1]
};

// Without a ghost force anywhere.
Landscape landscape_without_ghost(const Settings& settings) noexcept;

// What is no number, or out of every range, is taken for the nearest that can be drawn.
Landscape landscape_of(const Settings& settings, double dial) noexcept;

// ρ = ρ_A^u with ρ_A = 1 + κ k_u/k̂_u, or the chosen one [1].
double landscape_ratio(const Landscape& landscape, double kappa) noexcept;

// The value of the map [1].
double ghost_share(const Landscape& landscape, const LandscapePoint& point) noexcept;

// The same where many points share ρ* and ρ: those of one κ.
double ghost_share(double cosine, double optimal_ratio, double ratio, double softness) noexcept;

// The greatest and the least of a map, at some thousand points of it, 0 always among them.
NumberRange ghost_share_range(const Landscape& landscape) noexcept;

// ---- Where a set-up lies, and back ----------------------------------------------------------------------------------

LandscapePoint landscape_point(const Settings& settings) noexcept;

// Turns the wall about its own point and makes the renderer so stiff that the set-up lies at `point`. k_t stays, and
// with it ε: the map stands still while one drags. The wall stays on its side of the motor, and the normal in its
// quadrant, however far one drags: at 0° and 90° it stops a micro-radian short of where both sides would be the same.
// k_r stays within what a scene may hold, so that κ may stop short of what was asked for.
Settings with_landscape_point(Settings settings, const LandscapePoint& point) noexcept;

}  // namespace ghostforce
