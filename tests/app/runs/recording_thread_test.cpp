// A recording of a servo that runs: two threads and the ring between them, without a window.
#include <chrono>
#include <memory>
#include <thread>

#include <gtest/gtest.h>

#include "app/files/run_reader.h"
#include "app/files/scene_file.h"
#include "app/runs/recording.h"
#include "app/runs/replay.h"
#include "device/input/scripted_input.h"
#include "device/servo/servo_thread.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::recording_thread_test {
namespace {

TEST(RecordingThread, TakesEverythingFromARunningServo) {
  const TemporaryFolder folder;
  const Scene scene = load_scene("fig3-normal");
  ServoCommand command;
  command.settings = scene.settings;
  command.restart_state = state_at_start(scene.settings, goal_at(scene.goal, 0.0));
  command.recording = 1;
  Servo servo(std::make_unique<ScriptedInput>(scene.goal), command);
  Recording recording(folder / "run.csv", scene, servo, 1);
  ServoThread thread;
  thread.start(servo);
  // In vain: ctest ends the test.
  while (recording.progress().seconds < 0.4) std::this_thread::sleep_for(std::chrono::milliseconds(2));
  thread.stop();
  recording.end();
  const auto run = load_run(folder / "run.csv");
  ASSERT_FALSE(run.ticks.empty());
  EXPECT_EQ(run.ticks.back().tick, servo.newest().snapshot.tick);
  const ReplayReport report = replay(run, [](const ReplayedTick&) {});
  EXPECT_FALSE(report.first) << report.first->column << " at " << report.first->time_s;
  EXPECT_EQ(report.skipped, 0);
  EXPECT_GE(report.compared, 400);
}

}  // namespace
}  // namespace ghostforce::recording_thread_test
