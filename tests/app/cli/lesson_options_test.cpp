// --lesson and --language, as the program itself takes them.
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::lesson_options_test {
namespace {

// A lesson in French, which the stage does not speak.
constexpr std::string_view french_lesson = R"(format = 1
number = 1
[[step]]
name = "look"
set_up = "ghostforce run wall45 --goal-mm=-10,10"
[fr]
title = "Le mur"
about = "Un mur."
[fr.look]
text = "Regarde."
)";

// A window would end there without a display, with another code.
Outcome run_words(std::vector<std::string> words) {
  ProgramCall call;
  call.words = std::move(words);
  call.environment = {"DISPLAY=", "WAYLAND_DISPLAY="};
  return run_ghostforce(call);
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

TEST(Language, IsOneThatTheStageOrTheLessonHas) {
  const TemporaryFolder folder;
  write_whole(folder / "mur.toml", french_lesson);
  const std::vector<std::vector<std::string>> calls{
      {"render", "wall45", "--view", "stage", "--size", "320x240", "-o", folder / "a.png"},
      {"render", "--lesson", "ghost", "--size", "320x240", "-o", folder / "a.png"},
      {"worksheet", "ghost", "-o", folder / "a.pdf"},
      {"run", "--exit-after", "1"},
      {"run", "--lesson", "ghost", "--exit-after", "1"}};
  for (const std::vector<std::string>& call : calls) {
    for (const std::string word : {"fr", "ES", "es_ES.UTF-8", "spanish", "e", "\xff"}) {
      const Outcome outcome = run_words(joined(call, {"--language", word}));
      EXPECT_EQ(outcome.exit_code, 2) << call.front() << word << outcome.err;
      EXPECT_NE(outcome.err.find("is not one of en, es"), std::string::npos) << outcome.err;
    }
    EXPECT_NE(run_words(joined(call, {"--language", "es"})).exit_code, 2) << call.front();
  }
  EXPECT_NE(run_words(joined(calls[0], {"--language", "ES"})).err.find("did you mean 'es'?"), std::string::npos);
  const std::string own = folder / "mur.toml";
  for (const std::vector<std::string>& call :
       {std::vector<std::string>{"render", "--lesson", own, "--size", "320x240", "-o", folder / "a.png"},
        std::vector<std::string>{"worksheet", "ghost", own, "-o", folder / "a.pdf"},
        std::vector<std::string>{"run", "--lesson", own, "--exit-after", "1"}}) {
    EXPECT_NE(run_words(joined(call, {"--language", "fr"})).exit_code, 2) << call.front();
    EXPECT_EQ(run_words(joined(call, {"--language", "de"})).exit_code, 2) << call.front();
  }
}

}  // namespace
}  // namespace ghostforce::lesson_options_test
