// The whole program while the computer goes to sleep, which a logind of the test's own says.
#include <gtest/gtest.h>

#include <csignal>
#include <string>
#include <vector>

#include "tests/support/display.h"
#include "tests/support/fake_logind.h"
#include "tests/support/places.h"

namespace ghostforce::sleep_program_test {
namespace {

class SleepProgram : public testing::Test {
 protected:
  std::vector<std::string> environment() const {
    std::vector<std::string> all = display_.environment();
    all.push_back("DBUS_SYSTEM_BUS_ADDRESS=" + logind_.address());
    return all;
  }
  bool comes_to(const std::function<bool()>& as_wanted) { return logind_.comes_to(as_wanted); }

  Display display_{1024, 640};
  FakeLogind logind_;
};

TEST_F(SleepProgram, WithMotorsItDelaysSleepUntilTheyAreOff) {
  BackgroundProgram program({ghostforce_program(), "run", "--no-hints", "--input", "virtual-falcon"}, environment());
  for (std::size_t time = 1; time <= 2; ++time) {
    ASSERT_TRUE(comes_to([&] { return logind_.is_delayed(); }));
    EXPECT_EQ(logind_.locks.size(), time);
    logind_.prepare_for_sleep(true);
    EXPECT_TRUE(comes_to([&] { return !logind_.is_delayed(); }));
    logind_.prepare_for_sleep(false);
  }
  EXPECT_TRUE(comes_to([&] { return logind_.is_delayed(); }));
  EXPECT_EQ(program.end(SIGTERM), 130);
  EXPECT_FALSE(logind_.is_delayed());
}

TEST_F(SleepProgram, WithoutMotorsItDelaysNothing) {
  BackgroundProgram program({ghostforce_program(), "run", "--no-hints", "--exit-after", "0.5"}, environment());
  EXPECT_TRUE(comes_to([&] { return !program.is_running(); }));
  EXPECT_EQ(program.end(0), 0);
  EXPECT_TRUE(logind_.locks.empty());
}

}  // namespace
}  // namespace ghostforce::sleep_program_test
