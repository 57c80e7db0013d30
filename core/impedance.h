// The stiffnesses of a scene as plain values: the hand's, the renderer's and the wall's. Trivially copyable, so that
// they may cross threads whole.
#pragma once

#include <optional>

namespace ghostforce {

struct Impedances {
  double k_u = 0.0;                             // user stiffness, (1) [N/m]
  std::optional<double> believed_k_u;           // k̂_u, the k_u that the renderer assumes [N/m]; empty: the true one
  double k_r = 0.0;                             // rendering stiffness, (5) [N/m]
  double k_t = 0.0;                             // tracking stiffness on actuated degrees of freedom, k_ta, (2) [N/m]
  double k_c = 0.0;                             // constraint stiffness, (4) [N/m]; infinity is the hard constraint
  std::optional<double> chosen_tracking_ratio;  // ρ [1]; empty: the optimal one, (17)

  friend bool operator==(const Impedances&, const Impedances&) = default;
};

// k̂_u [N/m]
inline double believed_user_stiffness(const Impedances& impedances) noexcept {
  return impedances.believed_k_u.value_or(impedances.k_u);
}

// (17)  ρ* = 1 + k_r / k_u [1]
// The renderer can only evaluate it with the k_u that it believes in.
inline double optimal_tracking_ratio(double k_r, double k_u) noexcept {
  return 1.0 + k_r / k_u;
}

// The ratio that anisotropic rendering runs with [1].
inline double tracking_ratio(const Impedances& impedances) noexcept {
  return impedances.chosen_tracking_ratio.value_or(
      optimal_tracking_ratio(impedances.k_r, believed_user_stiffness(impedances)));
}

}  // namespace ghostforce
