// `sweep`: the ranges, how it ends, and the page about it.
#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <regex>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/base/progress.h"
#include "app/files/run.h"
#include "app/files/scene_file.h"
#include "app/files/scene_keys.h"
#include "app/tools/sweep/sweep.h"
#include "tests/app/tools/sweep/point_equilibrium.h"
#include "tests/support/places.h"
#include "tests/support/program.h"
#include "tests/support/scene_values.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::sweep_test {
namespace {

Outcome run(std::vector<std::string> words) {
  words.insert(words.begin(), "sweep");
  return run_ghostforce(std::move(words));
}

Range range(std::string_view argument) {
  auto parsed = parse_range(argument);
  if (const auto* const what = std::get_if<std::string>(&parsed)) throw std::runtime_error(*what);
  return std::get<Range>(parsed);
}

std::vector<double> values(std::string_view argument) {
  return range(argument).values;
}

// --- Ranges ---

TEST(SweepRange, EndsAreHitExactlyAndValuesAreWhatAPersonWouldWrite) {
  EXPECT_EQ(values("wall.normal_deg=0:180:7"), (std::vector<double>{0, 30, 60, 90, 120, 150, 180}));
  EXPECT_EQ(values("device.mass_kg=0.1:1:10"), (std::vector<double>{0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1}));
  EXPECT_EQ(values("wall.normal_deg=10:-10:5"), (std::vector<double>{10, 5, 0, -5, -10}));
  EXPECT_EQ(values(" wall.normal_deg = +1 : 2 : 2 "), (std::vector<double>{1, 2}));
  EXPECT_EQ(values("wall.normal_deg=3:4:1"), std::vector<double>{3});
  EXPECT_EQ(values("user.k_u_N_per_m=1:1000:4:log"), (std::vector<double>{1, 10, 100, 1000}));
  EXPECT_EQ(values("user.k_u_N_per_m=1000:1:4:log"), (std::vector<double>{1000, 100, 10, 1}));
  EXPECT_EQ(values("device.rate_hz=10:10000:4:log"), (std::vector<double>{10, 100, 1000, 10000}));
  for (const double value : values("wall.normal_deg=-1:1:21")) EXPECT_FALSE(value == 0.0 && std::signbit(value));
}

TEST(SweepRange, ValuesIncreaseAndStayBetweenTheEnds) {
  for (const std::string_view argument :
       {"user.k_u_N_per_m=0.1:1000000:10003", "user.k_u_N_per_m=0.1:1000000:10003:log",
        "user.k_u_N_per_m=0.30000000000000004:0.7:1001", "rendering.k_c_N_per_m=3:7:1001:log",
        "wall.normal_deg=-1e+308:1e+308:1001", "wall.normal_deg=1e+307:1.7e+308:1001"}) {
    const std::vector<double> all = values(argument);
    EXPECT_EQ(fmt::format("{}={}:{}:{}{}", argument.substr(0, argument.find('=')), all.front(), all.back(), all.size(),
                          argument.ends_with(":log") ? ":log" : ""),
              argument);
    for (std::size_t i = 1; i < all.size(); ++i) ASSERT_LT(all[i - 1], all[i]) << argument << " at " << i;
  }
}

TEST(SweepRange, LogarithmicStepsAreEqualRatios) {
  const std::vector<double> all = values("rendering.k_r_N_per_m=7:7000:11:log");
  const double ratio = std::pow(1000.0, 0.1);
  // Some ulp of pow() and of log10() times the logarithm.
  for (std::size_t i = 1; i < all.size(); ++i) EXPECT_NEAR(all[i] / all[i - 1], ratio, 1e-13 * ratio);
}

// Each number key, by --over and by --set with the text that the file shows.
TEST(SweepRange, AValueIsBitForBitThatOfSet) {
  int keys = 0;
  for (const SceneKey& key : scene_keys()) {
    double least = 0.0;
    double greatest = 0.0;
    bool whole = false;
    if (const auto* const number = std::get_if<NumberKey>(&key.value)) {
      least = number->least;
      greatest = number->greatest;
      whole = number->whole;
    } else if (const auto* const optional = std::get_if<OptionalNumberKey>(&key.value)) {
      least = optional->least;
      greatest = optional->greatest;
    } else {
      continue;
    }
    if (key.format > 1) continue;  // not of this scene
    ++keys;
    const std::string name = dotted_name(key.table, key.name);
    const double from = whole ? 10.0 : std::max(least, -777.7);
    const double to = whole ? 970.0 : std::min(greatest, 999.9);
    const Scene scene = load_scene("wall45");
    const Grid grid = make_grid(std::vector{fmt::format("{}={}:{}:25", name, from, to)}, scene);
    for (std::int64_t point = 0; point < size_of(grid); ++point) {
      Scene by_sweep = scene;
      put_point(grid, point, by_sweep);
      const Scene by_set = load_scene("wall45", std::vector{fmt::format("{}={}", name, value_at(grid, 0, point))});
      ASSERT_EQ(scene_values(by_sweep), scene_values(by_set)) << name << " at " << point;
    }
  }
  EXPECT_EQ(keys, 17);
}

TEST(SweepRange, WrongOnesAreRefusedAndNothingIsWritten) {
  struct Case {
    std::vector<std::string> ranges;
    std::string_view said;
  };
  const std::vector<Case> cases{
      {{"wall.normal_deg"}, "--over wall.normal_deg: give KEY=FROM:TO:COUNT"},
      {{"=1:2:3"}, "give KEY=FROM:TO:COUNT"},
      {{"wall.normal_deg=1:2"}, "the range is '1:2'; give KEY=FROM:TO:COUNT"},
      {{"wall.normal_deg=1:2:3:log:4"}, "the range is '1:2:3:log:4'"},
      {{"wall.normal_deg=90"}, "the range is '90'"},
      {{"wall.normaldeg=1:2:3"}, "the key wall.normaldeg is unknown; did you mean 'wall.normal_deg'?"},
      {{"k_r=1:2:3"}, "the key k_r is unknown; did you mean 'rendering.k_r_N_per_m'?"},
      {{"format=1:2:3"}, "the key format is unknown"},
      {{"goal.path_mm=1:2:3"}, "the key goal.path_mm is not a single number; a sweep can vary wall.normal_deg, "},
      {{"title=1:2:3"}, "the key title is not a single number"},
      {{"rendering.strategy=1:2:3"}, "the key rendering.strategy is not a single number"},
      {{"wall.normal_deg=a:2:3"}, "FROM is 'a'; give a finite number"},
      {{"wall.normal_deg=1:2x:3"}, "TO is '2x'; give a finite number"},
      {{"wall.normal_deg=1::3"}, "TO is empty; give a finite number"},
      {{"wall.normal_deg=nan:2:3"}, "FROM is 'nan'; give a finite number"},
      {{"wall.normal_deg=1:-inf:3"}, "TO is '-inf'; give a finite number"},
      {{"wall.normal_deg=1e999:2:3"}, "FROM is '1e999'; give a finite number"},
      {{"rendering.k_c_N_per_m=1:inf:3"}, "with --set rendering.k_c_N_per_m=inf"},
      {{"user.k_u_N_per_m=0:1:3"}, "FROM is 0, out of the key's range; give 0.1 to 1000000 N/m"},
      {{"user.k_u_N_per_m=1:1.1e6:1"}, "TO is 1100000, out of the key's range"},
      {{"rendering.tracking_ratio=1:1001:3"}, "TO is 1001, out of the key's range; give 0.001 to 1000"},
      {{"wall.normal_deg=1:2:0"}, "COUNT is '0'; give a whole number from 1 to 10000000"},
      {{"wall.normal_deg=1:2:-3"}, "COUNT is '-3'"},
      {{"wall.normal_deg=1:2:2.5"}, "COUNT is '2.5'"},
      {{"wall.normal_deg=1:2:"}, "COUNT is empty"},
      {{"wall.normal_deg=1:2:10000001"}, "COUNT is '10000001'"},
      {{"wall.normal_deg=1:2:99999999999999999999"}, "COUNT is '99999999999999999999'"},
      {{"wall.normal_deg=1:2:3:lin"}, "the spacing is 'lin'; write log"},
      {{"wall.normal_deg=0:2:3:log"}, "log needs FROM and TO greater than 0, but FROM is 0"},
      {{"wall.normal_deg=1:-2:3:log"}, "log needs FROM and TO greater than 0, but TO is -2"},
      {{"device.rate_hz=100:200:4"}, "number 2 of 4 would be 133.333333333333"},
      {{"device.rate_hz=100.5:200:1"}, "number 1 of 1 would be 100.5"},
      {{"wall.normal_deg=1:2:3", "wall.normal_deg=1:2:4"}, "the key wall.normal_deg already has a range"},
      {{"wall.radius_mm=10:20:3"}, "the key wall.radius_mm belongs to kind 'circle', and this wall is of kind 'plane'"},
      {{"wall.normal_deg=1:2:3", "user.k_u_N_per_m=1:2:3", "device.mass_kg=1:2:3"}, "one or two keys"},
      {{"wall.normal_deg=1:2:10000", "user.k_u_N_per_m=1:2:1001"}, "the sweep would have 10010000 points"},
      {{"goal.duration_s=1:1e5:4"}, "with goal.duration_s=33334 the key goal.duration_s: duration_s times rate_hz"},
      {{"goal.duration_s=1:1000:2", "device.rate_hz=1000:20000:2"},
       "with goal.duration_s=1000 and device.rate_hz=20000 the key goal.duration_s"},
  };
  const TemporaryFolder folder;
  for (const Case& wrong : cases) {
    std::vector<std::string> words{"wall45", "-o", folder / "sweep.csv"};
    for (const std::string& argument : wrong.ranges) words.push_back("--over=" + argument);
    const Outcome outcome = run(words);
    EXPECT_EQ(outcome.exit_code, 2) << wrong.said;
    EXPECT_NE(outcome.err.find(wrong.said), std::string::npos) << wrong.said << "\n" << outcome.err;
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(folder.count(), 0) << wrong.said;
  }
  EXPECT_EQ(run({"wall45"}).exit_code, 2);
  const Outcome changing = run({"changing-hand", "--over=user.k_u_N_per_m=100:200:2"});
  EXPECT_EQ(changing.exit_code, 2);
  EXPECT_NE(changing.err.find("the scene's hand changes its stiffness"), std::string::npos) << changing.err;
  const Outcome wrong_kind = run({"wall45", "--over=wall.normal_deg=1:2:3", "--at-rest=closed-from"});
  EXPECT_EQ(wrong_kind.exit_code, 2);
  EXPECT_NE(wrong_kind.err.find("did you mean 'closed-form'?"), std::string::npos) << wrong_kind.err;
}

// --- How it ends ---

// More points than can be swept before a signal arrives, and what they would be.
const std::vector<std::string> long_ranges{"wall.normal_deg=90:180:2000", "rendering.k_r_N_per_m=10:1e4:2000:log"};
const std::vector<std::string> long_sweep{"sweep",        "fig1",   "--at-rest=closed-form", "--over",
                                          long_ranges[0], "--over", long_ranges[1]};

// The text is a sweep cut after some whole row, and says so; its rows are those of the sweep.
void expect_interrupted_rows(const std::string& text, std::int64_t least_rows) {
  ASSERT_TRUE(text.ends_with("\n# interrupted\n"))
      << text.substr(text.size() - std::min<std::size_t>(text.size(), 300));
  const Scene scene = load_scene("fig1");
  const Grid grid = make_grid(long_ranges, scene);
  const EquilibriumKind& kind = equilibrium_kinds.front();
  const std::string header = sweep_header(scene, grid, kind);
  ASSERT_TRUE(text.starts_with(header));
  const std::string_view rows(text.data() + header.size(), text.size() - header.size() - interrupted_line.size() - 1);
  const std::int64_t row_count = std::ranges::count(rows, '\n');
  EXPECT_EQ(row_count % 3, 0);
  EXPECT_GE(row_count, least_rows);
  ASSERT_LT(row_count, 3 * size_of(grid));
  fmt::memory_buffer expected;
  for (std::int64_t point = 0; point < row_count / 3; ++point) {
    Scene at = scene;
    put_point(grid, point, at);
    append_sweep_rows(expected, grid, point, point_equilibrium(at, kind), kind);
  }
  EXPECT_TRUE(rows == std::string_view(expected.data(), expected.size()));
}

TEST(SweepEnds, InterruptedItLeavesWholeRowsInTheFile) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const TemporaryFolder folder;
    ProgramCall call;
    call.words = long_sweep;
    call.words.insert(call.words.end(), {"-o", folder / "sweep.csv"});
    RunningProgram program(ghostforce_program(), call);
    const auto has_rows = [&] {
      return std::ranges::any_of(std::filesystem::directory_iterator(folder.path()),
                                 [](const auto& file) { return file.file_size() > 100'000; });
    };
    while (!has_rows()) ::usleep(1000);  // in vain: ctest ends the test
    program.send(signal);
    EXPECT_EQ(program.wait_for_end(), 130);
    EXPECT_EQ(folder.count(), 1);
    expect_interrupted_rows(read_whole(folder / "sweep.csv"), 100);
  }
}

// The loop is unstable, so that each point takes as long as it can. Where the signal comes late all the same, there is
// a row.
TEST(SweepEnds, InterruptedBeforeItsFirstRowItKeepsTheOldFile) {
  for (int i = 0; i < 5; ++i) {
    const TemporaryFolder folder;
    write_whole(folder / "sweep.csv", "precious");
    ProgramCall call;
    call.words = {"sweep",
                  "wall45",
                  "--at-rest=simulated",
                  "--over",
                  "wall.normal_deg=90:180:2000",
                  "--set",
                  "rendering.k_r_N_per_m=2000",
                  "-o",
                  folder / "sweep.csv"};
    call.signal_when_created_in = folder.path();
    call.signal = SIGINT;
    const Outcome outcome = run_ghostforce(call);
    EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
    EXPECT_NE(outcome.err.find("interrupted"), std::string::npos) << outcome.err;
    const std::string text = read_whole(folder / "sweep.csv");
    EXPECT_TRUE(text == "precious" || text.find("\n90,full,") != std::string::npos) << text.substr(0, 3000);
    EXPECT_EQ(folder.count(), 1);
  }
}

// The pipe is full and the program waits for this reader when the signal comes.
TEST(SweepEnds, InterruptedWhileAReaderIsSlowItLeavesWholeRowsInThePipe) {
  ProgramCall call;
  call.words = long_sweep;
  RunningProgram program(ghostforce_program(), call);
  std::string text;
  const auto take = [&] {
    const auto line = program.next_line();
    if (line) text += *line + "\n";
    return line.has_value();
  };
  ASSERT_TRUE(take());
  ::usleep(100'000);  // time to fill the pipe; nothing is wrong if it is too short
  program.send(SIGINT);
  while (take()) {
  }
  EXPECT_EQ(program.wait_for_end(), 130);
  expect_interrupted_rows(text, 100);  // that is what the pipe held
}

TEST(SweepEnds, AReaderWhoTakesNothingIsNotWaitedFor) {
  ProgramCall call;
  call.words = long_sweep;
  RunningProgram program(ghostforce_program(), call);
  ASSERT_TRUE(program.next_line());
  program.send(SIGTERM);
  EXPECT_EQ(program.wait_for_end(), 130);
}

TEST(SweepEnds, AClosedPipeIsNoTrouble) {
  ProgramCall call;
  call.words = long_sweep;
  call.close_after_first_piece = true;
  const Outcome outcome = run_ghostforce(call);
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
}

TEST(SweepEnds, WhatCannotBeWrittenIsTold) {
  for (const auto& [path, said] : {std::pair("/dev/full", "/dev/full cannot be written: No space left on device"),
                                   std::pair("/none/sweep.csv", "/none/sweep.csv cannot be written: No such file")}) {
    const Outcome outcome = run({"fig1", "--over=wall.normal_deg=90:180:3", "-o", path});
    EXPECT_EQ(outcome.exit_code, 8);
    EXPECT_NE(outcome.err.find(said), std::string::npos) << outcome.err;
  }
  ProgramCall call;
  call.words = long_sweep;
  call.out_to = "/dev/full";
  EXPECT_EQ(run_ghostforce(call).exit_code, 8);
}

// --- On a terminal ---

TEST(SweepProgress, BarShareAndTimeLeft) {
  using Seconds = std::chrono::duration<double>;
  EXPECT_EQ(progress_words("sweeping", 0, 10, Seconds(2)), "sweeping [                    ]   0 %");
  EXPECT_EQ(progress_words("sweeping", 1, 4, Seconds(2)), "sweeping [#####               ]  25 %, 6 s left");
  EXPECT_EQ(progress_words("sweeping", 999, 1000, Seconds(9)), "sweeping [################### ]  99 %, 1 s left");
  EXPECT_EQ(progress_words("sweeping", 10, 10, Seconds(9)), "sweeping [####################] 100 %, 0 s left");
  EXPECT_EQ(progress_words("x", 1, 2, Seconds(600)), "x [##########          ]  50 %, 10 min left");
  EXPECT_EQ(progress_words("x", 1, 1001, Seconds(36)), "x [                    ]   0 %, 10 h left");
}

TEST(SweepProgress, ATerminalIsToldHowLongItTook) {
  const int terminal = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  ASSERT_GE(terminal, 0);
  ASSERT_EQ(grantpt(terminal), 0);
  ASSERT_EQ(unlockpt(terminal), 0);
  const std::string other_end = ptsname(terminal);
  const int kept_open = open(other_end.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);  // keeps what was said until it is read
  const Outcome outcome = run_program(
      "/bin/sh",
      {"-c", "exec \"$0\" sweep fig1 --over wall.normal_deg=90:180:3 2> \"$1\"", ghostforce_program(), other_end});
  EXPECT_EQ(outcome.exit_code, 0);
  pollfd wait{terminal, POLLIN, 0};
  ASSERT_EQ(poll(&wait, 1, 5000), 1);
  std::array<char, 4096> piece;
  const ssize_t count = read(terminal, piece.data(), piece.size());
  ASSERT_GT(count, 0);
  const std::string said(piece.data(), static_cast<std::size_t>(count));
  EXPECT_NE(said.find("s: computing "), std::string::npos) << said;
  EXPECT_NE(said.find("writing "), std::string::npos) << said;
  close(kept_open);
  close(terminal);
}

// --- The page about it ---

TEST(SweepDoc, ItsCommandsRun) {
  const std::string page = read_whole(source_path("/docs/sweep.md"));
  // In a block of its own, and followed by the block of what it prints if that is anything.
  const std::regex call("\n```\nghostforce (sweep [^`]*)```\n");
  int calls = 0;
  const TemporaryFolder folder;
  for (std::sregex_iterator found(page.begin(), page.end(), call), end; found != end; ++found) {
    ++calls;
    ProgramCall shell;
    shell.words = {"-c", "\"$0\" " + (*found)[1].str(), ghostforce_program()};
    shell.folder = folder.path();
    const Outcome outcome = run_program("/bin/sh", shell);
    EXPECT_EQ(outcome.exit_code, 0) << (*found)[1] << "\n" << outcome.err;
    EXPECT_TRUE(outcome.err.empty() || outcome.err.find("settled is 0") != std::string::npos) << outcome.err;
    if (outcome.out.empty()) continue;
    EXPECT_TRUE(found->suffix().str().starts_with("\n```\n" + outcome.out + "```\n"))
        << "the page has other numbers than\n"
        << outcome.out;
  }
  EXPECT_EQ(calls, 5);
}

}  // namespace
}  // namespace ghostforce::sweep_test
