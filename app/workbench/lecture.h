// What the first window shows a lecturer while the audience has the second: what to say, and that the audience sees
// nothing at the moment.
#pragma once

#include "app/picture/screen_box.h"
#include "app/widgets/panel_context.h"

namespace ghostforce {

// What the notes need at the lower edge of a window so high [points].
float notes_height(float window_height);

// In the window that is being drawn, which is theirs alone.
void draw_notes(const PanelContext& context);

// Over the scene; the stage, which the audience would see, is dimmed.
void draw_blank_words(const PanelContext& context, const ScreenBox& scene);

}  // namespace ghostforce
