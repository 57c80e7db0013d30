// Clips in each format; ffmpeg is a script of the test's own, so that it can fail in every way.
#include "app/files/clip_file.h"

#include <stdlib.h>
#include <sys/wait.h>

#include <cerrno>
#include <chrono>
#include <csignal>

#include <gtest/gtest.h>

#include "app/base/failure.h"
#include "tests/support/animated_png_reader.h"
#include "tests/support/fake_ffmpeg.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::clip_file_test {
namespace {

using std::chrono::milliseconds;

// Larger than a pipe holds.
constexpr ClipShape shape{.width = 200, .height = 150, .frames_per_second = 30};

Image picture(int number) {
  Image image{shape.width, shape.height, {}};
  for (int i = 0; i < 3 * shape.width * shape.height; ++i) {
    image.rgb.push_back(static_cast<std::uint8_t>(i * (number + 3)));
  }
  return image;
}

struct Stopped {};

class ClipFileTest : public testing::Test {
 protected:
  ClipFileTest() { std::signal(SIGPIPE, SIG_IGN); }  // as main() has it

  // What the failure says; empty: there was none. Nothing may be left of the clip then.
  std::string failure_of(const std::string& name, VideoWaiting waiting = {.look_up = [] {}}) {
    try {
      write(name, std::move(waiting));
    } catch (const Failure& failure) {
      EXPECT_EQ(folder_.count(), 0);
      EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1) << "ffmpeg is gone";
      EXPECT_EQ(errno, ECHILD);
      code_ = failure.code();
      return failure.what();
    }
    return {};
  }
  void write(const std::string& name, VideoWaiting waiting) {
    ClipFile clip(folder_ / name, shape, "what it shows", std::move(waiting));
    for (int i = 0; i < 5; ++i) clip.add(picture(i));
    clip.commit();
  }

  TemporaryFolder folder_;
  FakeFfmpeg ffmpeg_;
  ExitCode code_ = ExitCode::done;
};

TEST_F(ClipFileTest, AnimatedPngNeedsNoFfmpeg) {
  EXPECT_EQ(failure_of("clip.png"), "");
  EXPECT_EQ(read_animated_png(read_whole(folder_ / "clip.png")).frames.size(), 5U);
  EXPECT_EQ(failure_of("CLIP.PNG"), "") << "in any case of letters";
}

TEST_F(ClipFileTest, VideosAreWhatFfmpegMakesOfThePictures) {
  for (const std::string name : {"clip.mp4", "clip.webm"}) {
    ffmpeg_.is(FakeFfmpeg::keeps_what_it_gets);
    EXPECT_EQ(failure_of(name), "");
    std::string expected;
    for (int i = 0; i < 5; ++i) {
      const Image image = picture(i);
      for (std::size_t k = 0; k < image.rgb.size(); k += 3) {
        expected.append({static_cast<char>(image.rgb[k]), static_cast<char>(image.rgb[k + 1]),
                         static_cast<char>(image.rgb[k + 2]), '\xFF'});
      }
    }
    EXPECT_EQ(read_whole(folder_ / name), expected);
    const std::string words = ffmpeg_.arguments();
    for (const char* const part :
         {"-f\nrawvideo\n-pixel_format\nrgba\n-video_size\n200x150\n-framerate\n30\n-i\npipe:0\n",
          "-metadata\ncomment=what it shows\n", "-f\n"}) {
      EXPECT_NE(words.find(part), std::string::npos) << part << "\nin\n" << words;
    }
    EXPECT_NE(words.find(name.substr(5) + "\n-y\nfile:" + folder_.path()), std::string::npos) << words;
  }
}

TEST_F(ClipFileTest, AnOldFileStaysUntilTheNewOneIsWhole) {
  write_whole(folder_ / "clip.mp4", "old");
  ffmpeg_.is(FakeFfmpeg::fails);
  EXPECT_THROW(write("clip.mp4", {.look_up = [] {}}), Failure);
  EXPECT_EQ(read_whole(folder_ / "clip.mp4"), "old");
  EXPECT_EQ(folder_.count(), 1);
}

TEST_F(ClipFileTest, WithoutFfmpegItSaysWhatToInstall) {
  const std::string words = failure_of("clip.mp4");
  EXPECT_NE(words.find("install the package ffmpeg"), std::string::npos) << words;
  EXPECT_NE(words.find(".png"), std::string::npos) << words;
  EXPECT_EQ(code_, ExitCode::wrong_call);
}

TEST_F(ClipFileTest, OneThatFailsIsToldWithItsLastLines) {
  for (const char* const script : {FakeFfmpeg::fails, FakeFfmpeg::fails_at_the_end}) {
    ffmpeg_.is(script);
    const std::string words = failure_of("clip.webm");
    EXPECT_NE(words.find("exit code 3"), std::string::npos) << words;
    EXPECT_NE(words.find("\n  line 8\n  the encoder is broken\n"), std::string::npos) << words;
    EXPECT_EQ(words.find("line 2"), std::string::npos) << "only the last ones: " << words;
    EXPECT_EQ(code_, ExitCode::file_trouble);
  }
}

TEST_F(ClipFileTest, OneThatStopsReadingOrWritesNothingIsAFailureToo) {
  ffmpeg_.is(FakeFfmpeg::stops_early);
  EXPECT_NE(failure_of("clip.mp4").find("before the last picture"), std::string::npos);
  ffmpeg_.is(FakeFfmpeg::writes_nothing);
  EXPECT_NE(failure_of("clip.mp4").find("nothing"), std::string::npos);
}

TEST_F(ClipFileTest, OneThatHangsIsGivenUp) {
  for (const char* const script : {FakeFfmpeg::never_reads, FakeFfmpeg::never_ends}) {
    ffmpeg_.is(script);
    const std::string words = failure_of("clip.mp4", {.look_up = [] {}, .patience = milliseconds(200)});
    EXPECT_NE(words.find("no video was made: ffmpeg"), std::string::npos) << script;
    EXPECT_EQ(code_, ExitCode::file_trouble);
  }
}

TEST_F(ClipFileTest, OneThatHangsCanBeStopped) {
  for (const char* const script : {FakeFfmpeg::never_reads, FakeFfmpeg::never_ends}) {
    ffmpeg_.is(script);
    int looks = 0;
    const auto look_up = [&looks] {
      if (++looks == 20) throw Stopped();
    };
    EXPECT_THROW(write("clip.mp4", {.look_up = look_up}), Stopped);
    EXPECT_EQ(folder_.count(), 0);
    EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1) << "ffmpeg is gone";
  }
}

TEST_F(ClipFileTest, OneThatCannotBeStartedIsToldSo) {
  write_whole(ffmpeg_.folder() / "ffmpeg", "no program");  // nor may it be run
  EXPECT_NE(failure_of("clip.mp4").find("ffmpeg cannot be started"), std::string::npos);
}

TEST_F(ClipFileTest, RefusesOtherNamesAndWhatIsNoPlainFile) {
  EXPECT_NE(failure_of("clip.gif").find(".png, .mp4 or .webm"), std::string::npos);
  EXPECT_EQ(code_, ExitCode::wrong_call);
  try {
    const ClipFile clip("-", shape);
    ADD_FAILURE();
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.code(), ExitCode::wrong_call);
  }
}

TEST(ClipLimits, AreTold) {
  EXPECT_NO_THROW(check_clip_limits(3600, {.width = 1920, .height = 1080}));
  const auto words = [](std::int64_t frames, const ClipShape& clip) -> std::string {
    try {
      check_clip_limits(frames, clip);
    } catch (const Failure& failure) {
      EXPECT_EQ(failure.code(), ExitCode::wrong_call);
      return failure.what();
    }
    return {};
  };
  EXPECT_NE(words(3601, {.width = 64, .height = 64}).find("3600 is the most"), std::string::npos);
  EXPECT_EQ(words(444, {.width = 4096, .height = 4096}), "");
  EXPECT_NE(words(445, {.width = 4096, .height = 4096}).find("444 is the most"), std::string::npos);
}

}  // namespace
}  // namespace ghostforce::clip_file_test
