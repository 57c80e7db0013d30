// LessonLayout: where the words and buttons of a lesson stand on the stage. Points of the window, y down; any thread.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/picture/screen_box.h"

namespace ghostforce {

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

}  // namespace ghostforce
