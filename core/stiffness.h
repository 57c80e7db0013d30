// The stiffnesses of a scene as plain values: the hand's, the renderer's and the wall's. Trivially copyable, so that
// they may cross threads whole.
#pragma once

#include <optional>

namespace ghostforce {

struct Stiffnesses {
  double k_u = 0.0;                             // user stiffness, (1) [N/m]
  std::optional<double> believed_k_u;           // k̂_u, the k_u that the renderer assumes [N/m]; empty: the true one
  double k_r = 0.0;                             // rendering stiffness, (5) [N/m]
  double k_t = 0.0;                             // tracking stiffness on actuated degrees of freedom, k_ta, (2) [N/m]
  double k_c = 0.0;                             // constraint stiffness, (4) [N/m]; infinity is the hard constraint
  std::optional<double> chosen_tracking_ratio;  // ρ [1]; empty: the optimal one, (17)

  friend bool operator==(const Stiffnesses&, const Stiffnesses&) = default;
};

// k̂_u [N/m]
inline double believed_user_stiffness(const Stiffnesses& stiffnesses) noexcept {
  return stiffnesses.believed_k_u.value_or(stiffnesses.k_u);
}

// (17)  ρ* = 1 + k_r / k_u [1]
// The renderer can only evaluate it with the k_u that it believes in.
inline double optimal_tracking_ratio(double k_r, double k_u) noexcept {
  return 1.0 + k_r / k_u;
}

// The ratio that anisotropic rendering runs with [1].
inline double tracking_ratio(const Stiffnesses& stiffnesses) noexcept {
  return stiffnesses.chosen_tracking_ratio.value_or(
      optimal_tracking_ratio(stiffnesses.k_r, believed_user_stiffness(stiffnesses)));
}

}  // namespace ghostforce
