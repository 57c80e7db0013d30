// The words on a worksheet that are not the lesson's. One row for each language. Immutable, any thread.
#pragma once

#include <string_view>

namespace ghostforce {

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
