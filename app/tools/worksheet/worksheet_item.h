// The words of a worksheet, before anything has a place: its items, from the lesson, and the phrases that every
// worksheet has. A worksheet without answers knows nothing of them: neither which is right nor what the lesson says
// afterwards. Values; pure, any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "app/state/lesson.h"

namespace ghostforce {

enum class WorksheetSide : std::uint8_t { questions, answers };

struct WorksheetBox {
  std::string words;
  bool is_ticked = false;
};

// Words with a line after them to write on. With a unit the line is short and ends before it; without, it goes on to
// the edge.
struct WorksheetLine {
  std::string words;
  std::string_view unit{};
};

// What stands in one place of a worksheet: a step of the lesson, or a few that are only to be looked at.
struct WorksheetItem {
  std::size_t step = 0;  // of the lesson, from 0: the picture's
  std::string number;    // of the step, or of the first and the last, from 1 as on the screen
  std::string text;
  std::vector<WorksheetBox> boxes{};
  std::vector<WorksheetLine> lines{};
  std::string note{};          // below the boxes: what the lesson says after the answer, or how to answer
  double picture_share = 0.0;  // its height, 1 is usual; 0: there is no picture
  bool hides_handle = false;   // in the picture, since it would answer a question above
};

// Words in that language, which the lesson must have (language_in()).
std::vector<WorksheetItem> worksheet_items(const Lesson& lesson, std::string_view language, WorksheetSide side);

// The words on a worksheet that are not the lesson's. One row for each language. Immutable, any thread.
struct WorksheetPhrases {
  std::string_view language;
  std::string_view name;  // each with a line to write on
  std::string_view date;
  std::string_view answers;   // beside the title of the page with the answers
  std::string_view open;      // the lesson: one that comes with the program,
  std::string_view open_own;  // and another
  std::string_view how;       // to work with the page then
  std::string_view because;   // after the answers to choose from
  std::string_view draw;      // into the picture of a guess
  std::string_view off_by;    // how far off the guess on the screen was, in mm
  std::string_view done;      // a box to tick when a task is done,
  std::string_view found;     // and a line for what it took
  std::string_view look;      // of steps without a question,
  std::string_view try_out;   // and of those in which the person can change something
  std::string_view in_short;  // the question at the end
};

// English for a language that has no row.
const WorksheetPhrases& worksheet_phrases(std::string_view language) noexcept;

}  // namespace ghostforce
