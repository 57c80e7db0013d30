// Where the words and buttons of a lesson stand on the stage. Points of the window, y down; pure, any thread.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/view/screen_box.h"
#include "app/view/stage/stage_lesson.h"
#include "app/view/view.h"

namespace ghostforce {

inline constexpr double slider_knob = 10.0;  // radius of a slider's knob [points of the design]

struct StageLayout;
struct StageFrameWords;

struct LessonLayout {
  struct Button {
    ScreenBox box;
    std::vector<std::string> lines;
  };
  // At the upper right.
  std::vector<std::string> title;
  ScreenBox title_box;
  Vector<2> place{0.0};         // of its words
  std::vector<Vector<2>> dots;  // their middles
  ScreenBox leave;
  // Below, in rows.
  std::vector<Button> answers;
  std::optional<ScreenBox> slider;
  std::optional<ScreenBox> back;
  ScreenBox next;
  double top = 0.0;  // of these rows
};

// Fills in what the layout has of a lesson, its strategies and its corner, with the layout's letters. False where
// something does not fit.
bool arrange_lesson(const StageLesson& lesson, const StageFrameWords& words, const MeasureText& measure,
                    StageLayout& layout);

// The line on which the slider's knob is.
struct SliderTrack {
  Vector<2> from;
  Vector<2> to;
};
SliderTrack slider_track(const ScreenBox& slider, double unit) noexcept;

}  // namespace ghostforce
