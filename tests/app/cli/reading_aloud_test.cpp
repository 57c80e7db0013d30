// What the window says to those who do not look at it: on both faces, paused, looking back, in a mode, with a device.
#include "app/cli/reading_aloud.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <sstream>
#include <string>
#include <vector>

#include "app/shell/preferences.h"
#include "tests/app/shell/driven_window.h"
#include "tests/support/screen_text.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::reading_aloud_test {
namespace {

struct Line {
  std::string sentence;
  std::string strategy;
  std::string force;
  std::string wall_share;
  std::string ghost_force;
  std::string slide;
  double time_s = 0.0;
};

class ReadingAloudTest : public DrivenWindow {
 protected:
  ReadingAloudTest() {
    std::array<int, 2> ends{};
    EXPECT_EQ(pipe2(ends.data(), O_CLOEXEC), 0);
    reads_ = ends[0];
    writes_ = ends[1];
    open({.face = Face::stage});
    reader_.emplace(60.0, writes_);
    EXPECT_TRUE(next_text().starts_with("# sentence"));
  }
  ~ReadingAloudTest() override {
    reader_.reset();
    close(writes_);
    close_reader();
  }

  void close_reader() {
    if (reads_ >= 0) close(reads_);
    reads_ = -1;
  }
  std::string next_text() const {
    std::string text;
    for (char letter = 0; read(reads_, &letter, 1) == 1 && letter != '\n';) text += letter;
    return text;
  }
  // What is printed of the present; waits for it, so there must be something new.
  Line next_line() {
    reader_->follow(*application_, frame_s);
    std::istringstream columns(next_text());
    Line line;
    for (std::string* column :
         {&line.sentence, &line.strategy, &line.force, &line.wall_share, &line.ghost_force, &line.slide}) {
      std::getline(columns, *column, '\t');
    }
    columns >> line.time_s;
    return line;
  }

  std::optional<ReadingAloud> reader_;
  int reads_ = -1;
  int writes_ = -1;
};

TEST_F(ReadingAloudTest, FollowsTheStage) {
  const Line naive = next_line();
  EXPECT_EQ(naive.sentence, "A ghost force drags the handle along the wall.");
  EXPECT_EQ(naive.strategy, "naive");
  EXPECT_EQ(naive.ghost_force, "1.27");
  EXPECT_EQ(naive.slide, "12.0");
  press(key::digit_3);
  frames(120);
  const Line cured = next_line();
  EXPECT_EQ(cured.sentence, "Same motor, same hand: the ghost force is gone.");
  EXPECT_EQ(cured.strategy, "anisotropic");
  EXPECT_EQ(cured.ghost_force, "0.00");
  EXPECT_GT(cured.time_s, naive.time_s);
}

TEST_F(ReadingAloudTest, SaysTheSameOnTheWorkbenchWhateverTheStageWasDoing) {
  const Line stage = next_line();
  press(key::y);
  EXPECT_EQ(next_line().sentence, "A wall pushes straight out. One motor cannot.");
  press(key::f4);
  const Line workbench = next_line();
  EXPECT_EQ(workbench.sentence, stage.sentence);
  EXPECT_EQ(workbench.ghost_force, stage.ghost_force);
  press(key::digit_3);
  frames(120);
  EXPECT_EQ(next_line().sentence, "Same motor, same hand: the ghost force is gone.");
}

TEST_F(ReadingAloudTest, KeepsTheAnswerToAGuessHidden) {
  next_line();
  press(key::q);
  const Line question = next_line();
  EXPECT_EQ(question.sentence, "One motor. Where will the handle come to rest?");
  EXPECT_EQ(question.force + question.wall_share + question.ghost_force + question.slide, "----");
}

TEST_F(ReadingAloudTest, SaysThatItIsPausedAndWhatWasThen) {
  session().goal = {0.03, -0.03};
  frames(60);
  const Line present = next_line();
  press(key::space);
  EXPECT_EQ(next_line().sentence, "Paused. Press Space to go on.");
  session().stage.looks_back_to_s = now().time_s - 0.9;
  frames(2);
  const Line past = next_line();
  EXPECT_LT(past.time_s, present.time_s - 0.8);
  EXPECT_NE(past.ghost_force, present.ghost_force);
  EXPECT_NE(past.sentence, "Paused. Press Space to go on.");
}

TEST_F(ReadingAloudTest, TheShowForPassersByIsNotReadAloud) {
  const Line before = next_line();
  application_->update(30.0);  // nobody has touched anything
  for (int i = 0; i < 60; ++i) {
    application_->frame(0.25);
    ASSERT_EQ(application_->stage_reading().sentence, before.sentence);
  }
  EXPECT_TRUE(screen().stage().is_moving()) << "the show has begun";
}

TEST_F(ReadingAloudTest, OfADeviceItSaysWhatCannotBeKnown) {
  open({.face = Face::stage, .input = "virtual-falcon"});
  const Line line = next_line();
  EXPECT_EQ(line.sentence, "The device is not ready: F2 says what to do.");
}

TEST_F(ReadingAloudTest, AReaderThatHasGoneEndsThePrinting) {
  std::signal(SIGPIPE, SIG_IGN);
  next_line();
  close_reader();
  press(key::f4);
  press(key::y);
  while (reader_->output_problem() == 0) {
    press(key::space);
    reader_->follow(*application_, frame_s);
  }
  EXPECT_EQ(reader_->output_problem(), EPIPE);
  EXPECT_FALSE(session().notice) << "that is no problem of the person's";
}

TEST_F(ReadingAloudTest, AFullDiskIsSaid) {
  const int full = ::open("/dev/full", O_WRONLY | O_CLOEXEC);
  ASSERT_GE(full, 0);
  ReadingAloud to_disk(60.0, full);
  while (to_disk.output_problem() == 0) to_disk.follow(*application_, frame_s);
  EXPECT_EQ(to_disk.output_problem(), ENOSPC);
  EXPECT_TRUE(notice().starts_with("The values are no longer printed: No space left"));
}

TEST_F(ReadingAloudTest, FinishedItKnowsWhatBecameOfTheLastLine) {
  const int full = ::open("/dev/full", O_WRONLY | O_CLOEXEC);
  ASSERT_GE(full, 0);
  ReadingAloud to_disk(60.0, full);
  to_disk.finish_printing();
  EXPECT_EQ(to_disk.output_problem(), ENOSPC);
  to_disk.follow(*application_, frame_s);
  to_disk.finish_printing();
  EXPECT_EQ(to_disk.output_problem(), ENOSPC) << "for good";
  reader_->finish_printing();
  EXPECT_EQ(reader_->output_problem(), 0);
}

TEST_F(ReadingAloudTest, WithoutASpeechServiceItSaysWhyAndKeepsTheChoice) {
  constexpr std::string_view why = "Nothing can be spoken: Install the package speech-dispatcher.";
  const TemporaryFolder empty;
  const std::string path = getenv("PATH");
  for (const char* name : {"XDG_RUNTIME_DIR", "XDG_CONFIG_HOME"}) setenv(name, empty.path().c_str(), 1);
  open({}, "wall45", 1280, 2400);  // high enough for every panel
  session().folded_panels.clear();
  const Preferences stored{.face = Face::workbench, .speaks = true};
  apply(stored, session());
  PreferenceKeeper keeper(stored, session());
  ReadingAloud silent({}, -1);
  const auto follow = [&] {
    setenv("PATH", empty.path().c_str(), 1);
    for (int i = 0; i < 120; ++i) silent.follow(*application_, frame_s);
    setenv("PATH", path.c_str(), 1);
    frames(3);
  };
  const auto panel_says_why = [] {
    return std::ranges::any_of(words_on_screen(), [](const ScreenWords& words) {
      return words.window == "panels" && words.text.find("speech-dispatcher") != std::string::npos;
    });
  };
  follow();
  EXPECT_EQ(session().speech_problem, why);
  EXPECT_EQ(notice(), why);
  EXPECT_TRUE(is_problem());
  EXPECT_TRUE(panel_says_why());
  EXPECT_EQ(faults_of(words_on_screen()), std::vector<std::string>{});
  // The next run tries again, and this one does not.
  keeper.keep(session());
  EXPECT_EQ(empty.count(), 0) << "nobody has chosen anything";
  session().notice.reset();
  follow();
  EXPECT_FALSE(session().notice);
  // Off and on again it does.
  session().speaks = false;
  follow();
  EXPECT_EQ(session().speech_problem, "");
  EXPECT_FALSE(panel_says_why());
  session().speaks = true;
  follow();
  EXPECT_EQ(session().speech_problem, why);
  EXPECT_TRUE(session().notice);
}

}  // namespace
}  // namespace ghostforce::reading_aloud_test
