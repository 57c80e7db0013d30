// What draws offscreen: each renderer gives the same bytes, one takes the other's place where it is missing, and where
// one is asked for that is not there, the program says what to install. All stored pictures by both: snapshots_test.cpp.
#include "app/shell/desktop/renderer.h"
#include "app/shell/desktop/offscreen.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/support/no_opengl.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::renderer_test {
namespace {

class RendererTest : public testing::Test {
 protected:
  Outcome render(const std::string& name, const std::vector<std::string>& more,
                 const std::vector<std::string>& environment = {}) {
    ProgramCall call;
    call.words = {"render", "wall45", "--size", "640x400", "-o", folder_ / name};
    call.words.insert(call.words.end(), more.begin(), more.end());
    call.environment = environment;
    return run_ghostforce(call);
  }
  std::string file(const std::string& name) const { return read_whole(folder_ / name); }

  void expect_refusal(const Outcome& outcome, const std::vector<std::string>& words) {
    EXPECT_EQ(outcome.exit_code, 6) << outcome.err;
    for (const std::string& each : words) {
      EXPECT_NE(outcome.err.find(each), std::string::npos) << each << " in " << outcome.err;
    }
    EXPECT_EQ(folder_.count(), 0);
  }

  // For the library that finds the drivers, on a machine of any kind.
  static constexpr const char* no_drivers = "__EGL_VENDOR_LIBRARY_FILENAMES=/nowhere.json";

 private:
  TemporaryFolder folder_;
};

TEST_F(RendererTest, EglAndOsMesaGiveTheSameBytes) {
  if (!has_osmesa()) GTEST_SKIP() << "this system has no OSMesa";
  ASSERT_EQ(render("usual.png", {}).exit_code, 0);
  ASSERT_EQ(render("egl.png", {"--renderer", "egl"}).exit_code, 0);
  ASSERT_EQ(render("osmesa.png", {"--renderer", "osmesa"}).exit_code, 0);
  EXPECT_TRUE(file("usual.png") == file("egl.png"));
  EXPECT_TRUE(file("usual.png") == file("osmesa.png"));
}

TEST_F(RendererTest, OsMesaDrawsWhereEglIsMissing) {
  if (!has_osmesa()) GTEST_SKIP() << "this system has no OSMesa";
  ASSERT_EQ(render("usual.png", {}).exit_code, 0);
  const NoOpenGl no_egl({egl_library});
  for (const std::string& environment : {no_egl.variable(), std::string(no_drivers)}) {
    const Outcome outcome = render("other.png", {}, {environment});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_TRUE(file("usual.png") == file("other.png")) << environment;
  }
}

TEST_F(RendererTest, TheOneThatIsAskedForHasNoSubstitute) {
  const NoOpenGl no_egl({egl_library});
  const NoOpenGl no_osmesa({osmesa_library});
  expect_refusal(render("a.png", {"--renderer", "egl"}, {no_egl.variable()}), {"libegl1", "libgl1-mesa-dri"});
  expect_refusal(render("a.png", {"--renderer", "egl"}, {no_drivers}), {"EGL has no software renderer", "libegl1"});
  expect_refusal(render("a.png", {"--renderer", "osmesa"}, {no_osmesa.variable()}), {"libosmesa6"});
  expect_refusal(render("a.png", {"--renderer", "gpu"}, {no_egl.variable()}), {"libegl1"});
  expect_refusal(render("a.png", {"--renderer", "gpu"}, {no_drivers}), {"EGL knows of no graphics card", "driver"});
}

TEST_F(RendererTest, IsRefusedWhereItHasNoSay) {
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"render", "wall45", "-o", "a.svg", "--renderer", "egl"}, {"check", "ghost", "--renderer", "egl"}}) {
    const Outcome outcome = run_ghostforce(words);
    EXPECT_EQ(outcome.exit_code, 2) << words[0];
    EXPECT_NE(outcome.err.find("--renderer"), std::string::npos) << outcome.err;
  }
  const Outcome outcome = render("a.png", {"--renderer", "elg"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("did you mean 'egl'"), std::string::npos) << outcome.err;
}

TEST(RendererExamination, FindsWhatTheTestsNeed) {
  for (const RendererFinding& finding : examine_renderers()) {
    EXPECT_EQ(finding.is_default, finding.renderer == Renderer::egl);
    if (finding.renderer == Renderer::gpu) continue;  // as this machine is
    if (finding.renderer == Renderer::osmesa && !has_osmesa()) continue;
    EXPECT_TRUE(finding.is_there) << finding.words;
    EXPECT_NE(finding.words.find(", OpenGL "), std::string::npos) << finding.words;
  }
  EXPECT_TRUE(default_renderer_words().ends_with(", by egl")) << default_renderer_words();
}

TEST(RendererCatalog, IsInTheOrderOfItsEnumeration) {
  for (const RendererEntry& entry : renderer_catalog()) {
    EXPECT_EQ(&entry_of(entry.renderer), &entry);
    EXPECT_EQ(find_renderer(entry.name), entry.renderer);
  }
  EXPECT_EQ(find_renderer("opengl"), std::nullopt);
}

}  // namespace
}  // namespace ghostforce::renderer_test
