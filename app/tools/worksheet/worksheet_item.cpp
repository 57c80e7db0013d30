#include "app/tools/worksheet/worksheet_item.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "app/state/lesson_file.h"
#include "app/state/set_up.h"

namespace ghostforce {
namespace {

constexpr double large = 1.3;  // of the usual height: to draw into, or with many words

bool asks(const LessonStep& step) {
  return step.question != LessonQuestion::none;
}

// The first behind `step` that asks something; there may be none.
std::size_t next_question(const Lesson& lesson, std::size_t step) {
  while (step < lesson.steps.size() && !asks(lesson.steps[step])) ++step;
  return step;
}

bool lets_act(const LessonStep& step) {
  return !step.controls.empty() || step.slider;
}

// What was stated last on the way to a step; never null, since the first one states something.
const SetUp* shown_at(const Lesson& lesson, std::size_t step) {
  const SetUp* shown = nullptr;
  for (std::size_t i = 0; i <= step; ++i) {
    if (i > 0 && lesson.steps[i - 1].reveal) shown = lesson.steps[i - 1].reveal.get();
    if (lesson.steps[i].set_up) shown = lesson.steps[i].set_up.get();
  }
  return shown;
}

// What shows the answer to a prediction; null: nothing that was not there before.
const SetUp* answer_shown_by(const Lesson& lesson, std::size_t step) {
  const LessonStep& asked = lesson.steps[step];
  if (asked.question != LessonQuestion::choose && asked.question != LessonQuestion::guess) return nullptr;
  if (asked.reveal) return asked.reveal.get();
  const bool is_hidden = asked.question == LessonQuestion::guess || !asked.secrets.empty();
  return is_hidden ? shown_at(lesson, step) : nullptr;
}

// All of a page is seen at once.
bool answers_earlier_question(const Lesson& lesson, std::size_t step) {
  const std::string shown = set_up_line(*shown_at(lesson, step));
  for (std::size_t i = 0; i < step; ++i) {
    const SetUp* const answer = answer_shown_by(lesson, i);
    if (answer != nullptr && set_up_line(*answer) == shown) return true;
  }
  return false;
}

void add_what_to_do(const LessonStep& step, const LessonStepWords& words, const WorksheetPhrases& phrases,
                    WorksheetItem& item) {
  switch (step.question) {
    case LessonQuestion::none:
      return;
    case LessonQuestion::choose:
      for (const std::string& answer : words.answers) item.boxes.push_back({answer});
      item.lines.push_back({std::string(phrases.because)});
      return;
    case LessonQuestion::guess:
      item.note = phrases.draw;
      item.lines.push_back({std::string(phrases.off_by), "mm"});
      return;
    case LessonQuestion::task:
      item.boxes.push_back({std::string(phrases.done)});
      item.lines.push_back({std::string(phrases.found)});
      return;
  }
}

// Steps without a question, from one to another.
void add_what_to_look_at(const Lesson& lesson, std::size_t first, std::size_t last, const WorksheetPhrases& phrases,
                         WorksheetItem& item) {
  constexpr std::size_t most_lines = 3;
  bool is_active = false;
  for (std::size_t i = first; i <= last; ++i) {
    is_active = is_active || lets_act(lesson.steps[i]);
    if (i < first + most_lines) item.lines.emplace_back();
  }
  item.lines.front().words = is_active ? phrases.try_out : phrases.look;
  if (last > first) item.number = fmt::format("{}–{}", first + 1, last + 1);
}

void add_answer(const LessonStep& step, const LessonStepWords& words, WorksheetItem& item) {
  for (std::size_t i = 0; i < words.answers.size(); ++i) {
    item.boxes.push_back({words.answers[i], i == step.right_answer});
  }
  // That text explains; the other one praises somebody.
  item.note = words.wrong.empty() ? words.right : words.wrong;
}

}  // namespace

std::vector<WorksheetItem> worksheet_items(const Lesson& lesson, std::string_view language, WorksheetSide side) {
  const LessonWords& words = words_in(lesson, language);
  const WorksheetPhrases& phrases = worksheet_phrases(language);
  const bool has_answers = side == WorksheetSide::answers;
  const std::size_t first_question = next_question(lesson, 0);
  std::vector<WorksheetItem> items;
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    const LessonStep& step = lesson.steps[i];
    WorksheetItem item{.step = i, .number = fmt::format("{}", i + 1), .text = words.steps[i].text};
    item.hides_handle = !has_answers && answers_earlier_question(lesson, i);
    if (asks(step)) {
      item.picture_share = step.question == LessonQuestion::guess ? large : 1.0;
      has_answers ? add_answer(step, words.steps[i], item) : add_what_to_do(step, words.steps[i], phrases, item);
    } else if (has_answers) {
      // Texts in a row tell a story: its end has the picture.
      const bool ends_story = i > 0 && !asks(lesson.steps[i - 1]) && next_question(lesson, i) == i + 1;
      item.picture_share = ends_story ? large : 0.0;
    } else {
      const bool is_before_questions = i < first_question;
      const std::size_t last = is_before_questions ? i : next_question(lesson, i) - 1;
      // What is told after a question answers it.
      if (!is_before_questions) item.text.clear();
      add_what_to_look_at(lesson, i, last, phrases, item);
      i = last;
    }
    items.push_back(std::move(item));
  }
  return items;
}

namespace {

constexpr std::array worksheet_phrase_table{
    WorksheetPhrases{.language = "en",
                     .name = "Name",
                     .date = "Date",
                     .answers = "Answers",
                     .open = "Open this lesson on the screen (F5).",
                     .open_own = "Open this lesson on the screen.",
                     .how = "Answer each question here first, then there, and see what happens.",
                     .because = "Because",
                     .draw = "Draw the handle where you think it will come to rest.",
                     .off_by = "On the screen, I was off by",
                     .done = "Done on the screen",
                     .found = "What I found:",
                     .look = "Look at the screen. What do you see?",
                     .try_out = "Try it on the screen. What do you see?",
                     .in_short = "In your own words: what is this lesson about, and why is it so?"},
    WorksheetPhrases{.language = "es",
                     .name = "Nombre",
                     .date = "Fecha",
                     .answers = "Respuestas",
                     .open = "Abre esta lección en la pantalla (F5).",
                     .open_own = "Abre esta lección en la pantalla.",
                     .how = "Responde cada pregunta primero aquí, luego allí, y mira qué pasa.",
                     .because = "Porque",
                     .draw = "Dibuja el mango donde crees que descansará.",
                     .off_by = "En la pantalla me equivoqué en",
                     .done = "Hecho en la pantalla",
                     .found = "Lo que he encontrado:",
                     .look = "Mira la pantalla. ¿Qué ves?",
                     .try_out = "Pruébalo en la pantalla. ¿Qué ves?",
                     .in_short = "Con tus palabras: ¿de qué trata esta lección, y por qué es así?"},
};

}  // namespace

const WorksheetPhrases& worksheet_phrases(std::string_view language) noexcept {
  const auto* const found = std::ranges::find(worksheet_phrase_table, language, &WorksheetPhrases::language);
  return found == worksheet_phrase_table.end() ? worksheet_phrase_table.front() : *found;
}

}  // namespace ghostforce
