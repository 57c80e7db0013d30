// Clips as users make them, by the program's own `render --clip`.
#include <signal.h>

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/files/clip_file.h"
#include "app/files/scene_file.h"
#include "app/shell/desktop/offscreen.h"
#include "app/state/set_up.h"
#include "app/state/set_up_of.h"
#include "tests/support/animated_png_reader.h"
#include "tests/support/fake_ffmpeg.h"
#include "tests/support/program.h"
#include "tests/support/read_png.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::clip_command_test {
namespace {

std::vector<std::string> render(const std::vector<std::string>& words) {
  std::vector<std::string> all{"render", "wall45", "--size", "320x200"};
  all.insert(all.end(), words.begin(), words.end());
  return all;
}

// The picture of each frame of the clip, those that are shown longer as often as they are.
std::vector<Image> pictures_of(const Animation& animation) {
  std::vector<Image> pictures;
  for (const AnimatedFrame& frame : animation.frames) {
    for (int i = 0; i < frame.delay_numerator; ++i) pictures.push_back(frame.image);
  }
  return pictures;
}

TEST(RenderClip, HasTheSameBytesOnEveryRun) {
  const TemporaryFolder folder;
  for (const char* const face : {"stage", "workbench"}) {
    for (const char* const name : {"a.png", "b.png"}) {
      const Outcome outcome = run_ghostforce(render({"--view", face, "--clip", "0.8:1.2:15", "-o", folder / name}));
      ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    }
    const std::string bytes = read_whole(folder / "a.png");
    EXPECT_EQ(bytes, read_whole(folder / "b.png"));
    EXPECT_EQ(pictures_of(read_animated_png(bytes)).size(), 6U);
  }
}

TEST(RenderClip, HoldsEachPictureThatWasDrawn) {
  const TemporaryFolder folder;
  for (const Face face : {Face::stage, Face::workbench}) {
    const PictureRequest request{.scene = load_scene("wall45"), .at_s = {}, .width = 320, .height = 200, .face = face};
    ClipFile file(folder / "clip.png", {.width = 320, .height = 200, .frames_per_second = 10});
    std::vector<Image> drawn;
    draw_clip(request, {.from_s = 0.9, .to_s = 1.5, .frames_per_second = 10}, [&](const Image& image) {
      file.add(image);
      drawn.push_back(image);
    });
    file.commit();
    ASSERT_EQ(drawn.size(), 6U);
    EXPECT_NE(drawn.front(), drawn.back());
    EXPECT_TRUE(pictures_of(read_animated_png(read_whole(folder / "clip.png"))) == drawn);
  }
}

// The words of those that follow stay where they were, as in the window.
TEST(RenderClip, BeginsWithThePictureThatIsDrawnAlone) {
  const TemporaryFolder folder;
  for (const char* const at : {"0.5", "1", "1.7"}) {
    const std::string clip = std::string(at) + ":3:1";
    ASSERT_EQ(run_ghostforce(render({"--clip", clip, "-o", folder / "clip.png"})).exit_code, 0);
    ASSERT_EQ(run_ghostforce(render({"--at", at, "-o", folder / "picture.png"})).exit_code, 0);
    EXPECT_TRUE(read_png(folder / "clip.png") == read_png(folder / "picture.png")) << at;
  }
}

TEST(RenderClip, ShowsTheHandGoingIn) {
  const TemporaryFolder folder;
  for (const char* const mode : {"", "round", "ribbon", "why"}) {
    std::vector<std::string> words = render({"--view", "stage", "--clip", "0.5:1.5:6", "-o", folder / "clip.png"});
    if (*mode != '\0') words.insert(words.end(), {"--mode", mode});
    const Outcome outcome = run_ghostforce(words);
    ASSERT_EQ(outcome.exit_code, 0) << mode << outcome.err;
    EXPECT_GT(read_animated_png(read_whole(folder / "clip.png")).frames.size(), 3U) << mode;
  }
}

// The last picture: what is on the screen when somebody stops the clip at its end.
TEST(RenderClip, CarriesTheSetUpOfItsLastPicture) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_ghostforce(render({"--view", "stage", "--clip", "0:0.5:5", "-o", folder / "clip.png"})).exit_code, 0);
  ASSERT_EQ(run_ghostforce(render({"--view", "stage", "--at", "0.4", "-o", folder / "last.png"})).exit_code, 0);
  const auto set_up = read_picture_set_up(folder / "clip.png");
  EXPECT_EQ(set_up_line(set_up), set_up_line(read_picture_set_up(folder / "last.png")));
  EXPECT_NE(set_up.goal, load_scene("wall45").goal.points.back()) << "the hand is on its way";
}

TEST(RenderClip, SaysWhatIsWrongWithACall) {
  const TemporaryFolder folder;
  const std::string path = folder / "clip.png";
  const std::vector<std::pair<std::vector<std::string>, std::string>> calls{
      {{"--clip", "0:3", "-o", path}, "FPS"},
      {{"--clip", "", "-o", path}, "--clip"},
      {{"--clip", "0:3:0", "-o", path}, "1 to 60"},
      {{"--clip", "0:3:61", "-o", path}, "1 to 60"},
      {{"--clip", "0:3:29.97", "-o", path}, "whole number"},
      {{"--clip", "3:3:30", "-o", path}, "TO must be later than FROM"},
      {{"--clip", "-1:3:30", "-o", path}, "times in seconds"},
      {{"--clip", "0:nan:30", "-o", path}, "times in seconds"},
      {{"--clip", "0:3:30:2", "-o", path}, "FPS"},
      {{"--clip", "0:61:60", "-o", path}, "3600 is the most"},
      {{"--clip", "0:60:60", "--size", "4096x4096", "-o", path}, "444 is the most"},
      {{"--clip", "0:3:30", "-o", folder / "clip.svg"}, ".png, .mp4 or .webm"},
      {{"--clip", "0:3:30", "-o", "-"}, "cannot go into a pipe or a device"},
      {{"--clip", "0:3:30", "-o", "/dev/full"}, "cannot go into a pipe or a device"},
      {{"--clip", "0:3:30", "--at", "1", "-o", path}, "--at"},
      {{"--clip", "0:3:30", "--json", folder / "a.json", "-o", path}, "--json"},
      {{"--clip", "0:1:10", "--set", "rendering.k_r_N_per_m=1e6", "--set", "device.mass_kg=0.001", "-o", path},
       "unstable"}};
  for (const auto& [words, expected] : calls) {
    std::vector<std::string> call{"render", "wall45"};
    call.insert(call.end(), words.begin(), words.end());
    const Outcome outcome = run_ghostforce(call);
    EXPECT_EQ(outcome.exit_code, 2) << words[1];
    EXPECT_NE(outcome.err.find(expected), std::string::npos) << outcome.err;
    EXPECT_EQ(folder.count(), 0) << words[1];
  }
}

TEST(RenderClip, LeavesNothingWhenInterrupted) {
  for (const char* const script : {"", FakeFfmpeg::keeps_what_it_gets, FakeFfmpeg::never_reads}) {
    const FakeFfmpeg ffmpeg;
    if (*script != '\0') ffmpeg.is(script);
    const TemporaryFolder folder;
    ProgramCall call;
    call.words = render({"--clip", "0:100:30", "-o", folder / (*script == '\0' ? "clip.png" : "clip.mp4")});
    call.signal_when_created_in = folder.path();
    call.signal = SIGINT;
    const Outcome outcome = run_ghostforce(call);
    EXPECT_EQ(outcome.exit_code, 130) << script << outcome.err;
    EXPECT_EQ(folder.count(), 0) << script;
  }
}

TEST(RenderClip, MakesVideosByFfmpegWhereThereIsOne) {
  const FakeFfmpeg ffmpeg;
  const TemporaryFolder folder;
  const std::vector<std::string> words = render({"--clip", "0:0.2:10", "-o", folder / "clip.webm"});
  Outcome outcome = run_ghostforce(words);
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("install the package ffmpeg"), std::string::npos) << outcome.err;
  EXPECT_EQ(folder.count(), 0);

  ffmpeg.is(FakeFfmpeg::fails);
  outcome = run_ghostforce(words);
  EXPECT_EQ(outcome.exit_code, 8);
  EXPECT_NE(outcome.err.find("the encoder is broken"), std::string::npos) << outcome.err;
  EXPECT_EQ(folder.count(), 0);

  ffmpeg.is(FakeFfmpeg::keeps_what_it_gets);
  EXPECT_EQ(run_ghostforce(words).exit_code, 0);
  EXPECT_EQ(read_whole(folder / "clip.webm").size(), std::size_t{2} * 320 * 200 * 4);
}

}  // namespace
}  // namespace ghostforce::clip_command_test
