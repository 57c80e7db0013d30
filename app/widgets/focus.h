// Focus: the control that the keyboard is at. Dear ImGui moves it with Tab; what it does with arrows, and how one sees
// it, is decided here. UI thread.
#pragma once

#include <cstdint>
#include <vector>

#include "app/picture/theme.h"

namespace ghostforce {

// What an arrow, Home or End asks of a slider.
struct Nudge {
  enum class Way : std::uint8_t { step, to_least, to_greatest };

  Way way = Way::step;
  double steps = 0.0;  // up is positive; a tenth: fine, ten: coarse
};

// Some control has the focus, and a ring shows it. A click gives no control the keyboard.
bool has_focus();
// That control is one whose value arrows change.
bool focus_takes_arrows();
// For that control, in the next frame.
void nudge_focused(const Nudge& nudge);
// The next Tab goes on from there.
void leave_focus();

// Within a frame, of the item just drawn, whose value arrows change: what they have asked for, in their order.
std::vector<Nudge> take_nudges();
// Of the item just drawn.
bool is_focused();

// Round that control. At the end of a frame.
void draw_focus_ring(const Theme& theme, float scale);

}  // namespace ghostforce
