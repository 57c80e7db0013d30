// Each of the 48 ways to wire three encoders is told from the others by three movements of a hand.
#include "app/tools/doctor/encoder_wiring.h"

#include <array>
#include <random>

#include <gtest/gtest.h>

namespace ghostforce::encoder_wiring_test {
namespace {

constexpr std::array directions{Vector<3>{0.0, 0.0, 1.0}, Vector<3>{1.0, 0.0, 0.0}, Vector<3>{0.0, 1.0, 0.0}};

// What the encoders of a device wired like this say at a place, from a zero of their own for those that count back.
Vector<3> encoders_at(const Vector<3>& place, const LegNumbers& encoder_of_leg) {
  const FalconGeometry geometry;
  const Vector<3> legs = counts_of_angles(*FalconKinematics(geometry).angles(place), geometry);
  Vector<3> frame;
  for (std::size_t leg = 0; leg < 3; ++leg) {
    const double count = legs[static_cast<glm::length_t>(leg)];
    frame[static_cast<glm::length_t>(place_in_frame(encoder_of_leg[leg]))] =
        encoder_of_leg[leg] > 0 ? count : -2926.0 - count;
  }
  return frame;
}

std::array<HandMove, 3> moves_of(const LegNumbers& wiring, double crookedness, std::mt19937& random) {
  std::uniform_real_distribution<double> any(-crookedness, crookedness);
  const auto about = [&](const Vector<3>& place) { return place + Vector<3>(any(random), any(random), any(random)); };
  std::array<HandMove, 3> moves;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    moves[i].direction = directions[i];
    moves[i].from = encoders_at(about({0.0, 0.0, 0.12}), wiring);
    moves[i].to = encoders_at(about(Vector<3>(0.0, 0.0, 0.12) + 0.03 * directions[i]), wiring);
  }
  return moves;
}

TEST(EncoderWiring, FindsEachOfAll) {
  std::mt19937 random{1};
  LegNumbers order = legs_in_order;
  int count = 0;
  do {
    for (unsigned signs = 0; signs < 8; ++signs, ++count) {
      LegNumbers wiring = order;
      for (std::size_t leg = 0; leg < 3; ++leg) {
        if ((signs >> leg & 1U) != 0) wiring[leg] = static_cast<std::int8_t>(-wiring[leg]);
      }
      // A person does not move along a straight line, nor begin in the very middle.
      const EncoderWiring found = find_encoder_wiring(moves_of(wiring, 0.003, random), FalconGeometry{});
      EXPECT_TRUE(found.is_certain()) << found.agreement << ' ' << found.runner_up;
      EXPECT_EQ(found.encoder_of_leg, wiring);
    }
  } while (std::ranges::next_permutation(order).found);
  EXPECT_EQ(count, 48);
}

TEST(EncoderWiring, IsNotCertainOfAHandThatWentElsewhere) {
  std::mt19937 random{2};
  auto moves = moves_of(legs_in_order, 0.0, random);
  moves[2].to = encoders_at({0.0, -0.03, 0.12}, legs_in_order);  // lowered where it was to be lifted
  const EncoderWiring lowered = find_encoder_wiring(moves, FalconGeometry{});
  EXPECT_FALSE(lowered.is_certain()) << lowered.agreement << ' ' << lowered.runner_up;
  moves = moves_of(legs_in_order, 0.0, random);
  moves[0].to = moves[0].from + Vector<3>(30.0, 30.0, 30.0);
  EXPECT_FALSE(find_encoder_wiring(moves, FalconGeometry{}).has_moved);
  EXPECT_FALSE(find_encoder_wiring({}, FalconGeometry{}).is_certain());
}

TEST(EncoderWiring, OffsetsBringTheArmsTogetherAtTheStop) {
  EXPECT_EQ(offsets_at_stop({-1463.0, -1460.0, -1466.0}, {1, 2, 3}), MotorNumbers{});
  EXPECT_EQ(offsets_at_stop({-1463.0, -1463.0, -1463.0}, {1, -2, 3}), (MotorNumbers{0, 2926, 0}));
  EXPECT_EQ(offsets_at_stop({100.0, -1463.0, -1463.0}, {2, 3, -1}), (MotorNumbers{1363, 0, 0}));
  EXPECT_EQ(offsets_at_stop({1463.0, 1463.0, 1463.0}, {-1, -2, -3}), MotorNumbers{}) << "there is nothing to go by";
}

}  // namespace
}  // namespace ghostforce::encoder_wiring_test
