// What the bar at the bottom has to say, and what of it the stage says too.
#pragma once

#include <string>
#include <vector>

#include <imgui.h>

#include "app/widgets/panel_context.h"

namespace ghostforce {

// What is not as it should be with the loop, each with what to do about it; empty: all is well.
std::vector<std::string> troubles_of(const LoopReading& loop, const Settings& settings);

// In the window that is being drawn, left of that place and above it: that this is a replay, and how far it is, or that
// it is over. Nothing is drawn where it is none. As large as the stage's words: `unit` is that of its layout.
void draw_replay_place(const PanelContext& context, ImVec2 end, float unit);

}  // namespace ghostforce
