// Which sentences are spoken: those that stand.
#include "app/cli/speech.h"

#include <gtest/gtest.h>

#include <vector>

namespace ghostforce::settled_sentence_test {
namespace {

constexpr double step_s = 0.1;

// What is taken while the sentence stands for so long.
std::vector<std::string> taken_while(SettledSentence& settled, const std::string& sentence, double lasts_s) {
  std::vector<std::string> taken;
  for (double time_s = 0.0; time_s < lasts_s; time_s += step_s) {
    if (auto words = settled.take(sentence, step_s)) taken.push_back(*words);
  }
  return taken;
}

using Sentences = std::vector<std::string>;

TEST(SettledSentence, IsTakenOnceWhenItHasStood) {
  SettledSentence settled;
  EXPECT_EQ(taken_while(settled, "one", 0.5), Sentences{});
  EXPECT_EQ(taken_while(settled, "one", 60.0), Sentences{"one"});
  EXPECT_EQ(taken_while(settled, "two", 2.0), Sentences{"two"});
  EXPECT_EQ(taken_while(settled, "one", 2.0), Sentences{"one"});
}

TEST(SettledSentence, OnTheWayIsNotTaken) {
  SettledSentence settled;
  EXPECT_EQ(taken_while(settled, "one", 2.0), Sentences{"one"});
  EXPECT_EQ(taken_while(settled, "on the way", 0.5), Sentences{});
  EXPECT_EQ(taken_while(settled, "two", 2.0), Sentences{"two"});
}

TEST(SettledSentence, ThatComesBackIsNotSaidAgain) {
  SettledSentence settled;
  EXPECT_EQ(taken_while(settled, "one", 2.0), Sentences{"one"});
  EXPECT_EQ(taken_while(settled, "a flicker", 0.3), Sentences{});
  EXPECT_EQ(taken_while(settled, "one", 2.0), Sentences{});
}

TEST(SettledSentence, RunningNumbersAreNeverTaken) {
  SettledSentence settled;
  for (int i = 0; i < 100; ++i) {
    EXPECT_FALSE(settled.take(std::to_string(i) + " mm off", step_s));
  }
}

}  // namespace
}  // namespace ghostforce::settled_sentence_test
