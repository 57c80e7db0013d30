// StageLayout: where words, numbers, buttons and icons of the stage stand. Values; points of the window, y down; any
// thread.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/picture/screen_box.h"
#include "app/picture/view.h"
#include "app/stage/lesson_places.h"
#include "app/stage/stage_lesson.h"
#include "app/stage/stage_measuring.h"
#include "app/state/stage_action.h"
#include "app/state/stage_language.h"

namespace ghostforce {

struct StageButton {
  StageAction action;
  ScreenBox box;
  std::string words;
};

// The sizes of the stage's letters [points].
struct StageLetters {
  TextStyle words;
  TextStyle bold_words;
  TextStyle sentence;
  TextStyle number;
  TextStyle unit;
};

struct StageLayout {
  Vector<2> size{1.0};
  double unit = 1.0;    // a point of a picture 720 points high, at the scale that fits
  double margin = 1.0;  // to the window's edges
  StageLetters letters{};
  std::vector<std::string> sentence;  // its lines
  ScreenBox sentence_box;
  double words_end = 0.0;                // of the longest text that may stand there: the numbers below keep their place
  std::optional<ScreenBox> mark;         // of a lesson's answer, before the sentence
  std::vector<StageButton> strategies;   // the row below
  std::vector<StageButton> icons;        // the strip above, modes and workbench
  std::optional<StageButton> corner;     // at the row's other end
  std::optional<StageButton> measuring;  // above it, or in a lesson's row
  std::vector<StageButton> links;        // or there, as words, where there is room: lessons and keys
  std::optional<ScreenBox> ribbon;       // above the row, where there is one
  std::optional<LessonLayout> lesson;    // of which the strip of icons keeps the way out at most
  double header_left = 0.0;              // where what stands above at the right begins
  Vector<2> numbers_size{0.0};           // of the two numbers with their words
  double number_width = 0.0;             // of the widest number

  // Between them lies the scene.
  double top = 0.0;
  double bottom = 0.0;
  ScreenBox scene() const noexcept { return {{0.0, top}, {size.x, bottom}}; }

  // The end of what stands above at the right.
  const ScreenBox& strip() const noexcept { return lesson ? lesson->corner : icons.back().box; }

  // Where blocks of words may stand, and the best place for the two numbers: right below the sentence.
  ScreenBox room() const { return {Vector<2>(10.0 * unit), {size.x - 10.0 * unit, bottom - 6.0 * unit}}; }
  Vector<2> numbers_corner() const { return {margin, words_end + 6.0 * unit}; }
};

struct StageFrameWords {
  const StageLanguage& language;
  StageKeys keys;
  std::string_view sentence;
  std::string_view corner{};  // of the button at the other end of the row; empty: the help's, where there is room
  StageAction corner_action = StageCommand::keys;
  bool has_full = true;                             // the strategy with every motor can be chosen
  const StageMeasuringButton* measuring = nullptr;  // null: there is none
  const StageLesson* lesson = nullptr;              // null: there is none
};

}  // namespace ghostforce
