// The options that are about lessons: which one, in which language, and --kiosk, with which they go round for visitors.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/command.h"
#include "app/state/lesson.h"

namespace ghostforce {

// --language, empty where it is not given. `usual_language`: what it is then, for the help.
void attach_language(CLI::App& command, std::string& language, std::string_view usual_language);
// The language that the person wants to read. `kept`: from an earlier run; empty: none. Throws Failure(wrong_call)
// where neither the stage nor any of these lessons has the one that was asked for.
std::string language_wanted(const std::string& asked_for, const std::string& kept,
                            std::span<const std::shared_ptr<const Lesson>> lessons);

struct LessonOptions {
  std::string name;      // of a shipped lesson, or a path; empty: none
  std::string language;  // empty: that of an earlier run, else the environment's

  void attach(CLI::App& command, FileOptions& files, std::string_view usual_language);
  // Throws Failure(wrong_call) where --lesson stands beside an option of `command` that it contradicts.
  void refuse_contradictions(const CLI::App& command) const;
  // Null: none was asked for. Throws ReadError.
  std::shared_ptr<const Lesson> load() const;
  // As language_wanted(); `lesson`: as it was loaded.
  std::string wanted(const std::string& kept, const std::shared_ptr<const Lesson>& lesson) const;
};

// What ends the visitor's mode, for the person at the terminal.
inline constexpr std::string_view end_of_kiosk =
    "Visitor's mode: Ctrl+Alt+Shift+Q in the window ends it, and so does Ctrl+C here.";

// --kiosk, the visitor's mode (app/state/kiosk_visit.h, docs/kiosk.md), and what cannot be asked for together with it.
struct KioskOptions {
  bool is_on = false;

  void attach(CLI::App& command);
  // Throws Failure(wrong_call) where --kiosk stands beside an option that it contradicts.
  void refuse_contradictions() const;
  // Those that go round: the one that was asked for, else all that come with the program. Empty without --kiosk.
  std::vector<std::shared_ptr<const Lesson>> lessons(const std::shared_ptr<const Lesson>& asked_for) const;

 private:
  const CLI::App* command_ = nullptr;  // once attached
};

}  // namespace ghostforce
