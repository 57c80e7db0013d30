#include "app/files/run_reader.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "app/files/run.h"
#include "app/files/scene_file.h"
#include "app/runs/replay.h"
#include "core/simulate.h"
#include "ghostforce_version.h"
#include "tests/support/long_run.h"
#include "tests/support/scene_values.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::run_reader_test {
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
  simulate(scene, last_tick(scene), [&](const Snapshot& snapshot) {
    if (k == 3) {
      Settings wanted = known;
      wanted.stiffnesses.k_r = 812.5;
      wanted.wall_point = {0.001, -0.002};
      append_set_lines(rows, snapshot.time_s, known, wanted);
    }
    if (k == 5) append_state_line(rows, snapshot.time_s, {{Vector<2>(0.1, -0.2), {}, {}}, {1.5, 0.0, 0.0}});
    if (k == 7) rows.append(std::string_view("# dropped 12\n"));
    for (const Strategy& strategy : strategy_catalog()) {
      append_run_row(rows, snapshot, strategy.id);
      rows.append(std::string_view(",0,given,simulated,0,0,0,0.001,0,0\n"));
    }
    ++k;
  });
  rows.append(std::string_view("# interrupted\n"));
  return run_header(scene, recording_columns) + text_of(rows);
}

bool has_warning(const Run& run, std::string_view words) {
  return std::ranges::any_of(run.warnings,
                             [&](const std::string& remark) { return remark.find(words) != std::string::npos; });
}

std::string listed_warnings(const Run& run) {
  std::string all;
  for (const std::string& warning : run.warnings) all += warning + "\n";
  return all;
}

bool operator==(const RunRow& a, const RunRow& b) {
  return a.device == b.device && a.proxy == b.proxy && a.force == b.force;
}

// Whether each row of `part` stands in `whole` too, with the same goal and settings.
testing::AssertionResult invents_nothing(const Run& part, const Run& whole) {
  for (const RunTick& tick : part.ticks) {
    const auto same = std::ranges::find(whole.ticks, tick.time_s, &RunTick::time_s);
    if (same == whole.ticks.end()) return testing::AssertionFailure() << "is not the time of a tick at " << tick.time_s;
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
  EXPECT_EQ(run.settings[1].stiffnesses.k_r, 812.5);
  EXPECT_EQ(run.settings[1].wall_point, Vector<2>(0.001, -0.002));
  for (std::size_t k = 0; k < run.ticks.size(); ++k) {
    const RunTick& tick = run.ticks[k];
    EXPECT_EQ(tick.tick, static_cast<std::int64_t>(k));
    EXPECT_EQ(tick.settings, k < 3 ? 0U : 1U);
    EXPECT_EQ(tick.state, k == 5 ? 0U : RunTick::none);
    EXPECT_FALSE(tick.measured);
    for (const auto& row : tick.rows) EXPECT_TRUE(row);
  }
  EXPECT_EQ(run.states.at(0).velocity[0], Vector<2>(0.1, -0.2));
  EXPECT_EQ(run.states.at(0).energy[0], 1.5);
  EXPECT_EQ(run.dropped, 12U);
  EXPECT_TRUE(run.is_interrupted);
  EXPECT_EQ(run.warnings.size(), 1U) << listed_warnings(run);
  EXPECT_TRUE(has_warning(run, "12 samples were lost"));
}

TEST(RunReader, ReadsBackBitForBitWhatSimulateWrites) {
  const Scene scene = load_scene("fig3-normal");
  fmt::memory_buffer rows;
  std::vector<Snapshot> snapshots;
  simulate(scene, 700, [&](const Snapshot& snapshot) {
    snapshots.push_back(snapshot);
    append_run_row(rows, snapshot, StrategyId::naive);
    rows.push_back('\n');
  });
  const auto run = read_run(run_header(scene) + text_of(rows), "run.csv");
  EXPECT_EQ(listed_warnings(run), "");
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
      ASSERT_EQ(has_warning(run, "its last line is cut"), text[length - 1] != '\n') << listed_warnings(run);
    } catch (const ReadError& error) {
      ASSERT_EQ(error.kind(), ReadError::Kind::wrong);
      ASSERT_LT(length, text.find("# scene:")) << error.what();
    }
  }
  EXPECT_EQ(ticks_before, whole.ticks.size());
}

TEST(RunReader, SurvivesTenThousandMutations) {
  const std::string text = recording();
  std::mt19937 random(5);
  const auto below = [&](std::size_t end) { return std::uniform_int_distribution<std::size_t>(0, end - 1)(random); };
  int read = 0;
  int refused = 0;
  for (int i = 0; i < trials(10'000); ++i) {
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
    } catch (const std::runtime_error& error) {
      ++refused;
      ASSERT_TRUE(std::string_view(error.what()).starts_with("run.csv:")) << error.what();
    }
  }
  EXPECT_GT(read, trials(500));
  EXPECT_GT(refused, trials(5'000));
}

std::string words_of_refusal(const std::string& text) {
  try {
    const Run run = read_run(text, "run.csv");
    goal_path_of(run, 1000.0);
  } catch (const ReadError& error) {
    EXPECT_EQ(error.kind(), ReadError::Kind::wrong);
    return error.what();
  }
  return "";
}

TEST(RunReader, TakesAnEstimatedGoalHoweverFarAway) {
  const std::string text = run_header(load_scene("fig3-normal"), recording_columns) +
                           "naive,0,10.1,0,0,0,0,0,0,0,1,estimated,measured,0,0,0,0.001,0,0\n";
  EXPECT_EQ(read_run(text, "run.csv").ticks.size(), 1U) << "a low belief puts it anywhere";
  EXPECT_THROW(read_run(replaced(text, "estimated", "given"), "run.csv"), ReadError);
}

TEST(RunReader, RefusesADamagedLineWithItsNumberAndWhatIsWrong) {
  const std::string text = recording();
  const std::string far_goal = "\nnaive,0.002,-1.6e13,0,0,0,0,0,0,0,1,given,simulated,0,0,0,0.001,0,0\nnaive,0.002,";
  const std::string long_change = "rendering.k_r_N_per_m=" + std::string(5000, ' ') + "812.5";
  struct Case {
    std::string_view what;
    std::string_view by;
    std::string_view words;
    int lines_after = 0;  // where it shows
  };
  for (const Case& c : {
           Case{"naive,0.002,", "naive,0.002,,", "the row has 20 values, but there are 19 columns"},
           Case{"naive,0.002,", "naive,nan,", "t_s is 'nan', which is not a finite number"},
           Case{"naive,0.002,", "naive,inf,", "t_s is 'inf', which is not a finite number"},
           Case{"naive,0.002,", "naive,0.0021,", "t_s = 0.0021 is not the time of a tick at 1000 Hz"},
           Case{"naive,0.002,", "naive,-0.002,", "t_s = -0.002 does not come after the 0.002 of line"},
           Case{"full,0,", "full,-0.002,", "t_s = -0.002 is not the time of a tick at 1000 Hz"},
           Case{"naive,0.002,", "naive,1e300,", "t_s = 1e+300 is not the time of a tick at 1000 Hz"},
           Case{"naive,0.002,", "naiv,0.002,", "strategy is 'naiv', which is not a strategy"},
           Case{"naive,0.002,", "naive,0.002x,", "t_s is '0.002x', which is not a finite number"},
           Case{"naive,0.002,", "naive,0.006,", "t_s = 0.002 does not come after the 0.006 of line", 1},
           Case{"naive,0.002,", "full,0.002,", "t_s = 0.002 does not come after the 0.002 of line"},
           Case{"naive,0.002,", "naive,0.002,1e-9,", "the row has 20 values"},
           Case{"\nnaive,0.002,", far_goal, "is '-1.6e13', which is farther away than 10 m"},
           Case{"given,simulated", "given,real", "device_kind is 'real', which is neither simulated nor measured"},
           Case{"given,simulated", "gone,simulated", "goal_kind is 'gone', which is neither given nor estimated"},
           Case{",0,given,simulated,", ",x,given,simulated,", "active is 'x', which is not a finite number"},
           Case{",0,given,simulated,", ",nan,given,simulated,", "active is 'nan', which is not a finite number"},
           Case{",0,given,simulated,", ",2,given,simulated,", "active is '2', which is neither 0 nor 1"},
           Case{"simulated,0,0,0,0.001", "simulated,nan,0,0,0.001", "sent_x_N is 'nan'"},
           Case{"simulated,0,0,0,0.001", "simulated,0,,0,0.001", "sent_y_N is '', which is not a finite number"},
           Case{"simulated,0,0,0,0.001", "simulated,0,0,0.5,0.001", "saturated is '0.5', which is neither 0 nor 1"},
           Case{"simulated,0,0,0,0.001", "simulated,0,0,0,-inf", "loop_s is '-inf'"},
           Case{"simulated,0,0,0,0.001", "simulated,0,0,0,soon", "loop_s is 'soon'"},
           Case{"\nnaive,0.002,", ",naive,0.002,", "the row has 38 values, but there are 19 columns"},
           Case{"naive,0.002,", "# naive,0.002,", "the comment '# naive,0.002,"},
           Case{"# set t_s=0.003 rend", "# set t_s=x rend", "the time of the change cannot be read"},
           Case{"rendering.k_r_N_per_m=", "rendering.k_x=", "'rendering.k_x' is not a setting"},
           Case{"rendering.k_r_N_per_m=", "title=", "'title' is not a setting"},
           Case{"rendering.k_r_N_per_m=812.5", "rendering.k_r_N_per_m=-1", "rendering.k_r_N_per_m"},
           Case{"rendering.k_r_N_per_m=812.5", long_change, "the change is longer than one can be"},
           Case{"=0.005 full=0.1", "=0.005 full=nan", "the state from which the run continues cannot be read"},
           Case{"# dropped 12", "# dropped -1", "the number of lost samples cannot be read"},
           Case{"\n# interrupted", "\n# interupted", "the comment '# interupted' is not understood"},
           Case{"# end of scene\n", "", "the scene above it does not end with '# end of scene'", 1},
       }) {
    SCOPED_TRACE(c.by);
    const std::size_t at = text.find(c.what);
    ASSERT_NE(at, std::string::npos);
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(at + (c.what.front() == '\n' && c.by.front() == '\n'));
    const auto line = 1 + std::count(text.begin(), end, '\n') + c.lines_after;
    const std::string words = words_of_refusal(replaced(text, c.what, c.by));
    const std::string place = fmt::format("run.csv:{}:", line);
    EXPECT_TRUE(words.starts_with(place)) << words << "\nwanted at " << place;
    EXPECT_NE(words.find(c.words), std::string::npos) << words;
    // What is cut before the names of the columns holds nothing.
    const bool has_rows_before = c.what != "# end of scene\n";
    const std::string remedy =
        has_rows_before
            ? fmt::format("correct the line, or cut the file before it:\nhead -n {} RUN.csv > shorter.csv", line - 1)
            : "correct the line";
    EXPECT_TRUE(words.ends_with(remedy)) << words;
  }
}

TEST(RunReader, TellsTheColumnOfAWrongValue) {
  const std::string text = replaced(recording(), "naive,0.002,", "naive,nan,");
  EXPECT_NE(words_of_refusal(text).find(":7: t_s is 'nan', which is not a finite number; correct"), std::string::npos);
}

TEST(RunReader, RefusesRowsOfOneTickThatHaveTwoGoals) {
  const std::string text = recording();
  const std::string other = replaced(text, "naive,0.002,-0.03984,", "naive,0.002,-0.03985,");
  EXPECT_NE(words_of_refusal(other).find("the goal is not the same as in line"), std::string::npos);
}

// What the message asks for is enough.
TEST(RunReader, ReadsWhatIsLeftWhereTheFileIsCutBeforeTheDamagedLine) {
  const std::string text = replaced(recording(), "full,0.006,", "full,x,");
  ASSERT_NE(words_of_refusal(text), "");
  const auto run = read_run(text.substr(0, text.find("full,x,")), "run.csv");
  EXPECT_EQ(run.ticks.size(), 6U);
  EXPECT_TRUE(invents_nothing(run, read_run(recording(), "run.csv")));
}

// What is made of a run has every tick up to its last, so one damaged time is work without end.
TEST(RunReader, RefusesWhatADamagedTimeMakesTooLong) {
  std::string text = recording();
  text.erase(text.find("# interrupted"));
  const std::string last = replaced(text, "anisotropic,0.008,", "anisotropic,3e7,");
  const std::string line = std::to_string(std::count(text.begin(), text.end(), '\n'));
  const std::string words = words_of_refusal(last);
  EXPECT_TRUE(words.starts_with("run.csv:" + line + ":1: with t_s = 30000000 here")) << words;
  EXPECT_NE(words_of_refusal(replaced(text, "naive,0.002,", "naive,3e7,")), "");
  EXPECT_NE(words_of_refusal(replaced(text, "\nfull,0.005,", "\nfull,3e7,")), "");
  // A recording begins when it likes, and is as long as its rows say.
  std::string rows = text.substr(0, text.find("\nfull,0,") + 1);
  const std::string row = ",0,0,0,0,0,0,0,0,0,given,simulated,0,0,0,0.001,0,0\n";
  const std::string reset = "# state t_s=3 full=0,0,0 naive=0,0,0 anisotropic=0,0,0\n";
  EXPECT_EQ(words_of_refusal(rows + "full,90000" + row + "full,100000" + row), "") << "1e7 ticks";
  EXPECT_NE(words_of_refusal(rows + "full,90000" + row + "full,100000.001" + row), "") << "one more";
  EXPECT_EQ(words_of_refusal(rows + "full,90000" + row + reset + "full,3" + row + "full,10003" + row), "");
  rows += "full,90000" + row;
  EXPECT_EQ(words_of_refusal(rows + "# set t_s=1 device.rate_hz=10\nfull,1000000" + row), "");
  EXPECT_NE(words_of_refusal(rows + "# set t_s=1 device.rate_hz=10\nfull,100000" + row + "full,1100001" + row), "");
  // Without a scene it depends on the loop that plays it.
  const std::string bare = std::string(run_columns) + "\nfull,5,0,0,0,0,0,0,0,0\nfull,";
  EXPECT_EQ(words_of_refusal(bare + "10005,0,0,0,0,0,0,0,0\n"), "");
  EXPECT_TRUE(words_of_refusal(bare + "10006,0,0,0,0,0,0,0,0\n").starts_with("run.csv:3:1: with t_s = 10006"));
}

TEST(RunReader, TakesWhatOtherProgramsMakeOfTheFile) {
  const std::string text = recording();
  std::string windows = "\xEF\xBB\xBF";
  for (const char c : text) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  const auto whole = read_run(text, "run.csv");
  const auto run = read_run(windows, "run.csv");
  EXPECT_TRUE(invents_nothing(run, whole));
  EXPECT_EQ(run.ticks.size(), whole.ticks.size());
  EXPECT_EQ(run.warnings, whole.warnings);

  const auto moved = read_run(
      "note,force_y_N,force_x_N,strategy,t_s,goal_x_m,goal_y_m,device_x_m,device_y_m,proxy_x_m,proxy_y_m\n"
      "hello,1,2,full,0,3,4,5,6,7,8\n",
      "run.csv");
  EXPECT_FALSE(moved.scene);
  EXPECT_TRUE(has_warning(moved, "its scene is missing or incomplete"));
  ASSERT_EQ(moved.ticks.size(), 1U);
  EXPECT_EQ(moved.ticks[0].goal, Vector<2>(3.0, 4.0));
  EXPECT_EQ(moved.ticks[0].rows[0]->force, Vector<2>(2.0, 1.0));
  EXPECT_EQ(goal_path_of(moved).points, std::vector{Vector<2>(3.0, 4.0)});
}

TEST(RunReader, SaysWhatItCannotKnow) {
  const std::string text = recording();
  EXPECT_TRUE(has_warning(read_run(replaced(text, "# ghostforce " + std::string(version), "# ghostforce 99.1"), "f"),
                          "written by version 99.1"));
  const auto no_version = read_run(text.substr(text.find('\n') + 1), "f");
  EXPECT_TRUE(has_warning(no_version, "it does not say which version of ghostforce wrote it"));
  const auto no_scene = read_run(text.substr(text.find("\nstrategy,t_s") + 1), "f");
  EXPECT_TRUE(has_warning(no_scene, "its scene is missing or incomplete"));
  EXPECT_EQ(no_scene.ticks.size(), 9U);
  EXPECT_TRUE(no_scene.settings.empty());
}

TEST(RunReader, TakesResetsOfAFileThatHasLostItsComments) {
  const std::string rows = std::string(run_columns) + "\nfull,5,0,0,0,0,0,0,0,0\nfull,3,1,0,0,0,0,0,0,0\n";
  const auto run = read_run(rows, "f");
  ASSERT_EQ(run.ticks.size(), 2U);
  EXPECT_EQ(goal_path_of(run).points, std::vector{Vector<2>(0.0)}) << "the hand, up to the reset";
}

TEST(RunReader, TellsWhereItsSceneIsWrong) {
  const std::string text = replaced(recording(), "k_r_N_per_m = ", "k_s_N_per_m = ");
  const std::size_t at = text.find("k_s_N_per_m");
  const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
  const std::string place = fmt::format("run.csv:{}:{}: ", line, at - text.rfind('\n', at));
  const auto run = read_run(text, "run.csv");
  EXPECT_FALSE(run.scene);
  const auto says_where = [&](const std::string& warning) { return warning.find(place) != std::string::npos; };
  EXPECT_TRUE(std::ranges::any_of(run.warnings, says_where));
  EXPECT_EQ(run.ticks.size(), read_run(recording(), "run.csv").ticks.size());
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
  for (const std::string_view text : {"", "\n", "hello", "a,b,c\n1,2,3\n", "# ghostforce", "strategy,t_s\nfull,0\n",
                                      "# ghostforce 1.0\nstr?tegy,t?s\n"}) {
    try {
      read_run(text, "f.csv");
      ADD_FAILURE() << "'" << text << "' was read";
    } catch (const ReadError& error) {
      EXPECT_EQ(error.kind(), ReadError::Kind::wrong);
      EXPECT_TRUE(std::string_view(error.what()).starts_with("f.csv: ")) << error.what();
    }
  }
}

TEST(RunReader, RefusesANewerFormatAndTakesRunsThatTellNone) {
  const std::string text = recording();
  const std::size_t at = text.find("# format 1\n");
  ASSERT_NE(at, std::string::npos);
  const auto with_line = [&](std::string_view line) { return std::string(text).replace(at, 11, line); };
  EXPECT_EQ(read_run(with_line(""), "old.csv").ticks.size(), read_run(text, "run.csv").ticks.size());
  for (const auto& [line, words] : {std::pair{"# format 3\n",
                                              "new.csv:2:1: this is a run of format 3, but this program only knows "
                                              "formats 1 to 2; a newer version of ghostforce may read it"},
                                    std::pair{"# format x\n", "new.csv:2:1: this is not the number of a format"},
                                    std::pair{"# format 0\n", "new.csv:2:1: this is not the number of a format"}}) {
    try {
      read_run(with_line(line), "new.csv");
      ADD_FAILURE() << line << " was read";
    } catch (const ReadError& error) {
      EXPECT_TRUE(std::string_view(error.what()).starts_with(words)) << error.what();
    }
  }
}

TEST(RunReader, LoadsFilesInPieces) {
  const TemporaryFolder folder;
  Scene scene = load_scene("fig3-normal");
  fmt::memory_buffer rows;
  simulate(scene, last_tick(scene), [&](const Snapshot& snapshot) {
    for (const Strategy& strategy : strategy_catalog()) {
      append_run_row(rows, snapshot, strategy.id);
      rows.push_back('\n');
    }
  });
  const std::string text = run_header(scene) + text_of(rows);
  ASSERT_GT(text.size(), std::size_t{1} << 20);
  write_whole(folder / "run.csv", text);
  const auto run = load_run(folder / "run.csv");
  EXPECT_TRUE(run.warnings.empty()) << listed_warnings(run);
  EXPECT_EQ(run.ticks.size(), 3001U);
  EXPECT_TRUE(invents_nothing(run, read_run(text, "run.csv")));

  for (const std::string& path : {folder.path(), folder / "none.csv", std::string("/dev/zero")}) {
    SCOPED_TRACE(path);
    try {
      load_run(path);
      ADD_FAILURE();
    } catch (const ReadError& error) {
      EXPECT_EQ(error.kind(), ReadError::Kind::wrong);
    }
  }
}

TEST(RunReader, TheHandOfARunIsItsGoalAtEachTickBitForBit) {
  const Scene scene = load_scene("fig1");
  fmt::memory_buffer rows;
  std::vector<Vector<2>> goals;
  const auto write = [&](const Snapshot& snapshot) {
    append_run_row(rows, snapshot, StrategyId::full);
    rows.push_back('\n');
  };
  simulate(scene, 900, [&](const Snapshot& snapshot) {
    if (snapshot.tick < 100) return;  // recorded in mid-motion
    goals.push_back(snapshot.goal);
    write(snapshot);
  });
  append_state_line(rows, 0.0, {});
  simulate(scene, 10, write);  // reset
  const auto run = read_run(run_header(scene) + text_of(rows), "f");
  const GoalPath path = goal_path_of(run);
  ASSERT_EQ(path.points.size(), goals.size());
  for (std::size_t k = 0; k < goals.size(); ++k) {
    ASSERT_EQ(goal_at(path, time_of(static_cast<std::int64_t>(k), scene.settings.rate)), goals[k]) << k;
  }
}

}  // namespace
}  // namespace ghostforce::run_reader_test
