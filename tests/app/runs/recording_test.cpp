// A run written while it is made: whole lines, never over another file, readable at any moment and after any end.
#include "app/runs/recording.h"

#include <signal.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>

#include "app/base/failure.h"
#include "app/files/run_reader.h"
#include "app/runs/replay.h"
#include "device/input/mouse_input.h"
#include "device/input/scripted_input.h"
#include "tests/app/shell/driven_window.h"
#include "tests/support/file_calls.h"
#include "tests/support/small_files.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::recording_test {
namespace {

// Until it is so; a test that waits in vain is ended by ctest.
template <typename Condition>
void wait_until(Condition&& condition) {
  while (!condition()) std::this_thread::sleep_for(std::chrono::milliseconds(2));
}

// A servo on the scripted hand of a scene, stepped by hand, whose samples are marked 1.
struct Stepped {
  Scene scene = load_scene("fig3-normal");
  ServoCommand command;
  std::unique_ptr<Servo> servo;

  Stepped() {
    command.settings = scene.settings;
    command.restart_state = state_at_start(scene.settings, goal_at(scene.goal, 0.0));
    command.recording = 1;
    servo = std::make_unique<Servo>(std::make_unique<ScriptedInput>(scene.goal), command);
  }
  void step(int ticks) {
    for (int k = 0; k < ticks; ++k) servo->step();
  }
};

void expect_repeats(const std::string& path, std::int64_t ticks) {
  const auto run = load_run(path);
  const ReplayReport report = replay(run, [](const ReplayedTick&) {});
  EXPECT_FALSE(report.first) << report.first->column << " at " << report.first->time_s;
  EXPECT_EQ(report.skipped, 0);
  EXPECT_GE(report.compared, ticks);
}

TEST(Recording, IsARunLikeSimulates) {
  const TemporaryFolder folder;
  Stepped stepped;
  {
    Recording recording(folder / "run.csv", stepped.scene, *stepped.servo, 1);
    stepped.step(501);
    recording.end();
    recording.end();
    const RecordingProgress progress = recording.progress();
    EXPECT_NEAR(progress.seconds, 0.501, 1e-9);
    EXPECT_EQ(progress.bytes, read_whole(folder / "run.csv").size());
    EXPECT_EQ(progress.dropped, 0U);
    EXPECT_EQ(progress.error, 0);
  }
  const std::string text = read_whole(folder / "run.csv");
  EXPECT_NE(text.find(",force_y_N,active,goal_kind,device_kind,sent_x_N,sent_y_N,saturated,loop_s,tone_x_N,tone_y_N\n"),
            std::string::npos);
  EXPECT_NE(text.find("\nfull,0,"), std::string::npos);
  EXPECT_NE(text.find(",0,given,simulated,0,0,0,0,0,0\nnaive,0,"), std::string::npos)
      << "the scene's strategy is another";
  EXPECT_NE(text.find(",1,given,simulated,0,0,0,0,0,0\nfull,0.001,"), std::string::npos);
  EXPECT_TRUE(text.ends_with('\n'));
  EXPECT_EQ(text.find("# interrupted"), std::string::npos);
  const auto run = load_run(folder / "run.csv");
  EXPECT_TRUE(run.warnings.empty());
  EXPECT_EQ(run.ticks.size(), 501U);
  expect_repeats(folder / "run.csv", 501);
}

TEST(Recording, NeverOverwrites) {
  const TemporaryFolder folder;
  write_whole(folder / "run.csv", "precious");
  Stepped stepped;
  const auto words_of = [&](const std::string& path) -> std::string {
    try {
      const Recording recording(path, stepped.scene, *stepped.servo, 1);
    } catch (const Failure& failure) {
      EXPECT_EQ(failure.code(), ExitCode::file_trouble);
      return failure.what();
    }
    return "";
  };
  EXPECT_NE(
      words_of(folder / "run.csv").find("already exists, and a recording never overwrites a file; choose another name"),
      std::string::npos);
  EXPECT_EQ(read_whole(folder / "run.csv"), "precious");
  EXPECT_NE(words_of(folder / "no/run.csv").find("create the folder"), std::string::npos);
  EXPECT_NE(words_of(""), "");
  EXPECT_NE(words_of(folder.path()), "");
  EXPECT_EQ(folder.count(), 1);
}

TEST(Recording, CanBeReadWhileItIsMade) {
  const TemporaryFolder folder;
  Stepped stepped;
  const Recording recording(folder / "run.csv", stepped.scene, *stepped.servo, 1);
  for (int ticks = 100; ticks <= 300; ticks += 100) {
    stepped.step(100);
    wait_until([&] { return load_run(folder / "run.csv").ticks.size() == static_cast<std::size_t>(ticks); });
    EXPECT_TRUE(load_run(folder / "run.csv").warnings.empty());
  }
}

TEST(Recording, LeavesOutWhatBelongsToAnother) {
  const TemporaryFolder folder;
  Stepped stepped;
  stepped.step(100);
  stepped.command.recording = 2;
  stepped.servo->send(stepped.command);
  stepped.step(50);
  Recording recording(folder / "run.csv", stepped.scene, *stepped.servo, 2);
  recording.end();
  const auto run = load_run(folder / "run.csv");
  ASSERT_EQ(run.ticks.size(), 50U);
  EXPECT_EQ(run.ticks[0].tick, 100);
  EXPECT_EQ(run.dropped, 0U);
  expect_repeats(folder / "run.csv", 50);
}

TEST(Recording, EndsWhereAReaderWouldTakeNoMore) {
  const Stepped stepped;
  SampleText text(stepped.scene.settings);
  fmt::memory_buffer lines;
  Sample sample;
  sample.settings = stepped.scene.settings;
  const auto takes = [&](double tick) {
    sample.snapshot.tick = static_cast<std::int64_t>(tick);
    return text.append(lines, sample);
  };
  EXPECT_TRUE(takes(5.0));
  EXPECT_TRUE(takes(most_ticks + 5.0));
  const std::size_t size = lines.size();
  EXPECT_FALSE(takes(most_ticks + 6.0));
  EXPECT_EQ(lines.size(), size);
  EXPECT_TRUE(takes(0.0)) << "reset";
}

TEST(Recording, SaysWhatWasLost) {
  const TemporaryFolder folder;
  Stepped stepped;
  stepped.step(static_cast<int>(Servo::sample_capacity) + 25);  // nobody takes them yet
  Recording recording(folder / "run.csv", stepped.scene, *stepped.servo, 1);
  wait_until([&] { return recording.progress().seconds > 8.0; });
  stepped.step(10);
  recording.end();
  EXPECT_EQ(recording.progress().dropped, 25U);
  EXPECT_NE(read_whole(folder / "run.csv").find("\n# dropped 25\n# state t_s="), std::string::npos);
  EXPECT_EQ(load_run(folder / "run.csv").dropped, 25U);
  expect_repeats(folder / "run.csv", static_cast<std::int64_t>(Servo::sample_capacity) + 10);
}

// A file may not grow beyond a limit: as on a disk that is full, a write ends in the middle of a line.
TEST(Recording, EndsWithWholeLinesWhereTheFileTakesNoMore) {
  const TemporaryFolder folder;
  Stepped stepped;
  Recording recording(folder / "run.csv", stepped.scene, *stepped.servo, 1);
  stepped.step(100);
  wait_until([&] { return recording.progress().seconds > 0.099; });
  {
    const SmallFiles small(recording.progress().bytes + 12'345);
    stepped.step(1000);
    wait_until([&] { return recording.progress().error != 0; });
  }
  stepped.step(1000);
  recording.end();
  EXPECT_EQ(recording.progress().error, EFBIG);
  const std::string text = read_whole(folder / "run.csv");
  EXPECT_TRUE(text.ends_with('\n'));
  EXPECT_EQ(text.size(), recording.progress().bytes);
  EXPECT_TRUE(load_run(folder / "run.csv").warnings.empty());
  expect_repeats(folder / "run.csv", 100);
}

TEST(Recording, IsOnTheDiskTwiceASecondAndInTheEnd) {
  const TemporaryFolder folder;
  const std::string real = std::filesystem::canonical(folder.path());
  const std::string path = real + "/run.csv";
  FileCalls calls;
  Stepped stepped;
  const auto synced_bytes = [&] { return calls.last("fdatasync", path).bytes; };
  Recording recording(path, stepped.scene, *stepped.servo, 1);
  for (int i = 0; i < 2; ++i) {
    stepped.step(100);
    wait_until([&] { return recording.progress().seconds > 0.1 * i + 0.099; });
    wait_until([&] { return synced_bytes() == recording.progress().bytes; });
  }
  EXPECT_EQ(calls.count("fsync", real), 1) << "its name";
  EXPECT_FALSE(calls.was_made_by_this_thread("fdatasync")) << "whoever steps the servo waits for no disk";
  stepped.step(100);
  recording.end();
  EXPECT_EQ(synced_bytes(), recording.progress().bytes);
  EXPECT_EQ(synced_bytes(), read_whole(path).size());
  EXPECT_LE((Recording::writes_per_sync + 1) * Recording::writing_period_s, 0.5);
}

TEST(Recording, EndsWhereTheDiskFails) {
  const TemporaryFolder folder;
  FileCalls calls;
  Stepped stepped;
  Recording recording(folder / "run.csv", stepped.scene, *stepped.servo, 1);
  calls.fail("fdatasync", EIO);
  wait_until([&] { return recording.progress().error != 0; });
  recording.end();
  EXPECT_EQ(recording.progress().error, EIO);
  for (const int harmless : {EINVAL, EROFS}) {
    calls.fail("fdatasync", harmless);
    Recording another(folder / std::to_string(harmless), stepped.scene, *stepped.servo, 1);
    another.end();
    EXPECT_EQ(another.progress().error, 0);
  }
}

TEST(Recording, KnowsWhereItIs) {
  const TemporaryFolder folder;
  const std::string real = std::filesystem::canonical(folder.path());
  Stepped stepped;
  const auto end_after = [&](auto&& change) {
    std::filesystem::create_directory(real + "/in");
    Recording recording(real + "/in/run.csv", stepped.scene, *stepped.servo, 1);
    change();
    recording.end();
    std::filesystem::remove_all(real + "/in");
    return recording.found_at();
  };
  EXPECT_EQ(end_after([] {}), real + "/in/run.csv");
  EXPECT_EQ(end_after([&] { std::filesystem::remove_all(real + "/in"); }), "");
  EXPECT_EQ(end_after([&] { std::filesystem::rename(real + "/in/run.csv", real + "/in/other.csv"); }),
            real + "/in/other.csv");
  EXPECT_EQ(end_after([&] { std::filesystem::rename(real + "/in", real + "/out"); }), real + "/out/run.csv");
  EXPECT_EQ(end_after([&] {
              std::filesystem::remove(real + "/in/run.csv");
              write_whole(real + "/in/run.csv", "another's");
            }),
            "");
  EXPECT_EQ(end_after([&] {
              std::filesystem::create_hard_link(real + "/in/run.csv", real + "/second");
              std::filesystem::remove(real + "/in/run.csv");
            }),
            "")
      << "nobody knows its other name";
}

// --- At the window ---

class RecordingWindow : public DrivenWindow {
 protected:
  void record(const std::string& path) {
    act(StartRecording{path});
    frames(2);
  }
  void stop() {
    act(StopRecording{});
    frames(2);
  }
  void press_record_button() { click_at(863.0, 23.0); }
  // The sign in the button is red then.
  bool picture_is_recording() { return pixel(picture(), 863, 23) == session().appearance.theme->problem; }

  TemporaryFolder folder_;
};

TEST_F(RecordingWindow, RepeatsWhatAPersonDidThere) {
  record(folder_ / "run.csv");
  EXPECT_EQ(notice(), "");
  drag(on_window({0.0, 0.0}), on_window({0.02, -0.03}));
  press(key::digit_3);
  session().settings.wall_normal_angle = 2.0 + 1e-15;  // no number of degrees is exactly that
  session().settings.stiffnesses.k_r = 345.678;
  frames(5);
  press(key::z, modifier::control);
  press(key::space);
  press(key::period);
  frames(5);
  press(key::period);
  press(key::space);
  session().speed = 0.1;
  frames(10, 2);
  press(key::r);
  frames(10);
  press(key::left_bracket);
  act(TurnWallToLargestDrift{});
  frames(10);
  press(key::r, modifier::alt);
  frames(10);
  stop();
  EXPECT_TRUE(notice().starts_with("Recorded ")) << notice();
  EXPECT_NE(notice().find(folder_ / "run.csv"), std::string::npos) << notice();
  EXPECT_FALSE(is_problem());
  const auto run = load_run(folder_ / "run.csv");
  EXPECT_GE(run.settings.size(), 5U);
  EXPECT_EQ(run.states.size(), 3U) << "its beginning in mid-motion, and two resets";
  expect_repeats(folder_ / "run.csv", 500);
}

TEST_F(RecordingWindow, RecordsFromTheFirstTickWhenAskedOnTheCommandLine) {
  open({.input = "script", .record = folder_ / "run.csv"}, "fig1");
  frames(20);
  stop();
  const auto run = load_run(folder_ / "run.csv");
  ASSERT_FALSE(run.ticks.empty());
  EXPECT_EQ(run.ticks.front().tick, 0);
  expect_repeats(folder_ / "run.csv", 300);
  EXPECT_THROW(open({.record = folder_ / "run.csv"}), Failure);
}

TEST_F(RecordingWindow, AnotherSceneOrInputEndsIt) {
  record(folder_ / "scene.csv");
  frames(10);
  act(OpenScene{"fig1"});
  frames(2);
  EXPECT_TRUE(notice().starts_with("The recording ended because the scene or the input changed. Recorded "))
      << notice();
  record(folder_ / "input.csv");
  frames(10);
  act(ChooseInput{"script"});
  frames(10);
  EXPECT_TRUE(notice().starts_with("The recording ended because the scene or the input changed. Recorded "))
      << notice();
  EXPECT_EQ(load_run(folder_ / "scene.csv").scene->title, load_scene("wall45").title);
  EXPECT_EQ(load_run(folder_ / "input.csv").scene->title, load_scene("fig1").title);
  expect_repeats(folder_ / "scene.csv", 100);
  expect_repeats(folder_ / "input.csv", 100);
}

TEST_F(RecordingWindow, TellsWhatCannotBeWrittenAndGoesOn) {
  write_whole(folder_ / "run.csv", "precious");
  record(folder_ / "run.csv");
  EXPECT_NE(notice().find("never overwrites a file"), std::string::npos) << notice();
  EXPECT_TRUE(is_problem());
  EXPECT_EQ(read_whole(folder_ / "run.csv"), "precious");
  const std::int64_t tick = now().tick;
  frames(3);
  EXPECT_GT(now().tick, tick);
}

TEST_F(RecordingWindow, SaysSoWhenWhatItRecordsIsGone) {
  std::filesystem::create_directory(folder_ / "gone");
  record(folder_ / "gone/run.csv");
  frames(10);
  std::filesystem::remove_all(folder_ / "gone");
  // It does not wait for the person to end it.
  wait_until([&] {
    frames(1);
    return !notice().empty();
  });
  EXPECT_TRUE(is_problem());
  EXPECT_NE(notice().find(" s of recording are lost: "), std::string::npos) << notice();
  EXPECT_NE(notice().find(folder_ / "gone/run.csv was removed"), std::string::npos) << notice();
  EXPECT_EQ(application_->recording_problem(), notice());

  session().notice.reset();
  record(folder_ / "here.csv");
  frames(10);
  std::filesystem::rename(folder_ / "here.csv", folder_ / "there.csv");
  stop();
  EXPECT_TRUE(is_problem());
  EXPECT_NE(notice().find("there.csv. It was moved there while it was being written, so it is no longer "),
            std::string::npos)
      << notice();
  EXPECT_TRUE(load_run(folder_ / "there.csv").warnings.empty());
}

TEST_F(RecordingWindow, ReplaysARecordingThatIsDropped) {
  record(folder_ / "run.csv");
  drag(on_window({0.0, 0.0}), on_window({-0.02, 0.03}));
  frames(20);
  stop();
  const auto run = load_run(folder_ / "run.csv");
  session().notice.reset();
  const std::string path = folder_ / "run.csv";
  drop({path.c_str()});
  EXPECT_TRUE(notice().starts_with("Replaying ")) << notice();
  EXPECT_EQ(session().input, "replay");
  for (int i = 0; i < 10; ++i) {
    frames(1);
    const RunTick& tick = run.ticks.at(static_cast<std::size_t>(now().tick));
    ASSERT_EQ(now().goal, tick.goal);
    // It began at rest in the wall, and so does this.
    for (std::size_t s = 0; s < strategy_count; ++s) {
      ASSERT_LT(glm::distance(now().strategies[s].device, tick.rows[s]->device), 1e-6);
    }
  }
  // What is none changes nothing.
  const std::string none = folder_ / "none.csv";
  write_whole(none, "hello");
  drop({none.c_str()});
  EXPECT_NE(notice().find("this is not a run"), std::string::npos) << notice();
  EXPECT_EQ(session().input, "replay");
}

// A rehearsal with motors on: the wall is held softer on them, and another strategy takes over while they push.
TEST_F(RecordingWindow, RepeatsWhatIsSimulatedBesideADeviceInTheHand) {
  ApplicationOptions options;
  options.input = "virtual-falcon";
  options.input_options.virtual_falcon_clock = VirtualLink::Clock::stepped;
  open(options);
  session().settings.stiffnesses.k_r = 1200.0;
  constexpr int ticks = 100;
  const auto frames_until = [&](const auto& is_so) {
    for (int i = 0; i < 300 && !is_so(); ++i) frames(1, ticks);
    return is_so();
  };
  ASSERT_TRUE(frames_until([&] { return virtual_falcon().report().state == FalconState::idle; }));
  record(folder_ / "run.csv");
  for (int i = 1; i <= 10; ++i) {
    session().goal = glm::mix(Vector<2>(0.01, -0.01), Vector<2>(-0.015, 0.015), i / 10.0);
    frames(1, ticks);
  }
  frames(10, ticks);
  ++session().arms_asked;
  ASSERT_TRUE(frames_until([&] { return application_->report().motors.state == SafetyState::on; }));
  for (int i = 1; i <= 10; ++i) {
    session().goal = glm::mix(Vector<2>(-0.015, 0.015), Vector<2>(0.012, -0.012), i / 10.0);
    if (i == 8) session().settings.active = StrategyId::anisotropic;
    frames(1, ticks);
  }
  ASSERT_TRUE(now().measured);
  press(key::escape);
  ASSERT_TRUE(frames_until([&] { return application_->report().motors.state == SafetyState::off; }));
  frames(2, ticks);
  stop();

  const std::string text = read_whole(folder_ / "run.csv");
  EXPECT_NE(text.find(",1,estimated,measured,"), std::string::npos);
  EXPECT_NE(text.find(" rendering.k_r_N_per_m=800.0\n"), std::string::npos) << "held lower while armed";
  EXPECT_NE(text.find(" rendering.strategy=\"anisotropic\"\n"), std::string::npos);
  EXPECT_EQ(text.find("nan"), std::string::npos);
  const auto run = load_run(folder_ / "run.csv");
  EXPECT_TRUE(run.warnings.empty()) << run.warnings.front();
  EXPECT_EQ(run.states.size(), 4U) << "its beginning, motors on, another strategy, motors off";
  const ReplayReport report = replay(run, [](const ReplayedTick&) {});
  EXPECT_FALSE(report.first) << report.first->column << " at " << report.first->time_s;
  EXPECT_EQ(report.skipped, 0);
  EXPECT_GT(report.measured, 1000);
  EXPECT_GT(report.compared, report.measured + 1000);
}

TEST_F(RecordingWindow, TheButtonInTheBarBeginsAndEnds) {
  // A name is proposed in the folder that the program was started in.
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder_.path());
  const auto is_on = [&] { return picture_is_recording(); };
  EXPECT_FALSE(is_on());
  press_record_button();
  EXPECT_TRUE(is_on());
  frames(10);
  press_record_button();
  EXPECT_FALSE(is_on());
  std::filesystem::current_path(before);
  EXPECT_TRUE(notice().starts_with("Recorded ")) << notice();
  EXPECT_NE(notice().find(folder_ / "a-wall-at-45-degrees.csv"), std::string::npos) << notice();
  expect_repeats(folder_ / "a-wall-at-45-degrees.csv", 100);
}

}  // namespace
}  // namespace ghostforce::recording_test
