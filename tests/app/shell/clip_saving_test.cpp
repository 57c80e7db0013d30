// The last seconds of the stage into a file, from the window: what the person presses and reads, with the servo stepped
// by hand.
#include "app/shell/clip_saving.h"

#include <sys/wait.h>

#include <csignal>
#include <filesystem>
#include <string>

#include "core/simulate.h"
#include "tests/app/shell/driven_window.h"
#include "tests/support/animated_png_reader.h"
#include "tests/support/fake_ffmpeg.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::clip_saving_test {
namespace {

class ClipWindow : public DrivenWindow {
 protected:
  ClipWindow() {
    std::signal(SIGPIPE, SIG_IGN);  // as main() has it
    open({.face = Face::stage}, "wall45", 640, 400);
    draw_every_frame();
  }

  // As the dialog does.
  void ask(const std::string& path, double seconds) {
    act(SaveClip{.path = path, .seconds = seconds, .end_s = now().time_s, .frames_per_second = 10});
    frames(1);
  }
  bool is_saving() { return notice().starts_with("Saving "); }
  void frames_until_saved() {
    while (is_saving()) frames(1);
  }
  Animation saved(const std::string& path) { return read_animated_png(read_whole(path)); }
  static int length_of(const Animation& clip) {
    int length = 0;
    for (const AnimatedFrame& frame : clip.frames) length += frame.delay_numerator;
    return length;
  }

  TemporaryFolder folder_;
};

TEST_F(ClipWindow, SavesWhatTheStageHasShown) {
  act(OpenDialog{Dialog::save_clip});
  frames(3);
  ASSERT_EQ(session().dialog, Dialog::save_clip);
  EXPECT_EQ(session().form.clip_seconds, 5);
  const double before_s = now().time_s;
  type(folder_ / "clip");  // in place of the proposed name
  press(key::enter);
  EXPECT_EQ(session().dialog, Dialog::none);
  EXPECT_NE(notice().find("clip.png"), std::string::npos) << "a name without an ending gets one: " << notice();
  frames_until_saved();
  EXPECT_EQ(notice(), "Saved " + folder_ / "clip.png");
  EXPECT_GT(now().time_s, before_s) << "time has gone on meanwhile";
  EXPECT_EQ(folder_.count(), 1);
  const Animation clip = saved(folder_ / "clip.png");
  EXPECT_EQ(clip.frames.front().image.width, 640);
  EXPECT_EQ(clip.frames.front().image.height, 400);
  EXPECT_EQ(clip.frames.front().delay_denominator, 30);
  EXPECT_GT(clip.frames.size(), 20U) << "the hand has come in";
}

TEST_F(ClipWindow, HasTheSameBytesTwiceWhateverHappensMeanwhile) {
  for (const char* const name : {"a.png", "b.png"}) {
    // The hand goes in.
    act(SaveClip{.path = folder_ / name, .seconds = 1.0, .end_s = 1.5, .frames_per_second = 10});
    frames(1);
    session().settings.active = StrategyId::anisotropic;
    frames_until_saved();
  }
  const std::string bytes = read_whole(folder_ / "a.png");
  EXPECT_TRUE(bytes == read_whole(folder_ / "b.png"));
  EXPECT_EQ(length_of(read_animated_png(bytes)), 11);
}

TEST_F(ClipWindow, ClosingTheNoticeDoesNotGiveItUp) {
  ask(folder_ / "clip.png", 5.0);
  ASSERT_TRUE(is_saving()) << notice();
  EXPECT_EQ(folder_.count(), 1) << "what it is until it is whole";
  press(key::escape);
  EXPECT_FALSE(is_saving());
  while (notice().empty()) frames(1);
  EXPECT_EQ(notice(), "Saved " + folder_ / "clip.png");
  EXPECT_GT(saved(folder_ / "clip.png").frames.size(), 10U);
}

TEST_F(ClipWindow, TheWindowDoesNotWaitForIt) {
  const FakeFfmpeg ffmpeg;
  ffmpeg.is(FakeFfmpeg::never_reads);
  ask(folder_ / "clip.mp4", 5.0);
  frames(50);
  EXPECT_TRUE(is_saving());
}

TEST_F(ClipWindow, OtherNewsDoNotGiveItUp) {
  const FakeFfmpeg ffmpeg;
  ffmpeg.is(FakeFfmpeg::never_ends);
  ask(folder_ / "clip.mp4", 5.0);
  ASSERT_TRUE(is_saving());
  application_->show_notice("Something else.", false);
  frames(1);
  EXPECT_EQ(notice(), "Something else.");
  session().notice.reset();
  frames(1);
  EXPECT_TRUE(is_saving()) << "it is told again";
  ask(folder_ / "second.png", 1.0);
  EXPECT_NE(notice().find("Another clip is being saved"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "second.png"));
}

TEST_F(ClipWindow, TheEndOfTheProgramGivesItUp) {
  const FakeFfmpeg ffmpeg;
  ffmpeg.is(FakeFfmpeg::never_reads);
  ask(folder_ / "clip.webm", 5.0);
  ASSERT_TRUE(is_saving());
  application_.reset();
  EXPECT_EQ(folder_.count(), 0);
  EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1) << "ffmpeg is gone";
}

TEST_F(ClipWindow, SaysAtOnceWhatCanNeverBe) {
  ask(folder_ / "none/clip.png", 1.0);
  EXPECT_NE(notice().find("create the folder"), std::string::npos) << notice();
  ask(folder_ / "clip.gif", 1.0);
  EXPECT_NE(notice().find(".png, .mp4 or .webm"), std::string::npos) << notice();
  const FakeFfmpeg ffmpeg;
  ask(folder_ / "clip.mp4", 1.0);
  EXPECT_NE(notice().find("install the package ffmpeg"), std::string::npos) << notice();
  ffmpeg.is(FakeFfmpeg::fails);
  ask(folder_ / "clip.mp4", 1.0);
  frames_until_saved();
  EXPECT_NE(notice().find("the encoder is broken"), std::string::npos) << notice();
  EXPECT_TRUE(is_problem());
  EXPECT_EQ(folder_.count(), 0);
}

// --- Which moments ---------------------------------------------------------------------------------------------------

// The hand goes in for a second, and rests; the strategy changes at 2 s.
MomentHistory some_moments() {
  MomentHistory moments;
  Scene scene = load_scene("wall45");
  simulate(scene, 20'000, [&](const Snapshot& snapshot) {
    if (snapshot.time_s >= 2.0) scene.settings.active = StrategyId::anisotropic;
    moments.add(snapshot, scene.settings);
  });
  return moments;
}

TEST(ClipMoments, AreThoseUpToTheEnd) {
  const MomentHistory moments = some_moments();
  const std::vector<ClipMoment> chosen =
      clip_moments(moments, {.path = {}, .seconds = 0.5, .end_s = 1.5, .frames_per_second = 10});
  ASSERT_EQ(chosen.size(), 6U);
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    EXPECT_DOUBLE_EQ(chosen[i].snapshot.time_s, 1.0 + 0.1 * static_cast<double>(i));
    EXPECT_EQ(chosen[i].settings.active, StrategyId::naive);
  }
}

TEST(ClipMoments, LeaveOutThatNothingHappensAnyMore) {
  const MomentHistory moments = some_moments();
  const std::vector<ClipMoment> chosen =
      clip_moments(moments, {.path = {}, .seconds = 2.0, .end_s = 20.0, .frames_per_second = 10});
  ASSERT_EQ(chosen.size(), 21U);
  EXPECT_EQ(chosen.front().settings.active, StrategyId::naive);
  EXPECT_EQ(chosen.back().settings.active, StrategyId::anisotropic);
  EXPECT_LT(chosen.front().snapshot.time_s, 1.5) << "the end of the last change, and a second";
}

TEST(ClipMoments, AreFewerWhereThereAreNoMore) {
  const MomentHistory moments = some_moments();
  EXPECT_EQ(clip_moments(moments, {.path = {}, .seconds = 5.0, .end_s = 1.0, .frames_per_second = 10}).size(), 11U);
  EXPECT_TRUE(clip_moments(MomentHistory(), {.path = {}, .seconds = 5.0, .end_s = 1.0}).empty());
}

}  // namespace
}  // namespace ghostforce::clip_saving_test
