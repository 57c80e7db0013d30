// The whole program while it records, and its sudden ends.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <functional>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "app/files/run_reader.h"
#include "app/files/scene_file.h"
#include "app/runs/replay.h"
#include "core/settings.h"
#include "tests/support/display.h"
#include "tests/support/places.h"
#include "tests/support/program.h"
#include "tests/support/small_files.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::recording_program_test {
namespace {

// Records until the file has grown for a while, then gets the signal; returns the exit code.
int record_until(int signal, const std::string& path) {
  const Display display(1024, 640);
  BackgroundProgram program({ghostforce_program(), "run", "--input", "script", "--no-hints", "--record", path},
                            display.environment());
  std::size_t size = 0;
  while (size < 500'000 && program.is_running()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    size = read_whole(path).size();
  }
  EXPECT_TRUE(program.is_running());
  return program.end(signal);
}

void expect_repeats(const Run& run) {
  const ReplayReport report = replay(run, [](const ReplayedTick&) {});
  EXPECT_FALSE(report.first);
  EXPECT_EQ(report.skipped, 0);
  EXPECT_GT(report.compared, 500);
  EXPECT_EQ(run.ticks.front().tick, 0);
}

TEST(RecordingProgram, KilledItLeavesAFileThatReads) {
  const TemporaryFolder folder;
  EXPECT_EQ(record_until(SIGKILL, folder / "run.csv"), 128 + SIGKILL);
  const auto run = load_run(folder / "run.csv");
  EXPECT_FALSE(run.is_interrupted);
  expect_repeats(run);
}

TEST(RecordingProgram, InterruptedItSaysSoInItsLastLine) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const TemporaryFolder folder;
    EXPECT_EQ(record_until(signal, folder / "run.csv"), 130);
    const std::string text = read_whole(folder / "run.csv");
    EXPECT_TRUE(text.ends_with("\n# interrupted\n")) << text.substr(text.size() - 100);
    const auto run = load_run(folder / "run.csv");
    EXPECT_TRUE(run.is_interrupted);
    EXPECT_TRUE(run.warnings.empty());
    expect_repeats(run);
  }
}

// What another client of the display does to it, by xdotool.
void act_on_window(const Display& display, const std::string& act) {
  display.act({"search", "--sync", "--onlyvisible", "--class", "ghostforce", act, "%1"});
}

TEST(RecordingProgram, TheDisplayOrTheWindowGoesItSaysSoAndClosesTheFile) {
  struct Way {
    std::function<void(const Display& display)> go;
    std::string words;
  };
  const std::vector<Way> ways{
      {[](const Display& display) { display.lose(); }, "the display is gone: "},
      {[](const Display& display) { act_on_window(display, "windowclose"); }, "the window is gone: "},
      // The end of the window and that of the connection come at once.
      {[](const Display& display) { act_on_window(display, "windowkill"); }, " is gone: "},
  };
  for (const Way& way : ways) {
    const TemporaryFolder folder;
    const Display display(1024, 640);
    const std::string path = folder / "run.csv";
    std::jthread loss([&](const std::stop_token& stop) {
      while (read_whole(path).size() < 500'000 && !stop.stop_requested()) {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
      }
      if (!stop.stop_requested()) way.go(display);
    });
    ProgramCall call;
    call.words = {"run", "--input", "script", "--no-hints", "--record", path};
    call.environment = display.environment();
    const Outcome outcome = run_ghostforce(call);
    EXPECT_EQ(outcome.exit_code, 6) << way.words;
    EXPECT_NE(outcome.err.find(way.words), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("run.csv"), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.err.find("X Error"), std::string::npos) << outcome.err;
    EXPECT_TRUE(read_whole(path).ends_with("\n# interrupted\n")) << way.words;
    const auto run = load_run(path);
    EXPECT_TRUE(run.is_interrupted);
    expect_repeats(run);
  }
}

TEST(RecordingProgram, EndsByItselfAndOverwritesNothing) {
  const TemporaryFolder folder;
  const Display display(1024, 640);
  const std::string path = folder / "run.csv";
  const auto record = [&] {
    BackgroundProgram program({ghostforce_program(), "run", "--exit-after", "0.3", "--record", path},
                              display.environment());
    while (program.is_running()) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return program.end(0);
  };
  EXPECT_EQ(record(), 0);
  const std::string text = read_whole(path);
  EXPECT_TRUE(load_run(path).warnings.empty());
  EXPECT_EQ(record(), 8);
  EXPECT_EQ(read_whole(path), text);
}

// The same on either face: the simulation knows nothing of them.
TEST(RecordingProgram, BeginsAtRestUnderTheGoalThatWasAskedFor) {
  const Vector<2> goal{-0.005, -0.02};
  const Equilibrium<2> rest = equilibrium_of(StrategyId::naive, load_scene("wall45").settings, goal);
  for (const std::string face : {"stage", "workbench"}) {
    const TemporaryFolder folder;
    const Display display(1024, 640);
    BackgroundProgram program({ghostforce_program(), "run", "--goal-mm=-5,-20", "--view", face, "--exit-after", "0.3",
                               "--record", folder / "run.csv"},
                              display.environment());
    while (program.is_running()) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    EXPECT_EQ(program.end(0), 0);
    const auto run = load_run(folder / "run.csv");
    ASSERT_FALSE(run.ticks.empty());
    for (const RunTick& tick : {run.ticks.front(), run.ticks.back()}) {
      const auto& row = tick.rows[index_of(StrategyId::naive)];
      ASSERT_TRUE(row);
      EXPECT_EQ(tick.goal, goal);
      // A millionth of a metre: a second after the hand has stopped.
      EXPECT_LT(glm::distance(row->device, rest.device), 1e-6);
    }
  }
}

bool has_open(pid_t process, const std::string& path) {
  std::error_code has_just_gone;
  for (const auto& entry :
       std::filesystem::directory_iterator("/proc/" + std::to_string(process) + "/fd", has_just_gone)) {
    if (std::filesystem::read_symlink(entry, has_just_gone).string().starts_with(path)) return true;
  }
  return false;
}

void wait_a_little() {
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
}

BackgroundProgram recording_program(const Display& display, const std::string& path, const std::string& words) {
  const std::string command = "exec " + ghostforce_program() + " run --input script --no-hints --record " + path;
  return BackgroundProgram({"/bin/sh", "-c", command + " 2> " + words}, display.environment());
}

// The end of the recording closes the file; then its person quits.
int end_after_recording(BackgroundProgram& program, const Display& display, const std::string& recorded_in) {
  while (program.is_running() && has_open(program.pid(), recorded_in)) wait_a_little();
  while (program.is_running()) {
    display.act({"key", "ctrl+q"});
    wait_a_little();
  }
  return program.end(0);
}

TEST(RecordingProgram, SaysWhereTheFileTookNoMore) {
  const TemporaryFolder folder;
  const Display display(1024, 640);
  const std::string path = std::filesystem::canonical(folder.path()) / "run.csv";
  const SmallFiles small(100'000);
  BackgroundProgram program = recording_program(display, path, folder / "words");
  while (read_whole(path).empty() && program.is_running()) wait_a_little();
  EXPECT_EQ(end_after_recording(program, display, path), 8);
  const std::string words = read_whole(folder / "words");
  EXPECT_NE(words.find("run.csv cannot be written any further: File too large"), std::string::npos) << words;
}

TEST(RecordingProgram, SaysThatTheFolderHasVanished) {
  const TemporaryFolder folder;
  const Display display(1024, 640);
  const std::string gone = std::filesystem::canonical(folder.path()) / "gone";
  std::filesystem::create_directory(gone);
  BackgroundProgram program = recording_program(display, gone + "/run.csv", folder / "words");
  while (read_whole(gone + "/run.csv").empty() && program.is_running()) wait_a_little();
  std::filesystem::remove_all(gone);
  EXPECT_EQ(end_after_recording(program, display, gone), 8);
  const std::string words = read_whole(folder / "words");
  EXPECT_NE(words.find(" s of recording are lost: "), std::string::npos) << words;
  EXPECT_NE(words.find("gone/run.csv was removed while it was being written"), std::string::npos) << words;
}

TEST(RecordingProgram, IsAskedForAFile) {
  for (const std::string no_file : {"", "-"}) {
    const Outcome outcome = run_ghostforce({"run", "--exit-after", "0.1", "--record", no_file});
    EXPECT_EQ(outcome.exit_code, 2) << no_file;
    EXPECT_NE(outcome.err.find("--record: name a file"), std::string::npos) << outcome.err;
  }
}

}  // namespace
}  // namespace ghostforce::recording_program_test
