#include "tests/support/hand_at_wall.h"

#include <algorithm>

namespace ghostforce {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double settling_s = 1.0;
constexpr double longest_run_s = 30.0;
// Of the integration; the fastest that happens is b/m = 200/s. Dry friction wants it short.
constexpr double greatest_step_s = 125e-6;

double at(const std::vector<Sine>& sines, double seconds) {
  double sum = 0.0;
  for (const Sine& sine : sines) sum += sine.amplitude * std::sin(sine.omega * seconds + sine.phase);
  return sum;
}

// A peak of one hertz or so around a frequency, as in what is measured of physiological tremor.
std::vector<Sine> draw_tremor(HandRandom& random, double hz, double rms) {
  constexpr int count = 16;
  std::vector<Sine> sines;
  for (int i = 0; i < count; ++i) {
    sines.push_back(
        {rms * std::sqrt(2.0 / count), 2.0 * pi * (hz + 0.7 * random.normal()), random.uniform(0.0, 2.0 * pi)});
  }
  return sines;
}

// Slow, never faster than `speed`.
std::vector<Sine> draw_drift(HandRandom& random, double speed) {
  constexpr int count = 3;
  std::vector<Sine> sines;
  for (int i = 0; i < count; ++i) {
    const double omega = 2.0 * pi * random.over_decades(0.05, 0.5);
    sines.push_back({speed / count / omega, omega, random.uniform(0.0, 2.0 * pi)});
  }
  return sines;
}

// `size`: of a correction along the wall, rms; into the wall and out of it it is a third of that [m].
std::vector<Submovement> draw_submovements(HandRandom& random, double size, double wall_angle) {
  std::vector<Submovement> all;
  for (double seconds = random.uniform(0.0, 2.0); seconds < longest_run_s; seconds += random.uniform(0.5, 1.5)) {
    const double lasts = random.uniform(0.3, 0.6);
    const double along = size * random.normal();
    const double out = size / 3.0 * random.normal();
    all.push_back({seconds,
                   lasts,
                   {out * std::cos(wall_angle) - along * std::sin(wall_angle),
                    out * std::sin(wall_angle) + along * std::cos(wall_angle)}});
  }
  return all;
}

double minimum_jerk(double share) {
  const double u = std::clamp(share, 0.0, 1.0);
  return u * u * u * (10.0 + u * (-15.0 + 6.0 * u));
}

double rounded_to(double value, double unit) {
  return unit > 0.0 ? unit * std::round(value / unit) : value;
}

}  // namespace

HandOfTest draw_hand(HandPopulation population, std::uint64_t seed) {
  HandRandom random(seed);
  HandOfTest hand;
  hand.k_u = random.over_decades(50.0, 1000.0);
  hand.mass = random.over_decades(0.1, 0.5);
  // 0.2 to 0.8 of the critical damping is what is found of arms and fingers; a device has some of its own.
  hand.damping = population == HandPopulation::tied
                     ? 1.0 + 2.0 * random.uniform(0.2, 0.8) * std::sqrt(hand.k_u * hand.mass)
                     : random.over_decades(2.0, 20.0);
  hand.wall_angle = random.uniform(25.0, 65.0) * pi / 180.0;
  hand.k_r = random.over_decades(200.0, 800.0);
  hand.ratio = random.uniform(0.0, 1.0) < 0.5 ? 1.0 : 1.0 + hand.k_r / (hand.k_u * random.over_decades(0.5, 2.0));
  hand.press = random.uniform(1.5, 4.0);
  const double tremor_hz = random.uniform(8.0, 12.0);
  const double tremor = random.uniform(0.05e-3, 0.3e-3);
  for (std::vector<Sine>& axis : hand.tremor) axis = draw_tremor(random, tremor_hz, tremor);
  // Slow movements are made of steps: what corrects them is as long as the way of a fifth of a second.
  const double speed = random.uniform(0.0, 0.020);
  hand.drift = draw_drift(random, speed);
  hand.submovements = draw_submovements(random, 0.6e-3 + 0.2 * speed, hand.wall_angle);
  return hand;
}

HandOfTest held_still(HandOfTest hand) {
  hand.encoder = 0.0;
  hand.tremor = {};
  hand.drift.clear();
  hand.submovements.clear();
  return hand;
}

double two_tones(double force, double since_s) {
  const double fade = std::clamp(since_s / 0.2, 0.0, 1.0);
  return force * fade * (std::sin(2.0 * pi * 3.0 * since_s) + 0.6 * std::sin(2.0 * pi * 16.0 * since_s)) / 1.6;
}

HandAtWall::HandAtWall(const HandOfTest& hand, double rate) : hand_(hand), rate_(rate) {
  const double normal_x = std::cos(hand.wall_angle);
  const double normal_y = std::sin(hand.wall_angle);
  // At rest the motor holds what the hand presses with, and the handle stands so deep that it does.
  const double depth = hand.press / wall_force_per_depth();
  motion_.place = {-depth * normal_x, -depth * normal_y};
  base_goal_ = {motion_.place[0] - hand.press / hand.k_u, motion_.place[1]};
  goal_ = goal_at(0.0);
  read_before_ = {rounded_to(motion_.place[0], hand.encoder), rounded_to(motion_.place[1], hand.encoder)};
}

// With C = (n_x, ρ n_y)/k_t and k_t = k_r, the proxy is q_h + C depth/(1/k_c + n·C), and the motor gives k_r times its
// way along x.
double HandAtWall::wall_force_per_depth() const {
  const double normal_x = std::cos(hand_.wall_angle);
  const double normal_y = std::sin(hand_.wall_angle);
  return hand_.k_r * normal_x / (hand_.k_r / hand_.k_c + normal_x * normal_x + hand_.ratio * normal_y * normal_y);
}

void HandAtWall::set_k_u(double k_u) {
  base_goal_[0] += hand_.press / hand_.k_u - hand_.press / k_u;
  goal_[0] += hand_.press / hand_.k_u - hand_.press / k_u;
  hand_.k_u = k_u;
}

HandAtWall::Plane HandAtWall::goal_at(double seconds) const {
  const double slide = at(hand_.drift, seconds) - at(hand_.drift, 0.0);
  Plane goal{base_goal_[0] - slide * std::sin(hand_.wall_angle) + at(hand_.tremor[0], seconds),
             base_goal_[1] + slide * std::cos(hand_.wall_angle) + at(hand_.tremor[1], seconds)};
  for (const Submovement& each : hand_.submovements) {
    const double done = minimum_jerk((seconds - each.from_s) / each.lasts_s);
    for (std::size_t i = 0; i < 2; ++i) goal[i] += done * each.way[i];
  }
  return goal;
}

HandAtWall::Motion HandAtWall::change_of(const Motion& motion, const Plane& goal, double motor,
                                         const Plane& friction) const {
  Motion change;
  for (std::size_t i = 0; i < 2; ++i) {
    const double pull = hand_.k_u * (goal[i] - motion.place[i]) - hand_.damping * motion.speed[i];
    change.place[i] = motion.speed[i];
    change.speed[i] = (pull + (i == 0 ? motor : 0.0) + friction[i]) / hand_.mass;
  }
  return change;
}

// Runge and Kutta's fourth order. Dry friction is constant within a step, holds what does not move and is not pulled
// hard enough, and stops what turns round (Karnopp).
void HandAtWall::move(const Plane& from, const Plane& to, double step, double motor) {
  const Plane between{0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1])};
  Plane friction{};
  std::array<bool, 2> sticks{};
  if (hand_.friction > 0.0) {
    const Motion free = change_of(motion_, from, motor, {});
    for (std::size_t i = 0; i < 2; ++i) {
      const double pull = hand_.mass * free.speed[i];
      sticks[i] = motion_.speed[i] == 0.0 && std::abs(pull) <= hand_.friction;
      friction[i] = -std::copysign(hand_.friction, motion_.speed[i] == 0.0 ? pull : motion_.speed[i]);
    }
  }
  const auto after = [&](const Motion& change, double share) {
    Motion moved = motion_;
    for (std::size_t i = 0; i < 2; ++i) {
      moved.place[i] += share * step * change.place[i];
      moved.speed[i] += share * step * change.speed[i];
    }
    return moved;
  };
  const Motion first = change_of(motion_, from, motor, friction);
  const Motion second = change_of(after(first, 0.5), between, motor, friction);
  const Motion third = change_of(after(second, 0.5), between, motor, friction);
  const Motion fourth = change_of(after(third, 1.0), to, motor, friction);
  for (std::size_t i = 0; i < 2; ++i) {
    if (sticks[i]) continue;
    const double speed_before = motion_.speed[i];
    motion_.place[i] += step / 6.0 * (first.place[i] + 2.0 * (second.place[i] + third.place[i]) + fourth.place[i]);
    motion_.speed[i] += step / 6.0 * (first.speed[i] + 2.0 * (second.speed[i] + third.speed[i]) + fourth.speed[i]);
    const bool turned_round = speed_before * motion_.speed[i] < 0.0;
    if (hand_.friction > 0.0 && turned_round) motion_.speed[i] = 0.0;
  }
}

HandSample HandAtWall::step(double tone) {
  const Plane read{rounded_to(motion_.place[0], hand_.encoder), rounded_to(motion_.place[1], hand_.encoder)};
  const double depth = -(std::cos(hand_.wall_angle) * read_before_[0] + std::sin(hand_.wall_angle) * read_before_[1]);
  const bool in_contact = depth > 0.0;
  const double wanted = (in_contact ? wall_force_per_depth() * depth : 0.0) + tone;
  const double given = std::clamp(wanted, -motor_limit, motor_limit);
  const double period = 1.0 / rate_;
  const auto steps = static_cast<int>(std::ceil(period / greatest_step_s));
  ++tick_;
  const Plane next_goal = goal_at(seconds());
  const auto goal_after = [&](double share) -> Plane {
    return {goal_[0] + share * (next_goal[0] - goal_[0]), goal_[1] + share * (next_goal[1] - goal_[1])};
  };
  for (int i = 0; i < steps; ++i) {
    const double share = static_cast<double>(i) / steps;
    move(goal_after(share), goal_after(share + 1.0 / steps), period / steps, given);
  }
  goal_ = next_goal;
  read_before_ = read;
  return {read[0], given, tone, in_contact, given != wanted};
}

std::vector<HandSample> samples_of(const HandOfTest& hand, double force, double seconds, double rate) {
  HandAtWall wall(hand, rate);
  const auto settling = static_cast<std::int64_t>(std::llround(settling_s * rate));
  const auto count = static_cast<std::int64_t>(std::llround(seconds * rate));
  for (std::int64_t i = 0; i < settling; ++i) wall.step(0.0);
  std::vector<HandSample> samples;
  for (std::int64_t i = 0; i < count; ++i)
    samples.push_back(wall.step(two_tones(force, static_cast<double>(i) / rate)));
  return samples;
}

}  // namespace ghostforce
