// The options of a lesson: which one, and in which language.
#pragma once

#include <memory>
#include <string>

#include "app/cli/command.h"
#include "app/lessons/lesson.h"

namespace ghostforce {

struct LessonOptions {
  std::string name;      // of a shipped lesson, or a path; empty: none
  std::string language;  // empty: that of an earlier run, else the environment's

  void attach(CLI::App& command, FileOptions& files);
  // Null: none was asked for. Throws ReadError.
  std::shared_ptr<const Lesson> load() const;
  // The language that the person wants to read. `kept`: from an earlier run; empty: none.
  std::string wanted(const std::string& kept = {}) const;
};

}  // namespace ghostforce
