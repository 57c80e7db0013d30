// What is on the screen, handed on: copied as a line, saved with pictures, and taken back in by pasting and dropping.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/files/png_writer.h"
#include "app/files/read_error.h"
#include "app/state/lesson_file.h"
#include "app/state/set_up.h"
#include "app/state/set_up_of.h"
#include "tests/app/shell/driven_window.h"
#include "tests/support/random_set_up.h"
#include "tests/support/set_up_values.h"
#include "tests/support/small_files.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::set_up_window_test {
namespace {

class SetUpWindow : public DrivenWindow {
 protected:
  std::string clipboard() { return window_->clipboard_text().value_or(""); }
  std::string copied() {
    press(key::c, modifier::control);
    return clipboard();
  }
  void paste(const std::string& text) {
    window_->set_clipboard_text(text);
    press(key::v, modifier::control);
  }
  ghostforce::SetUp seen() { return set_up_of(session(), application_->shown()); }
};

TEST_F(SetUpWindow, ALineIsAllThatItTakesToShowTheSameAgain) {
  Random random(18);
  for (int i = 0; i < 25; ++i) {
    auto set_up = random_set_up(random);
    // Round and round has the hand on a circle, and what it is about is the goal inside.
    if (set_up.mode == StageMode::round) set_up.mode = StageMode::none;
    const std::string line = set_up_line(set_up);
    paste(line);
    ASSERT_FALSE(is_problem()) << notice();
    ASSERT_EQ(set_up_values(seen()), set_up_values(set_up)) << line;
    ASSERT_EQ(copied(), line);
  }
}

TEST_F(SetUpWindow, CopiesWhatAPersonHasDoneOnBothFaces) {
  EXPECT_EQ(copied(), "ghostforce run wall45 --view workbench") << "nothing has been done yet";
  press(key::f4);
  EXPECT_EQ(copied(), "ghostforce run wall45 --view stage");
  press(key::digit_1);
  press(key::right);
  press(key::y);
  session().settings.stiffnesses.believed_k_u = 50.0;
  frames(2);
  const std::string line = copied();
  EXPECT_TRUE(line.starts_with("ghostforce run wall45 --set user.believed_k_u_N_per_m=50.0 --goal-mm=")) << line;
  EXPECT_TRUE(line.ends_with(" --strategy full --view stage --mode why")) << line;
  open({});
  paste(line);
  EXPECT_EQ(session().face, Face::stage);
  EXPECT_EQ(session().stage.mode, StageMode::why);
  EXPECT_EQ(session().settings.active, StrategyId::full);
  EXPECT_EQ(copied(), line);
  // The hand is at rest there, and comes back to it.
  const Vector<2> goal = session().goal;
  EXPECT_EQ(now().goal, goal);
  press(key::left, modifier::control);
  press(key::r);
  EXPECT_EQ(session().goal, goal);
}

TEST_F(SetUpWindow, CopiesTheMomentThatSomebodyLooksBackAt) {
  const Vector<2> goal = session().goal;
  frames(10);
  session().goal = {0.0, 0.03};
  session().settings.stiffnesses.k_u = 300.0;
  frames(10);
  session().stage.looks_back_to_s = now().time_s - 0.2;
  frames(2);
  const auto past = read_set_up_line(copied());
  EXPECT_EQ(past.goal, goal);
  EXPECT_EQ(past.scene.settings.stiffnesses.k_u, load_scene("wall45").settings.stiffnesses.k_u);
}

TEST_F(SetUpWindow, UndoTakesAPasteBackAndRedoBringsItAgain) {
  press(key::f4);
  press(key::right, modifier::control);
  press(key::digit_1);
  const auto before = set_up_values(seen());
  paste("ghostforce run fig3-normal --goal-mm=5,-5 --view workbench");
  const auto pasted = set_up_values(seen());
  EXPECT_NE(pasted, before);
  press(key::z, modifier::control);
  EXPECT_EQ(session().face, Face::stage);
  EXPECT_EQ(set_up_values(seen()), before);
  press(key::y, modifier::control);
  EXPECT_EQ(set_up_values(seen()), pasted);
}

// Wherever the hand of the scene before was.
TEST_F(SetUpWindow, TheStageShowsHandAndHandleOfWhatIsPasted) {
  open({.face = Face::stage});
  frames(30);
  for (const std::string line : {"ghostforce run fig1 --view stage", "ghostforce run wall45 --view stage",
                                 "ghostforce run fig3-nonactuated --view stage --goal-mm=300,-700"}) {
    paste(line);
    frames(60);
    const StagePicture& shown = screen().stage().picture();
    const StageMoment rest = stage_moment_at_rest(session().settings, session().goal);
    for (const Vector<2>& place : {session().goal, rest.handle}) {
      EXPECT_TRUE(contains(shown.scene, to_screen(shown.pane.camera, place))) << line;
    }
  }
}

TEST_F(SetUpWindow, UndoOfAPasteInALessonBringsBackWhatWasBeforeIt) {
  ApplicationOptions options{.face = Face::workbench};
  options.lesson = std::make_shared<const Lesson>(load_lesson("feel-a-wall"));
  open(options);
  frames(30);
  const Settings before = session().lesson->before.settings;
  ASSERT_NE(session().settings, before) << "the lesson has its own";
  paste("ghostforce run fig1 --view stage");
  ASSERT_FALSE(session().lesson);
  press(key::z, modifier::control);
  EXPECT_EQ(session().settings, before);
  EXPECT_EQ(session().face, Face::workbench);
}

TEST_F(SetUpWindow, APasteThatIsNoSetUpIsSaidAndChangesNothing) {
  press(key::right);
  const auto before = set_up_values(seen());
  const std::string undo = session().undo_offer.undo;
  for (const std::string text : {"", "Dear colleague,", "ghostforce run wal45", "ghostforce run --record x.csv",
                                 "ghostforce run 'wall45", "\x1b[2J"}) {
    paste(text);
    EXPECT_TRUE(is_problem()) << text;
    EXPECT_NE(notice().find("The clipboard holds no set-up: "), std::string::npos) << notice();
    EXPECT_EQ(set_up_values(seen()), before);
    press(key::escape);
  }
  EXPECT_EQ(session().undo_offer.undo, undo);
}

TEST_F(SetUpWindow, KeepsTheInput) {
  act(ChooseInput{"virtual-falcon"});
  frames(2);
  paste("ghostforce run fig1 --strategy full");
  EXPECT_EQ(session().input, "virtual-falcon");
  act(ChooseInput{"script"});
  frames(2);
  paste("ghostforce run fig1 --goal-mm=5,-5");
  EXPECT_EQ(session().input, "script");
}

TEST_F(SetUpWindow, EndsAndBeginsRoundAndRound) {
  paste("ghostforce run wall45 --mode round");
  frames(3);
  EXPECT_EQ(session().input, "circle");
  const std::string line = copied();
  EXPECT_EQ(line, "ghostforce run wall45 --view stage --mode round");
  frames(60);
  EXPECT_EQ(copied(), line) << "wherever on the circle";
  paste("ghostforce run fig1 --mode round");
  frames(3);
  EXPECT_EQ(session().input, "circle");
  EXPECT_EQ(copied(), "ghostforce run fig1 --view stage --mode round");
  paste("ghostforce run fig1");
  frames(3);
  EXPECT_EQ(session().input, "mouse");
}

TEST_F(SetUpWindow, LeavesAFieldItsOwnKeys) {
  press(key::s, modifier::control);
  frames(4);
  window_->set_clipboard_text("ghostforce run fig1");
  press(key::v, modifier::control);
  EXPECT_EQ(session().scene->title, load_scene("wall45").title);
}

TEST_F(SetUpWindow, ADroppedPictureShowsWhatIsOnIt) {
  const TemporaryFolder folder;
  press(key::f4);
  press(key::right, modifier::control);
  press(key::digit_1);
  press(key::y);
  const auto saved = set_up_values(seen());
  const std::vector<std::string> names{"a.png", "b.svg", "c.pdf"};
  for (const std::string& name : names) {
    act(SavePicture{folder / name});
    frames(2);
  }
  // A name tells nothing here.
  write_whole(folder / "d.toml", read_whole(folder / "a.png"));
  for (const std::string name : {"a.png", "b.svg", "c.pdf", "d.toml"}) {
    open({}, "fig1");
    const std::string path = folder / name;
    drop({path.c_str()});
    EXPECT_FALSE(is_problem()) << notice();
    EXPECT_EQ(set_up_values(seen()), saved) << name;
    press(key::z, modifier::control);
    EXPECT_EQ(session().scene->title, load_scene("fig1").title);
  }
}

TEST_F(SetUpWindow, SaysWhatCanBeDropped) {
  const TemporaryFolder folder;
  const auto before = set_up_values(seen());
  const std::vector<std::pair<std::string, std::string>> files{
      {"letter.txt", "Dear colleague,"},
      {"empty", ""},
      {"program", std::string("\x7f"
                              "ELF\0\0",
                              6)},
  };
  for (const auto& [name, text] : files) {
    const std::string path = folder / name;
    write_whole(path, text);
    drop({path.c_str()});
    EXPECT_TRUE(is_problem()) << name;
    EXPECT_NE(notice().find("What can be dropped here: a picture that ghostforce has saved (.png, .svg, .pdf); a "),
              std::string::npos)
        << notice();
  }
  const std::string path = folder / ".";
  drop({path.c_str()});
  EXPECT_NE(notice().find("is a folder.\nWhat can be dropped here: "), std::string::npos) << notice();
  write_whole(folder / "plain.png", png_bytes(picture()));
  const std::string plain = folder / "plain.png";
  drop({plain.c_str()});
  EXPECT_NE(notice().find("plain.png: the picture does not say what it shows"), std::string::npos) << notice();
  EXPECT_EQ(set_up_values(seen()), before);
}

TEST_F(SetUpWindow, SaysThatOnlyTheFirstOfSeveralFilesIsOpen) {
  const TemporaryFolder folder;
  write_whole(folder / "a.toml", scene_text(load_scene("fig1")));
  write_whole(folder / "b.toml", scene_text(load_scene("fig3-normal")));
  const std::string a = folder / "a.toml";
  const std::string b = folder / "b.toml";
  drop({a.c_str(), b.c_str()});
  EXPECT_EQ(session().scene->title, load_scene("fig1").title);
  EXPECT_NE(notice().find("Only one file can be open at a time"), std::string::npos) << notice();
  EXPECT_NE(notice().find("a.toml"), std::string::npos) << notice();
}

}  // namespace
}  // namespace ghostforce::set_up_window_test
