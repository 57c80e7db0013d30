// What surrounds the scene: the bar above it, with its caption; the bar below it; and what a lecturer reads in the first
// window while the audience has the second. Within an ImGui frame, in the window that is current; UI thread.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <imgui.h>

#include "app/picture/screen_box.h"
#include "app/widgets/panel_context.h"

namespace ghostforce {

void draw_strategy_bar(const PanelContext& context);
// In points: two rows where the window is too narrow for one.
float strategy_bar_height(const PanelContext& context);

// --- The caption: what there is to see now, in a sentence; for a newcomer the hints ---

// About the active strategy under the goal as it is, by the closed forms: a motion on its way there changes nothing.
std::string_view caption_of(const Settings& settings, const Vector<2>& goal);

// What must be read even where the caption has no room: that time stands still, and what is the matter with the device.
std::vector<std::string> warnings_of_caption(const PanelContext& context);

void draw_caption(const PanelContext& context);

// --- The bar at the bottom ---

// What is not as it should be with the loop, each with what to do about it; empty: all is well.
std::vector<std::string> troubles_of(const LoopReading& loop, const Settings& settings);

void draw_status_bar(const PanelContext& context, bool has_caption);

// Left of that place and above it: that this is a replay, and how far it is, or that it is over. Nothing is drawn where
// it is none. As large as the stage's words: `unit` is that of its layout.
void draw_replay_place(const PanelContext& context, ImVec2 end, float unit);

// --- For a lecturer ---

// What the notes need at the lower edge of a window so high [points].
float notes_height(float window_height);

// In a window of their own.
void draw_notes(const PanelContext& context);

// That the audience sees nothing at the moment. The stage, which it would see, is dimmed.
void draw_blank_words(const PanelContext& context, const ScreenBox& scene);

}  // namespace ghostforce
