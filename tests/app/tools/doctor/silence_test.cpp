// Where a handle was after a silence tells whether the force was still there, or nothing.
#include "app/tools/doctor/motors.h"

#include <vector>

#include <gtest/gtest.h>

namespace ghostforce::silence_test {
namespace {

SilenceReading reading(double silence_s, double share, double tremor = 0.0001) {
  return {.silence_s = silence_s, .held = 0.004, .after = share * 0.004, .tremor = tremor};
}

TEST(Silence, ForceThatStays) {
  const std::vector<SilenceReading> readings{reading(0.02, 1.0), reading(0.5, 0.97), reading(1.0, 1.02)};
  const SilenceVerdict verdict = judge_silences(readings);
  EXPECT_EQ(verdict.outcome, SilenceOutcome::stays);
  EXPECT_EQ(verdict.still_there_s, 1.0);
}

TEST(Silence, ForceThatDrops) {
  // On its way back after 0.1 s: neither there nor gone.
  const std::vector<SilenceReading> readings{reading(0.2, 0.05), reading(0.02, 1.0), reading(0.05, 0.98),
                                             reading(0.1, 0.5)};
  const SilenceVerdict verdict = judge_silences(readings);
  EXPECT_EQ(verdict.outcome, SilenceOutcome::drops);
  EXPECT_EQ(verdict.still_there_s, 0.05);
  EXPECT_EQ(verdict.gone_s, 0.2);
}

TEST(Silence, GuessesNothing) {
  EXPECT_EQ(judge_silences({}).outcome, SilenceOutcome::undecidable);
  const auto outcome = [](const std::vector<SilenceReading>& readings) { return judge_silences(readings).outcome; };
  EXPECT_EQ(outcome({reading(0.5, 1.0), reading(1.0, 0.5)}), SilenceOutcome::undecidable);
  EXPECT_EQ(outcome({reading(0.2, 0.0), reading(0.2, 1.0)}), SilenceOutcome::undecidable) << "they disagree";
  EXPECT_EQ(outcome({reading(0.2, 0.0), reading(0.5, 1.0)}), SilenceOutcome::undecidable) << "back after longer";
  EXPECT_EQ(outcome({reading(1.0, 1.0, 0.003)}), SilenceOutcome::undecidable) << "a hand that trembles";
  SilenceReading firm = reading(1.0, 1.0);
  firm.held = firm.after = 0.0003;
  EXPECT_EQ(outcome({firm}), SilenceOutcome::undecidable) << "a hand that does not give way";
}

}  // namespace
}  // namespace ghostforce::silence_test
