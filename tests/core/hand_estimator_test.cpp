#include "core/hand_estimator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <memory>
#include <numbers>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "core/tick.h"
#include "tests/core/random_setting.h"
#include "tests/core/reference_hand_estimate.h"
#include "tests/support/hand_at_wall.h"
#include "tests/support/heap_guard.h"

namespace ghostforce::hand_estimator_test {
namespace {

constexpr double turn = 2.0 * std::numbers::pi;
constexpr double tone_force = 0.4;  // [N]

struct PlainHand {
  double k_u;      // [N/m]
  double mass;     // [kg]
  double damping;  // [N·s/m]
};

// What a hand of mass, damping and spring does under forces that have sounded forever: at each tone the force over the
// motion is k − ω² m + jωb. The force of a tick counts from there to the next, so it is that of the middle; and the mean
// of two neighbours of a sine is its middle times cos(ω dt/2). `hz`: of the two tones.
std::vector<HandSample> forever(const PlainHand& hand, double seconds, double rate = 1000.0,
                                std::array<double, 2> hz = {3.0, 16.0}) {
  std::vector<HandSample> samples;
  for (std::size_t i = 0; i < static_cast<std::size_t>(std::lround(seconds * rate)); ++i) {
    const double now = static_cast<double>(i) / rate + 0.01;
    HandSample sample{.position = 0.03, .force = 2.0, .in_contact = true};
    for (const std::size_t tone : {0U, 1U}) {
      const double omega = turn * hz[tone];
      const double force = tone_force * (tone == 0 ? 1.0 : 0.6) / 1.6;
      const std::complex<double> impedance(hand.k_u - omega * omega * hand.mass, omega * hand.damping);
      const std::complex<double> motion = force / impedance / std::cos(0.5 * omega / rate);
      sample.position += (motion * std::polar(1.0, omega * now)).imag();
      sample.tone += force * std::sin(omega * (now + 0.5 / rate));
    }
    sample.force += sample.tone;
    samples.push_back(sample);
  }
  return samples;
}

HandEstimator fed(std::span<const HandSample> samples, double rate = 1000.0, double window_s = 2.0) {
  HandEstimator estimator(rate, window_s);
  for (const HandSample& sample : samples) estimator.add(sample);
  return estimator;
}

HandEstimate estimate_of(std::span<const HandSample> samples, double rate = 1000.0, double window_s = 2.0) {
  return fed(samples, rate, window_s).estimate();
}

const PlainHand usual_hand{300.0, 0.2, 5.0};

template <typename Change>
std::vector<HandSample> changed(std::vector<HandSample> samples, Change change) {
  for (std::size_t i = 0; i < samples.size(); ++i) change(samples[i], i);
  return samples;
}

void expect_no_number(const HandEstimate& estimate, HandUnknown why) {
  EXPECT_EQ(estimate.why, why);
  EXPECT_EQ(estimate, HandEstimate{.why = why});
  EXPECT_FALSE(estimate.has_number());
  EXPECT_FALSE(estimate.is_known());
}

// ---- The equations --------------------------------------------------------------------------------------------------

TEST(HandEstimatorTest, FindsSpringMassAndDamperOfAHandThatHasAlwaysBeenThere) {
  Random random(1);
  for (const double rate : {250.0, 333.0, 500.0, 1000.0, 1001.0, 4000.0, 20000.0}) {
    for (int i = 0; i < 20; ++i) {
      const PlainHand hand{random.over_decades(50.0, 1000.0), random.over_decades(0.1, 0.5),
                           random.over_decades(2.0, 20.0)};
      SCOPED_TRACE(testing::Message() << hand.k_u << " N/m, " << hand.mass << " kg, " << hand.damping << " N s/m, "
                                      << rate << " Hz");
      const HandEstimate found = estimate_of(forever(hand, 2.05, rate), rate);
      ASSERT_TRUE(found.is_known());
      // The best parabola of two seconds takes some of a tone with it, and of a tone in another phase another part. Hann
      // leaves 4e-4 of that, of the whole impedance: spring, mass and damper may be small beside each other. At 333 and
      // 1001 Hz no window holds a whole number of samples and of tones, so that both tones leak.
      const double impedance = hand.k_u + 360.0 * hand.mass + 19.0 * hand.damping;  // ω₁ = 18.8/s, at most
      const double leak = rate == 333.0 || rate == 1001.0 ? 1e-3 : 5e-4;
      EXPECT_NEAR(found.k_u, hand.k_u, leak * impedance);
      EXPECT_NEAR(found.mass, hand.mass, leak * impedance / 360.0);
      // Were the force of a tick taken for the one before or after, this would be off by dt |k − ω₂² m|, 1 to 5 N·s/m.
      EXPECT_NEAR(found.damping, hand.damping, leak * impedance / 19.0);
      EXPECT_LT(found.sigma, 1e-3 * impedance);
    }
  }
}

TEST(HandEstimatorTest, PositionsAndForcesThatStayOrBendDoNotMatter) {
  const std::vector<HandSample> samples = forever(usual_hand, 2.05);
  const HandEstimate straight = estimate_of(samples);
  const HandEstimate bent = estimate_of(changed(samples, [](HandSample& sample, std::size_t i) {
    const double seconds = static_cast<double>(i) / 1000.0;
    sample.position += 0.5 - 0.1 * seconds + 0.05 * seconds * seconds;
    sample.force += -4.0 + 3.0 * seconds - 2.0 * seconds * seconds;
  }));
  // Parabolas go but for rounding, of numbers a thousand times those that are told.
  EXPECT_NEAR(bent.k_u, straight.k_u, 1e-8 * straight.k_u);
  EXPECT_NEAR(bent.mass, straight.mass, 1e-8 * straight.mass);
  EXPECT_NEAR(bent.damping, straight.damping, 1e-8 * straight.damping);
}

TEST(HandEstimatorTest, AgreesWithTheEquationsTermByTerm) {
  int compared = 0;
  for (const double window_s : {2.0, 4.0}) {
    for (const double rate : {250.0, 500.0, 1000.0, 4000.0}) {
      for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed << ", " << rate << " Hz, " << window_s << " s");
        const HandPopulation population = seed % 2 == 0 ? HandPopulation::tied : HandPopulation::apart;
        // The first sample has no tone yet and the next one no neighbour: the averages then begin where the other's do.
        const double seconds = 0.2 + window_s + 2.0 / rate;
        const std::vector<HandSample> samples = samples_of(draw_hand(population, seed), tone_force, seconds, rate);
        const HandEstimate found = estimate_of(samples, rate, window_s);
        if (!found.has_number()) continue;
        ++compared;
        const ReferenceHandEstimate reference = reference_hand_estimate(samples, rate, window_s);
        // Sums of 1000 terms in another order, 1e-13, of centimetres, where a tone may be some hundredths of a millimetre.
        EXPECT_NEAR(found.k_u / reference.k_u, 1.0, 1e-9);
        EXPECT_NEAR(found.sigma / reference.sigma, 1.0, 1e-7);  // what is left where the signals are taken off
        EXPECT_NEAR(found.mass / reference.mass, 1.0, 1e-9);
        EXPECT_NEAR(found.damping / reference.damping, 1.0, 1e-9);
      }
    }
  }
  EXPECT_GE(compared, 40);
}

// 0.5 % is what was asked of it, where the tones have sounded for so long that nothing rings any more: a hand that is
// damped to a fifth rings for a second after they begin, in the middle of what is measured.
TEST(HandEstimatorTest, AStillHandIsKnownToHalfAPerCent) {
  std::vector<double> errors;
  for (const HandPopulation population : {HandPopulation::tied, HandPopulation::apart}) {
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
      SCOPED_TRACE(seed);
      const HandOfTest hand = held_still(draw_hand(population, seed));
      const HandEstimate found = estimate_of(samples_of(hand, tone_force, 3.5));
      ASSERT_TRUE(found.is_known());
      EXPECT_NEAR(found.k_u / hand.k_u, 1.0, 0.005);
      EXPECT_NEAR(found.mass / hand.mass, 1.0, 0.005);
      errors.push_back(std::abs(found.k_u / hand.k_u - 1.0));
    }
  }
  std::ranges::sort(errors);
  EXPECT_LT(errors[errors.size() / 2], 0.001);
}

// With its delay and its implicit step, for both underactuated strategies. The spring acts at the end of a step and the
// mass at its beginning, half a tick late and half a tick early: as a damper of dt/2 (k + ω² m) more.
TEST(HandEstimatorTest, TheProgramsOwnTickWithoutNoiseIsKnownToHalfAPerCent) {
  for (const StrategyId id : {StrategyId::naive, StrategyId::anisotropic}) {
    for (const double k_u : {50.0, 120.0, 300.0, 1000.0}) {
      for (const double rate : {500.0, 1000.0, 4000.0}) {
        SCOPED_TRACE(testing::Message() << strategy(id).name << ' ' << k_u << " N/m, " << rate << " Hz");
        const double mass = 0.1;
        const double damping = 5.0;
        const Wall<2> wall{{0.0, 0.0}, direction_at(2.356)};
        const Vector<2> motor{1.0, 0.0};
        const TickCoefficients<2> coefficients =
            coefficients_of(wall, actuated_along(motor), make_stiffnesses(k_u, 600.0, 600.0, 1e5), mass, damping, rate);
        TickState<2> state = state_at_start(-0.03 * wall.normal);
        auto& own = state.strategies[index_of(id)];
        HandEstimator estimator(rate);
        const auto settled = static_cast<std::int64_t>(rate);
        for (std::int64_t k = 0; k < settled + std::llround(2.3 * rate); ++k) {
          tick(coefficients, state.goal, state);
          const double since_s = static_cast<double>(state.tick - settled) / rate;
          const double tone = since_s > 0.0 ? two_tones(tone_force, since_s) : 0.0;
          own.tone = tone * motor;
          const Vector<2> force = force_of<2>(coefficients.strategies[index_of(id)], own) + own.tone;
          if (since_s > 0.0) estimator.add({own.motion.position.x, force.x, tone, own.in_contact, false});
        }
        const HandEstimate found = estimator.estimate();
        ASSERT_TRUE(found.is_known()) << sentence_of(found.why);
        EXPECT_NEAR(found.k_u / k_u, 1.0, 0.005);
        EXPECT_NEAR(found.mass / mass, 1.0, 0.02);
        const double omega_2 = turn * turn * (3.0 * 3.0 + 16.0 * 16.0);
        const double omega_4 = std::pow(turn * 3.0, 4) + std::pow(turn * 16.0, 4);
        EXPECT_NEAR(found.damping, damping + 0.5 / rate * (k_u + mass * omega_4 / omega_2), 0.02 * damping);
      }
    }
  }
}

// ---- Sums that slide ------------------------------------------------------------------------------------------------

TEST(HandEstimatorTest, AMillionSamplesLeaveNothingBehind) {
  Random random(3);
  auto lasting = std::make_unique<HandEstimator>(1000.0);
  const std::vector<HandSample> round = forever(usual_hand, 1.0);  // whole turns of both tones
  std::vector<HandSample> last;
  constexpr std::size_t count = 1000000;
  constexpr std::size_t kept = 2400;  // 2 s and some, and whole averages
  for (std::size_t i = 0; i < count; ++i) {
    HandSample sample = round[i % round.size()];
    sample.position += 1e-4 * random.uniform(-1.0, 1.0);
    // Up to here things fly about: by metres, with kilonewtons.
    if (i < count - kept) {
      sample.position += 9.0 * random.uniform(-1.0, 1.0);
      sample.force += 5000.0 * random.uniform(-1.0, 1.0);
    } else {
      last.push_back(sample);
    }
    lasting->add(sample);
  }
  const HandEstimate one = lasting->estimate();
  const HandEstimate other = estimate_of(last);
  ASSERT_TRUE(other.has_number());
  EXPECT_EQ(one.why, other.why);
  // 250,000 averages of up to 5000 N come and go, each with a rounding of 1e-13 of the sums, in either direction: some
  // 1e-10 N beside tones of tenths of a newton. What is left between the tones is a hundredth of them.
  EXPECT_NEAR(one.k_u / other.k_u, 1.0, 1e-9);
  EXPECT_NEAR(one.mass / other.mass, 1.0, 1e-9);
  EXPECT_NEAR(one.damping / other.damping, 1.0, 1e-9);
  EXPECT_NEAR(one.sigma / other.sigma, 1.0, 1e-8);
}

TEST(HandEstimatorTest, WhatLiesBeforeTheWindowIsForgotten) {
  const HandOfTest stiff{.k_u = 900.0, .mass = 0.3, .damping = 12.0};
  std::vector<HandSample> samples = forever({80.0, 0.2, 5.0}, 3.0);
  const std::vector<HandSample> after = forever({900.0, 0.3, 12.0}, 2.1);
  samples.insert(samples.end(), after.begin(), after.end());
  EXPECT_NEAR(estimate_of(samples).k_u, stiff.k_u, 1e-3 * stiff.k_u);
}

TEST(HandEstimatorTest, UsesNoHeap) {
  const std::vector<HandSample> samples = samples_of(draw_hand(HandPopulation::apart, 5), tone_force, 3.0);
  const HeapGuard guard;
  HandEstimator estimator(1000.0);
  double sum = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    estimator.add(samples[i]);
    if (i % 100 == 0) sum += estimator.estimate().k_u + estimator.filled();
  }
  estimator.reset();
  EXPECT_GT(sum, 0.0);
}

// ---- How much is there ----------------------------------------------------------------------------------------------

TEST(HandEstimatorTest, TellsNothingUntilItsWindowIsFull) {
  for (const double window_s : {2.0, 4.0}) {
    const std::vector<HandSample> samples = forever(usual_hand, window_s + 0.1);
    HandEstimator estimator(1000.0, window_s);
    expect_no_number(estimator.estimate(), HandUnknown::collecting);
    EXPECT_EQ(estimator.filled(), 0.0);
    std::size_t taken = 0;
    double filled = 0.0;
    while (estimator.estimate().why == HandUnknown::collecting && taken < samples.size()) {
      EXPECT_GE(estimator.filled(), filled);
      filled = estimator.filled();
      estimator.add(samples[taken++]);
    }
    // And the neighbour of the first one.
    EXPECT_EQ(taken, static_cast<std::size_t>(1000.0 * window_s) + 1);
    EXPECT_EQ(estimator.filled(), 1.0);
    EXPECT_TRUE(estimator.estimate().is_known());
    estimator.reset();
    expect_no_number(estimator.estimate(), HandUnknown::collecting);
    EXPECT_EQ(estimator.filled(), 0.0);
  }
}

TEST(HandEstimatorTest, RefusesRatesThatAreTooLowOrImpossible) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double rate :
       {100.0, 200.0, 249.0, 0.0, -1000.0, std::numeric_limits<double>::quiet_NaN(), 1e10, 1e300, infinity}) {
    SCOPED_TRACE(rate);
    HandEstimator estimator(rate);
    for (const HandSample& sample : forever(usual_hand, 10.0, 200.0)) estimator.add(sample);
    expect_no_number(estimator.estimate(), HandUnknown::rate_too_low);
    EXPECT_EQ(estimator.filled(), 0.0);
    estimator.reset();
    expect_no_number(estimator.estimate(), HandUnknown::rate_too_low);
  }
}

// ---- Wrong signs, units and rates -----------------------------------------------------------------------------------

TEST(HandEstimatorTest, WhatIsNoHandIsNotKnown) {
  const std::vector<HandSample> good = forever(usual_hand, 2.05);
  const auto with = [&](auto change) { return estimate_of(changed(good, change)); };
  ASSERT_TRUE(estimate_of(good).is_known());
  const std::array wrong{
      with([](HandSample& sample, std::size_t) { sample.position = -sample.position; }),
      with([](HandSample& sample, std::size_t) { sample.force = -sample.force; }),
      with([](HandSample& sample, std::size_t) { sample.position *= 100.0; }),  // centimetres for metres
      with([](HandSample& sample, std::size_t) { sample.position *= 0.001; }),
      with([](HandSample& sample, std::size_t) { sample.force = sample.force - sample.tone; }),  // tones left out
      with([](HandSample& sample, std::size_t) { sample.force = 2.0; }),
      with([](HandSample& sample, std::size_t) { sample.position = 0.03; }),
      with([](HandSample& sample, std::size_t) { sample.position = sample.force = 0.0; }),
      with([](HandSample& sample, std::size_t i) { sample.position = 0.001 * static_cast<double>(i % 7); }),
      estimate_of(forever(usual_hand, 2.05, 1000.0, {5.0, 20.0})),
      estimate_of(forever(usual_hand, 2.05, 1000.0, {3.0, 12.0})),
      estimate_of(forever(usual_hand, 5.0, 2000.0), 1000.0),
      estimate_of(forever(usual_hand, 5.0, 500.0), 1000.0),
      estimate_of(forever(usual_hand, 5.0, 1000.0), 1100.0),
  };
  for (std::size_t i = 0; i < wrong.size(); ++i) {
    EXPECT_FALSE(wrong[i].is_known()) << "case " << i << ": " << wrong[i].k_u;
    EXPECT_TRUE(std::isfinite(wrong[i].k_u) && std::isfinite(wrong[i].sigma)) << i;
    EXPECT_FALSE(sentence_of(wrong[i].why).empty()) << i;
  }
}

// ---- What happens to samples ----------------------------------------------------------------------------------------

TEST(HandEstimatorTest, NoTonesNoNumber) {
  expect_no_number(estimate_of(samples_of(draw_hand(HandPopulation::tied, 7), 0.0, 2.3)), HandUnknown::no_tones);
  // They fall silent.
  std::vector<HandSample> samples = forever(usual_hand, 2.1);
  for (int i = 0; i < 100; ++i) {
    samples.push_back(samples.back());
    samples.back().tone = 0.0;
  }
  expect_no_number(estimate_of(samples), HandUnknown::no_tones);
  // Where they cross zero they have not.
  const HandEstimate crossed = estimate_of(changed(forever(usual_hand, 2.1), [](HandSample& sample, std::size_t i) {
    if (i % 300 == 150) sample.tone = 0.0;
  }));
  EXPECT_TRUE(crossed.is_known());
}

struct Mishap {
  const char* name;
  HandUnknown why;
  void (*happen)(HandSample&);
};

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

constexpr std::array mishaps{
    Mishap{"lost", HandUnknown::no_contact, [](HandSample& sample) { sample.in_contact = false; }},
    Mishap{"limit", HandUnknown::at_limit, [](HandSample& sample) { sample.is_at_limit = true; }},
    Mishap{"nan position", HandUnknown::damaged, [](HandSample& sample) { sample.position = nan; }},
    Mishap{"nan force", HandUnknown::damaged, [](HandSample& sample) { sample.force = nan; }},
    Mishap{"nan tone", HandUnknown::damaged, [](HandSample& sample) { sample.tone = nan; }},
    Mishap{"infinite position", HandUnknown::damaged, [](HandSample& sample) { sample.position = -infinite; }},
    Mishap{"infinite force", HandUnknown::damaged, [](HandSample& sample) { sample.force = infinite; }},
    Mishap{"1e300 position", HandUnknown::damaged, [](HandSample& sample) { sample.position = 1e300; }},
    Mishap{"1e300 force", HandUnknown::damaged, [](HandSample& sample) { sample.force = -1e300; }},
    Mishap{"1e300 tone", HandUnknown::damaged, [](HandSample& sample) { sample.tone = 1e300; }},
};

TEST(HandEstimatorTest, OneBadSampleCostsAWindow) {
  for (const Mishap& mishap : mishaps) {
    SCOPED_TRACE(mishap.name);
    std::vector<HandSample> samples = forever(usual_hand, 4.2);
    constexpr std::size_t when = 2100;
    mishap.happen(samples[when]);
    const std::span all(samples);
    HandEstimator estimator = fed(all.first(when));
    ASSERT_TRUE(estimator.estimate().is_known());
    for (std::size_t i = when; i < samples.size(); ++i) {
      estimator.add(samples[i]);
      if (i < when + 2001) {
        expect_no_number(estimator.estimate(), mishap.why);
      }
      if (HasFailure()) return;
    }
    const HandEstimate again = estimator.estimate();
    EXPECT_TRUE(again.is_known());
    EXPECT_NEAR(again.k_u, usual_hand.k_u, 1e-3 * usual_hand.k_u);
  }
}

TEST(HandEstimatorTest, AGapIsForTheCallerToTell) {
  std::vector<HandSample> samples = forever(usual_hand, 4.2);
  HandEstimator estimator = fed(std::span(samples).first(2100));
  estimator.reset(HandUnknown::damaged);
  for (std::size_t i = 2110; i < 4100; ++i) estimator.add(samples[i]);
  expect_no_number(estimator.estimate(), HandUnknown::damaged);
  for (std::size_t i = 4100; i < 4200; ++i) estimator.add(samples[i]);
  EXPECT_TRUE(estimator.estimate().is_known());
}

TEST(HandEstimatorTest, AnythingMayComeIn) {
  Random random(11);
  constexpr std::array values{0.0, -0.0, nan, infinite, -infinite, 1e300, -1e300, 5e-324, 9.99, -9.99, 9999.0, 1e-12};
  for (const double rate : {250.0, 1000.0, 20000.0}) {
    for (const bool is_damaged : {true, false}) {
      HandEstimator estimator(rate);
      for (int i = 0; i < 60000; ++i) {
        HandSample sample{random.uniform(-10.0, 10.0), random.over_decades(1e-9, 1e4), random.uniform(-1.0, 1.0), true,
                          false};
        if (is_damaged && random.once_in(700)) {
          double* const field =
              std::array{&sample.position, &sample.force, &sample.tone}.at(static_cast<std::size_t>(random.below(3)));
          *field = values.at(static_cast<std::size_t>(random.below(static_cast<int>(values.size()))));
        }
        estimator.add(sample);
        if (i % 500 != 0) continue;
        const HandEstimate estimate = estimator.estimate();
        ASSERT_TRUE(std::isfinite(estimate.k_u) && std::isfinite(estimate.sigma) && std::isfinite(estimate.mass) &&
                    std::isfinite(estimate.damping));
        ASSERT_GE(estimate.k_u, 0.0);
        ASSERT_GE(estimate.sigma, 0.0);
        if (!estimate.has_number()) {
          ASSERT_EQ(estimate, HandEstimate{.why = estimate.why});
        }
        if (estimate.is_known()) {
          ASSERT_TRUE(estimate.k_u > 20.0 && estimate.k_u < 2000.0 && estimate.sigma < 0.2 * estimate.k_u &&
                      estimate.mass > 0.02 && estimate.mass < 1.5 && estimate.damping > 0.0);
        }
        ASSERT_GE(estimator.filled(), 0.0);
        ASSERT_LE(estimator.filled(), 1.0);
      }
    }
  }
}

TEST(HandEstimatorTest, EachReasonIsASentenceOfItsOwn) {
  EXPECT_EQ(sentence_of(HandUnknown::none), "");
  std::vector<std::string_view> sentences;
  for (std::size_t i = 1; i < hand_unknown_count; ++i) {
    const std::string_view sentence = sentence_of(static_cast<HandUnknown>(i));
    EXPECT_TRUE(sentence.ends_with('.')) << i;
    EXPECT_EQ(std::ranges::count(sentences, sentence), 0) << sentence;
    sentences.push_back(sentence);
  }
}

}  // namespace
}  // namespace ghostforce::hand_estimator_test
