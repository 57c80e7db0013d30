// What was done in a window, recorded and done again in another one: the same values, bit for bit, and nothing besides.
#include "app/shell/session_replay.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "app/picture/handles.h"
#include "app/state/set_up.h"
#include "app/state/set_up_of.h"
#include "tests/app/shell/recorded_window.h"
#include "tests/support/program.h"
#include "tests/support/shrink.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::session_replay_test {
namespace {

class SessionReplayTest : public RecordedWindow {
 protected:
  // All that a person could tell two sessions apart by, with every digit.
  std::string state() {
    const Session& now_session = session();
    std::string text = set_up_line(set_up_of(now_session, application_->shown()));
    for (const auto& each : now().strategies)
      text += fmt::format("\n{} {} {} {}", each.device.x, each.device.y, each.force.x, each.force.y);
    return text + fmt::format("\n{} {} {} {} {} {} {} {} {} {} {}", now().tick, now_session.paused,
                              now_session.appearance.theme->name, now_session.appearance.scale,
                              static_cast<int>(now_session.options.compare), now_session.plots.is_open,
                              static_cast<int>(now_session.dialog), now_session.language, now_session.input,
                              now_session.undo_offer.undo, now_session.undo_offer.redo);
  }
  RecordedSession recorded() {
    end_recorded();
    return load_session(path_);
  }
  // Of a person who does a bit of everything.
  void do_much() {
    drag(on_window(session().goal), on_window({0.02, -0.01}));
    press(key::digit_2);
    press(key::digit_3, modifier::shift);
    press(key::f4);
    act(TurnWallTo{2.0});
    drag(on_window(session().goal), on_window({-0.01, 0.012}));
    act(ChangeStiffnesses{{300.0, 250.0, 700.0, 650.0, 1e5, 2.5}});
    press(key::z, modifier::control);
    act(ToggleViewOption{&ViewOptions::trails});
    press(key::v);
    frames(20);
    act(ChooseInput{"circle"});
    frames(40);
    act(OpenScene{"fig1"});
    frames(10);
    act(SaveScene{folder_ / "saved.toml"});
    act(StartRecording{folder_ / "run.csv"});
    frames(10);
    press(key::space);
    frames(3);
  }

  TemporaryFolder folder_;
  std::string path_ = folder_ / "a.session";
};

TEST_F(SessionReplayTest, ComesToTheSameEnd) {
  for (const Face face : {Face::stage, Face::workbench}) {
    std::filesystem::remove(path_);
    open_recorded(path_, {.face = face});
    frames(3);
    do_much();
    const RecordedSession session = recorded();
    const std::string end = state();
    for (int i = 0; i < 2; ++i) {
      open_replayed(session);
      replay_whole();
      EXPECT_EQ(state(), end) << i;
      EXPECT_EQ(replay_->counts().done + replay_->counts().refused + replay_->counts().left_out,
                session.actions.size());
      EXPECT_EQ(replay_->counts().left_out, 2U);
    }
    std::filesystem::remove(folder_ / "saved.toml");
    std::filesystem::remove(folder_ / "run.csv");
  }
}

TEST_F(SessionReplayTest, ADragIsOneStepToTakeBack) {
  open_recorded(path_, {.face = Face::workbench});
  frames(3);
  const double before = session().settings.wall_normal_angle;
  const auto grips = wall_grips(session().settings, screen().panes()[0].camera, 1.0);
  ASSERT_TRUE(grips);
  const Vector<2> grip = in_window((*grips)[0]);
  drag(grip, grip + Vector<2>(60.0, 60.0));
  EXPECT_NE(session().settings.wall_normal_angle, before);
  press(key::z, modifier::control);
  ASSERT_EQ(session().settings.wall_normal_angle, before);
  const RecordedSession session_then = recorded();
  const auto is_turn = [](const TimedAction& timed) { return std::holds_alternative<TurnWallTo>(timed.action); };
  EXPECT_GT(std::ranges::count_if(session_then.actions, is_turn), 1);
  open_replayed(session_then);
  replay_whole();
  EXPECT_EQ(session().settings.wall_normal_angle, before);
  EXPECT_FALSE(session().is_editing);
}

TEST_F(SessionReplayTest, SaysHowFarItIsOnBothFaces) {
  ApplicationOptions options{.face = Face::stage};
  options.language = "es";
  open_recorded(path_, options);
  frames(5);
  act(TurnWallTo{2.0});
  frames(5);
  act(SwitchFace{});
  frames(5);
  EXPECT_FALSE(says("replay: ")) << "it is none";
  const RecordedSession session_then = recorded();
  const std::size_t all = session_then.actions.size();
  open_replayed(session_then);
  for (int i = 0; i < 9; ++i) replay_->step();
  const auto is_early = [](const TimedAction& timed) { return timed.time_s < 0.16; };
  const auto done = std::ranges::count_if(session_then.actions, is_early);
  ASSERT_LT(static_cast<std::size_t>(done), all);
  ASSERT_EQ(session().face, Face::stage);
  EXPECT_TRUE(says(fmt::format("repetición: {} de {}", done, all)));
  replay_whole();
  ASSERT_EQ(session().face, Face::workbench);
  EXPECT_TRUE(says("The replay is over. Everything is yours again."));
  EXPECT_FALSE(session().notice);
  press(key::f4);
  EXPECT_EQ(session().face, Face::stage) << "and so it is";
  EXPECT_FALSE(says("repetición")) << "whoever goes on has read it";
}

TEST_F(SessionReplayTest, SaysItInLettersAsLargeAsTheStages) {
  ApplicationOptions options{.face = Face::stage};
  options.language = "es";
  for (const auto& [width, height] : {std::pair{1280, 720}, std::pair{640, 700}, std::pair{2560, 1440}}) {
    std::filesystem::remove(path_);
    open_recorded(path_, options, "wall45", width, height);
    frames(3);
    open_replayed(recorded());
    replay_whole();
    const std::vector<ScreenWords> all = words_on_screen();
    const auto found = std::ranges::find_if(
        all, [](const ScreenWords& words) { return words.text.starts_with("La repetición ha terminado."); });
    ASSERT_NE(found, all.end()) << width;
    EXPECT_TRUE(found->clip.Contains(found->ink)) << width;
    const double letters = 28.0 * screen().stage().picture().unit;
    EXPECT_GT(static_cast<double>(found->ink.GetHeight()), 0.6 * letters) << width;
  }
}

TEST_F(SessionReplayTest, WhatIsPastedIsInTheFile) {
  open_recorded(path_);
  window_->set_clipboard_text("ghostforce run wall45 --set wall.normal_deg=100.0 --view workbench");
  act(PasteSetUp{});
  frames(2);
  const double angle = session().settings.wall_normal_angle;
  const RecordedSession session_then = recorded();
  open_replayed(session_then);
  window_->set_clipboard_text("something else");
  replay_whole();
  EXPECT_EQ(session().settings.wall_normal_angle, angle);
  EXPECT_EQ(window_->clipboard_text(), "something else");
}

TEST_F(SessionReplayTest, WritesAndCopiesNothingAndStays) {
  open_recorded(path_);
  act(Undo{});
  const RecordedSession start = recorded();
  RecordedSession session = start;
  session.actions.clear();
  const std::string file = folder_ / "never";
  for (const Action& action :
       {Action(SaveScene{file}), Action(SavePicture{file, 1, true}), Action(SavePlots{file, true}),
        Action(SaveClip{file, 1.0, 1.0, 30}), Action(StartRecording{file}), Action(CopyPicture{}), Action(CopyValues{}),
        Action(CopySetUp{}), Action(Quit{true}), Action(ToggleFullScreen{}), Action(ToggleAudience{}),
        Action(ChooseInput{"falcon"})}) {
    session.actions.push_back({0.1, action});
  }
  session.end_s = 0.2;
  open_replayed(session);
  window_->set_clipboard_text("mine");
  replay_whole();
  EXPECT_EQ(replay_->counts().left_out, session.actions.size());
  EXPECT_EQ(folder_.count(), 1);  // the session's own file
  EXPECT_EQ(window_->clipboard_text(), "mine");
  EXPECT_FALSE(window_->should_close());
  EXPECT_EQ(this->session().input, "mouse");
}

TEST_F(SessionReplayTest, WhoWatchesChangesNothingAndMayLeave) {
  open_recorded(path_);
  open_replayed({recorded().start, {}, 1.0});
  replay_->step();
  press(key::digit_2);
  drag(on_window(session().goal), on_window({0.02, -0.01}));
  EXPECT_EQ(session().settings, session().scene->settings);
  EXPECT_EQ(session().goal, session().scene->goal.points.back());
  press(key::q, modifier::control);
  EXPECT_TRUE(window_->should_close());
}

// The last line of a program that has crashed is what it was about to do.
TEST_F(SessionReplayTest, ALineIsThereBeforeItsActionIsDone) {
  open_recorded(path_);
  const double before = session().settings.wall_normal_angle;
  double told = 0.0;
  application_.reset();
  recorder_ = std::make_unique<SessionRecorder>(folder_ / "b.session", SessionStart{});
  ApplicationOptions options;
  options.inputs = simulated_inputs();
  options.watch_actions = [&](double time_s, const Action& action) {
    recorder_->write(time_s, action);
    told = session().settings.wall_normal_angle;
    EXPECT_NE(read_whole(folder_ / "b.session").find("turn-wall-to angle=1\n"), std::string::npos);
  };
  application_ = std::make_unique<Application>(*window_, load_scene("wall45"), options);
  application_->act(TurnWallTo{1.0});
  EXPECT_EQ(told, before);
  EXPECT_EQ(session().settings.wall_normal_angle, 1.0);
}

TEST_F(SessionReplayTest, NeverOverwritesAFile) {
  write_whole(path_, "mine");
  EXPECT_THROW(SessionRecorder(path_, {}), Failure);
  EXPECT_EQ(read_whole(path_), "mine");
}

TEST_F(SessionReplayTest, TheShortestListThatFailsIsFound) {
  open_recorded(path_);
  for (int i = 0; i < 6; ++i) {
    act(TurnWallTo{0.1 * i});
    act(i == 2 ? Action(NextTheme{}) : Action(NextCompareMode{}));
    act(i == 4 ? Action(TogglePlots{}) : Action(ChooseStrategy{StrategyId::naive, false}));
  }
  const RecordedSession session_then = recorded();
  const auto fails = [&](const std::vector<TimedAction>& actions) {
    open_replayed({session_then.start, actions, actions.empty() ? 0.0 : actions.back().time_s});
    replay_whole();
    return session().appearance.theme != &theme_catalog().front() && session().plots.is_open;
  };
  ASSERT_TRUE(fails(session_then.actions));
  const auto left = shrink<TimedAction>(session_then.actions, fails);
  ASSERT_EQ(left.size(), 2U);
  EXPECT_TRUE(std::holds_alternative<NextTheme>(left[0].action));
  EXPECT_TRUE(std::holds_alternative<TogglePlots>(left[1].action));
}

TEST_F(SessionReplayTest, TheProgramReplaysItWithoutADisplay) {
  open_recorded(path_);
  frames(3);
  do_much();
  const RecordedSession session_then = recorded();
  open_replayed(session_then);
  replay_whole();
  for (int i = 0; i < 2; ++i) {
    const Outcome outcome = run_ghostforce({"replay-session", path_, "--headless"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.out, replay_->result());
    EXPECT_NE(outcome.err.find("2 of"), std::string::npos) << outcome.err;
  }
  EXPECT_EQ(run_ghostforce({"replay-session", folder_ / "none", "--headless"}).exit_code, 2);
  write_whole(folder_ / "wrong", start_line(session_then.start) + "1 fly\n");
  const Outcome wrong = run_ghostforce({"replay-session", folder_ / "wrong", "--headless"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_NE(wrong.err.find(":2:3: 'fly'"), std::string::npos) << wrong.err;
}

}  // namespace
}  // namespace ghostforce::session_replay_test
