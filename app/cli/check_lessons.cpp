#include "app/cli/check_lessons.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "app/base/failure.h"
#include "app/base/interruption.h"
#include "app/base/quoted.h"
#include "app/base/words.h"
#include "app/cli/exit_code.h"
#include "app/cli/lines.h"
#include "app/files/input_file.h"
#include "app/files/toml_document.h"
#include "app/state/lesson_check.h"
#include "app/state/lesson_file.h"

namespace ghostforce {
namespace {

// Returns how many steps are wrong.
std::size_t print_findings(const Lesson& lesson, const std::string& shown, Lines& lines) {
  std::vector<std::string_view> languages;
  for (const auto& [language, words] : lesson.words) languages.push_back(language);
  lines.write(fmt::format("{}: \"{}\", {} steps, languages: {}", shown, words_in(lesson, "en").title,
                          lesson.steps.size(), listed(languages)));
  std::size_t wrong = 0;
  std::size_t longest = 0;
  for (const LessonStep& step : lesson.steps) longest = std::max(longest, step.name.size());
  const std::vector<LessonStepFinding> findings = examine_lesson(lesson);
  for (std::size_t i = 0; i < findings.size(); ++i) {
    const LessonStepFinding& found = findings[i];
    lines.write(fmt::format("  {:2} {:5}  {:{}}  {}", i + 1, found.is_good ? "ok" : "WRONG", lesson.steps[i].name,
                            longest, found.words));
    if (!found.example.empty()) lines.write(fmt::format("            for example: {}", found.example));
    if (!found.is_good) ++wrong;
  }
  for (const std::string_view language : languages_missing_in(lesson)) {
    lines.write(fmt::format("  not translated yet: there is no [{}]", language));
  }
  return wrong;
}

// A case of a picture; then a person has named it instead of its folder.
bool is_case(const std::string& path) {
  TomlReader reader(path);
  return reader.parse(file_contents(path).text) && reader.find("", "scene");
}

}  // namespace

bool may_be_lesson(const std::string& word) {
  std::error_code unknown;
  if (std::filesystem::is_directory(word, unknown)) return false;
  const std::vector<std::string_view> shipped = shipped_lesson_names();
  return std::ranges::find(shipped, word) != shipped.end() || (word.ends_with(".toml") && !is_case(word));
}

int check_lessons(const std::vector<std::string>& lessons) {
  Lines lines;
  ExitCode end = ExitCode::done;
  std::size_t wrong = 0;
  for (const std::string& name : lessons) {
    stop_if_interrupted();
    const std::string shown = quoted_text(name, longest_path);
    try {
      const std::size_t steps = print_findings(load_lesson(name), shown, lines);
      if (steps == 0) continue;
      ++wrong;
      if (end == ExitCode::done) end = ExitCode::answer_is_no;
    } catch (const ReadError& error) {
      ++wrong;
      end = std::max(end, exit_code_of(error.kind()));
      lines.write(fmt::format("{}: cannot be read as a lesson", shown));
      say("{}\n", error.what());
    }
  }
  lines.write(fmt::format("{} {}, {} wrong", lessons.size(), lessons.size() == 1 ? "lesson" : "lessons", wrong));
  return static_cast<int>(end);
}

}  // namespace ghostforce
