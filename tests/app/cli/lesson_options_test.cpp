// --lesson beside other options, as the program itself takes them.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce {
namespace {

// A window would end there without a display, with another code.
Outcome run_words(std::vector<std::string> words) {
  ProgramCall call;
  call.words = std::move(words);
  call.environment = {"DISPLAY=", "WAYLAND_DISPLAY="};
  return run_program(GHOSTFORCE_PROGRAM, call);
}

std::vector<std::string> joined(std::vector<std::string> words, const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST(RenderLesson, RefusesWhatTheStepSays) {
  const TemporaryFolder folder;
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"fig1"},
           {"--set", "wall.normal_deg=90"},
           {"--set", "wall.normal_deg=90", "--set", "device.mass_kg=0.1"},
           {"--strategy", "full"},
           {"--mode", "why"},
           {"--landscape"},
           {"--view", "workbench"},
           {"--compare", "overlay"},
           {"--part", "scene"},
           {"--at", "0.5"},
           {"--clip", "0:1:5"},
       }) {
    const Outcome outcome =
        run_words(joined({"render", "--lesson", "ghost", "--size", "320x240", "-o", folder / "step.png"}, words));
    EXPECT_EQ(outcome.exit_code, 2) << words.front() << '\n' << outcome.err;
    EXPECT_NE(outcome.err.find("--lesson and "), std::string::npos) << words.front() << '\n' << outcome.err;
    EXPECT_NE(outcome.err.find("leave out one of them"), std::string::npos) << outcome.err;
    EXPECT_EQ(folder.count(), 0) << words.front();
  }
  const Outcome good = run_words({"render", "--lesson", "ghost", "--view", "stage", "--theme", "dark", "--scale", "1.5",
                                  "--size", "640x400", "-o", folder / "step.png"});
  EXPECT_EQ(good.exit_code, 0) << good.err;
}

}  // namespace
}  // namespace ghostforce
