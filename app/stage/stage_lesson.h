// StageLesson: what the stage shows of a lesson, as words and values: a text instead of the sentence, and buttons
// instead of those of the stage. Values, read only; any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ghostforce {

// Each is a shape as well as a colour.
enum class LessonMark : std::uint8_t { none, right, wrong };

// A control of its own for one number.
struct StageLessonSlider {
  std::string words;    // what it is
  std::string value;    // with its unit; empty: not told
  double share = 0.0;   // where the knob is, 0 to 1
  std::string longest;  // that the value can be
};

// What stands in the row of buttons in one step.
struct StageLessonRow {
  std::vector<std::string> answers{};
  std::optional<StageLessonSlider> slider{};
  bool has_strategies = false;
  bool has_measuring = false;  // the button that has the hand measured
};

struct StageLesson {
  std::string title;
  std::string place;               // "3 of 8"
  std::string text;                // of the step, or of what it was answered
  bool is_right = false;           // the question was answered so: a tick stands before the text
  std::vector<LessonMark> dots{};  // one for each step
  std::size_t step = 0;
  std::size_t furthest = 0;            // that was ever shown
  std::vector<StageLessonRow> rows{};  // one for each step, so that letters are as large in all of them
  std::string longest_text;            // of the whole lesson
  std::vector<LessonMark> marks{};     // of this step's answers
  std::optional<std::size_t> chosen{};
  bool is_open = false;  // the question can be answered; the digits are the answers'
  std::string back;      // words of the buttons; empty: there is no step before
  std::string next;
  bool has_way_out = true;
  std::string other_language;  // of a button in place of the way out; empty: neither is there

  const StageLessonRow& row() const { return rows[step]; }
};

// What is not drawn: what an open question asks for.
struct StageSecrets {
  bool numbers = false;
  bool force = false;
  bool slide = false;
  bool rest = false;    // where the handle should rest
  bool handle = false;  // and springs, and all that follows from where it is
};

}  // namespace ghostforce
