#include "app/cli/lesson_options.h"

#include <array>

#include <fmt/format.h>

#include "app/base/failure.h"
#include "app/base/language.h"
#include "app/base/quoted.h"
#include "app/base/typed_text.h"
#include "app/cli/option.h"
#include "app/state/faces_and_modes.h"
#include "app/state/lesson_file.h"
#include "device/report/input_choice.h"

namespace ghostforce {

void attach_language(CLI::App& command, std::string& language, std::string_view usual_language) {
  add_option(command, "--language CODE", language,
             fmt::format("The language of the stage and of lessons, as two letters: {}, or another that the "
                         "lesson has; default: {}",
                         listed(languages_with({})), usual_language))
      ->check(suggests(languages_with({})));
}

std::string language_wanted(const std::string& asked_for, const std::string& kept,
                            std::span<const std::shared_ptr<const Lesson>> lessons) {
  if (!asked_for.empty()) {
    const std::string problem = not_one_of(asked_for, languages_with(lessons));
    if (!problem.empty()) throw Failure(ExitCode::wrong_call, fmt::format("--language: {}", problem));
  }
  return wanted_language(asked_for.empty() ? kept : asked_for, locale_variables());
}

void LessonOptions::attach(CLI::App& command, FileOptions& files, std::string_view usual_language) {
  files.reads(
      add_option(command, "--lesson NAME|FILE", name, "A lesson that comes with the program, or the path of one")
          ->check(suggests(shipped_lesson_names())),
      path_unless_one_of(shipped_lesson_names()));
  attach_language(command, language, usual_language);
}

namespace {

constexpr std::string_view lesson_says = "a lesson says what is on the stage";
constexpr std::array beside_lesson{
    Contradiction{"SCENE", "", lesson_says},
    Contradiction{"--set", "", lesson_says},
    Contradiction{"--goal-mm", "", lesson_says},
    Contradiction{"--strategy", "", lesson_says},
    Contradiction{"--mode", "", lesson_says},
    Contradiction{"--landscape", "", lesson_says},
    Contradiction{"--view", face_name(Face::workbench), "lessons are on the stage"},
    Contradiction{"--compare", "", "the stage shows one strategy at a time"},
    Contradiction{"--part", "", "a step is shown whole"},
    Contradiction{"--at", "", "a step is shown when the hand is at rest"},
    Contradiction{"--clip", "", "a step is one picture"},
};

}  // namespace

void LessonOptions::refuse_contradictions(const CLI::App& command) const {
  if (!name.empty()) ghostforce::refuse_contradictions(command, "--lesson", beside_lesson);
}

std::string LessonOptions::wanted(const std::string& kept, const std::shared_ptr<const Lesson>& lesson) const {
  return language_wanted(language, kept, std::span(&lesson, lesson ? 1 : 0));
}

std::shared_ptr<const Lesson> LessonOptions::load() const {
  return name.empty() ? nullptr : std::make_shared<const Lesson>(load_lesson(name));
}

namespace {

// Visitors have lessons all the time.
std::vector<Contradiction> beside_kiosk() {
  std::vector<Contradiction> list(beside_lesson.begin(), beside_lesson.end());
  list.insert(list.end(), {
                              Contradiction{"--record", "", "nothing of a visit is stored"},
                              Contradiction{"--record-session", "", "nothing of a visit is stored"},
                              Contradiction{"--audience", "", "visitors see all that there is"},
                              Contradiction{"--shader-dir", "", "visitors must not see what is wrong with a shader"},
                          });
  for (const InputChoice& hand : hands_moving_by_themselves) {
    list.push_back({"--input", hand.name, "visitors move the hand themselves"});
  }
  return list;
}

}  // namespace

void KioskOptions::attach(CLI::App& command) {
  command_ = &command;
  command.add_flag(
      "--kiosk", is_on,
      "For visitors of an open day or a museum: full screen, the lessons in a loop, back to the start after "
      "90 s without a hand, and no way to files; with --lesson, that one over and over (docs/kiosk.md)");
}

void KioskOptions::refuse_contradictions() const {
  if (is_on) ghostforce::refuse_contradictions(*command_, "--kiosk", beside_kiosk());
}

std::vector<std::shared_ptr<const Lesson>> KioskOptions::lessons(const std::shared_ptr<const Lesson>& asked_for) const {
  if (!is_on) return {};
  return asked_for ? std::vector{asked_for} : shipped_lessons();
}

}  // namespace ghostforce
