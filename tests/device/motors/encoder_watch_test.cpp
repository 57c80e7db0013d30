// What counts as a frozen encoder, reading by reading.
#include "device/motors/encoder_watch.h"

#include <gtest/gtest.h>

namespace ghostforce::encoder_watch_test {
namespace {

constexpr std::int64_t tick_ns = 1'000'000;

// Encoders that say what `counts` makes of the number of milliseconds.
template <typename Counts>
void watch(EncoderWatch& watch, int from_ms, int to_ms, double force, Counts&& counts) {
  for (int ms = from_ms; ms < to_ms; ++ms) watch.update(counts(ms), true, force, ms * tick_ns);
}

Vector<3> silent(int /*ms*/) {
  return {10.0, 20.0, 30.0};
}

TEST(EncoderWatch, TakesEncodersForFrozenThatDoNotAnswer) {
  EncoderWatch encoders;
  watch(encoders, 1, 2, 0.0, silent);
  watch(encoders, 2, 80, 1.0, silent);
  EXPECT_TRUE(encoders.is_asking());
  EXPECT_FALSE(encoders.is_frozen());
  watch(encoders, 80, 92, 1.0, silent);
  EXPECT_TRUE(encoders.is_frozen());
}

TEST(EncoderWatch, WatchesNoWeakForce) {
  EncoderWatch encoders;
  watch(encoders, 1, 2000, 0.29, silent);
  EXPECT_FALSE(encoders.is_asking());
  EXPECT_FALSE(encoders.is_frozen());
}

TEST(EncoderWatch, AsksNobodyWhoSpeaks) {
  EncoderWatch encoders;
  watch(encoders, 1, 2000, 3.0, [](int ms) { return Vector<3>(ms / 20, ms / 15, ms / 24); });
  EXPECT_FALSE(encoders.is_asking());
  EXPECT_FALSE(encoders.is_frozen());
}

TEST(EncoderWatch, LeavesEncodersAloneThatHaveAnswered) {
  EncoderWatch encoders;
  watch(encoders, 1, 2, 0.0, silent);
  watch(encoders, 2, 50, 1.0, silent);
  ASSERT_TRUE(encoders.is_asking());
  const double asked = encoders.force_at(40 * tick_ns);
  ASSERT_LT(asked, 0.0);
  const auto answered = [](int ms) { return silent(ms) + Vector<3>(0.0, 1.0, 0.0); };
  watch(encoders, 50, 51, 1.0, answered);
  // The same back, and then nothing.
  EXPECT_NEAR(encoders.force_at(60 * tick_ns), -asked, 1e-9);
  watch(encoders, 51, 75, 1.0, answered);
  EXPECT_FALSE(encoders.is_frozen());
}

// 200 replies a second: 25 take 125 ms, which is three questions.
TEST(EncoderWatch, AsksAgainUntilRepliesAreEnough) {
  EncoderWatch encoders;
  watch(encoders, 1, 2, 0.0, silent);
  const auto watch_slowly = [&](int from_ms, int to_ms) {
    for (int ms = from_ms; ms < to_ms; ++ms) encoders.update(silent(ms), ms % 5 == 0, 1.0, ms * tick_ns);
  };
  watch_slowly(2, 120);
  EXPECT_LT(encoders.force_at(119 * tick_ns), -0.5) << "the second time";
  watch_slowly(120, 200);
  EXPECT_FALSE(encoders.is_frozen());
  watch_slowly(200, 215);
  EXPECT_TRUE(encoders.is_frozen());
}

TEST(EncoderWatch, AnswersToTheSecondQuestionCount) {
  EncoderWatch encoders;
  watch(encoders, 1, 2, 0.0, silent);
  for (int ms = 2; ms < 3000; ++ms) {
    encoders.update(silent(ms) + Vector<3>(ms / 130, 0.0, 0.0), ms % 5 == 0, 1.0, ms * tick_ns);
  }
  EXPECT_FALSE(encoders.is_frozen());
}

// The link has trouble of its own: what has been asked is not answered yet.
TEST(EncoderWatch, WithoutRepliesNothingIsKnown) {
  EncoderWatch encoders;
  watch(encoders, 1, 2, 0.0, silent);
  for (int ms = 2; ms < 2000; ++ms) encoders.update(silent(ms), false, 1.0, ms * tick_ns);
  EXPECT_FALSE(encoders.is_frozen());
}

TEST(EncoderWatch, ForgetsWhenMotorsGoOff) {
  EncoderWatch encoders;
  watch(encoders, 1, 200, 1.0, silent);
  ASSERT_TRUE(encoders.is_frozen());
  encoders.reset();
  EXPECT_FALSE(encoders.is_frozen());
  EXPECT_FALSE(encoders.is_asking());
}

}  // namespace
}  // namespace ghostforce::encoder_watch_test
