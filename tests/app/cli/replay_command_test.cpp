// `replay` as its users have it: what it repeats, what it says, and what it leaves when it cannot go on.
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/files/run.h"
#include "app/files/run_reader.h"
#include "app/files/scene_file.h"
#include "tests/app/runs/recorded_by_dice.h"
#include "tests/support/places.h"
#include "tests/support/program.h"
#include "tests/support/sanitized.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::replay_command_test {
namespace {

bool says(const Outcome& outcome, std::string_view words) {
  return outcome.err.find(words) != std::string::npos;
}

TEST(ReplayCommand, RepeatsSimulateAndItself) {
  const TemporaryFolder folder;
  const std::string run = folder / "run.csv";
  const std::string again = folder / "again.csv";
  ASSERT_EQ(run_ghostforce({"simulate", "fig1", "--strategy", "all", "-o", run}).exit_code, 0);
  const Outcome outcome = run_ghostforce({"replay", run, "-o", again});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(says(outcome, "run.csv: identical bit for bit for 3001 ticks")) << outcome.err;
  EXPECT_EQ(read_whole(again), read_whole(run));
  const Outcome to_pipe = run_ghostforce({"replay", again});
  EXPECT_EQ(to_pipe.out, read_whole(run));

  ASSERT_EQ(run_ghostforce({"simulate", "fig1", "--strategy", "naive", "-o", run}).exit_code, 0);
  EXPECT_EQ(run_ghostforce({"replay", run, "-o", again}).exit_code, 0);
  EXPECT_EQ(read_whole(again).find("# state"), std::string::npos);
}

TEST(ReplayCommand, IsIdenticalAlsoWhereItsWordsGoNowhere) {
  const TemporaryFolder folder;
  write_whole(folder / "run.csv", recorded_by_dice(6, 100));
  ProgramCall call;
  call.words = {"-c", "exec \"$0\" replay run.csv 2>/dev/full", ghostforce_program()};
  call.folder = folder.path();
  EXPECT_EQ(run_program("/bin/sh", call).exit_code, 0);
}

TEST(ReplayCommand, RepeatsARecordingAndWritesOneThatRepeatsToo) {
  const TemporaryFolder folder;
  write_whole(folder / "run.csv", recorded_by_dice(6, 100));
  const Outcome first = run_ghostforce({"replay", folder / "run.csv", "-o", folder / "again.csv"});
  EXPECT_EQ(first.exit_code, 0) << first.err;
  const Outcome second = run_ghostforce({"replay", folder / "again.csv", "-o", folder / "third.csv"});
  EXPECT_EQ(second.exit_code, 0) << second.err;
  EXPECT_EQ(read_whole(folder / "third.csv"), read_whole(folder / "again.csv"));
}

TEST(ReplayCommand, SaysWhereARunDiverges) {
  const TemporaryFolder folder;
  const std::string run = folder / "run.csv";
  ASSERT_EQ(run_ghostforce({"simulate", "fig1", "-o", run}).exit_code, 0);
  std::string text = read_whole(run);
  const std::size_t row = text.find("\nanisotropic,1.5,") + 1;
  const std::size_t end = text.find('\n', row);
  text.replace(text.rfind(',', end) + 1, end - text.rfind(',', end) - 1, "0.125");
  write_whole(run, text);
  const Outcome outcome = run_ghostforce({"replay", run, "-o", folder / "again.csv"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(says(outcome, "diverges at t = 1.5 s: force_y_N of anisotropic is 0.125 in the run")) << outcome.err;
  EXPECT_TRUE(says(outcome, "1 of 3001 ticks differ")) << outcome.err;

  write_whole(run, text.replace(0, text.find('\n'), "# ghostforce 0.0.1"));
  const Outcome older = run_ghostforce({"replay", run});
  EXPECT_TRUE(says(older, "written by version 0.0.1")) << older.err;
  EXPECT_TRUE(says(older, "only for the same version")) << older.err;
}

TEST(ReplayCommand, PassesARunOfAnotherBuildThatAgreesButForRounding) {
  const TemporaryFolder folder;
  const std::string run = folder / "run.csv";
  ASSERT_EQ(run_ghostforce({"simulate", "fig1", "-o", run}).exit_code, 0);
  std::string text = read_whole(run);
  // The device has one motor, along x.
  const std::size_t end = text.rfind(',', text.find('\n', text.find("\nanisotropic,2.5,") + 1));
  const std::size_t value = text.rfind(',', end - 1) + 1;
  const double force = std::stod(text.substr(value, end - value));
  ASSERT_GT(std::abs(force), 0.1);
  const auto with_force = [&](std::string_view first_line, double changed) {
    std::string whole = text;
    whole.replace(value, end - value, fmt::format("{}", changed));
    write_whole(run, whole.replace(0, whole.find('\n'), first_line));
    return run_ghostforce({"replay", run, "-o", folder / "again.csv"});
  };
  const std::string this_build = text.substr(0, text.find('\n'));
  const double nearly = std::nextafter(force, 10.0);

  const Outcome page = with_force(this_build + ", page", nearly);
  EXPECT_EQ(page.exit_code, 0) << page.err;
  EXPECT_TRUE(says(page, "relative for 3001 ticks, not bit for bit: recorded by another build (ghostforce "))
      << page.err;
  EXPECT_TRUE(says(page, ", page)")) << page.err;
  EXPECT_EQ(with_force("# ghostforce 0.0.1", nearly).exit_code, 0);
  const Outcome untold = with_force("# a comment", nearly);
  EXPECT_EQ(untold.exit_code, 0) << untold.err;
  EXPECT_TRUE(says(untold, "recorded by another build (it does not say which)")) << untold.err;

  const Outcome same = with_force(this_build, nearly);
  EXPECT_EQ(same.exit_code, 1);
  EXPECT_TRUE(says(same, "diverges at t = 2.5 s: force_x_N of anisotropic is ")) << same.err;
  EXPECT_TRUE(says(same, "but the file names this one")) << same.err;

  const Outcome off = with_force(this_build + ", page", force * (1.0 + 1e-9));
  EXPECT_EQ(off.exit_code, 1);
  EXPECT_TRUE(says(off, "diverges at t = 2.5 s: force_x_N of anisotropic is ")) << off.err;
  EXPECT_TRUE(says(off, "may differ by 1e-12 relative, and this one differs by ")) << off.err;
  EXPECT_TRUE(says(off, " at t = 2.5 s in force_x_N of anisotropic")) << off.err;
}

TEST(ReplayCommand, PlaysTheHandInAnotherSceneAndComparesNothing) {
  const TemporaryFolder folder;
  const std::string run = folder / "run.csv";
  ASSERT_EQ(run_ghostforce({"simulate", "fig1", "--strategy", "all", "-o", run}).exit_code, 0);
  const std::vector<std::string> other{"rendering.tracking_ratio=3"};
  const Outcome set = run_ghostforce({"replay", run, "--set", other[0], "-o", folder / "set.csv"});
  EXPECT_EQ(set.exit_code, 0) << set.err;
  EXPECT_TRUE(says(set, "nothing was compared")) << set.err;
  const Scene scene = load_scene("fig1", other);
  const auto wanted = run_ghostforce({"simulate", "fig1", "--strategy", "all", "--set", other[0]});
  // The recorded hand is that of the scene: so are all rows.
  const std::string found = read_whole(folder / "set.csv");
  EXPECT_EQ(found.substr(found.find("\nfull,0,")), wanted.out.substr(wanted.out.find("\nfull,0,")));
  EXPECT_TRUE(read_run(found, "set.csv").warnings.empty());

  const Outcome named = run_ghostforce({"replay", run, "wall45", "-o", folder / "wall.csv"});
  EXPECT_EQ(named.exit_code, 0) << named.err;
  EXPECT_EQ(read_run(read_whole(folder / "wall.csv"), "f").scene->title, load_scene("wall45").title);
}

// Sanitizers take more memory than any program.
#ifndef GHOSTFORCE_SANITIZED
// Held whole, 100 001 ticks would take more than 30 MB.
TEST(ReplayCommand, HoldsNoRunWhole) {
  const TemporaryFolder folder;
  const std::string run = folder / "run.csv";
  ASSERT_EQ(
      run_ghostforce({"simulate", "wall45", "--strategy", "all", "--set", "goal.duration_s=100", "-o", run}).exit_code,
      0);
  for (const std::string_view how : {"", "--set rendering.tracking_ratio=2"}) {
    const Outcome outcome = run_program("/bin/sh", {"-c", fmt::format("ulimit -d 20000; exec {} replay {} {} -o {}",
                                                                      ghostforce_program(), run, how, folder / "out")});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  }
}

TEST(ReplayCommand, SaysThatARunIsTooLongForTheMemory) {
  const TemporaryFolder folder;
  std::string text = std::string(run_columns) + "\n";
  for (int k = 0; k < 1'500'000; ++k) text += fmt::format("full,{},0,0,0,0,0,0,0,0\n", k);
  write_whole(folder / "long.csv", text);
  // A tick takes more than 200 bytes.
  const std::string limited =
      fmt::format("ulimit -v 300000 && exec {} measure-user {}", ghostforce_program(), folder / "long.csv");
  const Outcome outcome = run_program("/bin/sh", {"-c", limited});
  EXPECT_EQ(outcome.exit_code, 8) << outcome.err;
  EXPECT_TRUE(says(outcome, "long.csv: the run is too long for the memory of this machine; shorten it")) << outcome.err;
}
#endif

// The limits end a program that would write or compute without end.
TEST(ReplayCommand, AndEveryOtherThatTakesARunRefusesOneWithAnEndlessTime) {
  const TemporaryFolder folder;
  const std::string run = folder / "run.csv";
  ASSERT_EQ(run_ghostforce({"simulate", "wall45", "--strategy", "all", "-o", run}).exit_code, 0);
  std::string text = read_whole(run);
  const std::size_t row = text.rfind("\nanisotropic,3,");
  ASSERT_NE(row, std::string::npos);
  write_whole(run, text.replace(row, 15, "\nanisotropic,3e7,"));
  const std::string line = fmt::format("run.csv:{}:1: ", std::count(text.begin(), text.end(), '\n'));
  for (const std::string_view words :
       {"replay RUN -o OUT", "replay RUN --set rendering.k_r_N_per_m=500 -o OUT", "replay RUN fig1 -o OUT",
        "figures --only figure-6 --hand RUN -o OUT", "measure-user RUN", "run --exit-after 1 --input replay:RUN"}) {
    std::string call(words);
    call.replace(call.find("RUN"), 3, run);
    if (const std::size_t out = call.find("OUT"); out != std::string::npos) call.replace(out, 3, folder / "out");
    const Outcome outcome = run_program(
        "/bin/sh", {"-c", fmt::format("ulimit -t 60; ulimit -f 100000; exec {} {}", ghostforce_program(), call)});
    EXPECT_EQ(outcome.exit_code, 2) << words << outcome.err;
    EXPECT_TRUE(says(outcome, line)) << words << outcome.err;
    EXPECT_EQ(folder.count(), 1) << words;
  }
}

TEST(ReplayCommand, RefusesALengthThatAnotherRateMakesTooMuch) {
  const TemporaryFolder folder;
  const std::string run = folder / "run.csv";
  write_whole(run,
              run_header(load_scene("wall45")) + "anisotropic,0,0,0,0,0,0,0,0,0\nanisotropic,600,0,0,0,0,0,0,0,0\n");
  const Outcome outcome = run_program(
      "/bin/sh",
      {"-c", fmt::format("ulimit -t 60; ulimit -f 100000; exec {} replay {} --set device.rate_hz=20000 -o {}",
                         ghostforce_program(), run, folder / "out.csv")});
  EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
  EXPECT_TRUE(says(outcome, "with t_s = 600 here, the run is longer than 10000000 ticks")) << outcome.err;
  EXPECT_TRUE(says(outcome, "if the run really is that long, cut it before this line:\nhead -n ")) << outcome.err;
}

// A terminal that a program writes to.
class Terminal {
 public:
  Terminal() : descriptor_(posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK)) {
    EXPECT_EQ(grantpt(descriptor_), 0);
    EXPECT_EQ(unlockpt(descriptor_), 0);
    path_ = ptsname(descriptor_);
    // Open as long as this is, or what was written is gone when the program ends.
    own_end_ = open(path_.c_str(), O_RDWR | O_NOCTTY);
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;
  ~Terminal() {
    close(own_end_);
    close(descriptor_);
  }
  const std::string& path() const { return path_; }
  std::string take() const {
    std::string text;
    std::array<char, 4096> piece{};
    for (ssize_t count; (count = read(descriptor_, piece.data(), piece.size())) > 0;) {
      text.append(piece.data(), static_cast<std::size_t>(count));
    }
    return text;
  }

 private:
  int descriptor_;
  int own_end_ = -1;
  std::string path_;
};

bool has_open(pid_t program, const std::string& path) {
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(fmt::format("/proc/{}/fd", program), ignored)) {
    if (std::filesystem::read_symlink(entry.path(), ignored) == path) return true;
  }
  return false;
}

// Work is long when it takes more than a second: so the program is held up in the midst of it.
TEST(ReplayCommand, ShowsHowFarItIsAndEndsThatLineBeforeItsWords) {
  const TemporaryFolder folder;
  const std::string run = std::filesystem::canonical(folder.path()) / "run.csv";
  ASSERT_EQ(
      run_ghostforce({"simulate", "wall45", "--strategy", "all", "--set", "goal.duration_s=300", "-o", run}).exit_code,
      0);
  std::filesystem::create_directory(folder / "out");
  for (const bool is_exact : {true, false}) {
    const Terminal terminal;
    ProgramCall call;
    call.words = {"-c", fmt::format("echo $$; exec {} replay {} {} -o {} 2>{}", ghostforce_program(), run,
                                    is_exact ? "" : "--set rendering.tracking_ratio=2", folder / "out/again.csv",
                                    terminal.path())};
    RunningProgram program("/bin/sh", call);
    const pid_t pid = std::stoi(program.next_line().value_or("0"));
    ASSERT_GT(pid, 0);
    const auto hold_up_when = [&](const std::function<bool()>& has_come) {
      for (int i = 0; i < 20'000 && !has_come(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      program.send(SIGSTOP);
      std::this_thread::sleep_for(std::chrono::milliseconds(1100));
      program.send(SIGCONT);
    };
    hold_up_when([&] { return has_open(pid, run); });
    hold_up_when([&] {
      return std::ranges::any_of(std::filesystem::directory_iterator(folder / "out"), [](const auto& entry) {
        std::error_code has_just_gone;
        return entry.file_size(has_just_gone) > 100'000 && !has_just_gone;
      });
    });
    EXPECT_EQ(program.wait_for_end(), 0);
    const std::string words = terminal.take();
    // As it was recorded, it is not held whole: reading and replaying are one.
    EXPECT_EQ(words.find("\rreading [") == std::string::npos, is_exact) << words;
    EXPECT_NE(words.find("\rreplaying ["), std::string::npos) << words;
    const std::size_t verdict = words.rfind(run + ": " + (is_exact ? "identical" : "nothing was compared"));
    ASSERT_NE(verdict, std::string::npos) << words;
    EXPECT_TRUE(words.substr(0, verdict).ends_with("\r\x1b[K")) << words;
    std::filesystem::remove(folder / "out/again.csv");
  }
}

// From 2 s on the hand of wall45 rests 20 mm inside the wall. `state` stands before the first row.
std::string resting_run(const std::string& state) {
  const std::string text = run_ghostforce({"simulate", "wall45", "--strategy", "all"}).out;
  return text.substr(0, text.find("\nfull,0,") + 1) + state + text.substr(text.find("\nfull,2,") + 1);
}

double greatest_move(const Run& run) {
  double greatest = 0.0;
  for (const RunTick& tick : run.ticks) {
    for (std::size_t i = 0; i < strategy_count; ++i) {
      greatest = std::max(greatest, glm::distance(tick.rows[i]->device, run.ticks.front().rows[i]->device));
    }
  }
  return greatest;
}

TEST(ReplayCommand, BeginsAtRestWhereTheHandBeginsInTheWall) {
  const TemporaryFolder folder;
  write_whole(folder / "live.csv", resting_run("# state t_s=2 full=0,0,0 naive=0,0,0 anisotropic=0,0,0\n"));
  for (const std::string_view value : {"rendering.tracking_ratio=5", "rendering.k_r_N_per_m=300"}) {
    const Outcome outcome =
        run_ghostforce({"replay", folder / "live.csv", "--set", std::string(value), "-o", folder / "other.csv"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_TRUE(says(outcome, "played from rest for 1 s")) << outcome.err;
    const auto run = load_run(folder / "other.csv");
    ASSERT_EQ(run.ticks.size(), 1001U);
    EXPECT_LT(greatest_move(run), 1e-9) << value;
    // And what it wrote repeats itself.
    const Outcome again = run_ghostforce({"replay", folder / "other.csv"});
    EXPECT_EQ(again.exit_code, 0) << again.err;
    EXPECT_TRUE(says(again, "identical bit for bit for 1001 ticks")) << again.err;
  }
}

TEST(ReplayCommand, GoesOnFromTheRecordedStateWhereTheSettingsAreTheSame) {
  const TemporaryFolder folder;
  write_whole(folder / "live.csv", resting_run("# state t_s=2 full=0.1,0,0.5 naive=0,0,0 anisotropic=0,0,0\n"));
  const Outcome outcome = run_ghostforce({"replay", folder / "live.csv", "wall45", "-o", folder / "same.csv"});
  EXPECT_TRUE(says(outcome, "played from the recorded state")) << outcome.err;
  const auto run = load_run(folder / "same.csv");
  EXPECT_EQ(run.states.at(0).velocity[0], Vector<2>(0.1, 0.0));
  EXPECT_EQ(run.states.at(0).energy[0], 0.5);
  EXPECT_GT(greatest_move(run), 1e-5);
}

TEST(ReplayCommand, PlaysAHandThatTellsNoSceneInTheNamedOne) {
  const TemporaryFolder folder;
  const std::string text = resting_run("");
  write_whole(folder / "told.csv", text);
  write_whole(folder / "untold.csv", text.substr(text.find("\nstrategy,") + 1));
  const Outcome alone = run_ghostforce({"replay", folder / "untold.csv"});
  EXPECT_EQ(alone.exit_code, 2);
  EXPECT_TRUE(says(alone, "name a scene to replay its hand in")) << alone.err;
  for (const std::string_view name : {"told", "untold"}) {
    const Outcome outcome = run_ghostforce(
        {"replay", folder / (std::string(name) + ".csv"), "fig3-normal", "-o", folder / (std::string(name) + "-out")});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  }
  const std::string told = read_whole(folder / "told-out");
  const std::string untold = read_whole(folder / "untold-out");
  ASSERT_FALSE(told.empty());
  // The same rows but for a file's name.
  EXPECT_TRUE(told.substr(told.find("\n# state ")) == untold.substr(untold.find("\n# state ")));
  EXPECT_EQ(load_run(folder / "untold-out").ticks.size(), 1001U);
}

TEST(ReplayCommand, RefusesWhatItCannotReplay) {
  const TemporaryFolder folder;
  EXPECT_EQ(run_ghostforce({"replay"}).exit_code, 2);
  EXPECT_EQ(run_ghostforce({"replay", folder / "none.csv"}).exit_code, 2);
  EXPECT_EQ(run_ghostforce({"replay", folder.path()}).exit_code, 2);
  write_whole(folder / "text.csv", "hello\n");
  EXPECT_EQ(run_ghostforce({"replay", folder / "text.csv"}).exit_code, 2);
  write_whole(folder / "header.csv", run_header(load_scene("fig1")));
  EXPECT_EQ(run_ghostforce({"replay", folder / "header.csv"}).exit_code, 2);
  ASSERT_EQ(run_ghostforce({"simulate", "fig1", "-o", folder / "run.csv"}).exit_code, 0);
  EXPECT_EQ(run_ghostforce({"replay", folder / "run.csv", "--set", "rendering.k_q=1"}).exit_code, 2);
  EXPECT_EQ(run_ghostforce({"replay", folder / "run.csv", "-o", folder / "no/where.csv"}).exit_code, 8);
  EXPECT_EQ(run_ghostforce({"run", "--input", "replay"}).exit_code, 2);
  EXPECT_EQ(run_ghostforce({"run", "--input", "replay:" + folder / "none.csv"}).exit_code, 2);
  EXPECT_EQ(folder.count(), 3) << "nothing half-done is left";
}

TEST(ReplayCommand, LeavesNothingWhenInterrupted) {
  const TemporaryFolder folder;
  const TemporaryFolder results;
  ASSERT_EQ(
      run_ghostforce({"simulate", "fig1", "--strategy", "all", "--set", "goal.duration_s=60", "-o", folder / "run.csv"})
          .exit_code,
      0);
  const Outcome outcome = run_ghostforce({.words = {"replay", folder / "run.csv", "-o", results / "again.csv"},
                                          .environment = {},
                                          .folder = {},
                                          .out_to = {},
                                          .signal_when_created_in = results.path(),
                                          .signal = SIGINT});
  EXPECT_EQ(outcome.exit_code, 130);
  EXPECT_EQ(results.count(), 0);
}

}  // namespace
}  // namespace ghostforce::replay_command_test
