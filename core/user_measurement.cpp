#include "core/user_measurement.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace ghostforce {
namespace {

// sin² of 6 degrees.
constexpr double least_share = 0.011;

double quantile(std::span<const double> sorted, double share) {
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return std::lerp(sorted[below], sorted[above], place - static_cast<double>(below));
}

}  // namespace

std::string_view sentence_of(NoReading problem) noexcept {
  switch (problem) {
    case NoReading::none:
      return "";
    case NoReading::no_contact:
      return "The device is in front of the wall: press into it.";
    case NoReading::no_drift_at_all:
      return "The wall faces along or across the motors, where the proxy never drifts: turn one of them.";
    case NoReading::no_rendering:
      return "Nothing is rendered: raise k_r.";
    case NoReading::no_such_hand:
      return "No hand would drift like this: it did not aim there, or was not at rest.";
    case NoReading::limited:
      return "The motors gave less than was asked of them, at their limit or still coming on: press less deep, and "
             "wait.";
  }
  return "";
}

template <glm::length_t D>
Vector<D> drift_direction(const Wall<D>& wall, const Actuation<D>& actuation) noexcept {
  const Vector<D> pushed = actuation.actuated * wall.normal;
  const double alpha = glm::dot(wall.normal, pushed);
  if (!(alpha > least_share && 1.0 - alpha > least_share)) return Vector<D>(0.0);
  return glm::normalize(along(wall, pushed));
}

template <glm::length_t D>
UserReading read_user(const Wall<D>& wall, const Actuation<D>& actuation, const RestState<D>& rest) noexcept {
  UserReading reading;
  const Vector<D> direction = drift_direction(wall, actuation);
  if (direction == Vector<D>(0.0)) return {.problem = NoReading::no_drift_at_all};
  if (!(depth(wall, rest.device) > 0.0)) return {.problem = NoReading::no_contact};
  reading.drift = glm::dot(direction, rest.proxy - rest.aim);

  const Vector<D> pushed = actuation.actuated * wall.normal;
  const Vector<D> x = actuation.actuated * (rest.proxy - rest.device);
  const double k_r = glm::dot(rest.force, x) / glm::dot(x, x);
  if (!(k_r > 0.0)) {
    reading.problem = NoReading::no_rendering;
    return reading;
  }
  const double alpha = glm::dot(wall.normal, pushed);
  const double slide = reading.drift * glm::dot(direction, pushed);  // drift·(P_A n)
  const double null_ratio = rest.tracking_ratio + slide / ((1.0 - alpha) * glm::dot(x, pushed));
  if (!(null_ratio > 1.0) || !std::isfinite(null_ratio)) {
    reading.problem = NoReading::no_such_hand;
    return reading;
  }
  reading.null_ratio = null_ratio;
  reading.k_u = user_stiffness_of(k_r, null_ratio);
  return reading;
}

Spread spread_of(std::span<const double> readings) {
  if (readings.empty()) return {};
  std::vector<double> sorted(readings.begin(), readings.end());
  std::ranges::sort(sorted);
  return {quantile(sorted, 0.5), quantile(sorted, 0.25), quantile(sorted, 0.75)};
}

#define GHOSTFORCE_INSTANTIATE(D)                                                      \
  template Vector<D> drift_direction<D>(const Wall<D>&, const Actuation<D>&) noexcept; \
  template UserReading read_user<D>(const Wall<D>&, const Actuation<D>&, const RestState<D>&) noexcept
GHOSTFORCE_INSTANTIATE(2);
GHOSTFORCE_INSTANTIATE(3);
GHOSTFORCE_INSTANTIATE(4);
#undef GHOSTFORCE_INSTANTIATE

}  // namespace ghostforce
