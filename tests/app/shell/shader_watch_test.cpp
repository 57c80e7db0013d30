// Shaders that change while the program runs.
#include "app/shell/shader_watch.h"

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "app/base/failure.h"
#include "embedded_shaders.h"
#include "tests/app/shell/driven_window.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::shader_watch_test {
namespace {

class ShaderWatchTest : public DrivenWindow {
 protected:
  ShaderWatchTest() {
    for (const EmbeddedText& shader : embedded_shaders) {
      write_whole(folder_ / shader.name, shader.contents);
      if (shader.name == "mark.frag") fragment_ = shader.contents;
    }
  }
  // Changes the file and lets half a second go by.
  void write_fragment(const std::string& text) {
    write_whole(folder_ / "mark.frag", text);
    ++writes_;
    const auto later = std::filesystem::file_time_type::clock::now() + std::chrono::seconds(writes_);
    std::filesystem::last_write_time(folder_ / "mark.frag", later);
    frames(40, 0);
  }
  void open_watching() {
    ApplicationOptions options;
    options.shader_folder = folder_.path();
    open(options);
    session().paused = true;
    frames(20);
  }

  TemporaryFolder folder_;
  std::string fragment_;
  int writes_ = 0;
};

TEST_F(ShaderWatchTest, AChangedShaderDrawsAtOnce) {
  open_watching();
  const Image before = picture();
  std::string inverted = fragment_;
  const std::string line = "colour.a *= covered;";
  ASSERT_NE(inverted.find(line), std::string::npos);
  inverted.replace(inverted.find(line), line.size(), "colour.rgb = 1.0 - colour.rgb; colour.a *= covered;");
  write_fragment(inverted);
  EXPECT_NE(picture(), before);
  write_fragment(fragment_);
  EXPECT_EQ(picture(), before);
}

TEST_F(ShaderWatchTest, ABrokenShaderIsShownAndTheOldOneGoesOn) {
  open_watching();
  const Image before = picture();
  write_fragment("#version 330 core\nthis is no shader\n");
  const Image broken = picture();
  EXPECT_NE(broken, before) << "the panel with the log and the source";
  // Above the panel the scene is drawn as before.
  for (int y = 60; y < 300; ++y) {
    const std::ptrdiff_t row = 3 * static_cast<std::ptrdiff_t>(y) * before.width;
    ASSERT_TRUE(std::equal(before.rgb.begin() + row, before.rgb.begin() + row + 3 * 840, broken.rgb.begin() + row))
        << y;
  }
  write_fragment(fragment_);
  EXPECT_EQ(picture(), before) << "the panel goes when the shader is right again";
}

TEST_F(ShaderWatchTest, TheMessageHoldsTheLogAndTheNumberedSource) {
  GlPainter painter(window().fonts());
  ShaderWatch watch(folder_.path());
  watch.poll(painter, 0.0);
  EXPECT_EQ(watch.problem(), "");
  write_whole(folder_ / "mark.frag", "#version 330 core\nthis is no shader\n");
  watch.poll(painter, 0.1);
  EXPECT_EQ(watch.problem(), "") << "not every frame";
  watch.poll(painter, 1.0);
  EXPECT_NE(watch.problem().find("   2 this is no shader"), std::string::npos) << watch.problem();
  std::filesystem::remove(folder_ / "mark.frag");
  watch.poll(painter, 2.0);
  EXPECT_NE(watch.problem().find("mark.frag cannot be read"), std::string::npos) << watch.problem();
}

// Mesa's log begins with "0:LINE(COLUMN)".
TEST_F(ShaderWatchTest, TheDriverCountsLinesAsTheFileDoes) {
  GlPainter painter(window().fonts());
  for (const std::string first : {"#version 330 core", "#version 300 es", "// no version"}) {
    write_whole(folder_ / "mark.frag", first + "\nout vec4 colour;\nthis is no shader\n");
    ShaderWatch watch(folder_.path());
    watch.poll(painter, 0.0);
    EXPECT_NE(watch.problem().find("0:3("), std::string::npos) << watch.problem();
    EXPECT_NE(watch.problem().find("   3 this is no shader"), std::string::npos) << watch.problem();
  }
}

// A copy of a shader from when each had the desktop's version in its first line.
TEST_F(ShaderWatchTest, AVersionInTheFileIsReplaced) {
  GlPainter painter(window().fonts());
  for (const std::string first : {"#version 330 core\n", "#version 300 es\r\n"}) {
    write_whole(folder_ / "mark.frag", first + fragment_);
    ShaderWatch watch(folder_.path());
    watch.poll(painter, 0.0);
    EXPECT_EQ(watch.problem(), "");
  }
  write_whole(folder_ / "mark.frag", "#version 330 core");
  ShaderWatch watch(folder_.path());
  watch.poll(painter, 0.0);
  EXPECT_NE(watch.problem(), "") << "nothing else is in it";
}

TEST_F(ShaderWatchTest, AFolderWithoutTheShadersIsRefused) {
  const TemporaryFolder empty;
  try {
    const ShaderWatch watch(empty.path());
    FAIL();
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.code(), ExitCode::wrong_call);
    EXPECT_NE(std::string(failure.what()).find("mark.vert"), std::string::npos);
  }
}

}  // namespace
}  // namespace ghostforce::shader_watch_test
