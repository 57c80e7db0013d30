// Which command a reply belongs to, when replies are lost, late or come twice.
#include "device/motors/reply_matcher.h"

#include <gtest/gtest.h>

#include <deque>
#include <random>

#include "tests/support/long_run.h"

namespace ghostforce::reply_matcher_test {
namespace {

constexpr std::int64_t ms = 1'000'000;

TEST(ReplyMatcher, OneReplyForOneCommand) {
  ReplyMatcher replies;
  EXPECT_TRUE(replies.may_send(0));
  EXPECT_FALSE(replies.replied(0)) << "nobody has asked";
  replies.sent(10);
  EXPECT_TRUE(replies.is_waiting());
  EXPECT_FALSE(replies.may_send(11));
  EXPECT_EQ(replies.replied(12), 10);
  EXPECT_TRUE(replies.may_send(12));
  EXPECT_FALSE(replies.replied(13)) << "one that comes twice is no news";
}

TEST(ReplyMatcher, AsksAgainInTimeAndNotForEver) {
  ReplyMatcher replies;
  replies.sent(0);
  EXPECT_FALSE(replies.may_ask_again(ReplyMatcher::patience_ns - 1));
  std::int64_t now = 0;
  for (std::size_t i = 0; i < ReplyMatcher::most_given_up; ++i) {
    now += ReplyMatcher::patience_ns;
    ASSERT_TRUE(replies.may_ask_again(now)) << i;
    replies.sent(now);
  }
  EXPECT_FALSE(replies.may_ask_again(now + 100 * ms));
}

// Lost: the reply to the second command is taken for that to the first, which makes it look older than it is. Then a
// pause shows that nothing more comes, and ages are right again. All that within the 20 ms that end the force.
TEST(ReplyMatcher, ALostReplyMakesNothingLookYounger) {
  ReplyMatcher replies;
  replies.sent(0);
  replies.sent(6 * ms);
  EXPECT_EQ(replies.replied(7 * ms), 0);
  ASSERT_TRUE(replies.may_send(7 * ms)) << "the newest is answered; it is too old a time to pause";
  replies.sent(7 * ms);
  EXPECT_EQ(replies.replied(8 * ms), 6 * ms);
  EXPECT_FALSE(replies.may_send(9 * ms)) << "the pause";
  const std::int64_t end = 8 * ms + ReplyMatcher::pause_ns;
  EXPECT_FALSE(replies.may_send(end - 1));
  EXPECT_TRUE(replies.may_send(end));
  EXPECT_LT(end + ms - 6 * ms, 20 * ms) << "the position that all go by meanwhile";
  replies.sent(end);
  EXPECT_EQ(replies.replied(end + ms), end);
}

TEST(ReplyMatcher, AReplyThatComesAfterAllEndsTheDoubt) {
  ReplyMatcher replies;
  replies.sent(0);
  replies.sent(6 * ms);
  EXPECT_EQ(replies.replied(7 * ms), 0);       // late
  EXPECT_EQ(replies.replied(8 * ms), 6 * ms);  // and the one to the second
  EXPECT_TRUE(replies.may_send(8 * ms));
  replies.sent(8 * ms);
  EXPECT_EQ(replies.replied(9 * ms), 8 * ms);
}

// A device that answers late, loses, and does both, for a long time: no reply ever looks younger than it is, as long as
// it is not later than the pause is long.
TEST(ReplyMatcher, NoReplyEverLooksYoungerThanItIs) {
  for (int seed = 1; seed <= trials(200); ++seed) {
    std::mt19937_64 random(static_cast<std::uint64_t>(seed));
    struct Reply {
      std::int64_t at;
      std::int64_t asked;
    };
    std::deque<Reply> on_the_way;
    ReplyMatcher replies;
    std::int64_t delay = ms;
    int matched = 0;
    std::int64_t heard = 0;
    for (std::int64_t now = 0; now < 20'000 * ms; now += ms / 4) {
      if (random() % 400 == 0) delay = static_cast<std::int64_t>(random() % 11) * ms;
      while (!on_the_way.empty() && on_the_way.front().at <= now) {
        const std::int64_t truly = on_the_way.front().asked;
        on_the_way.pop_front();
        heard = now;
        const auto asked = replies.replied(now);
        if (!asked) continue;
        ++matched;
        ASSERT_LE(*asked, truly) << "seed " << seed << " at " << now / ms << " ms";
      }
      if (replies.is_waiting() && now - heard >= 40 * ms) {  // the driver gives up, and throws away what still comes
        replies.reset();
        on_the_way.clear();
      }
      if (!replies.may_send(now) && !replies.may_ask_again(now)) continue;
      replies.sent(now);
      if (random() % 50 == 0) continue;  // lost
      const std::int64_t at = now + delay;
      on_the_way.push_back({on_the_way.empty() ? at : std::max(at, on_the_way.back().at), now});
    }
    EXPECT_GT(matched, 100) << seed;
  }
}

}  // namespace
}  // namespace ghostforce::reply_matcher_test
