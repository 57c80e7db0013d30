#include "app/tools/doctor/encoder_wiring.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace ghostforce {
namespace {

constexpr double move_length = 0.030;

double cosine(const Vector<3>& a, const Vector<3>& b) noexcept {
  const double lengths = glm::length(a) * glm::length(b);
  return lengths > 0.0 ? glm::dot(a, b) / lengths : 0.0;
}

// How the upper arms swing in such a move.
Vector<3> expected(const Vector<3>& direction, const FalconKinematics& kinematics) noexcept {
  const auto before = kinematics.angles(workspace_center);
  const auto after = kinematics.angles(workspace_center + move_length * direction);
  return before && after ? *after - *before : Vector<3>(0.0);
}

// All that there are; g++ 12 warns of its own std::next_permutation on arm64.
constexpr std::array<LegNumbers, 6> leg_orders{{{1, 2, 3}, {1, 3, 2}, {2, 1, 3}, {2, 3, 1}, {3, 1, 2}, {3, 2, 1}}};

}  // namespace

EncoderWiring find_encoder_wiring(std::span<const HandMove> moves, const FalconGeometry& geometry) noexcept {
  const FalconKinematics kinematics(geometry);
  EncoderWiring best;
  best.agreement = best.runner_up = -1.0;
  best.has_moved = !moves.empty();
  for (const HandMove& move : moves) {
    const Vector<3> change = glm::abs(move.to - move.from);
    if (std::max({change.x, change.y, change.z}) < EncoderWiring::least_move) best.has_moved = false;
  }
  for (const LegNumbers& order : leg_orders) {
    for (unsigned signs = 0; signs < 8; ++signs) {
      LegNumbers wiring = order;
      for (std::size_t leg = 0; leg < wiring.size(); ++leg) {
        if ((signs >> leg & 1U) != 0) wiring[leg] = static_cast<std::int8_t>(-wiring[leg]);
      }
      double worst = 1.0;
      for (const HandMove& move : moves) {
        worst =
            std::min(worst, cosine(in_leg_order(move.to - move.from, wiring), expected(move.direction, kinematics)));
      }
      if (worst > best.agreement) {
        best.runner_up = best.agreement;
        best.agreement = worst;
        best.encoder_of_leg = wiring;
      } else {
        best.runner_up = std::max(best.runner_up, worst);
      }
    }
  }
  return best;
}

MotorNumbers offsets_at_stop(const Vector<3>& at_stop, const LegNumbers& encoder_of_leg) noexcept {
  double sum = 0.0;
  int straight = 0;
  for (const std::int8_t number : encoder_of_leg) {
    if (number < 0) continue;
    sum += at_stop[static_cast<glm::length_t>(place_in_frame(number))];
    ++straight;
  }
  MotorNumbers offsets{};
  if (straight == 0) return offsets;
  for (const std::int8_t number : encoder_of_leg) {
    if (number > 0) continue;
    // −(count + offset) is to be the others' count.
    const double count = at_stop[static_cast<glm::length_t>(place_in_frame(number))];
    offsets[place_in_frame(number)] = static_cast<std::int16_t>(std::lround(-sum / straight - count));
  }
  return offsets;
}

}  // namespace ghostforce
