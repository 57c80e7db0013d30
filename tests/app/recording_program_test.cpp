// The whole program while it records, and its sudden ends.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <thread>

#include "app/replay.h"
#include "app/run_reader.h"
#include "tests/support/display.h"
#include "tests/support/program.h"
#include "tests/support/small_files.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce {
namespace {

// Records until the file has grown for a while, then gets the signal; returns the exit code.
int record_until(int signal, const std::string& path) {
  const Display display(1024, 640);
  BackgroundProgram program({GHOSTFORCE_PROGRAM, "run", "--input", "script", "--no-hints", "--record", path},
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
    EXPECT_TRUE(run.remarks.empty());
    expect_repeats(run);
  }
}

TEST(RecordingProgram, TheDisplayGoesItSaysSoAndClosesTheFile) {
  const TemporaryFolder folder;
  const Display display(1024, 640);
  const std::string path = folder / "run.csv";
  std::jthread crash([&](const std::stop_token& stop) {
    while (read_whole(path).size() < 500'000 && !stop.stop_requested()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    display.lose();
  });
  ProgramCall call;
  call.words = {"run", "--input", "script", "--no-hints", "--record", path};
  call.environment = display.environment();
  const Outcome outcome = run_program(GHOSTFORCE_PROGRAM, call);
  EXPECT_EQ(outcome.exit_code, 6);
  EXPECT_NE(outcome.err.find("the display is gone: "), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("run.csv"), std::string::npos) << outcome.err;
  EXPECT_TRUE(read_whole(path).ends_with("\n# interrupted\n"));
  const auto run = load_run(path);
  EXPECT_TRUE(run.is_interrupted);
  expect_repeats(run);
}

TEST(RecordingProgram, EndsByItselfAndOverwritesNothing) {
  const TemporaryFolder folder;
  const Display display(1024, 640);
  const std::string path = folder / "run.csv";
  const auto record = [&] {
    BackgroundProgram program({GHOSTFORCE_PROGRAM, "run", "--exit-after", "0.3", "--record", path},
                              display.environment());
    while (program.is_running()) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return program.end(0);
  };
  EXPECT_EQ(record(), 0);
  const std::string text = read_whole(path);
  EXPECT_TRUE(load_run(path).remarks.empty());
  EXPECT_EQ(record(), 8);
  EXPECT_EQ(read_whole(path), text);
}

TEST(RecordingProgram, SaysWhereTheFileTookNoMore) {
  const TemporaryFolder folder;
  const Display display(1024, 640);
  ProgramCall call;
  call.words = {"run", "--input", "script", "--exit-after", "2", "--record", folder / "run.csv"};
  call.environment = display.environment();
  const SmallFiles small(100'000);
  const Outcome outcome = run_program(GHOSTFORCE_PROGRAM, call);
  EXPECT_EQ(outcome.exit_code, 8);
  EXPECT_NE(outcome.err.find("run.csv takes no more: File too large"), std::string::npos) << outcome.err;
}

TEST(RecordingProgram, SaysThatTheFolderHasVanished) {
  const TemporaryFolder folder;
  const Display display(1024, 640);
  std::filesystem::create_directory(folder / "gone");
  ProgramCall call;
  call.words = {"-c", std::string(GHOSTFORCE_PROGRAM) + " run --input script --exit-after 3 --record gone/run.csv & " +
                          "until test -s gone/run.csv; do sleep 0.1; done; rm -r gone; wait $!"};
  call.environment = display.environment();
  call.folder = folder.path();
  const Outcome outcome = run_program("/bin/sh", call);
  EXPECT_EQ(outcome.exit_code, 8);
  EXPECT_NE(outcome.err.find("The recording is lost, "), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("gone/run.csv was removed while it was written"), std::string::npos) << outcome.err;
}

TEST(RecordingProgram, IsAskedForAFile) {
  for (const std::string no_file : {"", "-"}) {
    const Outcome outcome = run_program(GHOSTFORCE_PROGRAM, {"run", "--exit-after", "0.1", "--record", no_file});
    EXPECT_EQ(outcome.exit_code, 2) << no_file;
    EXPECT_NE(outcome.err.find("--record: name a file"), std::string::npos) << outcome.err;
  }
}

}  // namespace
}  // namespace ghostforce
