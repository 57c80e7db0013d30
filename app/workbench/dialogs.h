// What may stand in front of the scene, one at a time: help, and the forms for opening and saving. Each edits its own
// fields, and in the end leaves a request in the session.
#pragma once

#include <optional>

#include "app/picture/screen_box.h"
#include "app/widgets/panel_context.h"

namespace ghostforce {

// What is typed is meant for the dialog, even between two fields: keys are no shortcuts.
bool has_field(Dialog dialog) noexcept;

// The one that session.dialog names, in the middle of the window; the device's status on the side of the window where
// the hand is not. `hand`: where in the window that is [points]; empty: on the left.
void draw_dialog(const PanelContext& context, const std::optional<Vector<2>>& hand);

// Some of what that dialog shows lies beyond its edge.
bool scrolls(Dialog dialog);
// What a key asks of it: so many lines and pages down; no step leads beyond the ends. Any number of times before the
// next frame.
struct ScrollStep {
  float lines = 0.0F;
  float pages = 0.0F;
};
void scroll(Dialog dialog, const ScrollStep& step);

// What there is to tell, if anything, at the top of the scene. It covers no button.
void draw_notice(const PanelContext& context, const ScreenBox& scene);

// Why the shaders in the watched folder are not in use, if they are not: the driver's log and the numbered source.
void draw_shader_problem(const PanelContext& context, const ScreenBox& scene);

// The dialogs themselves: a file each, and one for all that save.
void draw_help(const PanelContext& context);
void draw_doctor(const PanelContext& context);
void draw_lessons(const PanelContext& context);
void draw_open_scene(const PanelContext& context);
void draw_save_scene(const PanelContext& context);
void draw_save_picture(const PanelContext& context);
void draw_save_clip(const PanelContext& context);
void draw_save_plots(const PanelContext& context);
void draw_reset_preferences(const PanelContext& context);
void draw_palette(const PanelContext& context);

// Lets the person choose the language of the stage and of lessons, one of the catalog.
void draw_language_choice(const PanelContext& context);

}  // namespace ghostforce
