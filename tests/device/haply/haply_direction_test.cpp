// The direction test of the Haply's motors: with how little it pushes, that it finds a motor which pushes the wrong way
// before anything pushes harder, and that no hand makes it take a right motor for a wrong one.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "core/tremor_and_drift.h"
#include "device/motors/direction_test.h"
#include "tests/device/haply/held_haply.h"
#include "tests/support/hand_at_wall.h"
#include "tests/support/long_run.h"

namespace ghostforce::haply_direction_test {
namespace {

constexpr double gentle_N = 0.25;
constexpr std::array<HaplyBoard::Kind, 3> kinds{HaplyBoard::Kind::m0, HaplyBoard::Kind::m3, HaplyBoard::Kind::dev_kit};

// What each motor has done until one of them pushes harder than gently.
class GentleWatch {
 public:
  explicit GentleWatch(HeldHaply& haply) : haply_(haply), before_ns_(haply.port().now_ns()) {
    haply.port().on_step = [this] { look(); };
  }
  ~GentleWatch() { haply_.port().on_step = nullptr; }
  GentleWatch(const GentleWatch&) = delete;
  GentleWatch& operator=(const GentleWatch&) = delete;

  double greatest_force() const { return greatest_; }                // at all times [N]
  double gentle_force() const { return gentle_; }                    // until both have had a train [N]
  double pushed_s(std::size_t arm) const { return pushed_s_[arm]; }  // until then
  double longest_pulse_s() const { return longest_pulse_s_; }
  bool has_tested_both() const { return std::ranges::min(pushed_s_) > 0.95 * DirectionTest::train_s; }

 private:
  void look() {
    const HaplyTruth truth = haply_.truth();
    const std::int64_t now_ns = haply_.port().now_ns();
    const double lasted_s = 1e-9 * static_cast<double>(now_ns - std::exchange(before_ns_, now_ns));
    const double force = glm::length(truth.force);
    greatest_ = std::max(greatest_, force);
    if (has_tested_both()) return;
    gentle_ = std::max(gentle_, force);
    for (std::size_t arm = 0; arm < 2; ++arm) {
      const double duty = truth.duties[arm];
      if (duty == 0.0 || duty * duty_before_[arm] < 0.0) pulse_s_[arm] = 0.0;
      duty_before_[arm] = duty;
      if (duty == 0.0) continue;
      pushed_s_[arm] += lasted_s;
      pulse_s_[arm] += lasted_s;
      longest_pulse_s_ = std::max(longest_pulse_s_, pulse_s_[arm]);
    }
  }

  HeldHaply& haply_;
  std::int64_t before_ns_;
  std::array<double, 2> duty_before_{};
  std::array<double, 2> pushed_s_{};
  std::array<double, 2> pulse_s_{};
  double longest_pulse_s_ = 0.0;
  double gentle_ = 0.0;
  double greatest_ = 0.0;
};

HeldHaply::Options held(std::string_view variant, HaplyBoard::Kind kind, double stiffness) {
  HeldHaply::Options options;
  options.device.variant = variant;
  options.device.board.kind = kind;
  options.device.hand.stiffness = stiffness;
  options.calibration = right_calibration(variant, kind);
  options.settings.wall_point = {0.2, -0.2};  // out of the way
  return options;
}

void reverse_motor(HeldHaply& haply, std::size_t motor) {
  InjectedHaplyFault wrong;
  wrong.reversed_motors = static_cast<std::uint8_t>(1U << motor);
  haply.board().inject(wrong);
}

bool prints() {
  return std::getenv("GHOSTFORCE_PRINT_HAPLY_FAULTS") != nullptr;
}

TEST(HaplyDirection, PushesWithNoMoreThanAQuarterOfANewtonWhereverTheHandleIs) {
  double greatest = 0.0;
  double longest_s = 0.0;
  for (const HaplyVariant& variant : haply_variant_catalog()) {
    for (const double stiffness : {20.0, 100.0, 1000.0}) {
      // Along the edge with the loose hand, which goes farthest from there.
      const std::vector<Vector<2>> places =
          stiffness > 20.0 ? std::vector{Vector<2>(0.0)}
                           : std::vector{Vector<2>(-0.03, 0.03), Vector<2>(0.03, 0.03), Vector<2>(-0.03, -0.03),
                                         Vector<2>(0.03, -0.03), Vector<2>(0.0, -0.04)};
      for (const Vector<2>& place : places) {
        SCOPED_TRACE(testing::Message() << variant.name << ' ' << stiffness << " N/m, " << place.x << ' ' << place.y);
        HeldHaply haply(held(variant.name, HaplyBoard::Kind::m3, stiffness));
        ASSERT_TRUE(haply.get_ready());
        haply.lead(place, 0.3);
        haply.run(1.5);
        haply.ask_to_arm();
        const GentleWatch watch(haply);
        ASSERT_TRUE(haply.run_until(9.0, [&] { return watch.has_tested_both() || haply.motors().gain > 0.0; }))
            << haply.reason();
        EXPECT_TRUE(watch.has_tested_both());
        // Near a singular pose there is less of it.
        if (haply.haply().workspace_share == 1.0) {
          EXPECT_GT(watch.gentle_force(), 0.15);
        }
        EXPECT_LE(watch.gentle_force(), gentle_N);
        EXPECT_LE(watch.longest_pulse_s(), 0.3);
        greatest = std::max(greatest, watch.gentle_force());
        longest_s = std::max(longest_s, watch.longest_pulse_s());
      }
    }
  }
  if (prints()) std::printf("direction test: at most %.3f N, for %.0f ms\n", greatest, 1e3 * longest_s);
}

TEST(HaplyDirection, FindsAMotorThatPushesTheWrongWayBeforeAnythingPushesHarder) {
  std::size_t turn = 0;
  for (const HaplyBoard::Kind kind : kinds) {
    for (const HaplyVariant& variant : haply_variant_catalog()) {
      for (const std::size_t motor : {0U, 1U}) {
        constexpr std::array stiffnesses{20.0, 60.0, 150.0};
        for (const double stiffness : is_long_run() ? std::vector<double>(stiffnesses.begin(), stiffnesses.end())
                                                    : std::vector<double>{stiffnesses[turn++ % 3]}) {
          SCOPED_TRACE(testing::Message() << variant.name << " board " << static_cast<int>(kind) << " motor "
                                          << motor + 1 << ' ' << stiffness << " N/m");
          HeldHaply haply(held(variant.name, kind, stiffness));
          ASSERT_TRUE(haply.get_ready());
          reverse_motor(haply, motor);
          haply.run(0.8);
          haply.ask_to_arm();
          const GentleWatch watch(haply);
          ASSERT_TRUE(haply.run_until(6.0, [&] { return haply.motors().reason != OffReason::none; }));
          EXPECT_EQ(haply.motors().reason, OffReason::calibration) << haply.reason();
          EXPECT_EQ(haply.motors().finding, (MotorFinding{MotorVerdict::wrong_way, motor}));
          EXPECT_LE(watch.greatest_force(), gentle_N);
          haply.run(0.5);
          EXPECT_FALSE(haply.pushes());
        }
      }
    }
  }
}

// A dev kit with the calibration of an M3: the motor at its first port pushes the other way. Once that motor's sign is
// turned round, as a person does it in the file, the motors come on.
TEST(HaplyDirection, NamesTheMotorWhoseSignHasToBeTurnedRound) {
  for (const HaplyVariant& variant : haply_variant_catalog()) {
    SCOPED_TRACE(variant.name);
    HeldHaply::Options options = held(variant.name, HaplyBoard::Kind::dev_kit, 100.0);
    options.calibration = right_calibration(variant.name, HaplyBoard::Kind::m3);
    HeldHaply haply(options);
    ASSERT_TRUE(haply.get_ready());
    EXPECT_FALSE(haply.arm());
    const MotorFinding found = haply.motors().finding;
    ASSERT_EQ(found.verdict, MotorVerdict::wrong_way);
    EXPECT_EQ(options.calibration.arms[found.motor].motor_port, 1);
    options.calibration.arms[found.motor].is_motor_reversed = true;
    HeldHaply mended(options);
    ASSERT_TRUE(mended.get_ready());
    EXPECT_TRUE(mended.arm()) << mended.reason();
    EXPECT_EQ(mended.motors().finding, MotorFinding{});
  }
}

// A quarter of a newton moves such a hand by less than an encoder tells: what pushes harder finds it.
TEST(HaplyDirection, LeavesAFirmHandToTheMotorCheck) {
  for (const HaplyBoard::Kind kind : kinds) {
    for (const std::size_t motor : {0U, 1U}) {
      for (const double stiffness : {1000.0, 2000.0}) {
        SCOPED_TRACE(testing::Message() << "board " << static_cast<int>(kind) << " motor " << motor + 1 << ' '
                                        << stiffness);
        HeldHaply haply(held("v3.1", kind, stiffness));
        ASSERT_TRUE(haply.get_ready());
        reverse_motor(haply, motor);
        haply.run(0.8);
        haply.ask_to_arm();
        ASSERT_TRUE(haply.run_until(9.0, [&] { return haply.motors().reason != OffReason::none; }));
        EXPECT_EQ(haply.motors().finding, (MotorFinding{MotorVerdict::wrong_way, motor}));
        EXPECT_EQ(haply.motors().gain, 0.0);
      }
    }
  }
}

TEST(HaplyDirection, TellsWhatElseIsWrong) {
  {
    HeldHaply::Options options = held("v3.1", HaplyBoard::Kind::m3, 100.0);
    options.device.full_torques.y = 1e-6;  // motor 2 has no supply
    HeldHaply haply(options);
    ASSERT_TRUE(haply.get_ready());
    EXPECT_FALSE(haply.arm());
    EXPECT_EQ(haply.motors().finding, (MotorFinding{MotorVerdict::silent, 1}));
  }
  {
    HeldHaply::Options options = held("v3.1", HaplyBoard::Kind::m3, 100.0);
    std::swap(options.calibration.arms[0].motor_port, options.calibration.arms[1].motor_port);
    HeldHaply haply(options);
    ASSERT_TRUE(haply.get_ready());
    haply.ask_to_arm();
    ASSERT_TRUE(haply.run_until(12.0, [&] { return haply.motors().reason != OffReason::none; }));
    EXPECT_EQ(haply.motors().finding.verdict, MotorVerdict::crossed);
  }
}

// A person and the device in the hand.
struct Person {
  HeldHaply::Options options;
  TremorAndDrift tremor_and_drift;
};

Person person(HandRandom& random) {
  const auto variants = haply_variant_catalog();
  const auto one_of = [&](std::size_t count) {
    return static_cast<std::size_t>(random.uniform(0.0, 1.0) * static_cast<double>(count));
  };
  const std::string_view variant = variants[one_of(variants.size())].name;
  Person person{held(variant, kinds[one_of(kinds.size())], random.over_decades(20.0, 1000.0)), {}};
  HaplyArms::Options& arms = person.options.device.arms;
  arms.handle_mass = random.over_decades(0.05, 0.4);
  arms.friction = Vector<2>(random.uniform(0.0, 1.0) < 0.5 ? 0.0 : random.uniform(0.0, 1.5e-3));
  person.options.device.full_torques = 0.123 * Vector<2>(random.uniform(0.7, 1.3), random.uniform(0.7, 1.3));
  person.tremor_and_drift.tremor_rms = random.uniform(0.0, 1.0) < 0.3 ? 0.0 : random.over_decades(10e-6, 200e-6);
  person.tremor_and_drift.drift_speed = random.uniform(0.0, 1.0) < 0.3 ? 0.0 : random.over_decades(0.5e-3, 5e-3);
  person.tremor_and_drift.seed = std::floor(random.uniform(1.0, 1e6));
  return person;
}

// Arms, and waits until the motors push or are off. The hand is where it means to be, but for what it does by itself.
void arm_in_hand(HeldHaply& haply, const TremorAndDrift& own, HandRandom& random) {
  const TremorAndDriftMotion motion(own);
  Vector<2> place = HeldHaply::free_place;
  for (int ms = 0; ms < 9000; ++ms) {
    // One that moves on, some of the time.
    if (own.seed > 5e5 && ms % 700 == 350)
      place += 0.005 * Vector<2>(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
    haply.lead(motion.shaken(place, 0.001 * ms), 0.0);
    if (ms == 1000) haply.ask_to_arm();
    haply.step();
    if (haply.motors().gain > 0.0 || haply.motors().reason != OffReason::none) return;
  }
}

TEST(HaplyDirection, NeverTakesARightMotorForAWrongOne) {
  HandRandom random(20261129);
  const int people = is_long_run() ? 1000 : 40;
  int came_on = 0;
  for (int i = 0; i < people; ++i) {
    const Person who = person(random);
    SCOPED_TRACE(testing::Message() << i << ": " << who.options.device.variant << ' '
                                    << who.options.device.hand.stiffness << " N/m, trembles "
                                    << who.tremor_and_drift.tremor_rms << " m, drifts "
                                    << who.tremor_and_drift.drift_speed << " m/s");
    HeldHaply haply(who.options);
    ASSERT_TRUE(haply.get_ready());
    arm_in_hand(haply, who.tremor_and_drift, random);
    EXPECT_NE(haply.motors().reason, OffReason::calibration);
    came_on += haply.motors().gain > 0.0 ? 1 : 0;
  }
  // It was about something. Others are too lively for the check that follows, which waits.
  EXPECT_GT(came_on, people / 3);
}

// The same people, each with one motor that pushes the wrong way.
TEST(HaplyDirection, NobodyFeelsAWallOfAWrongMotor) {
  HandRandom random(20261130);
  const int people = is_long_run() ? 1000 : 30;
  int loose = 0;
  int found_gently = 0;
  for (int i = 0; i < people; ++i) {
    const Person who = person(random);
    SCOPED_TRACE(testing::Message() << i << ": " << who.options.device.variant << ' '
                                    << who.options.device.hand.stiffness << " N/m");
    HeldHaply haply(who.options);
    ASSERT_TRUE(haply.get_ready());
    reverse_motor(haply, static_cast<std::size_t>(i) % 2);
    const GentleWatch watch(haply);
    arm_in_hand(haply, who.tremor_and_drift, random);
    EXPECT_EQ(haply.motors().gain, 0.0);
    if (haply.motors().reason == OffReason::calibration) {
      const MotorFinding found = haply.motors().finding;
      EXPECT_TRUE(found.verdict == MotorVerdict::undecided || found.motor == static_cast<std::size_t>(i) % 2)
          << static_cast<int>(found.verdict) << ' ' << found.motor;
    }
    if (who.options.device.hand.stiffness > 150.0) continue;
    ++loose;
    // The motors of some of them are stronger than the calibration says.
    found_gently += haply.motors().reason == OffReason::calibration && watch.greatest_force() < 1.4 * gentle_N ? 1 : 0;
  }
  EXPECT_GT(10 * found_gently, 6 * loose);
  if (prints())
    std::printf("of %d loose hands with a wrong motor, %d were told by the direction test\n", loose, found_gently);
}

}  // namespace
}  // namespace ghostforce::haply_direction_test
