// Measuring the user: the one quantity that the renderer cannot know, k_u, read off the proxy drift at rest against a
// wall. Pure values and functions, any dimension; never allocates or throws, but for spread_of(), any thread. SI units.
//
// At rest in contact (core/equilibrium.h) the drift is
//     (q_p − q_u) along the wall = (λ/k_t) (1 + κ − ρ) a,   a = P_A n less its component along n
// whatever the wall's softness. It vanishes at ρ° = 1 + k_r/k_u, hence
//     k_u = k_r/(ρ° − 1)
// One rest at any ρ tells ρ° too (docs/theory.md), with an x that the renderer knows:
//     x  = P_A (q_p − q_h) = (λ/k_t) P_A n
//     ρ° = ρ + drift·(P_A n) / ((1 − α) x·(P_A n)),   α = nᵀP_A n
// Neither k_t nor k_c is needed, and k_r = f_r·x / x·x is the one that the motors really had.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "core/actuation.h"
#include "core/wall.h"

namespace ghostforce {

// k_u = k_r/(ρ° − 1) [N/m]; `null_ratio` ρ° > 1 is the ratio at which the drift vanishes [1].
inline double user_stiffness_of(double k_r, double null_ratio) noexcept {
  return k_r / (null_ratio - 1.0);
}

// Everything at rest that a reading is made of.
template <glm::length_t D>
struct RestState {
  Vector<D> aim{0.0};           // q_u, or any point on the normal line through it, as a target on the wall is [m]
  Vector<D> device{0.0};        // q_h [m]
  Vector<D> proxy{0.0};         // q_p [m]
  Vector<D> force{0.0};         // f_r [N]
  double tracking_ratio = 1.0;  // ρ in use [1]
};

// Why a rest tells nothing about the user.
enum class NoReading : std::uint8_t {
  none,             // it does
  no_contact,       // the device is in front of the wall
  no_drift_at_all,  // n lies along or across the motors: the proxy never drifts, whatever ρ
  no_rendering,     // k_r is 0: nothing is felt
  no_such_hand,     // ρ° is not above 1: the hand was not at rest, or did not aim there
  limited,          // the motors gave something else than f_r; read_user() cannot know, whoever reads the device does
};
// For a person: what is so, and what to do instead.
std::string_view sentence_of(NoReading problem) noexcept;

struct UserReading {
  NoReading problem = NoReading::none;
  // Along the wall; positive: ρ is below ρ°. 0 where there is no direction for it [m].
  double drift = 0.0;
  double null_ratio = 0.0;  // ρ° [1]; 0 where there is none
  double k_u = 0.0;         // [N/m]; 0 where there is none
};

// The direction along the wall in which the drift lies while ρ < ρ° [1]; zero where n lies along or across the motors,
// to within 6 degrees: farther in, the drift is too small to be read.
template <glm::length_t D>
Vector<D> drift_direction(const Wall<D>& wall, const Actuation<D>& actuation) noexcept;

template <glm::length_t D>
UserReading read_user(const Wall<D>& wall, const Actuation<D>& actuation, const RestState<D>& rest) noexcept;

// Of repeated readings. The quartiles bound the middle half of them: of five readings, the second and the fourth.
struct Spread {
  double median = 0.0;
  double lower_quartile = 0.0;
  double upper_quartile = 0.0;
};
// Between readings it interpolates linearly; of none it is 0. Allocates.
Spread spread_of(std::span<const double> readings);

// Watches whether something has come to rest: since when it has stayed as near as `reach` to where it was then.
template <glm::length_t D>
class RestWatch {
 public:
  explicit RestWatch(double reach) noexcept : reach_(reach) {}

  // In the order of time. Forgets what was before a step back in time.
  void see(double time_s, const Vector<D>& position) noexcept {
    if (!has_seen_ || time_s < now_s_ || !(glm::distance(position, where_) <= reach_)) {
      where_ = position;
      since_s_ = time_s;
      has_seen_ = true;
    }
    now_s_ = time_s;
  }
  void forget() noexcept { has_seen_ = false; }

  // How long it has been at rest [s].
  double held_s() const noexcept { return has_seen_ ? now_s_ - since_s_ : 0.0; }

 private:
  double reach_;
  Vector<D> where_{0.0};
  double since_s_ = 0.0;
  double now_s_ = 0.0;
  bool has_seen_ = false;
};

}  // namespace ghostforce
