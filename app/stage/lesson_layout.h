// Finds places for the words and buttons of a lesson. Points of the window, y down; pure, any thread.
#pragma once

#include "app/stage/stage_places.h"

namespace ghostforce {

inline constexpr double slider_knob = 10.0;  // radius of a slider's knob [points of the design]

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
