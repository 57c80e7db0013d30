// StageLayout: where words, numbers, buttons and the menu of the stage stand, those of a lesson too; and StageMeasuring,
// what the stage shows of measuring the hand. Values, read only; points of the window, y down; any thread.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/picture/screen_box.h"
#include "app/picture/view.h"
#include "app/stage/stage_lesson.h"
#include "app/state/stage_action.h"
#include "app/state/stage_language.h"
#include "core/hand_estimator.h"

namespace ghostforce {

// What the stage shows of measuring the hand. SI units.
struct StageMeasuring {
  bool is_running = false;
  double filled = 0.0;  // of its ring, 0 to 1
  // While it runs, what it waits for; afterwards, why nobody knows.
  HandUnknown why = HandUnknown::none;
  std::optional<HandEstimate> result{};  // known
  std::optional<HandEstimate> before{};  // the one that was known before
  bool is_believed = false;              // the result is what the renderer believes in now
  // Of a lesson that wants another grip: the nearest stiffness that would do [N/m].
  std::optional<double> asked{};

  // It was tried, or is, and there is something to say about it instead of a number.
  bool has_trouble() const noexcept { return why != HandUnknown::none; }
};

// The words of the button that has the hand measured. There are several: letters are as large with all of them.
struct StageMeasuringButton {
  std::string words;
  std::string longest;
};

// Where the words and buttons of a lesson stand on the stage.
struct LessonLayout {
  struct Button {
    ScreenBox box;
    std::vector<std::string> lines;
  };
  // At the upper right.
  std::vector<std::string> title;
  ScreenBox title_box;
  Vector<2> place{0.0};               // of its words
  std::vector<Vector<2>> dots;        // their middles
  ScreenBox corner;                   // where the way out is,
  std::optional<ScreenBox> language;  // or the button of another language
  // Below, in rows.
  std::vector<Button> answers;
  std::optional<ScreenBox> slider;
  std::optional<ScreenBox> back;
  ScreenBox next;
  double top = 0.0;  // of these rows
};

struct StageButton {
  StageAction action;
  ScreenBox box;
  std::string words;
  std::string about{};  // a line below them, in smaller letters
};

// Of the menu: modes that have no button of their own, and the ways to everything else.
struct StageMenuRow {
  StageAction action;
  std::string_view title;
  std::string_view key;  // as printed on it
  std::string_view about;
  ScreenBox box{};
};

// The sizes of the stage's letters [points].
struct StageLetters {
  TextStyle words;
  TextStyle bold_words;
  TextStyle sentence;
  TextStyle number;
  TextStyle unit;
  TextStyle about;  // what a strategy does, on its button
};

struct StageLayout {
  Vector<2> size{1.0};
  double unit = 1.0;    // a point of a picture 720 points high, at the scale that fits
  double margin = 1.0;  // to the window's edges
  // Of a phone: no button is less high than a finger wants it; in an upright one what stands above at the right has a
  // row of its own, and so has each strategy.
  double least_target = 0.0;
  bool is_upright = false;
  StageLetters letters{};
  std::vector<std::string> sentence;  // its lines
  ScreenBox sentence_box;
  double words_end = 0.0;                // of the longest text that may stand there: what is below keeps its place
  std::optional<ScreenBox> mark;         // of a lesson's answer, before the sentence
  std::vector<StageButton> strategies;   // the row below
  std::vector<StageButton> header;       // above at the right; of a lesson the way out at most, without words
  std::vector<StageMenuRow> menu;        // below the last of these, while it is open
  ScreenBox menu_box;                    // round them
  std::optional<StageButton> corner;     // at the row's other end
  std::optional<StageButton> measuring;  // above it, or in a lesson's row
  std::vector<StageButton> key_hints;    // of a page, in place of the corner's: as many as have room
  std::optional<ScreenBox> ribbon;       // above the row, where there is one
  std::optional<LessonLayout> lesson;
  double header_left = 0.0;          // where what stands above at the right begins
  std::optional<ScreenBox> numbers;  // below the sentence; empty: a bare scene, or a window too small for them
  double number_width = 0.0;         // of the widest number
  std::vector<StageButton> tools;    // below them
  std::vector<StageButton> motors;   // of a device, which push: above the strategies

  // Between them lies the scene.
  double top = 0.0;
  double bottom = 0.0;
  ScreenBox scene() const noexcept { return {{0.0, top}, {size.x, bottom}}; }

  // Round all of these; empty: there are none.
  std::optional<ScreenBox> tools_box() const noexcept { return box_round(tools); }
  std::optional<ScreenBox> motors_box() const noexcept { return box_round(motors); }

  static std::optional<ScreenBox> box_round(const std::vector<StageButton>& buttons) noexcept {
    std::optional<ScreenBox> all;
    for (const StageButton& button : buttons) {
      if (!all) all = button.box;
      all->include(button.box.least);
      all->include(button.box.most);
    }
    return all;
  }

  // The end of what stands above at the right.
  const ScreenBox& header_end() const noexcept { return lesson ? lesson->corner : header.back().box; }
  // All of that, up to the window's edges.
  ScreenBox header_box() const noexcept {
    const double end = lesson           ? std::max(lesson->corner.most.y, lesson->title_box.most.y)
                       : header.empty() ? 0.0
                                        : header.back().box.most.y;
    return {{header_left, 0.0}, {size.x, end}};
  }

  // Where blocks of words may stand.
  ScreenBox room() const { return {Vector<2>(10.0 * unit), {size.x - 10.0 * unit, bottom - 6.0 * unit}}; }
};

class SentenceWidths;

// What the layout has to find room for.
struct StageFrameWords {
  const StageLanguage& language;
  StageKeys keys;
  std::string_view sentence;
  std::string_view corner{};  // of the button at the other end of the row; empty: there is none
  StageAction corner_action = StageCommand::next;
  bool has_full = true;                             // the strategy with every motor can be chosen
  bool has_strings = false;                         // in place of motors that push
  bool has_motors_to_choose = false;                // of a device, one or the other or both
  const StageMeasuringButton* measuring = nullptr;  // null: there is none
  const StageLesson* lesson = nullptr;              // null: there is none
  bool shows_menu = false;
  bool has_tools = false;            // the view can be made to fit, and the motion begun anew
  bool has_numbers = true;           // are shown; their place is there all the same
  SentenceWidths* widths = nullptr;  // of the picture before; null: all is measured anew
};

// Not below the numbers, nor Fit and Reset, nor between them and the edge.
bool is_in_sight(const StageLayout& layout, const Vector<2>& place);

// How wide that button is, with its key and the strategy's shape before the words [points]. Pure.
double strategy_button_width(const StrategyWords& words, double unit, const StageLetters& letters,
                             const MeasureText& measure);

}  // namespace ghostforce
