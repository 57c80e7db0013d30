// ghostforce worksheet, as a teacher calls it.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/places.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::worksheet_command_test {
namespace {

Outcome worksheet(std::vector<std::string> words) {
  words.insert(words.begin(), "worksheet");
  return run_ghostforce(std::move(words));
}

bool holds(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

TEST(WorksheetCommand, WritesAPageForEachLessonWithTheSameBytesOnEveryRun) {
  const TemporaryFolder folder;
  const Outcome outcome = worksheet({"-o", folder / "all.pdf"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  const std::string all = read_whole(folder / "all.pdf");
  EXPECT_TRUE(all.starts_with("%PDF-"));
  EXPECT_TRUE(holds(all, "/Count 11\n")) << "pages";
  EXPECT_TRUE(holds(all, "[ 0 0 595.276 841.89 ]"));
  EXPECT_TRUE(holds(all, "/ToUnicode")) << "letters that a search understands";
  EXPECT_EQ(worksheet({"-o", "-"}).out, all);
}

TEST(WorksheetCommand, TakesLessonsLanguageAndPaper) {
  const TemporaryFolder folder;
  const std::string english = worksheet({"ghost", "why", "-o", "-", "--language", "en"}).out;
  EXPECT_TRUE(holds(english, "/Count 2\n"));
  const std::string letter = worksheet({"ghost", "-o", "-", "--paper", "letter"}).out;
  EXPECT_TRUE(holds(letter, "[ 0 0 612 792 ]"));
  EXPECT_TRUE(holds(letter, "/Title (The ghost force)"));
  EXPECT_TRUE(holds(worksheet({"ghost", "-o", "-", "--language", "es"}).out, "/Title (La fuerza fantasma)"));
  ProgramCall call;
  call.words = {"worksheet", "ghost", "-o", "-"};
  call.environment = {"LC_ALL=es_ES.UTF-8"};
  EXPECT_TRUE(holds(run_ghostforce(call).out, "/Title (The ghost force)")) << "the same everywhere";
  EXPECT_NE(worksheet({"ghost", "-o", "-", "--answers"}).out, worksheet({"ghost", "-o", "-"}).out);
}

TEST(WorksheetCommand, TakesALessonOfATeachersOwnAndNeverWritesOverIt) {
  const TemporaryFolder folder;
  const std::string doc = read_whole(source_path("/docs/lessons.md"));
  constexpr std::string_view fence = "```toml\n";
  const std::size_t begin = doc.rfind(fence) + fence.size();
  const std::string lesson = doc.substr(begin, doc.find("```", begin) - begin);
  write_whole(folder / "steep.toml", lesson);
  const Outcome outcome = worksheet({folder / "steep.toml", "-o", "-"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(holds(outcome.out, "/Title (A steep wall)"));
  write_whole(folder / "steep.pdf", lesson);
  EXPECT_EQ(worksheet({folder / "steep.pdf", "-o", folder / "steep.pdf"}).exit_code, 2);
  EXPECT_EQ(read_whole(folder / "steep.pdf"), lesson);
}

TEST(WorksheetCommand, SaysWhatIsWrongAndLeavesNothing) {
  const TemporaryFolder folder;
  Outcome outcome = worksheet({"gost", "-o", folder / "F.pdf"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(holds(outcome.err, "no lesson named 'gost'; did you mean 'ghost'?")) << outcome.err;
  outcome = worksheet({"ghost", "-o", folder / "F.png"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(holds(outcome.err, "a worksheet is a PDF; give a name that ends in .pdf")) << outcome.err;
  outcome = worksheet({"ghost", "-o", folder / "F.pdf", "--paper", "lettr"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(holds(outcome.err, "'letter'")) << outcome.err;
  EXPECT_EQ(worksheet({"ghost", "-o", folder / "none/F.pdf"}).exit_code, 8);
  write_whole(folder / "broken.toml", "format = 1\nnumber = 1\nstepp = 2\n");
  outcome = worksheet({folder / "broken.toml", "-o", folder / "F.pdf"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(holds(outcome.err, "broken.toml:3:1: ")) << outcome.err;
  EXPECT_EQ(folder.count(), 1);
}

}  // namespace
}  // namespace ghostforce::worksheet_command_test
