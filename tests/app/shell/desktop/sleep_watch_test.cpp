// Delaying sleep, against a bus and a logind of the test's own.
#include "app/shell/desktop/sleep_watch.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/support/becomes.h"
#include "tests/support/fake_logind.h"

namespace ghostforce::sleep_watch_test {
namespace {

class SleepWatchTest : public testing::Test {
 protected:
  SleepWatchTest() { setenv("DBUS_SYSTEM_BUS_ADDRESS", logind_.address().c_str(), 1); }

  bool comes_to(const std::function<bool()>& as_wanted) { return logind_.comes_to(as_wanted); }
  // Until everything has been answered that was asked before.
  void settle() {
    for (int step = 0; step < 50; ++step) {
      logind_.step();
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
  }

  FakeLogind logind_;
};

TEST_F(SleepWatchTest, HoldsALockWhileThatIsWanted) {
  SleepWatch watch;
  settle();
  EXPECT_TRUE(logind_.locks.empty()) << "nobody wants one";
  watch.delay(true);
  EXPECT_TRUE(comes_to([&] { return logind_.is_delayed(); }));
  EXPECT_EQ(logind_.locks, std::vector<std::string>{"sleep|ghostforce|Turning the motors off|delay"});
  watch.delay(false);
  EXPECT_TRUE(comes_to([&] { return !logind_.is_delayed(); }));
  EXPECT_FALSE(watch.is_coming());
}

TEST_F(SleepWatchTest, SaysThatSleepIsComingAndKeepsItBackUntilItIsLet) {
  SleepWatch watch;
  watch.delay(true);
  ASSERT_TRUE(comes_to([&] { return logind_.is_delayed(); }));
  logind_.prepare_for_sleep(true);
  EXPECT_TRUE(comes_to([&] { return watch.is_coming(); }));
  EXPECT_TRUE(logind_.is_delayed());
  watch.delay(false);
  EXPECT_TRUE(comes_to([&] { return !logind_.is_delayed(); }));
  watch.delay(true);
  settle();
  EXPECT_EQ(logind_.locks.size(), 1U) << "logind gives none while the computer is on its way";
  logind_.prepare_for_sleep(false);
  EXPECT_TRUE(comes_to([&] { return logind_.is_delayed(); })) << "awake, it takes the next";
  EXPECT_FALSE(watch.is_coming());
  EXPECT_EQ(logind_.locks.size(), 2U);
}

TEST_F(SleepWatchTest, GivesTheLockBackWhenItEnds) {
  {
    SleepWatch watch;
    watch.delay(true);
    ASSERT_TRUE(comes_to([&] { return logind_.is_delayed(); }));
  }
  EXPECT_TRUE(comes_to([&] { return !logind_.is_delayed(); }));
}

TEST_F(SleepWatchTest, ARefusalStandsUntilTheComputerHasSlept) {
  logind_.refuses = true;
  SleepWatch watch;
  watch.delay(true);
  EXPECT_TRUE(comes_to([&] { return !logind_.locks.empty(); }));
  settle();
  EXPECT_EQ(logind_.locks.size(), 1U) << "it does not ask again and again";
  EXPECT_FALSE(logind_.is_delayed());
  logind_.refuses = false;
  logind_.prepare_for_sleep(true);
  EXPECT_TRUE(comes_to([&] { return watch.is_coming(); })) << "it hears of sleep all the same";
  logind_.prepare_for_sleep(false);
  EXPECT_TRUE(comes_to([&] { return logind_.is_delayed(); }));
}

TEST_F(SleepWatchTest, SleepIsNotComingWhenTheBusHasEnded) {
  SleepWatch watch;
  watch.delay(true);
  ASSERT_TRUE(comes_to([&] { return logind_.is_delayed(); }));
  logind_.prepare_for_sleep(true);
  ASSERT_TRUE(comes_to([&] { return watch.is_coming(); }));
  logind_.end_bus();
  EXPECT_TRUE(becomes([&] { return !watch.is_coming(); }));
  EXPECT_FALSE(logind_.is_delayed());
}

TEST_F(SleepWatchTest, FindsABusThatHasBegunAgain) {
  SleepWatch watch;
  watch.delay(true);
  ASSERT_TRUE(comes_to([&] { return logind_.is_delayed(); }));
  logind_.end_bus();
  EXPECT_TRUE(becomes([&] { return !logind_.is_delayed(); }));
  logind_.begin_bus();
  watch.delay(false);  // whoever wants something else is a reason to look at once
  watch.delay(true);
  EXPECT_TRUE(comes_to([&] { return logind_.is_delayed(); }));
}

TEST(SleepWatchWithoutABus, DelaysNothing) {
  setenv("DBUS_SYSTEM_BUS_ADDRESS", "unix:path=/nonexistent/socket", 1);
  SleepWatch watch;
  watch.delay(true);
  EXPECT_FALSE(watch.is_coming());
}

}  // namespace
}  // namespace ghostforce::sleep_watch_test
