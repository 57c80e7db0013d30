// A sampled loop that runs away ends each command that follows it in the same way: it says which strategy did, when and
// what helps, with exit code 2, and leaves no file. What went to a pipe until then is whole rows of finite numbers.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/files/run_reader.h"
#include "core/divergence.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::unstable_loop_test {
namespace {

// So few ticks a second that every step overshoots.
const std::vector<std::string> too_slow{"--set", "device.rate_hz=20"};
// The anisotropic device alone runs away, after some two seconds.
const std::vector<std::string> too_slow_for_one{"--set", "device.rate_hz=34"};

class UnstableLoop : public testing::Test {
 protected:
  static Outcome run(std::vector<std::string> words, const std::vector<std::string>& more = {}) {
    words.insert(words.end(), more.begin(), more.end());
    return run_ghostforce(words);
  }

  // What was written until the naive device ran away.
  std::string rows() {
    const Outcome outcome = run({"simulate", "wall45", "--strategy", "naive"}, too_slow);
    expect_refused(outcome);
    return outcome.out;
  }

  // Such a run as it might come from elsewhere: it goes on, with numbers that mean nothing.
  std::string run_that_goes_on() {
    std::string text = rows();
    const double last_s = parse(text).ticks.back().time_s;
    for (int tick = 1; tick <= 5; ++tick) {
      text += "naive," + std::to_string(last_s + 0.05 * tick) + ",0.06,-0.06,-1e13,1e13,-1e13,1e13,0,0\n";
    }
    write_whole(folder_ / "run.csv", text);
    return folder_ / "run.csv";
  }

  ghostforce::Run parse(const std::string& text) {
    write_whole(folder_ / "part.csv", text);
    ghostforce::Run run = load_run(folder_ / "part.csv");
    remove((folder_ / "part.csv").c_str());
    return run;
  }

  // `strategy`: the one that runs away first of those that are played.
  static void expect_refused(const Outcome& outcome, const std::string& strategy = "naive",
                             const std::string& run = "") {
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    const std::string words =
        run + "the sampled loop is unstable with these settings: the " + strategy + " device has run away by t = ";
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("lower rendering.k_r_N_per_m"), std::string::npos) << outcome.err;
  }

  TemporaryFolder folder_;
};

TEST_F(UnstableLoop, EndsSimulateAfterWholeFiniteRows) {
  const ghostforce::Run run = parse(rows());  // a number that is not finite would be refused
  ASSERT_GT(run.ticks.size(), 10U);
  for (const RunTick& tick : run.ticks) {
    const RunRow& row = tick.rows[index_of(StrategyId::naive)].value();
    EXPECT_TRUE(is_near(row.device) && is_near(row.proxy)) << tick.time_s;
  }
}

// Far out already, though each of its numbers can still be read.
TEST_F(UnstableLoop, EndsSimulateSoon) {
  expect_refused(run({"simulate", "wall45", "--strategy", "naive", "--set", "goal.duration_s=1.1"}, too_slow));
}

TEST_F(UnstableLoop, LeavesNoFile) {
  expect_refused(run({"simulate", "wall45", "--strategy", "naive", "-o", folder_ / "run.csv"}, too_slow));
  EXPECT_EQ(folder_.count(), 0);
}

TEST_F(UnstableLoop, EndsReplay) {
  const std::string path = run_that_goes_on();
  expect_refused(run({"replay", path, "-o", folder_ / "again.csv"}), "naive", "run.csv: ");
  expect_refused(run({"replay", path, "wall45", "-o", folder_ / "again.csv"}, too_slow), "anisotropic");
  EXPECT_EQ(folder_.count(), 1);
}

// The run is no worse for a device that it does not have.
TEST_F(UnstableLoop, OfADeviceThatTheRunDoesNotHaveEndsItsRowsAlone) {
  const std::string path = folder_ / "full.csv";
  const Outcome simulated = run({"simulate", "wall45", "--strategy", "full", "-o", path}, too_slow_for_one);
  ASSERT_EQ(simulated.exit_code, 0) << simulated.err;
  const Outcome replayed = run({"replay", path});
  EXPECT_EQ(replayed.exit_code, 0) << replayed.err;
  EXPECT_NE(replayed.err.find("the anisotropic device, of which the run has no rows there, has run away by t = 2."),
            std::string::npos)
      << replayed.err;
  const ghostforce::Run again = parse(replayed.out);
  EXPECT_TRUE(again.ticks.front().rows[index_of(StrategyId::anisotropic)]);
  EXPECT_FALSE(again.ticks.back().rows[index_of(StrategyId::anisotropic)]);
  EXPECT_TRUE(again.ticks.back().rows[index_of(StrategyId::full)]);
}

TEST_F(UnstableLoop, EndsMeasureUser) {
  expect_refused(run({"measure-user", run_that_goes_on()}), "naive", "run.csv: ");
}

TEST_F(UnstableLoop, EndsRender) {
  expect_refused(run({"render", "wall45", "--strategy", "naive", "-o", folder_ / "picture.png"}, too_slow));
  expect_refused(run({"render", "wall45", "--strategy", "full", "-o", folder_ / "picture.png"}, too_slow_for_one),
                 "anisotropic");
  EXPECT_EQ(folder_.count(), 0);
}

// Where it is stable is what a sweep maps.
TEST_F(UnstableLoop, IsNotSettledInASweep) {
  const Outcome outcome = run({"sweep", "wall45", "--over", "device.rate_hz=20:1000:2", "--at-rest", "simulated"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("\n20,naive,"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.err.find(" of the rows, settled is 0"), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.out.find("inf"), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.out.find("nan"), std::string::npos) << outcome.out;
}

}  // namespace
}  // namespace ghostforce::unstable_loop_test
