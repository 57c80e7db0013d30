#include "app/files/run_reader.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "app/console/failure.h"
#include "app/files/scene_file.h"
#include "app/runs/run_hand.h"
#include "core/play.h"
#include "ghostforce_version.h"
#include "tests/support/scene_values.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce {
namespace {

std::string text_of(const fmt::memory_buffer& buffer) {
  return {buffer.data(), buffer.size()};
}

// Short enough to be cut at every byte: ticks of a scripted hand, a change of two settings, a reset, a gap.
std::string recording() {
  Scene scene = load_scene("fig3-normal");
  scene.duration = 0.008;
  fmt::memory_buffer rows;
  Settings known = scene.settings;
  std::int64_t k = 0;
  play(scene, last_tick(scene), [&](const Snapshot& snapshot) {
    if (k == 3) {
      Settings wanted = known;
      wanted.impedances.k_r = 812.5;
      wanted.wall_point = {0.001, -0.002};
      append_set_lines(rows, snapshot.time_s, known, wanted);
    }
    if (k == 5) append_state_line(rows, snapshot.time_s, {{Vector<2>(0.1, -0.2), {}, {}}, {1.5, 0.0, 0.0}});
    if (k == 7) rows.append(std::string_view("# dropped 12\n"));
    for (const Strategy& strategy : strategy_catalog()) {
      append_run_row(rows, snapshot, strategy.id);
      rows.append(std::string_view(",0,given,simulated,0,0,0,0.001\n"));
    }
    ++k;
  });
  rows.append(std::string_view("# interrupted\n"));
  return run_header(scene, recording_columns) + text_of(rows);
}

bool has_remark(const Run& run, std::string_view words) {
  return std::ranges::any_of(run.remarks,
                             [&](const std::string& remark) { return remark.find(words) != std::string::npos; });
}

std::string listed_remarks(const Run& run) {
  std::string all;
  for (const std::string& remark : run.remarks) all += remark + "\n";
  return all;
}

bool operator==(const RunRow& a, const RunRow& b) {
  return a.device == b.device && a.proxy == b.proxy && a.force == b.force;
}

// Whether each row of `part` stands in `whole` too, with the same goal and settings.
testing::AssertionResult invents_nothing(const Run& part, const Run& whole) {
  for (const RunTick& tick : part.ticks) {
    const auto same = std::ranges::find(whole.ticks, tick.time_s, &RunTick::time_s);
    if (same == whole.ticks.end()) return testing::AssertionFailure() << "no tick at " << tick.time_s;
    if (tick.goal != same->goal) return testing::AssertionFailure() << "another goal at " << tick.time_s;
    for (std::size_t s = 0; s < strategy_count; ++s) {
      if (tick.rows[s] && !(same->rows[s] && *tick.rows[s] == *same->rows[s])) {
        return testing::AssertionFailure() << "another row at " << tick.time_s;
      }
    }
    if (part.scene && part.settings[tick.settings] != whole.settings[same->settings]) {
      return testing::AssertionFailure() << "other settings at " << tick.time_s;
    }
  }
  return testing::AssertionSuccess();
}

std::string replaced(std::string text, std::string_view what, std::string_view by) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), by);
}

TEST(RunReader, ReadsARecordingBack) {
  const auto run = read_run(recording(), "run.csv");
  EXPECT_EQ(run.version, version);
  ASSERT_TRUE(run.scene);
  ASSERT_EQ(run.ticks.size(), 9U);
  ASSERT_EQ(run.settings.size(), 2U) << "two keys that change at once are one change";
  EXPECT_EQ(run.settings[1].impedances.k_r, 812.5);
  EXPECT_EQ(run.settings[1].wall_point, Vector<2>(0.001, -0.002));
  for (std::size_t k = 0; k < run.ticks.size(); ++k) {
    const RunTick& tick = run.ticks[k];
    EXPECT_EQ(tick.tick, static_cast<std::int64_t>(k));
    EXPECT_EQ(tick.settings, k < 3 ? 0U : 1U);
    EXPECT_EQ(tick.state, k == 5 ? 0U : RunTick::none);
    EXPECT_TRUE(tick.is_sure);
    EXPECT_FALSE(tick.measured);
    for (const auto& row : tick.rows) EXPECT_TRUE(row);
  }
  EXPECT_EQ(run.states.at(0).velocity[0], Vector<2>(0.1, -0.2));
  EXPECT_EQ(run.states.at(0).energy[0], 1.5);
  EXPECT_EQ(run.dropped, 12U);
  EXPECT_TRUE(run.is_interrupted);
  EXPECT_EQ(run.remarks.size(), 1U) << listed_remarks(run);
  EXPECT_TRUE(has_remark(run, "12 samples were lost"));
}

TEST(RunReader, ReadsBackBitForBitWhatSimulateWrites) {
  const Scene scene = load_scene("fig3-normal");
  fmt::memory_buffer rows;
  std::vector<Snapshot> snapshots;
  play(scene, 700, [&](const Snapshot& snapshot) {
    snapshots.push_back(snapshot);
    append_run_row(rows, snapshot, StrategyId::naive);
    rows.push_back('\n');
  });
  const auto run = read_run(run_header(scene) + text_of(rows), "run.csv");
  EXPECT_EQ(listed_remarks(run), "");
  ASSERT_TRUE(run.scene);
  EXPECT_EQ(scene_values(*run.scene), scene_values(scene));
  ASSERT_EQ(run.ticks.size(), snapshots.size());
  for (std::size_t i = 0; i < snapshots.size(); ++i) {
    const StrategySnapshot<2>& wanted = snapshots[i].strategies[index_of(StrategyId::naive)];
    const RunTick& tick = run.ticks[i];
    ASSERT_EQ(tick.tick, snapshots[i].tick);
    ASSERT_EQ(tick.time_s, snapshots[i].time_s);
    ASSERT_EQ(tick.goal, snapshots[i].goal);
    ASSERT_FALSE(tick.rows[index_of(StrategyId::full)]);
    ASSERT_TRUE(tick.rows[index_of(StrategyId::naive)]);
    ASSERT_TRUE((*tick.rows[index_of(StrategyId::naive)] == RunRow{wanted.device, wanted.proxy, wanted.force}));
  }
}

TEST(RunReader, InventsNothingWhereverTheFileIsCut) {
  const std::string text = recording();
  const auto whole = read_run(text, "run.csv");
  std::size_t ticks_before = 0;
  for (std::size_t length = 0; length < text.size(); ++length) {
    SCOPED_TRACE(length);
    try {
      const auto run = read_run(std::string_view(text).substr(0, length), "run.csv");
      ASSERT_TRUE(invents_nothing(run, whole));
      ASSERT_GE(run.ticks.size(), ticks_before);
      ticks_before = run.ticks.size();
      ASSERT_EQ(has_remark(run, "its last line is cut"), text[length - 1] != '\n') << listed_remarks(run);
    } catch (const Failure& failure) {
      ASSERT_EQ(failure.code(), ExitCode::wrong_call);
      ASSERT_LT(length, text.find("# scene:")) << failure.what();
    }
  }
  EXPECT_EQ(ticks_before, whole.ticks.size());
}

TEST(RunReader, SurvivesTenThousandMutations) {
  const std::string text = recording();
  std::mt19937 random(5);
  const auto below = [&](std::size_t end) { return std::uniform_int_distribution<std::size_t>(0, end - 1)(random); };
  int read = 0;
  for (int i = 0; i < 10'000; ++i) {
    // Most of them among the rows: those are quick to read.
    const std::size_t begin = i % 10 == 0 ? 0 : text.find("\nfull,");
    std::string mutated = text;
    for (std::size_t change = 1 + below(3); change > 0; --change) {
      const std::size_t at = begin + below(mutated.size() - begin);
      constexpr std::string_view odd = "0123456789.,-+en\n\r#\0\xFF ainf";
      switch (below(4)) {
        case 0:
          mutated[at] = odd[below(odd.size())];
          break;
        case 1:
          mutated.erase(at, 1 + below(40));
          break;
        case 2:
          mutated.insert(at, mutated.substr(begin + below(mutated.size() - begin), below(80)));
          break;
        default:
          mutated[at] = static_cast<char>(random());
      }
    }
    try {
      const auto run = read_run(mutated, "run.csv");
      ++read;
      for (const RunTick& tick : run.ticks) {
        ASSERT_TRUE(std::isfinite(tick.time_s) && std::isfinite(tick.goal.x) && std::isfinite(tick.goal.y));
        ASSERT_TRUE(!run.scene || tick.settings < run.settings.size());
        ASSERT_TRUE(tick.state == RunTick::none || tick.state < run.states.size());
        ASSERT_TRUE(std::ranges::any_of(tick.rows, [](const auto& row) { return row.has_value(); }));
        for (const auto& row : tick.rows) {
          ASSERT_TRUE(!row || (std::isfinite(row->device.x) && std::isfinite(row->force.y)));
        }
      }
      if (run.scene && !run.ticks.empty()) {
        const GoalPath path = goal_path_of(run);
        ASSERT_TRUE(std::ranges::is_sorted(path.times, std::less_equal<>()));
      }
    } catch (const Failure& failure) {
      ASSERT_EQ(failure.code(), ExitCode::wrong_call) << failure.what();
    }
  }
  EXPECT_GT(read, 9'000);
}

TEST(RunReader, LeavesOutDamagedLinesOneByOne) {
  const std::string text = recording();
  const auto whole = read_run(text, "run.csv");
  struct Case {
    std::string_view what;
    std::string_view by;
    std::string_view remark;
    std::size_t rows_lost;
  };
  for (const Case& c : {
           Case{"naive,0.002,", "naive,0.002,,", "1 line is damaged and left out: line", 1},
           Case{"naive,0.002,", "naive,nan,", "NaN or infinite) and is left out: line", 1},
           Case{"naive,0.002,", "naive,inf,", "NaN or infinite) and is left out: line", 1},
           Case{"naive,0.002,", "naive,0.0021,", "1 line is damaged", 1},
           Case{"naive,0.002,", "naive,-0.002,", "1 line is damaged", 1},
           Case{"naive,0.002,", "naive,1e300,", "1 line is damaged", 1},
           Case{"naive,0.002,", "naiv,0.002,", "1 line is damaged", 1},
           Case{"naive,0.002,", "naive,0.002x,", "1 line is damaged", 1},
           Case{"naive,0.002,", "naive,0.006,", "1 tick is out of order", 1},
           Case{"given,simulated", "given,real", "1 line is damaged", 1},
           Case{",0,given,simulated,", ",x,given,simulated,", "1 line is damaged", 1},
           Case{",0,given,simulated,", ",nan,given,simulated,", "NaN or infinite", 1},
           Case{",0,given,simulated,", ",2,given,simulated,", "1 line is damaged", 1},
           Case{"simulated,0,0,0,0.001", "simulated,nan,0,0,0.001", "NaN or infinite", 1},
           Case{"simulated,0,0,0,0.001", "simulated,0,,0,0.001", "1 line is damaged", 1},
           Case{"simulated,0,0,0,0.001", "simulated,0,0,0.5,0.001", "1 line is damaged", 1},
           Case{"simulated,0,0,0,0.001", "simulated,0,0,0,-inf", "NaN or infinite", 1},
           Case{"simulated,0,0,0,0.001", "simulated,0,0,0,soon", "1 line is damaged", 1},
           Case{"\nnaive,0.002,", ",naive,0.002,", "1 line is damaged", 2},
           Case{"naive,0.002,", "# naive,0.002,", "1 comment is not understood", 1},
       }) {
    SCOPED_TRACE(c.by);
    const auto run = read_run(replaced(text, c.what, c.by), "run.csv");
    EXPECT_TRUE(has_remark(run, c.remark)) << listed_remarks(run);
    EXPECT_TRUE(invents_nothing(run, whole));
    std::size_t rows = 0;
    for (const RunTick& tick : run.ticks) {
      for (const auto& row : tick.rows) rows += row ? 1U : 0U;
    }
    EXPECT_EQ(rows, 27 - c.rows_lost);
    EXPECT_EQ(run.ticks.size(), 9U);
  }
  const std::string twice = replaced(replaced(text, "naive,0.002,", "naive,,"), "full,0.006,", "full,x,");
  const auto line =
      1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(text.find("naive,0.002")), '\n');
  EXPECT_TRUE(has_remark(read_run(twice, "run.csv"),
                         "run.csv: 2 lines are damaged and left out, the first is line " + std::to_string(line)));
}

TEST(RunReader, IsNotSureAfterADamagedChangeOrJump) {
  const std::string text = recording();
  for (const std::string_view by :
       {"# set t_s=x rendering.k_r", "# set t_s=0.003 rendering.k_x", "# set t_s=0.003 title"}) {
    const auto run = read_run(replaced(text, "# set t_s=0.003 rendering.k_r_N_per_m", by), "run.csv");
    EXPECT_TRUE(has_remark(run, "1 change of a setting cannot be read")) << listed_remarks(run);
    EXPECT_TRUE(run.ticks.at(2).is_sure);
    EXPECT_FALSE(run.ticks.at(3).is_sure);
    EXPECT_FALSE(run.ticks.at(8).is_sure);
    EXPECT_EQ(run.settings.size(), 2U) << "the other change holds";
  }
  const auto run = read_run(replaced(text, "# state t_s=0.005 full=0.1", "# state t_s=0.005 full=nan"), "run.csv");
  EXPECT_TRUE(has_remark(run, "1 line about a jump cannot be read"));
  EXPECT_TRUE(run.ticks.at(4).is_sure);
  EXPECT_FALSE(run.ticks.at(5).is_sure);
}

std::string words_of_refusal(const std::string& text) {
  try {
    const Run run = read_run(text, "run.csv");
    goal_path_of(run, 1000.0);
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.code(), ExitCode::wrong_call);
    return failure.what();
  }
  return "";
}

// What is made of a run has every tick up to its last, so one damaged time is work without end.
TEST(RunReader, RefusesWhatADamagedTimeMakesTooLong) {
  std::string text = recording();
  text.erase(text.find("# interrupted"));
  const std::string last = replaced(text, "anisotropic,0.008,", "anisotropic,3e7,");
  const std::string line = std::to_string(std::count(text.begin(), text.end(), '\n'));
  const std::string words = words_of_refusal(last);
  EXPECT_TRUE(words.starts_with("run.csv: line " + line + ": with t_s = 30000000 there")) << words;
  // In the midst others go on without it; after a jump they do not.
  EXPECT_EQ(words_of_refusal(replaced(text, "naive,0.002,", "naive,3e7,")), "");
  EXPECT_NE(words_of_refusal(replaced(text, "\nfull,0.005,", "\nfull,3e7,")), "");
  // A recording begins when it likes, and is as long as its rows say.
  std::string rows = text.substr(0, text.find("\nfull,0,") + 1);
  const std::string row = ",0,0,0,0,0,0,0,0,0,given,simulated,0,0,0,0.001\n";
  EXPECT_EQ(words_of_refusal(rows + "full,90000" + row + "full,100000" + row), "") << "1e7 ticks";
  EXPECT_NE(words_of_refusal(rows + "full,90000" + row + "full,100000.001" + row), "") << "one more";
  EXPECT_EQ(words_of_refusal(rows + "full,90000" + row + "full,3" + row + "full,10003" + row), "") << "reset";
  rows += "full,90000" + row;
  EXPECT_EQ(words_of_refusal(rows + "# set t_s=1 device.rate_hz=10\nfull,1000000" + row), "");
  EXPECT_NE(words_of_refusal(rows + "# set t_s=1 device.rate_hz=10\nfull,100000" + row + "full,1100001" + row), "");
  // Without a scene it depends on the loop that plays it.
  const std::string bare = std::string(run_columns) + "\nfull,5,0,0,0,0,0,0,0,0\nfull,";
  EXPECT_EQ(words_of_refusal(bare + "10005,0,0,0,0,0,0,0,0\n"), "");
  EXPECT_TRUE(words_of_refusal(bare + "10006,0,0,0,0,0,0,0,0\n").starts_with("run.csv: line 3: with t_s = 10006"));
}

TEST(RunReader, TakesWhatOtherProgramsMakeOfTheFile) {
  const std::string text = recording();
  std::string windows = "\xEF\xBB\xBF";
  for (const char c : text) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  const auto whole = read_run(text, "run.csv");
  const auto run = read_run(windows, "run.csv");
  EXPECT_TRUE(invents_nothing(run, whole));
  EXPECT_EQ(run.ticks.size(), whole.ticks.size());
  EXPECT_EQ(run.remarks, whole.remarks);

  const auto moved = read_run(
      "note,force_y_N,force_x_N,strategy,t_s,goal_x_m,goal_y_m,device_x_m,device_y_m,proxy_x_m,proxy_y_m\n"
      "hello,1,2,full,0,3,4,5,6,7,8\n",
      "run.csv");
  EXPECT_FALSE(moved.scene);
  EXPECT_TRUE(has_remark(moved, "the scene is not told"));
  ASSERT_EQ(moved.ticks.size(), 1U);
  EXPECT_EQ(moved.ticks[0].goal, Vector<2>(3.0, 4.0));
  EXPECT_EQ(moved.ticks[0].rows[0]->force, Vector<2>(2.0, 1.0));
  EXPECT_EQ(goal_path_of(moved).points, std::vector{Vector<2>(3.0, 4.0)});
}

TEST(RunReader, SaysWhatItCannotKnow) {
  const std::string text = recording();
  EXPECT_TRUE(has_remark(read_run(replaced(text, "# ghostforce " + std::string(version), "# ghostforce 99.1"), "f"),
                         "written by version 99.1"));
  const auto no_scene = read_run(replaced(text, "k_r_N_per_m = ", "k_s_N_per_m = "), "f");
  EXPECT_TRUE(has_remark(no_scene, "the scene in it cannot be read"));
  EXPECT_EQ(no_scene.ticks.size(), 9U);
  EXPECT_TRUE(no_scene.settings.empty());
  const auto no_names = read_run(replaced(text, "\nstrategy,t_s", "\nstr?tegy,t?s"), "f");
  EXPECT_TRUE(has_remark(no_names, "the line of column names is damaged"));
  EXPECT_EQ(no_names.ticks.size(), 9U);
}

TEST(RunReader, KnowsAMeasuredDevice) {
  std::string text = recording();
  const std::size_t row = text.find("anisotropic,0.002,");
  const std::size_t kinds = text.find("given,simulated", row);
  text.replace(kinds, 21, "estimated,measured,-1.5,0.25,1");
  const auto run = read_run(text, "f");
  EXPECT_EQ(run.ticks.at(2).measured, StrategyId::anisotropic);
  EXPECT_FALSE(run.ticks.at(3).measured);
  const RunRow& measured = *run.ticks.at(2).rows[index_of(StrategyId::anisotropic)];
  EXPECT_EQ(measured.sent, Vector<2>(-1.5, 0.25));
  EXPECT_TRUE(measured.is_saturated);
  const RunRow& simulated = *run.ticks.at(2).rows[index_of(StrategyId::naive)];
  EXPECT_EQ(simulated.sent, std::nullopt) << "it has no motors";
  EXPECT_FALSE(simulated.is_saturated);
}

TEST(RunReader, RefusesWhatIsNoRun) {
  for (const std::string_view text : {"", "\n", "hello", "a,b,c\n1,2,3\n", "# ghostforce", "strategy,t_s\nfull,0\n"}) {
    try {
      read_run(text, "f.csv");
      ADD_FAILURE() << "'" << text << "' was read";
    } catch (const Failure& failure) {
      EXPECT_EQ(failure.code(), ExitCode::wrong_call);
      EXPECT_TRUE(std::string_view(failure.what()).starts_with("f.csv: ")) << failure.what();
    }
  }
}

TEST(RunReader, LoadsFilesInPieces) {
  const TemporaryFolder folder;
  Scene scene = load_scene("fig3-normal");
  fmt::memory_buffer rows;
  play(scene, last_tick(scene), [&](const Snapshot& snapshot) {
    for (const Strategy& strategy : strategy_catalog()) {
      append_run_row(rows, snapshot, strategy.id);
      rows.push_back('\n');
    }
  });
  const std::string text = run_header(scene) + text_of(rows);
  ASSERT_GT(text.size(), std::size_t{1} << 20);
  write_whole(folder / "run.csv", text);
  const auto run = load_run(folder / "run.csv");
  EXPECT_TRUE(run.remarks.empty()) << listed_remarks(run);
  EXPECT_EQ(run.ticks.size(), 3001U);
  EXPECT_TRUE(invents_nothing(run, read_run(text, "run.csv")));

  const auto code_of = [](const std::string& path) {
    try {
      load_run(path);
    } catch (const Failure& failure) {
      return failure.code();
    }
    return ExitCode::done;
  };
  EXPECT_EQ(code_of(folder.path()), ExitCode::wrong_call);
  EXPECT_EQ(code_of(folder / "none.csv"), ExitCode::wrong_call);
  EXPECT_EQ(code_of("/dev/zero"), ExitCode::wrong_call);
}

TEST(RunReader, TheHandOfARunIsItsGoalAtEachTickBitForBit) {
  const Scene scene = load_scene("fig1");
  fmt::memory_buffer rows;
  std::vector<Vector<2>> goals;
  const auto write = [&](const Snapshot& snapshot) {
    append_run_row(rows, snapshot, StrategyId::full);
    rows.push_back('\n');
  };
  play(scene, 900, [&](const Snapshot& snapshot) {
    if (snapshot.tick < 100) return;  // recorded in mid-motion
    goals.push_back(snapshot.goal);
    write(snapshot);
  });
  append_state_line(rows, 0.0, {});
  play(scene, 10, write);  // reset
  const auto run = read_run(run_header(scene) + text_of(rows), "f");
  const GoalPath path = goal_path_of(run);
  ASSERT_EQ(path.points.size(), goals.size());
  for (std::size_t k = 0; k < goals.size(); ++k) {
    ASSERT_EQ(goal_at(path, time_of(static_cast<std::int64_t>(k), scene.settings.rate)), goals[k]) << k;
  }
}

}  // namespace
}  // namespace ghostforce
