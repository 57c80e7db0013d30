// A run driven once more: what simulate wrote, what a servo did under every kind of live change, and what is damaged.
#include "app/replay.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "app/failure.h"
#include "app/recording.h"
#include "app/scene_file.h"
#include "core/play.h"
#include "device/mouse_input.h"
#include "device/servo.h"
#include "ghostforce_version.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce {
namespace {

Settings as_in_file(const Settings& settings) {
  Scene scene;
  scene.settings = settings;
  return rounded_to_file(scene).settings;
}

// A minute at the window, by dice: every setting, pause, single steps, speed, reset, other rates.
std::string recorded_by_dice(unsigned seed, int rounds, int gap_every = 0) {
  std::mt19937 random(seed);
  const auto between = [&](double least, double greatest) {
    return std::uniform_real_distribution<double>(least, greatest)(random);
  };
  const Scene scene = load_scene("wall45");
  ServoCommand command;
  command.settings = scene.settings;
  command.recording = 1;
  command.restart_state = play(scene, last_tick(scene), [](const Snapshot&) {});
  Servo servo(std::make_unique<MouseInput>(), command);
  auto& mouse = dynamic_cast<MouseInput&>(servo.input());
  SampleText text(scene.settings);
  fmt::memory_buffer lines;
  for (int round = 0; round < rounds; ++round) {
    mouse.move_to({between(-0.05, 0.05), between(-0.05, 0.05)}, 0.016);
    Settings& settings = command.settings;
    switch (random() % 16) {
      case 0:
        settings.impedances.k_r = between(0.0, 2000.0);
        break;
      case 1:
        settings.wall_normal_angle = between(-7.0, 7.0);
        break;
      case 2:
        settings.actuated_angle = between(-7.0, 7.0);
        break;
      case 3:
        settings.impedances.believed_k_u = between(20.0, 500.0);
        break;
      case 4:
        settings.impedances.believed_k_u.reset();
        settings.impedances.k_u = between(20.0, 500.0);
        break;
      case 5:
        settings.impedances.chosen_tracking_ratio = between(0.5, 20.0);
        break;
      case 6:
        settings.impedances.chosen_tracking_ratio.reset();
        break;
      case 7:
        settings.active = strategy_catalog()[random() % strategy_count].id;
        settings.wall_point = {between(-0.02, 0.02), between(-0.02, 0.02)};
        break;
      case 8:
        settings.rate = std::floor(between(500.0, 4000.0));
        break;
      case 9:
        ++command.restarts_asked;
        command.restart_state = state_at_start(Vector<2>(between(-0.02, 0.02), between(0.0, 0.02)));
        command.restart_state.tick = static_cast<std::int64_t>(random() % 5000);
        break;
      case 10:
        command.paused = true;
        command.steps_asked += 2;
        break;
      case 11:
        settings.impedances.k_c = random() % 2 == 0 ? std::numeric_limits<double>::infinity() : between(100.0, 1e6);
        settings.mass = between(0.05, 0.5);
        settings.damping = between(2.0, 20.0);
        break;
      case 12:
        command.speed = between(0.01, 2.0);
        break;
      default:
        command.paused = false;
    }
    settings = as_in_file(settings);
    ++command.settings_generation;
    servo.send(command);
    for (int k = 0; k < 16; ++k) servo.wake();
    if (gap_every > 0 && round % gap_every == gap_every - 1) {
      Sample lost;
      servo.take_record(lost);
    }
    for (Sample sample; servo.take_record(sample);) text.append(lines, sample);
    for (Sample sample; servo.take_sample(sample);) {
    }
  }
  EXPECT_EQ(servo.newest().refused_commands, 0U);
  EXPECT_EQ(servo.newest().loop.dropped_records, 0U);
  return run_header(scene, recording_columns) + std::string(lines.data(), lines.size());
}

ReplayReport replay_text(const std::string& text) {
  const auto run = read_run(text, "run.csv");
  return replay(run, [](const ReplayedTick&) {});
}

TEST(Replay, RepeatsWhatAServoDidUnderEveryLiveChangeBitForBit) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE(seed);
    const auto run = read_run(recorded_by_dice(seed, 600), "run.csv");
    EXPECT_TRUE(run.remarks.empty()) << run.remarks.front();
    ASSERT_GT(run.settings.size(), 100U);
    ASSERT_GT(run.states.size(), 10U);
    const ReplayReport report = replay(run, [](const ReplayedTick&) {});
    if (report.first) {
      ADD_FAILURE() << report.first->column << " at " << report.first->time_s << ": " << report.first->recorded
                    << " became " << report.first->replayed;
    }
    EXPECT_EQ(report.skipped, 0);
    EXPECT_EQ(report.compared, static_cast<std::int64_t>(run.ticks.size()));
    EXPECT_GT(report.compared, 5000);
  }
}

TEST(Replay, FindsTheLastBitOfAnyValueThatIsAnother) {
  const auto whole = read_run(recorded_by_dice(4, 60), "run.csv");
  std::mt19937 random(9);
  for (int i = 0; i < 100; ++i) {
    auto run = whole;
    RunTick& tick = run.ticks[random() % run.ticks.size()];
    const StrategyId id = strategy_catalog()[random() % strategy_count].id;
    RunRow& row = *tick.rows[index_of(id)];
    // Where it goes on from a recorded state, only forces are the replay's own.
    const auto which = tick.state != RunTick::none ? 4 + random() % 2 : random() % 6;
    double& value = which == 0   ? row.device.x
                    : which == 1 ? row.device.y
                    : which == 2 ? row.proxy.x
                    : which == 3 ? row.proxy.y
                    : which == 4 ? row.force.x
                                 : row.force.y;
    value = std::nextafter(value, 10.0);
    const ReplayReport report = replay(run, [](const ReplayedTick&) {});
    ASSERT_TRUE(report.first);
    EXPECT_EQ(report.diverging, 1);
    EXPECT_EQ(report.first->time_s, tick.time_s);
    EXPECT_EQ(report.first->strategy, id);
    EXPECT_EQ(report.first->recorded, value);
    EXPECT_EQ(report.first->column.substr(0, 5), which < 2 ? "devic" : which < 4 ? "proxy" : "force");
  }
}

TEST(Replay, GoesOnAfterLostSamples) {
  const auto run = read_run(recorded_by_dice(5, 200, 20), "run.csv");
  EXPECT_EQ(run.dropped, 9U) << "what is lost after the last row does not show";
  const ReplayReport report = replay(run, [](const ReplayedTick&) {});
  EXPECT_FALSE(report.first);
  EXPECT_EQ(report.skipped, 0);
  EXPECT_GE(report.resumed, 9);
}

TEST(Replay, LeavesOutWhatFollowsFromDamage) {
  Scene scene = load_scene("fig3-normal");
  scene.duration = 0.1;
  fmt::memory_buffer rows;
  play(scene, last_tick(scene), [&](const Snapshot& snapshot) {
    append_run_row(rows, snapshot, StrategyId::naive);
    rows.push_back('\n');
  });
  const std::string text = run_header(scene) + std::string(rows.data(), rows.size());
  EXPECT_EQ(replay_text(text).compared, 101);

  std::string damaged = text;
  damaged[damaged.find("\nnaive,0.06,") + 1] = 'x';
  const ReplayReport report = replay_text(damaged);
  EXPECT_FALSE(report.first);
  EXPECT_EQ(report.compared, 60);
  EXPECT_EQ(report.skipped, 40);

  const std::string headless = text.substr(0, text.find("\nnaive,0,")) + text.substr(text.find("\nnaive,0.001,"));
  EXPECT_EQ(replay_text(headless).compared, 0);
  EXPECT_EQ(replay_text(headless).skipped, 100);
}

TEST(Replay, LeavesMeasuredDevicesAsTheyAreAndComparesTheOthers) {
  // As the servo ticks with the device in the hand: tick_measured() of core, with motors that give half of what is
  // asked.
  const Scene scene = load_scene("wall45");
  const TickPlan<2> plan = plan_of(scene.settings);
  TickState<2> state = play(scene, last_tick(scene), [](const Snapshot&) {});
  SampleText text(scene.settings);
  fmt::memory_buffer lines;
  std::uint64_t serial = 0;
  const auto record = [&] {
    Sample sample;
    sample.snapshot = snapshot_of(plan, state);
    for (std::size_t i = 0; i < strategy_count; ++i) sample.velocity[i] = state.strategies[i].motion.velocity;
    sample.settings = scene.settings;
    sample.serial = serial++;
    text.append(lines, sample);
  };
  const StrategyId active = scene.settings.active;
  for (int k = 0; k < 400; ++k) {
    record();
    const double phase = 0.02 * k;
    if (k / 100 % 2 == 0) {
      tick(plan, Vector<2>(0.02 * std::sin(phase), -0.02), state);
    } else {
      const auto& before = state.strategies[index_of(active)];
      tick_measured(plan, active, Vector<2>(0.01 * std::sin(phase), -0.01 * std::cos(phase)),
                    Vector<2>(300.0 * (before.proxy.x - before.motion.position.x), 0.0), 200.0, state);
    }
  }
  std::string file = run_header(scene, recording_columns) + std::string(lines.data(), lines.size());
  const auto run = read_run(file, "run.csv");
  const ReplayReport report = replay(run, [](const ReplayedTick&) {});
  EXPECT_FALSE(report.first);
  EXPECT_EQ(report.compared, 400);
  EXPECT_EQ(report.measured, 199);
  EXPECT_EQ(report.resumed, 4) << "the beginning, and each time motors come on or go off";
  ASSERT_EQ(run.ticks[150].measured, active);

  // A simulated device beside the measured one is compared.
  auto other = run;
  other.ticks[150].rows[index_of(StrategyId::full)]->device.x += 1e-9;
  EXPECT_TRUE(replay(other, [](const ReplayedTick&) {}).first);
}

// --- The command ---

Outcome run_ghostforce(std::vector<std::string> words) {
  return run_program(GHOSTFORCE_PROGRAM, std::move(words));
}

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
  EXPECT_TRUE(says(older, "for the same version only")) << older.err;
}

TEST(ReplayCommand, PlaysTheHandInAnotherSceneAndComparesNothing) {
  const TemporaryFolder folder;
  const std::string run = folder / "run.csv";
  ASSERT_EQ(run_ghostforce({"simulate", "fig1", "--strategy", "all", "-o", run}).exit_code, 0);
  const std::vector<std::string> other{"rendering.tracking_ratio=3"};
  const Outcome set = run_ghostforce({"replay", run, "--set", other[0], "-o", folder / "set.csv"});
  EXPECT_EQ(set.exit_code, 0) << set.err;
  EXPECT_TRUE(says(set, "nothing is compared")) << set.err;
  const Scene scene = load_scene("fig1", other);
  const auto wanted = run_ghostforce({"simulate", "fig1", "--strategy", "all", "--set", other[0]});
  // The recorded hand is that of the scene: so are all rows.
  const std::string found = read_whole(folder / "set.csv");
  EXPECT_EQ(found.substr(found.find("\nfull,0,")), wanted.out.substr(wanted.out.find("\nfull,0,")));
  EXPECT_TRUE(read_run(found, "set.csv").remarks.empty());

  const Outcome named = run_ghostforce({"replay", run, "wall45", "-o", folder / "wall.csv"});
  EXPECT_EQ(named.exit_code, 0) << named.err;
  EXPECT_EQ(read_run(read_whole(folder / "wall.csv"), "f").scene->title, load_scene("wall45").title);
}

// Sanitizers take more memory than any program.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST(ReplayCommand, SaysThatARunIsTooLongForTheMemory) {
  const TemporaryFolder folder;
  std::string text = std::string(run_columns) + "\n";
  for (int k = 0; k < 1'500'000; ++k) text += fmt::format("full,{},0,0,0,0,0,0,0,0\n", k);
  write_whole(folder / "long.csv", text);
  // A tick takes more than 200 bytes.
  const std::string limited = fmt::format("ulimit -v 300000 && exec {} replay {} wall45 -o {}", GHOSTFORCE_PROGRAM,
                                          folder / "long.csv", folder / "out.csv");
  const Outcome outcome = run_program("/bin/sh", {"-c", limited});
  EXPECT_EQ(outcome.exit_code, 8) << outcome.err;
  EXPECT_TRUE(says(outcome, "long.csv: the run is too long for this machine's memory; cut it")) << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "out.csv"));
}
#endif

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
      run_ghostforce({"simulate", "wall45", "--strategy", "all", "--set", "goal.duration_s=100", "-o", run}).exit_code,
      0);
  std::filesystem::create_directory(folder / "out");
  for (const bool is_exact : {true, false}) {
    const Terminal terminal;
    ProgramCall call;
    call.words = {"-c", fmt::format("echo $$; exec {} replay {} {} -o {} 2>{}", GHOSTFORCE_PROGRAM, run,
                                    is_exact ? "" : "--set rendering.tracking_ratio=2", folder / "out/again.csv",
                                    terminal.path())};
    RunningProgram program("/bin/sh", call);
    const pid_t pid = std::stoi(program.next_line(std::chrono::seconds(20)).value_or("0"));
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
    EXPECT_NE(words.find("\rreading ["), std::string::npos) << words;
    EXPECT_NE(words.find("\rreplaying ["), std::string::npos) << words;
    const std::size_t verdict = words.rfind(run + ": " + (is_exact ? "identical" : "nothing is compared"));
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
  EXPECT_TRUE(says(alone, "name one to replay its hand in")) << alone.err;
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
  const Outcome outcome =
      run_program(GHOSTFORCE_PROGRAM, {.words = {"replay", folder / "run.csv", "-o", results / "again.csv"},
                                       .environment = {},
                                       .folder = {},
                                       .out_to = {},
                                       .signal_when_created_in = results.path(),
                                       .signal = SIGINT});
  EXPECT_EQ(outcome.exit_code, 130);
  EXPECT_EQ(results.count(), 0);
}

}  // namespace
}  // namespace ghostforce
