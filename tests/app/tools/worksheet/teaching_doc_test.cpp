// docs/teaching.md has a part for each lesson, and its commands are understood.
#include <sstream>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/state/lesson_file.h"
#include "tests/support/places.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::teaching_doc_test {
namespace {

const std::string& doc() {
  static const std::string text = read_whole(source_path("/docs/teaching.md"));
  return text;
}

TEST(TeachingDoc, HasAPartForEachLesson) {
  for (const std::string_view name : shipped_lesson_names()) {
    const Lesson lesson = load_lesson(std::string(name));
    const std::string title = fmt::format("### {:g}. {} (`{}`)\n", lesson.number, words_in(lesson, "en").title, name);
    const std::size_t begin = doc().find(title);
    ASSERT_NE(begin, std::string::npos) << "docs/teaching.md should hold " << title;
    const std::string part = doc().substr(begin, doc().find("\n#", begin + title.size()) - begin);
    for (const std::string_view needed : {"**Aim.**", "**Ten minutes.**", "**What students say.**", "**Left out.**"}) {
      EXPECT_NE(part.find(needed), std::string::npos) << name << ": " << needed;
    }
  }
}

// Those without a window: each line of a block that begins with the program's name.
TEST(TeachingDoc, HasCommandsThatRun) {
  std::istringstream lines(doc());
  std::string line;
  int count = 0;
  while (std::getline(lines, line)) {
    if (!line.starts_with("ghostforce ") || line.starts_with("ghostforce run") ||
        line.starts_with("ghostforce doctor")) {
      continue;
    }
    std::istringstream words_of_line(line.substr(0, line.find(" #")));
    ProgramCall call;
    const TemporaryFolder folder;
    call.folder = folder.path();
    std::string word;
    words_of_line >> word;
    while (words_of_line >> word) call.words.push_back(word);
    const Outcome outcome = run_ghostforce(call);
    EXPECT_EQ(outcome.exit_code, 0) << line << "\n" << outcome.err;
    ++count;
  }
  EXPECT_GT(count, 5);
}

}  // namespace
}  // namespace ghostforce::teaching_doc_test
