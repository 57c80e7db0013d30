// ghostforce check LESSON: what it prints and how it ends.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/support/places.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::check_lessons_test {
namespace {

constexpr std::string_view lesson = R"(format = 1
number = 20
[[step]]
name     = "look"
set_up   = "wall45"
[[step]]
name     = "deeper"
controls = ["hand"]
question = "task"
until    = [{ quantity = "depth_mm", at_least = 25 }]
[en]
title = "Press"
about = "Deeper."
look   = { text = "Look." }
deeper = { text = "Deeper.", right = "Yes.", wrong = "No." }
)";

class CheckLessons : public testing::Test {
 protected:
  std::string write(std::string_view name, std::string_view in_place_of = "", std::string_view other = "") {
    std::string text(lesson);
    if (!in_place_of.empty()) text.replace(text.find(in_place_of), in_place_of.size(), other);
    write_whole(folder_ / name, text);
    return folder_ / name;
  }
  TemporaryFolder folder_;
};

Outcome check(std::vector<std::string> words) {
  words.insert(words.begin(), "check");
  return run_ghostforce(std::move(words));
}

bool holds(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

TEST_F(CheckLessons, SaysOfEachStepWhetherItCanBeDone) {
  const Outcome outcome = check({write("press.toml")});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_TRUE(outcome.out.starts_with((folder_ / "press.toml") +
                                      ": \"Press\", 2 steps, languages: en\n"
                                      "   1 ok     look    text\n"
                                      "   2 ok     deeper  task: it is not done at the start, and can be done\n"
                                      "            for example: ghostforce run wall45 --goal-mm="))
      << outcome.out;
  EXPECT_TRUE(outcome.out.ends_with("  not translated yet: there is no [es]\n1 lesson, 0 wrong\n")) << outcome.out;
}

TEST_F(CheckLessons, AnswersNoForATaskThatIsNoTask) {
  const std::string done = write("done.toml", "at_least = 25", "at_least = 5");
  const std::string hopeless = write("hopeless.toml", "at_least = 25", "at_least = 2500");
  const Outcome outcome = check({done, hopeless, "feel-a-wall"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(holds(outcome.out,
                    "   2 WRONG  deeper  task: it is done before anybody has done anything; change set_up "
                    "or until\n"))
      << outcome.out;
  EXPECT_TRUE(holds(outcome.out,
                    "   2 WRONG  deeper  task: no way to do it was found; give other controls, a longer "
                    "slider or wider limits in until\n"))
      << outcome.out;
  EXPECT_TRUE(holds(outcome.out, "feel-a-wall: \"Feel a wall\"")) << outcome.out;
  EXPECT_TRUE(outcome.out.ends_with("3 lessons, 2 wrong\n")) << outcome.out;
}

TEST_F(CheckLessons, TellsAllThatIsWrongWithAFileAndGoesOn) {
  const std::string broken = write("broken.toml", "question = ", "qestion = ");
  const Outcome outcome = check({broken, folder_ / "none.toml", write("press.toml")});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(holds(outcome.err, broken + ":9:1: the key step.qestion is unknown; did you mean 'question'?"))
      << outcome.err;
  EXPECT_TRUE(holds(outcome.err, "there is no file '" + (folder_ / "none.toml") + "'")) << outcome.err;
  EXPECT_TRUE(holds(outcome.out, broken + ": cannot be read as a lesson\n")) << outcome.out;
  EXPECT_TRUE(outcome.out.ends_with("3 lessons, 2 wrong\n")) << outcome.out;
}

TEST_F(CheckLessons, KnowsWhichLessonAMistypedNameMeant) {
  for (const std::vector<std::string>& words : {std::vector<std::string>{"ghst"}, {"feel-a-wall", "ghst"}}) {
    const Outcome outcome = check(words);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_TRUE(holds(outcome.err, "there is no folder or lesson 'ghst'; did you mean 'ghost'?")) << outcome.err;
  }
  EXPECT_TRUE(holds(check({"nothing-like-it"}).err, "there is no folder 'nothing-like-it'"));
}

TEST_F(CheckLessons, PrintsWhatTheDocShows) {
  const std::string doc = read_whole(source_path("/docs/lessons.md"));
  constexpr std::string_view fence = "```toml\n";
  const std::size_t begin = doc.rfind(fence) + fence.size();
  write_whole(folder_ / "steep.toml", doc.substr(begin, doc.find("```", begin) - begin));
  ProgramCall call;
  call.words = {"check", "steep.toml"};
  call.folder = folder_.path();
  const Outcome outcome = run_ghostforce(call);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(holds(doc, outcome.out)) << "docs/lessons.md should hold\n" << outcome.out;
}

TEST_F(CheckLessons, DoesNotMixThemWithFoldersOfCases) {
  const std::string good = write("press.toml");
  const Outcome mixed = check({good, folder_.path()});
  EXPECT_EQ(mixed.exit_code, 2);
  EXPECT_TRUE(holds(mixed.err, "check takes either one folder of cases or lessons; call it once for each"))
      << mixed.err;
  const Outcome report = check({good, "--report", folder_ / "report"});
  EXPECT_EQ(report.exit_code, 2);
  EXPECT_TRUE(
      holds(report.err,
            "--only, --update, --report, --jobs, --json and --renderer are for a folder of cases; leave them out"))
      << report.err;
  const Outcome missing = check({folder_ / "none"});
  EXPECT_EQ(missing.exit_code, 2) << "a word that is no lesson is a folder, as ever";
  EXPECT_TRUE(holds(missing.err, "none")) << missing.err;
}

}  // namespace
}  // namespace ghostforce::check_lessons_test
