// The options of a lesson: which one, and in which language.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/cli/command.h"
#include "app/lessons/lesson.h"

namespace ghostforce {

// The files that a word means which names a lesson: none where the lesson comes with the program.
std::vector<std::string> files_of_lesson(const std::string& word);

// --language; empty: the environment's.
void attach_language(CLI::App& command, std::string& language);
// The language that the person wants to read.
std::string wanted_lesson_language(const std::string& asked_for);

struct LessonOptions {
  std::string name;      // of a shipped lesson, or a path; empty: none
  std::string language;  // empty: the environment's

  void attach(CLI::App& command, FileOptions& files);
  // Null: none was asked for. Throws ReadError.
  std::shared_ptr<const Lesson> load() const;
  std::string wanted() const { return wanted_lesson_language(language); }
};

}  // namespace ghostforce
