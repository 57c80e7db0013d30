// Explanations on hover, after a moment, beside what they explain and all inside the window. None while something is
// dragged, and none for 2 s after. Within an ImGui frame.
#pragma once

#include <string_view>

#include "app/paint/label_painter.h"
#include "app/picture/glossary.h"
#include "app/picture/panes.h"

namespace ghostforce {

// On the item just drawn.
void tooltip(std::string_view sentence);
void tooltip(Term term);

// Once in a frame, before what may have a tooltip.
void keep_tooltips_from_drags();

// On the mark of the scene under the pointer, where the item just drawn is the scene. `pointer` in the pane [points].
void mark_tooltip(const Pane& pane, const LabelFonts& fonts, const Vector<2>& pointer, double unit,
                  bool is_goal_estimated);

// The uppermost mark with a meaning at that place; null if there is none. Words count as far as they reach.
const Mark* mark_at(const Pane& pane, const LabelFonts& fonts, const Vector<2>& pointer, double unit);

}  // namespace ghostforce
